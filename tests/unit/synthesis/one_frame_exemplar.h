#pragma once

#include "fluidymation/synthesis/exemplar.h"
#include "support/synthetic_scene.h"

namespace fluidymation {

/// A level of an exemplar of one frame, all of which is material.
[[nodiscard]] inline ExemplarLevel oneFrame(const Image<Lab>& color) {
  ExemplarLevel level(color.size(), 1, 5.0F);
  const test::GrowingDisc all{color.size(), {0.0F, 0.0F}, 1000.0F, 0.0F, 1};
  level.setColor(0, color);
  level.setGuides(0, finestLevel(all.guides(0)));
  level.finish();
  return level;
}

}  // namespace fluidymation
