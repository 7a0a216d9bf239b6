#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "fluidymation/core/geometry.h"
#include "fluidymation/synthesis/exemplar.h"
#include "fluidymation/synthesis/nnf.h"
#include "fluidymation/synthesis/patch_distance.h"
#include "fluidymation/synthesis/texel.h"
#include "synthesis/sample_order.h"

namespace fluidymation {

/// A window in the exemplar: sample o of the target's window lies at the window's centre +
/// R_-theta o, and all pixels round it that bilinear interpolation reads are there.
struct SourceWindow {
  /// How far the first pixel read may lie left of and above the pixel nearest to the centre: a
  /// turned window reaches 2.83 px, and the centre lies at most half a pixel beside its pixel.
  static constexpr int kOriginPx = 4;
  static_assert(kOriginPx < ExemplarLevel::kMarginPx);

  const Texel* origin = nullptr;  ///< kOriginPx left of and above the pixel nearest to the centre
  std::int32_t stride = 0;        ///< texels from row to row
  float x = 0.0F;                 ///< of the centre from `origin`, px, kOriginPx +- 1/2
  float y = 0.0F;
  Rotation rotation;
};

/// Of a match whose nearest pixel is in the image.
[[nodiscard]] inline SourceWindow sourceWindow(const ExemplarLevel& exemplar, const Match& match) {
  const int left = match.nearestX() - SourceWindow::kOriginPx;
  const int top = match.nearestY() - SourceWindow::kOriginPx;
  return {&exemplar.texel(left, top, match.frame), exemplar.stride(),
          match.x - static_cast<float>(left), match.y - static_cast<float>(top), match.rotation};
}

/// How much the samples of a window count, in the order of kSampleOffsets.
struct SampleWeights {
  std::array<std::int32_t, kPatchArea> ofSample{};
  /// Whether any sample of a block counts; the last one, the window's own pixel, always does.
  std::array<bool, kSampleBlocks> blockCounts{};
};

/// Where the colours of one window are added up: four sums (L, a, b in FixedLab's steps, weight)
/// for each of its samples, in the order of kSampleOffsets.
struct WindowSums {
  std::int32_t* centre = nullptr;           ///< of the window's own pixel
  const std::ptrdiff_t* offsets = nullptr;  ///< of kPatchArea samples from there
  const SampleWeights* weights = nullptr;   ///< never null where colours are added
};

/// What a target window is made of: images of one size, and weights of squared steps.
struct WindowSource {
  const FixedLab* picture = nullptr;   ///< at the window's centre
  const FixedLab* previous = nullptr;  ///< likewise
  const FixedGuides* guides = nullptr;
  /// Of the samples from the centre, in the order of kSampleOffsets; one more, see TargetWindow.
  const std::int32_t* offsets = nullptr;
};

/// Weights of squared steps in a window; the colours' still to be divided by the number of pixels
/// that have one.
struct WindowWeights {
  float color = 0.0F;
  float previous = 0.0F;
  float dist = 0.0F;
  float flow = 0.0F;

  /// Of one pixel's colours, where so many of the window have a colour, or a previous one.
  [[nodiscard]] float ofColor(int colored) const {
    return colored == 0 ? 0.0F : color / static_cast<float>(colored);
  }
  [[nodiscard]] float ofPrevious(int remembered) const {
    return remembered == 0 ? 0.0F : previous / static_cast<float>(remembered);
  }
};

/// The share of the previous colour in the blend, in steps of 1 / 2^15.
[[nodiscard]] inline std::int16_t blendShare(float colorWeight, float previousWeight) {
  const float both = colorWeight + previousWeight;
  if (!(both > 0.0F)) return 0;
  constexpr float kWhole = 32767.0F;
  const float upToHalfMore = kWhole * (previousWeight / both) + 0.5F;
  return static_cast<std::int16_t>(floorToInt(upToHalfMore));
}

/// The inner loops of the synthesis for one instruction set. All give the same bytes: positions
/// and distances are computed in single precision in one order, and what lies between is integer.
struct PatchKernels {
  const char* name;

  /// window.constant + the weighted squares of the differences between `wanted` and the source
  /// window. Stops once it reaches `stopAt` and then returns what it has.
  /// @param wanted    `window.value` or `window.swapped`.
  /// @param samples   is set to the number of samples compared.
  float (*distance)(const TargetWindow& window, const Texel* wanted, const SourceWindow& source,
                    float stopAt, int& samples);

  /// The distances of a source window and of the same one given a half turn, which reads the same
  /// samples: `upright` is compared as by `distance`, `turned` with the samples exchanged. Stops
  /// once both reach `stopAt`.
  /// @return  of the source window, of the turned one; each as `distance` gives it.
  std::array<float, 2> (*bothDistances)(const TargetWindow& window, const Texel* upright,
                                        const Texel* turned, const SourceWindow& source,
                                        float stopAt, int& samples);

  /// Fills value, swapped, weight and constant of `window`.
  void (*gather)(const WindowSource& source, const WindowWeights& weights, TargetWindow& window);

  /// The sum of a grid of `taps` x `taps` colours, each weighted by its column and its row: L, a, b
  /// in FixedLab's steps, and the weights' own sum.
  /// @param first   the left upper one; `stride` texels from row to row.
  std::array<float, 4> (*weightedGrid)(const Texel* first, std::ptrdiff_t stride, std::size_t taps,
                                       const float* columnWeights, const float* rowWeights);

  /// Adds the source window's colours, each times its weight, to `sums`.
  void (*addColors)(const SourceWindow& source, const WindowSums& sums);
};

[[nodiscard]] const PatchKernels& portableKernels();
/// Null where the build or the processor lacks the instructions.
[[nodiscard]] const PatchKernels* avx2Kernels();
/// The fastest that this processor runs.
[[nodiscard]] const PatchKernels& bestKernels();

}  // namespace fluidymation
