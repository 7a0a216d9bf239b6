#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "fluidymation/core/geometry.h"
#include "fluidymation/synthesis/exemplar.h"
#include "fluidymation/synthesis/texel.h"
#include "synthesis/patch_kernels.h"

namespace fluidymation {

/// Four floats that the compiler keeps in one vector register (GCC and Clang, any architecture).
using Float4 = float __attribute__((vector_size(16)));

/// Weights of the four pixels at -1, 0, 1, 2 for a point at `t` in [0, 1] between the middle two:
/// Keys' cubic convolution with a = -1/2, Catmull-Rom's spline. They sum to 1.
[[nodiscard]] inline std::array<float, 4> cubicWeights(float t) {
  return {((-0.5F * t + 1.0F) * t - 0.5F) * t, (1.5F * t - 2.5F) * t * t + 1.0F,
          ((-1.5F * t + 2.0F) * t + 0.5F) * t, (0.5F * t - 0.5F) * t * t};
}

/// Weights of the two pixels round a point at `t` in [0, 1] between them.
[[nodiscard]] inline std::array<float, 2> linearWeights(float t) { return {1.0F - t, t}; }

/// L, a, b of one exemplar frame at a real position, CIELAB; the fourth lane means nothing. The
/// weighted mean of kTaps x kTaps pixels, those of the left upper one at `first` from the
/// position's own pixel. The position is clamped to the image, whose edge repeats. `weightsAt(t)`
/// are the weights along one axis for a position t in [0, 1) behind a pixel.
template <std::size_t kTaps, typename WeightsAt>
[[nodiscard]] inline Float4 sampleSeparably(const ExemplarLevel& exemplar, int frame, float x,
                                            float y, int first, const WeightsAt& weightsAt) {
  static_assert(kTaps / 2 < ExemplarLevel::kMarginPx);
  const Size size = exemplar.size();
  const float cx = std::clamp(x, 0.0F, static_cast<float>(size.width - 1));
  const float cy = std::clamp(y, 0.0F, static_cast<float>(size.height - 1));
  const int x0 = static_cast<int>(cx);
  const int y0 = static_cast<int>(cy);
  const std::array<float, kTaps> wx = weightsAt(cx - static_cast<float>(x0));
  const std::array<float, kTaps> wy = weightsAt(cy - static_cast<float>(y0));
  const std::array<float, 4> sum =
      exemplar.kernels().weightedGrid(&exemplar.texel(x0 + first, y0 + first, frame),
                                      exemplar.stride(), kTaps, wx.data(), wy.data());
  constexpr float kUnit = 1.0F / kColorSteps;
  return kUnit * Float4{sum[0], sum[1], sum[2], sum[3]};
}

/// See `sampleSeparably`; bilinear.
[[nodiscard]] inline Float4 sampleBilinear(const ExemplarLevel& exemplar, int frame, float x,
                                           float y) {
  return sampleSeparably<2>(exemplar, frame, x, y, 0, linearWeights);
}

/// See `sampleSeparably`; by cubic interpolation.
[[nodiscard]] inline Float4 sampleCubic(const ExemplarLevel& exemplar, int frame, float x,
                                        float y) {
  return sampleSeparably<4>(exemplar, frame, x, y, -1, cubicWeights);
}

/// Weights of Lanczos' interpolation, sinc(d) sinc(d / 3) for pixels nearer than 3 (Duchon 1979),
/// tabulated. They sum to 1.
class LanczosKernel {
 public:
  static constexpr int kLobes = 3;
  static constexpr std::size_t kTaps = std::size_t{2} * std::size_t{kLobes};

  LanczosKernel() {
    for (std::size_t p = 0; p < weights_.size(); ++p) {
      const double t = static_cast<double>(p) / kPhases;
      std::array<double, kTaps> weight{};
      double sum = 0.0;
      for (std::size_t i = 0; i < kTaps; ++i) {
        const double distance = static_cast<double>(i) - (kLobes - 1) - t;
        weight[i] = sinc(distance) * sinc(distance / kLobes);
        sum += weight[i];
      }
      for (std::size_t i = 0; i < kTaps; ++i) {
        weights_[p][i] = static_cast<float>(weight[i] / sum);
      }
    }
  }

  /// For a position t in [0, 1] behind the third pixel, to 1/512 px.
  [[nodiscard]] const std::array<float, kTaps>& operator()(float t) const {
    return weights_[static_cast<std::size_t>(std::lround(t * kPhases))];
  }

 private:
  static constexpr int kPhases = 256;

  static double sinc(double x) {
    constexpr double kPi = 3.14159265358979323846;
    return x == 0.0 ? 1.0 : std::sin(kPi * x) / (kPi * x);
  }

  std::array<std::array<float, kTaps>, kPhases + 1> weights_{};
};

/// See `sampleSeparably`; by Lanczos' interpolation.
[[nodiscard]] inline Float4 sampleLanczos(const LanczosKernel& kernel,
                                          const ExemplarLevel& exemplar, int frame, float x,
                                          float y) {
  return sampleSeparably<LanczosKernel::kTaps>(exemplar, frame, x, y, 1 - LanczosKernel::kLobes,
                                               kernel);
}

}  // namespace fluidymation
