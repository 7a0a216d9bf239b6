#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "fluidymation/core/color.h"
#include "fluidymation/core/geometry.h"
#include "fluidymation/core/image.h"
#include "fluidymation/guides/input_mask.h"
#include "fluidymation/io/file_identity.h"
#include "fluidymation/io/frame_sequence.h"
#include "fluidymation/io/png.h"
#include "fluidymation/options.h"
#include "fluidymation/pipeline.h"
#include "pipeline/memory.h"

namespace fluidymation {

/// A sequence as found on disk, the size of its frames and the one they are scaled to.
struct InputSequence {
  FrameFiles files;
  std::vector<FileIdentity> identities;  ///< of the files when the run began
  Size stored;
  Size scaled;
};

/// Flow files of a sequence of masks; of the masks' size.
struct FlowSequence {
  FrameFiles files;  ///< one a frame; at the end where none is needed the path may be empty
  std::vector<FileIdentity> identities;  ///< of the files when the run began
  Size stored;
  Size scaled;
  float factor = 1.0F;  ///< of the vectors: the sequence's scale, negative where it is reversed
  /// Whether a frame's own file says how it came about; else that of the frame before does.
  bool seenOnFrame = true;
};

/// The picture of a background, where it is a file.
struct BackgroundFile {
  FileIdentity identity;  ///< when the run began
  Size stored;
};

/// Everything that is read, checked as far as headers and folders tell.
struct Inputs {
  InputSequence color;
  InputSequence sourceMask;
  InputSequence target;
  std::optional<FlowSequence> sourceFlow;
  std::optional<FlowSequence> targetFlow;
  std::optional<BackgroundFile> background;  ///< of `--background`, or of what stands for it
};

/// Finds all files, reads all headers, and checks that they fit together and into memory.
/// @throws Faults, one for each gap, file and size that is wrong in any of the sequences;
/// UsageError naming the option.
[[nodiscard]] Inputs openInputs(const Options& options, const Observer& observer);

/// Of the file that `text` names; nothing where it is a colour or stands for the film's surface.
/// @param option  which asks for it, for messages.
/// @throws UsageError where it is neither and there is no such file; Error where it cannot be read.
[[nodiscard]] std::optional<BackgroundFile> openBackground(const std::string& option,
                                                           const std::string& text);

/// Of all files, by their order; nothing of those that need not be there. @throws Error.
[[nodiscard]] std::vector<FileIdentity> identitiesOf(const FrameFiles& files);

/// What the headers tell of it: no mask pixels yet.
[[nodiscard]] RunSize sizeOfRun(const Options& options, const Inputs& inputs);

/// Alpha where any frame of the sequence is not opaque everywhere, else brightness. Decided for the
/// whole sequence: a frame that its shape covers wholly is opaque everywhere too.
/// @param beforeFrame  called before each look at a file.
/// @throws Error naming the file.
[[nodiscard]] MaskChannel maskChannel(const InputSequence& masks,
                                      const std::function<void()>& beforeFrame);

/// Reads mask `frame` of a sequence and scales it as gray.
/// @throws Error naming the file, also when it is no longer the one found at first.
[[nodiscard]] InputMask readMask(const InputSequence& masks, MaskChannel channel, int frame);

/// Reads and scales picture `frame` of a sequence; sRGB-encoded. @throws Error likewise.
[[nodiscard]] Image<Rgb> readPicture(const InputSequence& pictures, int frame);

}  // namespace fluidymation
