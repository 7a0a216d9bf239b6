#include "fluidymation/preview.h"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <system_error>
#include <utility>
#include <vector>

#include "compositing/over.h"
#include "fluidymation/core/error.h"
#include "fluidymation/core/index.h"
#include "fluidymation/core/resize.h"
#include "fluidymation/core/text.h"
#include "fluidymation/io/apng.h"
#include "fluidymation/io/atomic_file.h"
#include "fluidymation/io/frame_pattern.h"
#include "fluidymation/io/png.h"
#include "pipeline/backdrop.h"
#include "pipeline/dump_name.h"
#include "pipeline/inputs.h"
#include "pipeline/outputs.h"
#include "pipeline/protected_files.h"
#include "pipeline/starting_point.h"
#include "preview/sheet.h"
#include "preview/video.h"

namespace fluidymation {
namespace {

namespace fs = std::filesystem;

enum class Format { kSheet, kAnimatedPng, kGif, kMp4 };

/// @throws UsageError where the name has no ending that is known, or ffmpeg is wanted and missing.
[[nodiscard]] Format formatOf(const std::string& path) {
  std::string ending = fs::path(path).extension().string();
  for (char& c : ending) c = static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
  if (ending == ".png") return Format::kSheet;
  if (ending == ".apng") return Format::kAnimatedPng;
  if (ending != ".gif" && ending != ".mp4") {
    throw UsageError("--preview " + path +
                     ": wanted a name that ends in .png (a sheet), .apng, .gif or .mp4");
  }
  if (!hasFfmpeg()) {
    throw UsageError("--preview " + path +
                     ": is made by the program ffmpeg, which is not in the PATH; install it, or "
                     "take a name that ends in .apng or .png");
  }
  return ending == ".gif" ? Format::kGif : Format::kMp4;
}

[[nodiscard]] int longestSidePx(Format format) {
  constexpr int kOfSheet = 320;
  constexpr int kOfSmallFilm = 480;
  constexpr int kOfFilm = 1280;
  if (format == Format::kSheet) return kOfSheet;
  return format == Format::kMp4 ? kOfFilm : kOfSmallFilm;
}

/// @throws UsageError where the preview would replace what is read or painted.
void requireApart(const Options& options, const PreviewOptions& preview) {
  const std::string& path = preview.path;
  const std::string option = "--preview " + path;
  std::error_code ignored;
  if (preview.background && (canonical(path) == canonical(*preview.background) ||
                             fs::equivalent(path, *preview.background, ignored))) {
    throw UsageError(option + ": is the picture of --preview-background; choose another name");
  }
  if (ProtectedFiles(options).contains(path)) {
    throw UsageError(option + ": is an input and would be overwritten; choose another name");
  }
  if (preview.configFile && (canonical(path) == canonical(*preview.configFile) ||
                             fs::equivalent(path, *preview.configFile, ignored))) {
    throw UsageError(option + ": is the file of --config; choose another name");
  }
  const fs::path file = canonical(path);
  const FramePattern frames(options.outPath);
  if (file.parent_path() == canonical(frames.folder()) &&
      frames.numberOf(file.filename().string()).has_value()) {
    throw UsageError(option + ": is the name of a painted frame; choose another one");
  }
  if (!options.dumpGuidesDirectory) return;
  for (const char* sequence : {"source", "target"}) {
    if (file.parent_path() == canonical(dumpFolder(options, sequence)) &&
        isDumpName(file.filename().string())) {
      throw UsageError(option + ": is the name of a dumped file; choose another one");
    }
  }
}

/// @throws Interrupted
void requireNotCancelled(const std::function<bool()>& cancelled) {
  if (cancelled && cancelled()) throw Interrupted("interrupted; the preview is not written");
}

[[nodiscard]] std::string folderOf(const std::string& path) {
  const fs::path parent = fs::path(path).parent_path();
  return parent.empty() ? "." : parent.string();
}

[[nodiscard]] Image<Rgb> grayPicture(const Image<float>& values) {
  Image<Rgb> result(values.size());
  std::transform(values.begin(), values.end(), result.begin(), [](float v) {
    return Rgb{v, v, v};
  });
  return result;
}

/// Opaque, as files hold it, with one row or column less where a side is odd.
[[nodiscard]] Image<Rgba8> evenPicture(const Image<Rgb>& picture) {
  Image<Rgba8> result({picture.width() / 2 * 2, picture.height() / 2 * 2});
  for (int y = 0; y < result.height(); ++y) {
    for (int x = 0; x < result.width(); ++x) {
      const Rgb color = picture(x, y);
      result(x, y) = {toByte(color.r), toByte(color.g), toByte(color.b), 255};
    }
  }
  return result;
}

}  // namespace

struct Preview::Content {
  Inputs inputs;
  FramePattern frames;
  PreviewOptions options;
  Format format;
  int begin;  ///< of the frames that are painted, by index
  int end;
  Image<Rgb> backdrop;  ///< of the target's size
  std::function<bool()> cancelled;
  MaskChannel targetChannel = MaskChannel::kBrightness;
  int written = 0;  ///< since the last refresh

