#include "fluidymation/guides/motion.h"

#include <vector>

#include "components.h"
#include "fluidymation/core/parallel.h"
#include "fluidymation/guides/gaussian.h"
#include "gradient.h"

namespace fluidymation {
namespace {

/// Largest distance of each connected part, at least 0: how far it may move in one frame.
std::vector<float> thicknesses(const Components& parts, const Image<float>& distance) {
  std::vector<float> largest(static_cast<std::size_t>(parts.count), 0.0F);
  for (int y = 0; y < distance.height(); ++y) {
    for (int x = 0; x < distance.width(); ++x) {
      const int part = parts.label(x, y);
      if (part < 0) continue;
      float& value = largest[static_cast<std::size_t>(part)];
      value = std::max(value, distance(x, y));
    }
  }
  return largest;
}

}  // namespace

Mask borderPixels(const Mask& mask) {
  Mask border(mask.size());
  forEachRow(mask.height(), [&](int y) {
    for (int x = 0; x < mask.width(); ++x) {
      if (mask(x, y) == 0) continue;
      // Past the image edge the nearest pixel is this one, which is inside: no border there
      const bool surrounded = mask.clamped(x - 1, y) != 0 && mask.clamped(x + 1, y) != 0 &&
                              mask.clamped(x, y - 1) != 0 && mask.clamped(x, y + 1) != 0;
      border(x, y) = surrounded ? 0 : 1;
    }
  });
  return border;
}

Image<float> continuousDistance(const Image<float>& signedDistance) {
  Image<float> continuous(signedDistance.size());
  forEachRow(signedDistance.height(), [&](int y) {
    for (int x = 0; x < signedDistance.width(); ++x) {
      const float d = signedDistance(x, y);
      continuous(x, y) = d > 0.0F ? d - 0.5F : d + 0.5F;
    }
  });
  return continuous;
}

Image<float> motionDistance(const Image<float>& signedDistance) {
  return gaussianBlur(continuousDistance(signedDistance), kStaircaseSigmaPx);
}

MotionField motionField(const Mask& mask, const Image<float>& before, const Image<float>& after,
                        const Image<float>& here) {
  MotionField motion;
  motion.flow = Image<Vec2>(mask.size());

  // Movement along the normal at the border
  const Mask border = borderPixels(mask);
  const Components parts = findComponents(mask);
  const std::vector<float> limits = thicknesses(parts, here);
  forEachRow(mask.height(), [&](int y) {
    for (int x = 0; x < mask.width(); ++x) {
      if (border(x, y) == 0) continue;
      const Vec2 gradient = gradientAt(here, x, y);
      const float steepness = length(gradient);
      if (steepness < kFlatGradient) continue;
      const float limit = limits[static_cast<std::size_t>(parts.label(x, y))];
      const float advance = std::clamp(after(x, y) - before(x, y), -limit, limit);
      motion.flow(x, y) = (-advance / steepness) * gradient;
    }
  });

  motion.report = diffuse(mask, border, motion.flow);
  return motion;
}

}  // namespace fluidymation
