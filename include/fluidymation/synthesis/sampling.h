#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "fluidymation/core/geometry.h"
#include "fluidymation/synthesis/lanes.h"

namespace fluidymation {

/// Bilinear interpolation between the four pixels round a point. `top` and `bottom` point at the
/// left one of each pair, `right` is the distance to the right one (0 at the image edge).
[[nodiscard]] inline Lanes interpolate(const Lanes* top, const Lanes* bottom, std::ptrdiff_t right,
                                       float fx, float fy) {
  const float w11 = fx * fy;
  const float w10 = fx - w11;  // right, top
  const float w01 = fy - w11;  // left, bottom
  const float w00 = 1.0F - fx - w01;
  return {
      top[0].low * w00 + top[right].low * w10 + bottom[0].low * w01 + bottom[right].low * w11,
      top[0].high * w00 + top[right].high * w10 + bottom[0].high * w01 + bottom[right].high * w11};
}

/// Value of one exemplar frame (`size`, row-major) at a real position, clamped to the image.
[[nodiscard]] inline Lanes sampleClamped(const Lanes* frame, Size size, float x, float y) {
  const float cx = std::clamp(x, 0.0F, static_cast<float>(size.width - 1));
  const float cy = std::clamp(y, 0.0F, static_cast<float>(size.height - 1));
  const int x0 = static_cast<int>(cx);
  const int y0 = static_cast<int>(cy);
  const std::ptrdiff_t right = x0 + 1 < size.width ? 1 : 0;
  const std::ptrdiff_t down = y0 + 1 < size.height ? size.width : 0;
  const Lanes* top = frame + static_cast<std::ptrdiff_t>(y0) * size.width + x0;
  return interpolate(top, top + down, right, cx - static_cast<float>(x0),
                     cy - static_cast<float>(y0));
}

/// The same for a position known to have all four neighbours in the image.
[[nodiscard]] inline Lanes sampleInside(const Lanes* frame, int width, float x, float y) {
  const int x0 = static_cast<int>(x);
  const int y0 = static_cast<int>(y);
  const Lanes* top = frame + static_cast<std::ptrdiff_t>(y0) * width + x0;
  return interpolate(top, top + width, 1, x - static_cast<float>(x0), y - static_cast<float>(y0));
}

/// Weights of the four pixels at -1, 0, 1, 2 for a point at `t` in [0, 1] between the middle two:
/// Keys' cubic convolution with a = -1/2, Catmull-Rom's spline. They sum to 1.
[[nodiscard]] inline std::array<float, 4> cubicWeights(float t) {
  return {((-0.5F * t + 1.0F) * t - 0.5F) * t, (1.5F * t - 2.5F) * t * t + 1.0F,
          ((-1.5F * t + 2.0F) * t + 0.5F) * t, (0.5F * t - 0.5F) * t * t};
}

/// L, a, b and edge of one exemplar frame at a real position: the weighted mean of kTaps x kTaps
/// pixels, those of the left upper one at `first` from the position's own pixel. The position is
/// clamped to the image, whose edge repeats. `weightsAt(t)` are the weights along one axis for a
/// position t in [0, 1) behind a pixel.
template <std::size_t kTaps, typename WeightsAt>
[[nodiscard]] inline Float4 sampleSeparably(const Lanes* frame, Size size, float x, float y,
                                            int first, const WeightsAt& weightsAt) {
  const float cx = std::clamp(x, 0.0F, static_cast<float>(size.width - 1));
  const float cy = std::clamp(y, 0.0F, static_cast<float>(size.height - 1));
  const int x0 = static_cast<int>(cx);
  const int y0 = static_cast<int>(cy);
  const std::array<float, kTaps> wx = weightsAt(cx - static_cast<float>(x0));
  const std::array<float, kTaps> wy = weightsAt(cy - static_cast<float>(y0));
  Float4 sum{};
  for (std::size_t j = 0; j < kTaps; ++j) {
    const int row = std::clamp(y0 + first + static_cast<int>(j), 0, size.height - 1);
    const Lanes* pixels = frame + static_cast<std::ptrdiff_t>(row) * size.width;
    Float4 along{};
    for (std::size_t i = 0; i < kTaps; ++i) {
      const int column = std::clamp(x0 + first + static_cast<int>(i), 0, size.width - 1);
      along += wx[i] * pixels[column].low;
    }
    sum += wy[j] * along;
  }
  return sum;
}

/// See `sampleSeparably`; by cubic interpolation.
[[nodiscard]] inline Float4 sampleCubic(const Lanes* frame, Size size, float x, float y) {
  return sampleSeparably<4>(frame, size, x, y, -1, cubicWeights);
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
[[nodiscard]] inline Float4 sampleLanczos(const LanczosKernel& kernel, const Lanes* frame,
                                          Size size, float x, float y) {
  return sampleSeparably<LanczosKernel::kTaps>(frame, size, x, y, 1 - LanczosKernel::kLobes,
                                               kernel);
}

}  // namespace fluidymation
