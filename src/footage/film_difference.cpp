#include "footage/film_difference.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <vector>

#include "fluidymation/core/parallel.h"
#include "fluidymation/guides/gaussian.h"

namespace fluidymation {
namespace {

/// One channel of what differs, averaged.
[[nodiscard]] Image<float> averagedChannel(const Image<Lab>& frame, const Image<Lab>& bare,
                                           float Lab::*channel, float grainSigmaPx) {
  Image<float> difference(frame.size());
  for (std::size_t i = 0; i < difference.pixelCount(); ++i) {
    difference.data()[i] = frame.data()[i].*channel - bare.data()[i].*channel;
  }
  return gaussianBlur(difference, grainSigmaPx);
}

/// Standard deviation of the grain in what differs in one channel.
[[nodiscard]] double grainOf(const Image<Lab>& frame, const Image<Lab>& bare, float Lab::*channel) {
  std::vector<float> steps;
  steps.reserve(frame.pixelCount());
  for (int y = 0; y < frame.height(); ++y) {
    for (int x = 1; x < frame.width(); ++x) {
      const float here = frame(x, y).*channel - bare(x, y).*channel;
      const float before = frame(x - 1, y).*channel - bare(x - 1, y).*channel;
      steps.push_back(std::abs(here - before));
    }
  }
  if (steps.empty()) return 0.0;
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  constexpr double kMedianOfNormal = 0.6745;  // of the absolute value, in standard deviations
  return *middle / (kMedianOfNormal * std::sqrt(2.0));
}

}  // namespace

float grainLevel(const Image<Lab>& frame, const Image<Lab>& bare, float grainSigmaPx) {
  assert(frame.size() == bare.size());
  double square = 0.0;
  for (float Lab::*const channel : {&Lab::l, &Lab::a, &Lab::b}) {
    const double grain = grainOf(frame, bare, channel);
    square += grain * grain;
  }
  const std::vector<float> kernel = gaussianKernel(grainSigmaPx);
  double squaredWeights = 0.0;
  for (std::size_t i = 0; i < kernel.size(); ++i) {
    squaredWeights += (i == 0 ? 1.0 : 2.0) * kernel[i] * kernel[i];
  }
  // Averaged along x and along y
  return static_cast<float>(std::sqrt(square) * squaredWeights);
}

Image<float> filmDifference(const Image<Lab>& frame, const Image<Lab>& bare, float grainSigmaPx) {
  assert(frame.size() == bare.size());
  Image<float> squares(frame.size(), 0.0F);
  for (float Lab::*const channel : {&Lab::l, &Lab::a, &Lab::b}) {
    const Image<float> averaged = averagedChannel(frame, bare, channel, grainSigmaPx);
    for (std::size_t i = 0; i < squares.pixelCount(); ++i) {
      squares.data()[i] += averaged.data()[i] * averaged.data()[i];
    }
  }
  forEachRow(squares.height(), [&](int y) {
    for (int x = 0; x < squares.width(); ++x) squares(x, y) = std::sqrt(squares(x, y));
  });
  return squares;
}

}  // namespace fluidymation
