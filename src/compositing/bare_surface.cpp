#include "compositing/bare_surface.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <tuple>

#include "compositing/quilt.h"
#include "fluidymation/core/box.h"
#include "fluidymation/core/resize.h"

namespace fluidymation {
namespace {

[[nodiscard]] Rgb plus(Rgb a, Rgb b) { return {a.r + b.r, a.g + b.g, a.b + b.b}; }
[[nodiscard]] Rgb minus(Rgb a, Rgb b) { return {a.r - b.r, a.g - b.g, a.b - b.b}; }
[[nodiscard]] Rgb times(float s, Rgb a) { return {s * a.r, s * a.g, s * a.b}; }

/// What lies within `radius` pixels, along x and y, of a pixel with any coverage.
[[nodiscard]] Mask grownMask(const Image<float>& coverage, int radius) {
  const auto grownAlong = [radius](const Mask& mask, bool alongX) {
    Mask result(mask.size());
    const int length = alongX ? mask.width() : mask.height();
    for (int line = 0; line < (alongX ? mask.height() : mask.width()); ++line) {
      int until = -1;  // covered up to here
      const auto pixel = [&](auto& image, int i) -> auto& {
        return alongX ? image(i, line) : image(line, i);
      };
      for (int i = 0; i < length + radius; ++i) {
        if (i < length && pixel(mask, i) != 0) until = i + 2 * radius;
        const int place = i - radius;
        if (place >= 0 && i <= until) pixel(result, place) = 1;
      }
    }
    return result;
  };
  Mask mask(coverage.size());
  std::transform(coverage.begin(), coverage.end(), mask.begin(),
                 [](float c) { return static_cast<std::uint8_t>(c > 0.0F ? 1 : 0); });
  return grownAlong(grownAlong(mask, true), false);
}

/// Gives unknown pixels (weight 0) the mean of known ones around: means of blocks of 2x2, from
/// level to level, until all is known.
void fillSmoothly(Image<Rgb>& colors, const Image<float>& weights) {
  const bool complete =
      std::all_of(weights.begin(), weights.end(), [](float w) { return w > 0.0F; });
  if (complete) return;
  const Size half{(colors.width() + 1) / 2, (colors.height() + 1) / 2};
  Image<Rgb> means(half);
  Image<float> known(half, 0.0F);
  for (int y = 0; y < colors.height(); ++y) {
    for (int x = 0; x < colors.width(); ++x) {
      if (weights(x, y) <= 0.0F) continue;
      means(x / 2, y / 2) = plus(means(x / 2, y / 2), colors(x, y));
      known(x / 2, y / 2) += 1.0F;
    }
  }
  for (std::size_t i = 0; i < means.pixelCount(); ++i) {
    if (known.data()[i] > 0.0F) means.data()[i] = times(1.0F / known.data()[i], means.data()[i]);
  }
  fillSmoothly(means, known);
  const Image<Rgb> enlarged = resize(means, colors.size());
  for (std::size_t i = 0; i < colors.pixelCount(); ++i) {
    if (weights.data()[i] <= 0.0F) colors.data()[i] = enlarged.data()[i];
  }
}

/// The shading: all that is larger than some pixels.
[[nodiscard]] Image<Rgb> shadingOf(const Image<Rgb>& image) {
  constexpr double kShare = 1.0 / 16.0;
  return resize(resize(image, scaledSize(image.size(), kShare)), image.size());
}

/// Steps to look for a bare place, nearest first.
[[nodiscard]] std::vector<Pixel> stepsFor(Size size) {
  constexpr int kStepsAlong = 24;
  constexpr int kLeastStepPx = 4;
  const int step = std::max(kLeastStepPx, std::max(size.width, size.height) / kStepsAlong);
  std::vector<Pixel> steps;
  for (int y = -size.height / step * step; y < size.height; y += step) {
    for (int x = -size.width / step * step; x < size.width; x += step) steps.push_back({x, y});
  }
  const auto order = [](Pixel p) {
    return std::tuple{std::int64_t{p.x} * p.x + std::int64_t{p.y} * p.y, p.y, p.x};
  };
  std::sort(steps.begin(), steps.end(), [&](Pixel a, Pixel b) { return order(a) < order(b); });
  return steps;
}

/// Summed up in double: the sum of a large picture has no room for single pixels in float.
[[nodiscard]] Rgb meanOf(const Image<Rgb>& image) {
  double r = 0.0;
  double g = 0.0;
  double b = 0.0;
  for (const Rgb color : image) {
    r += static_cast<double>(color.r);
    g += static_cast<double>(color.g);
    b += static_cast<double>(color.b);
  }
  const double share = 1.0 / static_cast<double>(image.pixelCount());
  return {static_cast<float>(share * r), static_cast<float>(share * g),
          static_cast<float>(share * b)};
}

/// With the mean colour everywhere, as far as structures larger than some pixels go.
[[nodiscard]] Image<Rgb> withoutShading(const Image<Rgb>& image) {
  Image<Rgb> result = shadingOf(image);
  const Rgb mean = meanOf(result);
  for (std::size_t i = 0; i < result.pixelCount(); ++i) {
    result.data()[i] = plus(mean, minus(image.data()[i], result.data()[i]));
  }
  return result;
}

/// Of any size: mirrored at its sides again and again.
[[nodiscard]] Image<Rgb> mirrored(const Image<Rgb>& image, Size size) {
  const auto inside = [](int i, int length) {
    const int place = i % (2 * length);
    return place < length ? place : 2 * length - 1 - place;
  };
  Image<Rgb> result(size);
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      result(x, y) = image(inside(x, image.width()), inside(y, image.height()));
    }
  }
  return result;
}

}  // namespace

