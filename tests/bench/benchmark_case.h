#pragma once

#include <string>
#include <vector>

#include "fluidymation/core/geometry.h"
#include "fluidymation/guides/input_mask.h"
#include "fluidymation/options.h"
#include "fluidymation/synthesis/exemplar.h"

namespace fluidymation::bench {

/// A row of the paper's table 2 and the bundled samples that stand in for its exemplar and target.
struct BenchmarkCase {
  std::string name;
  std::string exemplar;  ///< folder of samples/source
  Size exemplarSize;
  int exemplarFrames = 0;
  std::string target;  ///< folder of samples/target-mask
  Size targetSize;
  std::string paperRow;
  int paperMaskPixels = 0;    ///< inside the mask, mean over the sequence
  double paperSeconds = 0.0;  ///< a frame
};

[[nodiscard]] const std::vector<BenchmarkCase>& benchmarkCases();

/// A case ready to be painted, by the standard look.
struct LoadedCase {
  Exemplar exemplar;
  std::vector<std::string> targetFiles;  ///< masks
  Size targetSize;                       ///< to scale them to
  GuideOptions targetGuides;
  SynthesisOptions synthesis;
};

/// Reads a sample's mask and scales it.
[[nodiscard]] InputMask readMask(const std::string& path, Size size);

/// Reads the samples and scales them to the case's sizes, with its proportions, times `scale`.
/// @param samples  folder that holds source/ and target-mask/.
/// @param frames   of the target.
/// @throws Error naming the file or option.
[[nodiscard]] LoadedCase load(const BenchmarkCase& benchmarkCase, const std::string& samples,
                              int frames, double scale);

}  // namespace fluidymation::bench
