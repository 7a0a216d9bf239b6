#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <cstring>
#include <vector>

#include "fluidymation/presets.h"
#include "fluidymation/synthesis/synthesizer.h"
#include "support/synthetic_scene.h"

namespace fluidymation {

inline constexpr float kBorderWidthPx = 5.0F;

inline SynthesisOptions smallOptions() {
  Options thesis;
  applyThesisPreset(thesis);  // what the standard look changes has tests of its own
  SynthesisOptions options = thesis.synthesis;
  options.prevModulation = {5.0F, 1.0F, ModulationUnit::kPixels};
  return options;
}

inline std::vector<Image<Lab>> paintAll(const Exemplar& exemplar, const test::GrowingDisc& target,
                                        const SynthesisOptions& options) {
  Synthesizer synthesizer(exemplar, options);
  std::vector<Image<Lab>> frames;
  for (int j = 0; j < target.frameCount; ++j) frames.push_back(synthesizer.paint(target.guides(j)));
  return frames;
}

inline bool equalBytes(const std::vector<Image<Lab>>& a, const std::vector<Image<Lab>>& b) {
  for (std::size_t j = 0; j < a.size(); ++j) {
    if (std::memcmp(a[j].data(), b[j].data(), a[j].pixelCount() * sizeof(Lab)) != 0) return false;
  }
  return a.size() == b.size();
}

inline bool sameBytes(const Image<Lab>& a, const Image<Lab>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.pixelCount() * sizeof(Lab)) == 0;
}

inline bool sameBytes(const NearestNeighborField& a, const NearestNeighborField& b) {
  return a.size() == b.size() &&
         std::memcmp(a.data(), b.data(), a.pixelCount() * sizeof(Match)) == 0;
}

class SynthesizerTest : public ::testing::Test {
 protected:
  test::GrowingDisc disc_{Size{72, 64}, {36.0F, 32.0F}, 14.0F, 1.0F, 6};
  test::GrowingDisc other_{Size{90, 80}, {45.0F, 40.0F}, 20.0F, 1.5F, 4};
};

}  // namespace fluidymation
