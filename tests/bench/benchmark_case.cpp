#include "bench/benchmark_case.h"

#include <algorithm>
#include <numeric>

#include "fluidymation/automatic.h"
#include "fluidymation/core/error.h"
#include "fluidymation/core/resize.h"
#include "fluidymation/guides/guide_stream.h"
#include "fluidymation/io/frame_sequence.h"
#include "fluidymation/io/png.h"

namespace fluidymation::bench {
namespace {

/// The files of the first frames of a sample.
std::vector<std::string> sampleFiles(const std::string& folder, int frames) {
  SequenceOptions sequence;
  sequence.path = folder + "/%05d.png";
  sequence.frames = frames;
  FrameFiles files = findFrames(FramePattern(sequence.path), sequence, "--samples");
  if (files.count() < frames) {
    throw Error(folder + ": " + std::to_string(files.count()) + " frames; wanted " +
                std::to_string(frames));
  }
  return files.paths;
}

std::vector<InputMask> readMasks(const std::vector<std::string>& files, Size size) {
  std::vector<InputMask> masks;
  for (const std::string& path : files) masks.push_back(readMask(path, size));
  return masks;
}

/// As the tool smooths masks where nothing is said.
MaskOptions automaticMaskOptions(const std::vector<InputMask>& masks, const Options& options) {
  std::vector<double> areas;
  for (const InputMask& mask : masks) {
    areas.push_back(std::accumulate(mask.coverage.begin(), mask.coverage.end(), 0.0));
  }
  return {automaticBlurSigmaPx(areas), options.maskThreshold};
}

GuideOptions guideOptions(const std::vector<InputMask>& masks, const Options& options) {
  GuideOptions guides;
  guides.mask = automaticMaskOptions(masks, options);
  guides.timeBlurSigmaFrames = options.timeBlurSigmaFrames;
  return guides;
}

}  // namespace

const std::vector<BenchmarkCase>& benchmarkCases() {
  static const std::vector<BenchmarkCase> cases = {
      {"genie", "ink", {400, 120}, 30, "genie", {900, 900}, "01 + genie", 123'000, 3.48},
      {"horse", "watercolour", {400, 222}, 20, "horse", {1000, 800}, "02 + horse", 111'000, 2.89},
      {"sunflower",
       "rust",
       {200, 200},
       20,
       "sunflower",
       {500, 600},
       "03 + sunflower",
       60'000,
       1.33},
      {"waving", "ink", {160, 149}, 20, "waving", {640, 740}, "05 + waving", 80'000, 2.62},
      {"jump", "rust", {225, 94}, 20, "jump", {700, 300}, "06 + jump", 12'000, 0.55},
  };
  return cases;
}

InputMask readMask(const std::string& path, Size size) {
  // The samples' masks are black and white.
  return {resize(readCoverage(path, MaskChannel::kBrightness), size), false};
}

LoadedCase load(const BenchmarkCase& benchmarkCase, const std::string& samples, int frames,
                double scale) {
  const Options options;
  const Size size = scaledSize(benchmarkCase.exemplarSize, scale);
  const Size targetSize = scaledSize(benchmarkCase.targetSize, scale);
  const std::string source = samples + "/source/" + benchmarkCase.exemplar;

  const std::vector<InputMask> masks =
      readMasks(sampleFiles(source + "/mask", benchmarkCase.exemplarFrames), size);
  GuideStream guides(
      benchmarkCase.exemplarFrames,
      [&](int k) {
        const InputMask& mask = masks[static_cast<std::size_t>(k)];
        return InputMask(mask.coverage.clone(), mask.soft);
      },
      guideOptions(masks, options));
  Exemplar exemplar(size, benchmarkCase.exemplarFrames, coarsestLevel(size, targetSize),
                    automaticBorderWidthPx(size), options.synthesis.shape);
  const std::vector<std::string> pictures =
      sampleFiles(source + "/rgb", benchmarkCase.exemplarFrames);
  for (int k = 0; k < benchmarkCase.exemplarFrames; ++k) {
    exemplar.setColor(k, toLab(resize(readColor(pictures[static_cast<std::size_t>(k)]), size)));
    exemplar.setGuides(k, guides.next());
  }
  exemplar.finish(options.synthesis.extentUnit);

  std::vector<std::string> targetFiles =
      sampleFiles(samples + "/target-mask/" + benchmarkCase.target, frames);
  const GuideOptions targetGuides = guideOptions(readMasks(targetFiles, targetSize), options);
  return {std::move(exemplar), std::move(targetFiles), targetSize, targetGuides, options.synthesis};
}

}  // namespace fluidymation::bench
