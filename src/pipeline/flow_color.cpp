#include "pipeline/flow_color.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "fluidymation/core/color.h"

namespace fluidymation {
namespace {

/// Fully saturated colour; hue and its channels go once round the circle: 0 red, 1/3 green,
/// 2/3 blue.
Rgba8 hueColor(float hue, float intensity) {
  const auto channel = [&](float phase) {
    const float turn = hue + phase - std::floor(hue + phase);
    return toByte(intensity * std::clamp(std::abs(6.0F * turn - 3.0F) - 1.0F, 0.0F, 1.0F));
  };
  return {channel(0.0F), channel(2.0F / 3.0F), channel(1.0F / 3.0F), 255};
}

}  // namespace

Rgba8 flowColor(Vec2 flow, float scale) {
  return hueColor(std::atan2(flow.y, flow.x) / kTwoPi, scale * length(flow));
}

}  // namespace fluidymation