  /// Those from `from` to before `limit` that are on the disk.
  [[nodiscard]] std::vector<int> existing(int from, int limit) const {
    std::vector<int> indices;
    for (int i = std::max(from, begin); i < std::min(limit, end); ++i) {
      std::error_code ignored;
      if (fs::exists(framePath(i), ignored)) indices.push_back(i);
    }
    return indices;
  }

  [[nodiscard]] std::string framePath(int index) const {
    return frames.path(inputs.target.files.numbers[at(index)]);
  }

  /// What is shown of a frame.
  [[nodiscard]] Image<Rgb> cell(int index) const {
    stopIfWanted();
    const std::string path = framePath(index);
    const Image<Rgba> frame = readPng(path);
    if (frame.size() != backdrop.size()) {
      throw Error(path + ": " + sizeText(frame.size()) + ", but the animation is " +
                  sizeText(backdrop.size()) + "; it is a frame of another run");
    }
    const Size size = fitted(frame.size(), longestSidePx(format));
    Image<Rgb> painted = resize(composited(frame, backdrop), size);
    if (!options.beside) return painted;
    const Size film = inputs.color.scaled;
    const Size filmCell =
        fitted({film.width * size.height / film.height, size.height}, longestSidePx(format));
    std::vector<Image<Rgb>> row;
    const int k = index % inputs.color.files.count();
    row.push_back(resize(readPicture(inputs.color, k), filmCell));
    row.push_back(
        grayPicture(resize(readMask(inputs.target, targetChannel, index).coverage, size)));
    row.push_back(std::move(painted));
    return besideEachOther(row);
  }

  void stopIfWanted() const { requireNotCancelled(cancelled); }

  void write(const std::vector<int>& all, int most) const {
    if (all.empty()) return;
    createFolder(folderOf(options.path));
    const std::vector<int> places = evenly(static_cast<int>(all.size()), most);
    if (format == Format::kSheet) {
      std::vector<Image<Rgb>> cells;
      cells.reserve(places.size());
      for (const int place : places) cells.push_back(cell(all[at(place)]));
      writePng(options.path, evenPicture(inRows(cells)));
      return;
    }
    const auto picture = [&](int i) { return evenPicture(cell(all[at(places[at(i)])])); };
    const int count = static_cast<int>(places.size());
    if (format == Format::kAnimatedPng) {
      writeAnimatedPng(options.path, count, kFramesPerSecond, picture);
    } else {
      writeVideo(options.path, format == Format::kGif ? VideoFormat::kGif : VideoFormat::kMp4,
                 count, kFramesPerSecond, picture, [this] { stopIfWanted(); });
    }
  }
};

Preview::Preview(const Options& options, const PreviewOptions& preview,
                 const std::function<bool()>& cancelled) {
  const auto stopIfWanted = [&cancelled] { requireNotCancelled(cancelled); };
  const Format format = formatOf(preview.path);
  requireApart(options, preview);
  if (options.background && preview.background) {
    throw UsageError("--preview-background: not wanted with --background, whose frames are opaque");
  }
  checkFolderCreatable(folderOf(preview.path));
  checkReplaceable(preview.path);
  Inputs inputs = openInputs(options, Observer{});
  const std::string background = preview.background.value_or(kDefaultBackground);
  inputs.background = openBackground("--preview-background", background);
  Image<Rgb> surface =
      backdrop("--preview-background", background, inputs, inputs.target.scaled, stopIfWanted);
  const auto [begin, end] = wantedFrames(options, inputs.target.files.numbers);
  content_ =
      std::make_unique<Content>(Content{std::move(inputs), FramePattern(options.outPath), preview,
                                        format, begin, end, std::move(surface), cancelled});
  if (preview.beside) content_->targetChannel = maskChannel(content_->inputs.target, stopIfWanted);
}

Preview::~Preview() = default;

void Preview::frameWritten(const FrameReport& report) {
  if (!content_->options.every || ++content_->written < *content_->options.every) return;
  content_->written = 0;
  const bool isSheet = content_->format == Format::kSheet;
  const std::vector<int>& numbers = content_->inputs.target.files.numbers;
  const auto frame = static_cast<int>(
      std::find(numbers.begin(), numbers.end(), report.frameNumber) - numbers.begin());
  // What the run has painted, and what was there before it went on
  const std::vector<int> shown = report.reversed ? content_->existing(frame, content_->end)
                                                 : content_->existing(content_->begin, frame + 1);
  content_->write(shown, isSheet ? kMostOnSheet : kMostWhileRunning);
}

int Preview::finish() {
  const std::vector<int> all = content_->existing(content_->begin, content_->end);
  if (all.empty()) return 0;
  const int count = static_cast<int>(all.size());
  content_->write(all, content_->format == Format::kSheet ? kMostOnSheet : std::max(count, 2));
  return count;
}

void requirePreviewFile(const PreviewOptions& preview) {
  if (!preview.path.empty()) return;
  for (const auto& [isGiven, option] :
       {std::pair{preview.background.has_value(), "--preview-background"},
        std::pair{preview.beside, "--preview-beside"},
        std::pair{preview.every.has_value(), "--preview-every"}}) {
    if (isGiven) throw UsageError(std::string(option) + ": wanted with --preview FILE only");
  }
}

}  // namespace fluidymation
