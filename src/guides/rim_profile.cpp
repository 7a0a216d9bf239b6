#include "fluidymation/guides/rim_profile.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>

#include "fluidymation/guides/distance_field.h"
#include "fluidymation/guides/mask.h"

namespace fluidymation {
namespace {

/// Difference in CIELAB from which on two colours are told apart (Mahy et al. 1994: 2.3).
constexpr double kNoticeable = 2.3;

/// Share of the whole change with the distance that counts as none. Less or more by 5 % moves the
/// width by half and more on films whose colours change gradually (docs/quality.md).
constexpr double kNegligibleShare = 0.1;

/// Sums of the pixels of a band.
struct Band {
  double l = 0.0;
  double a = 0.0;
  double b = 0.0;
  double pixels = 0.0;
};

[[nodiscard]] double difference(const Band& p, const Band& q) {
  return std::hypot(p.l - q.l, p.a - q.a, p.b - q.b);
}

}  // namespace

RimProfile::RimProfile(int bandCount) : changes_(static_cast<std::size_t>(bandCount - 1)) {
  assert(bandCount >= 1);
}

void RimProfile::add(const Image<Lab>& picture, const Mask& mask) {
  assert(picture.size() == mask.size());
  if (!hasEdge(mask)) return;
  const Image<float> distance = signedDistance(mask);
  std::vector<Band> bands(changes_.size() + 1);
  for (int y = 0; y < mask.height(); ++y) {
    for (int x = 0; x < mask.width(); ++x) {
      // Band i holds what is nearest to i + 1 px, the distance of the outermost pixels being 1.
      const auto i = std::lround(distance(x, y)) - 1;
      if (i < 0 || static_cast<std::size_t>(i) >= bands.size()) continue;
      Band& band = bands[static_cast<std::size_t>(i)];
      const Lab color = picture(x, y);
      band.l += static_cast<double>(color.l);
      band.a += static_cast<double>(color.a);
      band.b += static_cast<double>(color.b);
      band.pixels += 1.0;
    }
  }
  for (std::size_t i = 0; i < changes_.size(); ++i) {
    const Band& outer = bands[i];
    const Band& inner = bands[i + 1];
    const double weight = std::min(outer.pixels, inner.pixels);
    if (weight == 0.0) continue;
    Change& change = changes_[i];
    change.l += weight * (inner.l / inner.pixels - outer.l / outer.pixels);
    change.a += weight * (inner.a / inner.pixels - outer.a / outer.pixels);
    change.b += weight * (inner.b / inner.pixels - outer.b / outer.pixels);
    change.pixels += weight;
  }
}

std::optional<float> RimProfile::widthPx(int stepPx) const {
  assert(stepPx >= 1);
  std::vector<Band> profile(1);  // relative to the outermost band; ends where no frame goes on
  for (const Change& change : changes_) {
    if (change.pixels == 0.0) break;
    const Band& last = profile.back();
    profile.push_back({last.l + change.l / change.pixels, last.a + change.a / change.pixels,
                       last.b + change.b / change.pixels, 0.0});
  }
  if (profile.size() < 2) return std::nullopt;
  double range = 0.0;
  for (const Band& band : profile) range = std::max(range, difference(band, profile.front()));
  const double negligible = std::max(kNoticeable, kNegligibleShare * range);
  std::size_t width = 1;
  for (std::size_t i = 0; i < profile.size(); ++i) {
    const std::size_t inner = std::min(i + static_cast<std::size_t>(stepPx), profile.size() - 1);
    if (difference(profile[i], profile[inner]) > negligible) width = i + 2;
  }
  return static_cast<float>(width);
}

}  // namespace fluidymation