void BareSurface::add(const Image<Rgb>& picture, const Image<float>& coverage) {
  assert(picture.size() == sum_.size() && coverage.size() == sum_.size());
  constexpr int kLeastMarginPx = 4;
  constexpr int kSidesPerMargin = 50;  // 8 px of 400
  const int margin =
      std::max(kLeastMarginPx, std::max(picture.width(), picture.height()) / kSidesPerMargin);
  const Mask covered = grownMask(coverage, margin);
  for (std::size_t i = 0; i < sum_.pixelCount(); ++i) {
    if (covered.data()[i] != 0) continue;
    sum_.data()[i] = plus(sum_.data()[i], picture.data()[i]);
    count_.data()[i] += 1.0F;
  }
}

bool BareSurface::known() const {
  return std::any_of(count_.begin(), count_.end(), [](float c) { return c > 0.0F; });
}

Image<Rgb> BareSurface::filled() const {
  assert(known());
  Image<Rgb> colors(sum_.size());
  for (std::size_t i = 0; i < colors.pixelCount(); ++i) {
    if (count_.data()[i] > 0.0F) colors.data()[i] = times(1.0F / count_.data()[i], sum_.data()[i]);
  }
  fillSmoothly(colors, count_);
  const Image<Rgb> shading = shadingOf(colors);
  const std::vector<Pixel> steps = stepsFor(colors.size());
  Image<Rgb> result = colors.clone();
  for (int y = 0; y < colors.height(); ++y) {
    for (int x = 0; x < colors.width(); ++x) {
      if (count_(x, y) > 0.0F) continue;
      const auto step = std::find_if(steps.begin(), steps.end(), [&](Pixel s) {
        return count_.contains(x + s.x, y + s.y) && count_(x + s.x, y + s.y) > 0.0F;
      });
      if (step == steps.end()) continue;  // smooth, as it is
      const int sourceX = x + step->x;
      const int sourceY = y + step->y;
      result(x, y) =
          plus(shading(x, y), minus(colors(sourceX, sourceY), shading(sourceX, sourceY)));
    }
  }
  return result;
}

Mask BareSurface::bareFor(float share) const {
  const float least = share * *std::max_element(count_.begin(), count_.end());
  Mask bare(count_.size());
  std::transform(count_.begin(), count_.end(), bare.begin(), [least](float count) {
    return static_cast<std::uint8_t>(count > 0.0F && count >= least ? 1 : 0);
  });
  return bare;
}

Image<Rgb> BareSurface::spread(Size size) const {
  const Image<Rgb> surface = filled();
  if (surface.width() >= size.width && surface.height() >= size.height) {
    const int left = (surface.width() - size.width) / 2;
    const int top = (surface.height() - size.height) / 2;
    return cropped(surface, {left, top, left + size.width, top + size.height});
  }
  const Image<Rgb> grain = withoutShading(surface);
  constexpr float kLong = 0.5F;
  for (const float share : {kLong, 0.0F}) {
    if (auto quilt = quilted(grain, bareFor(share), size)) return std::move(*quilt);
  }
  return mirrored(grain, size);
}

}  // namespace fluidymation
