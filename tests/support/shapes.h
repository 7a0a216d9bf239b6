#pragma once

#include <cstdint>
#include <vector>

#include "fluidymation/guides/guide_frame.h"
#include "fluidymation/options.h"

namespace fluidymation::test {

/// The middle of a pixel.
[[nodiscard]] inline Vec2 place(int x, int y) {
  return {static_cast<float>(x), static_cast<float>(y)};
}

/// 1 where `inside(x, y)`.
template <typename Inside>
[[nodiscard]] Mask maskOf(Size size, const Inside& inside) {
  Mask mask(size);
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) mask(x, y) = inside(x, y) ? 1 : 0;
  }
  return mask;
}

/// Pixels nearer to `centre` than `radius`.
[[nodiscard]] Mask disc(Size size, Vec2 centre, float radius);

/// How much of each pixel lies within a disc, to one part in 1024.
[[nodiscard]] Image<float> softDisc(Size size, Vec2 centre, float radius);

/// How much of each pixel lies where dot(place - point, normal) > 0, exactly. `normal` has unit
/// length.
[[nodiscard]] Image<float> softHalfPlane(Size size, Vec2 point, Vec2 normal);

/// As an 8-bit file holds it.
[[nodiscard]] Image<float> eightBit(const Image<float>& coverage);

/// Each pixel inside with a chance of `percent` in a hundred.
[[nodiscard]] Mask randomMask(Size size, std::uint64_t seed, int percent);

/// A few random discs: larger parts than `randomMask` has, with holes, touching the edge at times.
[[nodiscard]] Mask randomBlobs(Size size, std::uint64_t seed);

template <typename T>
[[nodiscard]] Image<T> flippedX(const Image<T>& image) {
  Image<T> result(image.size());
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) result(x, y) = image(image.width() - 1 - x, y);
  }
  return result;
}

template <typename T>
[[nodiscard]] Image<T> transposed(const Image<T>& image) {
  Image<T> result(Size{image.height(), image.width()});
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) result(y, x) = image(x, y);
  }
  return result;
}

/// Guides of all frames of a sequence of masks.
[[nodiscard]] std::vector<GuideFrame> guidesWith(const std::vector<Mask>& masks,
                                                 const GuideOptions& options);

/// The same without spatial smoothing.
[[nodiscard]] std::vector<GuideFrame> guidesOf(const std::vector<Mask>& masks, float sigmaFrames,
                                               MotionModel model = MotionModel::kNormals);

/// The same for a sequence of soft masks.
[[nodiscard]] std::vector<GuideFrame> softGuidesOf(const std::vector<Image<float>>& coverages,
                                                   float sigmaFrames, float blurSigmaPx = 0.0F);

}  // namespace fluidymation::test
