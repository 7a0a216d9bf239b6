#pragma once

#include <cstdint>
#include <vector>

#include "fluidymation/core/color.h"
#include "fluidymation/guides/guide_frame.h"
#include "fluidymation/synthesis/exemplar.h"
#include "fluidymation/synthesis/texel.h"

namespace fluidymation::test {

/// A disc that grows by `speedPx` per frame, with all guides known in closed form.
struct GrowingDisc {
  Size size{48, 40};
  Vec2 centre{24.0F, 20.0F};
  float startRadiusPx = 8.0F;
  float speedPx = 1.0F;
  int frameCount = 8;

  [[nodiscard]] float radiusPx(int frame) const {
    return startRadiusPx + speedPx * static_cast<float>(frame);
  }
  [[nodiscard]] GuideFrame guides(int frame) const;
};

/// A picture of smooth random colour, different for every seed.
[[nodiscard]] Image<Lab> randomTexture(Size size, std::uint64_t seed);

/// A medium painted on a growing disc: static grain, darker towards the rim that moves outwards.
[[nodiscard]] Image<Lab> paintedDisc(const GrowingDisc& disc, int frame, std::uint64_t seed);

/// A target's picture: the colours in fixed point where the segment is not Segment::kOutside, none
/// elsewhere.
[[nodiscard]] Image<FixedLab> fixedPicture(const Image<Lab>& color, const Image<Segment>& segment);

/// An exemplar of a growing disc, with as many levels as wanted.
[[nodiscard]] Exemplar discExemplar(const GrowingDisc& disc, int coarsest, float borderWidthPx,
                                    std::uint64_t seed, const ShapeRules& rules = {});

/// The same where only `held` frames are held, from frame `begin` of the disc on.
[[nodiscard]] Exemplar heldDiscExemplar(const GrowingDisc& disc, int begin, int held, int coarsest,
                                        float borderWidthPx, std::uint64_t seed,
                                        const ShapeRules& rules = {});

/// Fills in frame `frame` of the disc, which the exemplar has to hold.
void fillFrame(const GrowingDisc& disc, int frame, std::uint64_t seed, Exemplar& exemplar);

}  // namespace fluidymation::test
