#include "fluidymation/guides/motion.h"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "components.h"
#include "fluidymation/core/parallel.h"
#include "fluidymation/guides/gaussian.h"
#include "gradient.h"
#include "rigid_motion.h"

namespace fluidymation {
namespace {

/// The smoothed field at a pixel.
float smoothAt(const ShapeChange& change, int x, int y) {
  float sum = 0.0F;
  for (const WeightedField& share : change.smooth) sum += share.weight * (*share.field)(x, y);
  return sum;
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
  const int width = mask.width();
  forEachRow(mask.height(), [&](int y) {
    // Past the image edge the nearest pixel is the one at the edge: no border there
    const std::uint8_t* here = mask.row(y);
    const std::uint8_t* above = mask.row(std::max(y - 1, 0));
    const std::uint8_t* below = mask.row(std::min(y + 1, mask.height() - 1));
    std::uint8_t* out = border.row(y);
    const auto mark = [&](int x, int left, int right) {
      // Products instead of branches: masks are 0 or 1
      const int surrounded = here[left] * here[right] * above[x] * below[x];
      out[x] = static_cast<std::uint8_t>(here[x] * (1 - surrounded));
    };
    if (width == 0) return;
    mark(0, 0, std::min(1, width - 1));
    for (int x = 1; x < width - 1; ++x) mark(x, x - 1, x + 1);
    mark(width - 1, std::max(width - 2, 0), width - 1);
  });
  return border;
}

std::vector<float> partThicknesses(const Mask& mask, const Image<float>& depth) {
  const Components parts = findComponents(mask);
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

MotionField motionField(const Mask& mask, const ShapeChange& change, MotionModel model,
                        Pixel origin) {
  assert(change.fields.size() == change.stepWeights.size() + 1);
  const Mask border = borderPixels(mask);
  const Components parts = findComponents(mask);
  assert(change.thicknesses.size() == static_cast<std::size_t>(parts.count));

  // Movement along the outward normal at the border
  Image<Vec2> normals(mask.size());
  Image<float> speeds(mask.size());
  forEachRow(mask.height(), [&](int y) {
    for (int x = 0; x < mask.width(); ++x) {
      if (border(x, y) == 0) continue;
      const Vec2 gradient =
          gradientOf([&](int sx, int sy) { return smoothAt(change, sx, sy); }, mask.size(), x, y);
      const float steepness = length(gradient);
      if (steepness < kFlatGradient) continue;
      normals(x, y) = (-1.0F / steepness) * gradient;
      const float limitPx = change.thicknesses[static_cast<std::size_t>(parts.label(x, y))];
      speeds(x, y) = advance(change, x, y, limitPx);
    }
  });

  // What the parts do as a whole is known everywhere; only the rest has to be spread inside
  Image<Vec2> whole;
  if (model == MotionModel::kRigidParts) {
    whole = rigidMotion(parts, border, normals, speeds, origin);
  }
  const auto wholeAt = [&](int x, int y) { return whole.empty() ? Vec2{} : whole(x, y); };
  MotionField motion;
  motion.flow = std::move(normals);
  forEachRow(mask.height(), [&](int y) {
    for (int x = 0; x < mask.width(); ++x) {
      if (border(x, y) == 0) continue;
      const Vec2 normal = motion.flow(x, y);
      motion.flow(x, y) = (speeds(x, y) - dot(wholeAt(x, y), normal)) * normal;
    }
  });
  motion.report = diffuse(mask, border, motion.flow, origin);
  forEachRow(mask.height(), [&](int y) {
    for (int x = 0; x < mask.width(); ++x) motion.flow(x, y) += wholeAt(x, y);
  });
  return motion;
}

}  // namespace fluidymation
