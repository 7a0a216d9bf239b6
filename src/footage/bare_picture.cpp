#include "footage/bare_picture.h"

#include <algorithm>
#include <cassert>
#include <cstddef>

#include "compositing/bare_surface.h"
#include "fluidymation/core/index.h"
#include "fluidymation/core/parallel.h"

namespace fluidymation {
namespace {

/// Changes the order of the values.
[[nodiscard]] float medianOf(std::vector<float>& values) {
  const auto half = static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), values.begin() + half, values.end());
  const float upper = values[static_cast<std::size_t>(half)];
  if (values.size() % 2 == 1) return upper;
  constexpr float kMean = 0.5F;
  return kMean * (upper + *std::max_element(values.begin(), values.begin() + half));
}

}  // namespace

Image<Rgb> medianPicture(const std::vector<Image<Rgb>>& pictures) {
  assert(!pictures.empty());
  if (pictures.size() == 1) return pictures.front().clone();
  Image<Rgb> median(pictures.front().size());
  forEachRow(median.height(), [&](int y) {
    std::vector<float> values(pictures.size());
    for (int x = 0; x < median.width(); ++x) {
      for (float Rgb::*const channel : {&Rgb::r, &Rgb::g, &Rgb::b}) {
        for (std::size_t i = 0; i < pictures.size(); ++i) values[i] = pictures[i](x, y).*channel;
        median(x, y).*channel = medianOf(values);
      }
    }
  });
  return median;
}

std::optional<Image<Rgb>> withoutPaint(const Image<Rgb>& picture, const Image<float>& paint) {
  BareSurface surface(picture.size());
  surface.add(picture, paint);
  if (!surface.known()) return std::nullopt;
  return surface.filled();
}

}  // namespace fluidymation
