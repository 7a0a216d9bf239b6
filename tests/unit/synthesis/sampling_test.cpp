#include "synthesis/sampling.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "one_frame_exemplar.h"
#include "support/fixed_point.h"
#include "support/synthetic_scene.h"

namespace fluidymation {
namespace {

/// An exemplar whose lightness is `value(x, y)`, to half a step of its fixed point.
template <typename Value>
ExemplarLevel withLightness(Size size, const Value& value) {
  Image<Lab> color(size);
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      color(x, y).l = value(static_cast<float>(x), static_cast<float>(y));
    }
  }
  return oneFrame(color);
}

TEST(CubicSampling, ReproducesQuadraticsAndPassesThroughThePixels) {
  const auto value = [](float x, float y) { return 0.3F * x * x - 0.2F * x * y + y - 2.0F; };
  const ExemplarLevel exemplar = withLightness({12, 10}, value);
  // Half a step per pixel, times the sum of the weights' sizes, 1.25 at most along either axis
  constexpr float kTolerance = 0.5F / kColorSteps * 1.25F * 1.25F + 1e-4F;
  for (const auto& [x, y] : {std::pair{1.0F, 1.0F}, {3.25F, 4.5F}, {9.9F, 7.75F}, {5.0F, 2.5F}}) {
    EXPECT_NEAR(sampleCubic(exemplar, 0, x, y)[0], value(x, y), kTolerance) << x << ", " << y;
  }
  // Past the image the edge repeats
  EXPECT_EQ(sampleCubic(exemplar, 0, -3.0F, -3.0F)[0], sampleCubic(exemplar, 0, 0.0F, 0.0F)[0]);
}

/// Largest error between the pixels of a row that holds a wave with this many periods per px, away
/// from its ends, relative to the wave.
template <typename Sample>
float errorOn(float frequency, const Sample& sample) {
  constexpr float kPi = 3.14159265F;
  constexpr float kAmplitude = 100.0F;  // half a step of the fixed point is 4e-5 of it
  const auto wave = [frequency](float x) { return std::cos(2.0F * kPi * frequency * x); };
  const ExemplarLevel exemplar =
      withLightness({64, 1}, [&](float x, float) { return kAmplitude * wave(x); });
  float worst = 0.0F;
  for (float x = 20.0F; x < 44.0F; x += 0.125F) {
    worst = std::max(worst, std::abs(sample(exemplar, x)[0] / kAmplitude - wave(x)));
  }
  return worst;
}

TEST(LanczosSampling, KeepsFineDetailBetterThanCubic) {
  const LanczosKernel kernel;
  const auto lanczos = [&](const ExemplarLevel& exemplar, float x) {
    return sampleLanczos(kernel, exemplar, 0, x, 0.0F);
  };
  const auto cubic = [](const ExemplarLevel& exemplar, float x) {
    return sampleCubic(exemplar, 0, x, 0.0F);
  };
  for (const float frequency : {0.2F, 0.25F, 0.3F, 0.35F}) {
    EXPECT_LT(errorOn(frequency, lanczos), 0.7F * errorOn(frequency, cubic)) << frequency;
  }
  EXPECT_LT(errorOn(0.25F, lanczos), 0.06F);
  EXPECT_LT(errorOn(0.0F, lanczos), 1e-6F);
}

TEST(LanczosSampling, PassesThroughThePixelsAndRepeatsTheEdge) {
  const LanczosKernel kernel;
  const Size size{12, 10};
  const ExemplarLevel exemplar = oneFrame(test::randomTexture(size, 5));
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      EXPECT_NEAR(
          sampleLanczos(kernel, exemplar, 0, static_cast<float>(x), static_cast<float>(y))[0],
          test::channelAt(exemplar, x, y, 0, kLightness), 1e-4F);
    }
  }
  EXPECT_EQ(sampleLanczos(kernel, exemplar, 0, -3.0F, 20.0F)[0],
            sampleLanczos(kernel, exemplar, 0, 0.0F, 9.0F)[0]);
}

}  // namespace
}  // namespace fluidymation
