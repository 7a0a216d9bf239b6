#pragma once

#include <algorithm>

#include "fluidymation/core/color.h"
#include "fluidymation/core/image.h"
#include "fluidymation/synthesis/channels.h"
#include "fluidymation/synthesis/exemplar.h"
#include "fluidymation/synthesis/texel.h"
#include "support/synthetic_scene.h"

namespace fluidymation::test {

inline constexpr float kBorderPx = 8.0F;

/// Lightness of a medium that gets darker by `perPx` up to the border width, and grain on it.
inline Image<Lab> darkeningInwards(const GuideFrame& guides, float perPx, float grain = 0.0F) {
  Image<Lab> picture(guides.mask.size());
  const Image<Lab> texture = randomTexture(picture.size(), 5);
  for (int y = 0; y < picture.height(); ++y) {
    for (int x = 0; x < picture.width(); ++x) {
      const float speck = grain * (texture(x, y).l - 50.0F) / 20.0F;
      const float depth = std::min(guides.distance(x, y), kBorderPx);
      picture(x, y) = {90.0F - perPx * depth + speck, 2.0F * depth, 0.0F};
    }
  }
  return picture;
}

/// A film of a growing disc; frame k gets darker by `perPx(k)`.
template <typename PerPx>
Exemplar filmOf(const GrowingDisc& disc, int coarsest, const PerPx& perPx, float grain = 0.0F) {
  Exemplar film(disc.size, disc.frameCount, coarsest, kBorderPx);
  for (int k = 0; k < disc.frameCount; ++k) {
    const GuideFrame guides = disc.guides(k);
    film.setColor(k, darkeningInwards(guides, perPx(k), grain));
    film.setGuides(k, guides);
  }
  film.finish();
  return film;
}

/// The edge guide at a depth, as it is kept.
inline int edgeAt(float depthPx) { return toFixed(edgeChannel(depthPx, kBorderPx), kEdgeSteps); }

}  // namespace fluidymation::test
