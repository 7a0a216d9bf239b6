#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "fluidymation/option_ranges.h"
#include "fluidymation/options.h"
#include "fluidymation/pipeline.h"

namespace fluidymation {

/// How painted frames are shown.
struct PreviewOptions {
  std::string path;                       ///< ends in .png, .apng, .gif or .mp4; empty: no preview
  std::optional<std::string> background;  ///< a colour, a PNG file or "exemplar"
  bool beside = false;                    ///< exemplar and mask beside the frames
  std::optional<int> every;               ///< written anew after so many frames
  std::optional<std::string> configFile;  ///< options were read from it: not to be replaced
};

/// What frames are laid over where no background is given: paper.
inline constexpr const char* kDefaultBackground = "#F4F1E8";

/// Shows the frames of a run, which it reads from the disk; it never changes them. Of the frames
/// one is in memory at a time, at the target's size. Who makes films by ffmpeg has to ignore
/// SIGPIPE, as the tool does: ffmpeg may end while it is fed.
class Preview {
 public:
  /// A preview that is refreshed while a run goes on shows so many frames at most, evenly chosen of
  /// those written; the last one shows all.
  static constexpr int kMostWhileRunning = 48;
  static constexpr int kMostOnSheet = 12;  ///< frames of a .png sheet, evenly chosen
  static constexpr int kFramesPerSecond = 12;

  /// Checks all that is needed: the file's ending and place, the background, ffmpeg where it is
  /// wanted.
  /// @param cancelled  whether to stop; asked before each file that is read, here and later.
  /// @throws UsageError, Error, Interrupted.
  Preview(const Options& options, const PreviewOptions& preview,
          const std::function<bool()>& cancelled = {});
  Preview(const Preview&) = delete;
  Preview& operator=(const Preview&) = delete;
  ~Preview();

  /// A frame is written; the preview is too, where it is due.
  /// @throws Error naming the file, Interrupted.
  void frameWritten(const FrameReport& report);

  /// Writes the preview of all frames that are there.
  /// @return  how many; 0: none is there, and nothing was written.
  /// @throws Error naming the file, Interrupted.
  int finish();

 private:
  struct Content;
  std::unique_ptr<Content> content_;
};

/// @throws UsageError where options of the preview are given and no file.
void requirePreviewFile(const PreviewOptions& preview);

}  // namespace fluidymation
