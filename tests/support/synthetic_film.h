#pragma once

#include <cstdint>

#include "fluidymation/core/color.h"
#include "fluidymation/core/geometry.h"
#include "fluidymation/core/image.h"

namespace fluidymation::test {

/// How one frame of paint on paper was filmed.
struct Shot {
  Size size{160, 120};
  Vec2 centre{80.0F, 60.0F};
  float radiusPx = 30.0F;        ///< of the round stain; 0: bare paper
  Rgb paint{0.5F, 0.45F, 0.8F};  ///< what it leaves of the paper's colour, as factors
  Vec2 cameraPx;                 ///< everything lies so much further right and down
  float light = 1.0F;            ///< factor of all colours
  float grain = 0.0F;  ///< standard deviation of each channel, changing from frame to frame
  std::uint64_t grainSeed = 1;
};

/// As the defaults, but for these.
[[nodiscard]] inline Shot stained(Size size, Vec2 centre, float radiusPx) {
  Shot shot;
  shot.size = size;
  shot.centre = centre;
  shot.radiusPx = radiusPx;
  return shot;
}

/// Bare paper.
[[nodiscard]] inline Shot paper(Size size = Shot().size) { return stained(size, {}, 0.0F); }

/// The frame: paper whose smooth random structure is fixed to it, with the stain.
[[nodiscard]] Image<Rgb> filmed(const Shot& shot);

}  // namespace fluidymation::test
