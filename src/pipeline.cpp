#include "fluidymation/pipeline.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "fluidymation/core/color.h"
#include "fluidymation/core/error.h"
#include "fluidymation/core/parallel.h"
#include "fluidymation/core/resize.h"
#include "fluidymation/guides/guide_dump.h"
#include "fluidymation/guides/guide_stream.h"
#include "fluidymation/io/atomic_file.h"
#include "fluidymation/io/frame_pattern.h"
#include "fluidymation/io/frame_sequence.h"
#include "fluidymation/io/png.h"
#include "fluidymation/synthesis/exemplar.h"
#include "fluidymation/synthesis/nnf_dump.h"
#include "fluidymation/synthesis/pyramid.h"
#include "fluidymation/synthesis/synthesizer.h"

namespace fluidymation {
namespace {

/// A mask image is inside from half the range up.
constexpr float kInsideCoverage = 0.5F;

std::string text(Size size) {
  return std::to_string(size.width) + "x" + std::to_string(size.height);
}

/// A sequence as found on disk and the size its frames are scaled to.
struct InputSequence {
  FrameFiles files;
  Size scaled;
};

InputSequence openSequence(const std::string& path, const SequenceOptions& sequence,
                           const std::string& optionName, const Observer& observer) {
  InputSequence input;
  input.files = findFrames(FramePattern(path), sequence, optionName);
  if (!input.files.note.empty() && observer.note) observer.note(input.files.note);
  input.scaled = scaledSize(commonSize(input.files), sequence.scale);
  if (input.scaled.width > kMaxImageSidePx || input.scaled.height > kMaxImageSidePx ||
      static_cast<std::int64_t>(input.scaled.width) * input.scaled.height > kMaxImagePixels) {
    throw UsageError(optionName + ": frames scaled to " + text(input.scaled) + "; wanted at most " +
                     std::to_string(kMaxImageSidePx) + " px a side and " +
                     std::to_string(kMaxImagePixels) + " px in all");
  }
  return input;
}

/// Everything that is read, checked as far as headers and folders tell.
struct Inputs {
  InputSequence color;
  InputSequence sourceMask;
  InputSequence target;
};

Inputs openInputs(const Options& options, const Observer& observer) {
  Inputs inputs;
  inputs.color = openSequence(options.source.path, options.source, "--src-path", observer);
  inputs.sourceMask =
      openSequence(options.sourceMaskPath, options.source, "--src-mask-path", Observer{});
  inputs.target = openSequence(options.target.path, options.target, "--target-path", observer);

  const FrameFiles& color = inputs.color.files;
  const FrameFiles& mask = inputs.sourceMask.files;
  if (color.count() != mask.count()) {
    throw Error("--src-mask-path " + options.sourceMaskPath + ": " + std::to_string(mask.count()) +
                " frames, but --src-path " + options.source.path + " has " +
                std::to_string(color.count()) + "; an exemplar and its masks must agree");
  }
  requireMasksOfSameSize(color, mask);
  return inputs;
}

std::string dumpFolder(const Options& options, const std::string& sequence) {
  return (std::filesystem::path(*options.dumpGuidesDirectory) / sequence).string();
}

/// One spelling for all paths to a file, also in folders that are still to be created.
std::filesystem::path canonical(const std::string& path) {
  namespace fs = std::filesystem;
  std::error_code ignored;
  fs::path resolved = fs::absolute(path, ignored);
  // A folder that does not exist yet is not resolved, and the ".." behind it may lead to a link:
  // hence twice.
  for (int i = 0; i < 2; ++i) {
    const fs::path once = fs::weakly_canonical(resolved, ignored);
    resolved = ignored ? resolved.lexically_normal() : once;
  }
  return resolved;
}

/// Whether a dump into `folder` can write `path`; its files are NNNNN.<channel>.<extension>.
bool isDumpFile(const std::filesystem::path& folder, const std::filesystem::path& path) {
  const std::string name = path.filename().string();
  const std::size_t dot = name.find('.');
  return path.parent_path() == folder && dot != name.rfind('.') &&
         FramePattern("%05d").numberOf(name.substr(0, dot)).has_value();
}

/// @throws UsageError where the dump would replace a painted frame or anything that is read.
void checkDump(const Options& options, const std::set<std::filesystem::path>& read,
               const std::vector<std::string>& painted) {
  const std::string option = "--dump-guides " + *options.dumpGuidesDirectory + ": ";
  for (const char* sequence : {"source", "target"}) {
    const std::string folder = dumpFolder(options, sequence);
    const std::filesystem::path resolved = canonical(folder);
    for (const std::filesystem::path& path : read) {
      if (!isDumpFile(resolved, path)) continue;
      throw UsageError(option + folder + "/" + path.filename().string() +
                       " is an input and would be overwritten; choose another folder");
    }
    for (const std::string& path : painted) {
      if (!isDumpFile(resolved, canonical(path))) continue;
      throw UsageError(option + path + " is a painted frame; choose another folder");
    }
  }
}

void createWritableFolder(const std::string& folder) {
  createFolder(folder);
  checkFolderWritable(folder);
}

/// The frames to be written: checked not to replace anything that is read, in a folder that exists
/// and can be written; likewise the folders of the dump.
std::vector<std::string> prepareOutput(const Options& options, const Inputs& inputs) {
  const FramePattern pattern(options.outPath);
  std::set<std::filesystem::path> read;
  for (const InputSequence* input : {&inputs.color, &inputs.sourceMask, &inputs.target}) {
    for (const std::string& path : input->files.paths) read.insert(canonical(path));
  }
  std::vector<std::string> paths;
  for (const int number : inputs.target.files.numbers) {
    paths.push_back(pattern.path(number));
    if (read.count(canonical(paths.back())) != 0) {
      throw UsageError("--out-path " + options.outPath + ": " + paths.back() +
                       " is an input and would be overwritten; choose another --out-path");
    }
  }
  if (options.dumpGuidesDirectory) checkDump(options, read, paths);

  createWritableFolder(pattern.folder());
  for (const std::string& path : paths) checkReplaceable(path);
  if (options.dumpGuidesDirectory) {
    createWritableFolder(dumpFolder(options, "source"));
    createWritableFolder(dumpFolder(options, "target"));
  }
  return paths;
}

Mask readMask(const std::string& path, Size size) {
  const Image<float> coverage = resize(readCoverage(path), size);
  Mask mask(size);
  std::transform(coverage.begin(), coverage.end(), mask.begin(),
                 [](float c) { return static_cast<std::uint8_t>(c >= kInsideCoverage ? 1 : 0); });
  return mask;
}

GuideStream guidesOf(const InputSequence& masks, const MaskOptions& maskOptions,
                     float timeBlurSigmaFrames) {
  return GuideStream(
      masks.files.count(),
      [&masks](int frame) {
        return readMask(masks.files.paths[static_cast<std::size_t>(frame)], masks.scaled);
      },
      GuideOptions{maskOptions, timeBlurSigmaFrames});
}

Exemplar readExemplar(const Options& options, const Inputs& inputs) {
  const Size size = inputs.color.scaled;
  Exemplar exemplar(size, inputs.color.files.count(), coarsestLevel(size, inputs.target.scaled),
                    options.synthesis.borderWidthPx);
  GuideStream guides = guidesOf(inputs.sourceMask, options.sourceMask, options.timeBlurSigmaFrames);
  bool anyInside = false;
  for (int k = 0; k < exemplar.frameCount(); ++k) {
    const auto i = static_cast<std::size_t>(k);
    const GuideFrame frame = guides.next();
    anyInside = anyInside || countInside(frame.mask) > 0;
    if (options.dumpGuidesDirectory) {
      dumpGuides(dumpFolder(options, "source"), inputs.color.files.numbers[i], frame);
    }
    exemplar.setFrame(k, toLab(resize(readColor(inputs.color.files.paths[i]), size)), frame);
  }
  if (!anyInside) {
    throw Error("--src-mask-path " + options.sourceMaskPath + ": all " +
                std::to_string(exemplar.frameCount()) +
                " masks are empty after smoothing with --blur-sigma; wanted some material, so "
                "check the masks or lower --blur-sigma");
  }
  exemplar.finish();
  return exemplar;
}

std::uint8_t eightBit(float channel) {
  return static_cast<std::uint8_t>(std::lround(std::clamp(channel, 0.0F, 1.0F) * 255.0F));
}

/// Straight alpha: painted and opaque inside the mask, fully transparent elsewhere.
Image<Rgba8> toOutput(const Image<Lab>& picture, const Mask& mask) {
  Image<Rgba8> output(picture.size());
  forEachRow(picture.height(), [&](int y) {
    for (int x = 0; x < picture.width(); ++x) {
      if (mask(x, y) == 0) continue;
      const Rgb color = toRgb(picture(x, y));
      output(x, y) = {eightBit(color.r), eightBit(color.g), eightBit(color.b), 255};
    }
  });
  return output;
}

}  // namespace

void stylize(const Options& options, const Observer& observer) {
  using Clock = std::chrono::steady_clock;
  omp_set_num_threads(options.threads);

  const Inputs inputs = openInputs(options, observer);
  const std::vector<std::string> outPaths = prepareOutput(options, inputs);
  const Exemplar exemplar = readExemplar(options, inputs);

  MaskOptions targetMask = options.sourceMask;
  targetMask.blurSigmaPx = options.targetBlurSigmaPx.value_or(targetMask.blurSigmaPx);
  GuideStream guides = guidesOf(inputs.target, targetMask, options.timeBlurSigmaFrames);
  Synthesizer synthesizer(exemplar, options.synthesis);

  for (int j = 0; j < guides.frameCount(); ++j) {
    const auto i = static_cast<std::size_t>(j);
    const Clock::time_point start = Clock::now();
    const GuideFrame frame = guides.next();
    const Image<Lab> picture = synthesizer.paint(frame);
    writePng(outPaths[i], toOutput(picture, frame.mask));
    const int number = inputs.target.files.numbers[i];
    if (options.dumpGuidesDirectory) {
      dumpGuides(dumpFolder(options, "target"), number, frame);
      dumpNearestNeighborField(dumpFolder(options, "target"), number, synthesizer.nnf(),
                               inputs.color.files.numbers, exemplar.level(0).size());
    }
    if (observer.frameDone) {
      const std::chrono::duration<double> spent = Clock::now() - start;
      observer.frameDone({j, guides.frameCount(), number, spent.count(), outPaths[i]});
    }
  }
}

}  // namespace fluidymation
