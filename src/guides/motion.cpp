#include "fluidymation/guides/motion.h"

#include <algorithm>
#include <cassert>
#include <vector>

#include "components.h"
#include "fluidymation/core/parallel.h"
#include "fluidymation/guides/gaussian.h"
#include "gradient.h"
#include "rigid_motion.h"

namespace fluidymation {
namespace {

/// Largest depth of each connected part, at least 0: how far it may move in one frame.
std::vector<float> thicknesses(const Components& parts, const Image<float>& depth) {
  std::vector<float> largest(static_cast<std::size_t>(parts.count), 0.0F);
  for (int y = 0; y < depth.height(); ++y) {
    for (int x = 0; x < depth.width(); ++x) {
      const int part = parts.label(x, y);
      if (part < 0) continue;
      float& value = largest[static_cast<std::size_t>(part)];
      value = std::max(value, depth(x, y));
    }
  }
  return largest;
}

/// The smoothed change of the distance at a pixel, px per frame.
float advance(const ShapeChange& change, int x, int y, float limitPx) {
  float sum = 0.0F;
  for (std::size_t s = 0; s < change.stepWeights.size(); ++s) {
    const float step = (*change.fields[s + 1])(x, y) - (*change.fields[s])(x, y);
    sum += change.stepWeights[s] * std::clamp(step, -limitPx, limitPx);
  }
  return sum;
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

MotionField motionField(const Mask& mask, const ShapeChange& change, MotionModel model) {
  assert(change.fields.size() == change.stepWeights.size() + 1);
  const Mask border = borderPixels(mask);
  const Components parts = findComponents(mask);
  const std::vector<float> limits = thicknesses(parts, change.depth);

  // Movement along the outward normal at the border
  Image<Vec2> normals(mask.size());
  Image<float> speeds(mask.size());
  forEachRow(mask.height(), [&](int y) {
    for (int x = 0; x < mask.width(); ++x) {
      if (border(x, y) == 0) continue;
      const Vec2 gradient = gradientAt(change.smooth, x, y);
      const float steepness = length(gradient);
      if (steepness < kFlatGradient) continue;
      normals(x, y) = (-1.0F / steepness) * gradient;
      speeds(x, y) = advance(change, x, y, limits[static_cast<std::size_t>(parts.label(x, y))]);
    }
  });

  // What the parts do as a whole is known everywhere; only the rest has to be spread inside
  MotionField motion;
  Image<Vec2> whole = model == MotionModel::kRigidParts
                          ? rigidMotion(parts, border, normals, speeds)
                          : Image<Vec2>(mask.size());
  motion.flow = Image<Vec2>(mask.size());
  forEachRow(mask.height(), [&](int y) {
    for (int x = 0; x < mask.width(); ++x) {
      if (border(x, y) == 0) continue;
      const Vec2 normal = normals(x, y);
      motion.flow(x, y) = (speeds(x, y) - dot(whole(x, y), normal)) * normal;
    }
  });
  motion.report = diffuse(mask, border, motion.flow);
  forEachRow(mask.height(), [&](int y) {
    for (int x = 0; x < mask.width(); ++x) motion.flow(x, y) += whole(x, y);
  });
  return motion;
}

}  // namespace fluidymation
