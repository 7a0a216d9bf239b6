#include "fluidymation/guides/direction.h"

#include "fluidymation/core/parallel.h"
#include "fluidymation/guides/diffusion.h"
#include "fluidymation/guides/motion.h"
#include "gradient.h"

namespace fluidymation {
namespace {

/// Outward normals of the border, spread over the inside. Not of unit length.
Image<Vec2> extendedNormals(const Mask& mask, const Image<float>& distance, SolveReport& report) {
  const Mask border = borderPixels(mask);
  const Image<float> smooth = motionDistance(distance);
  Image<Vec2> normals(mask.size());
  forEachRow(mask.height(), [&](int y) {
    for (int x = 0; x < mask.width(); ++x) {
      if (border(x, y) == 0) continue;
      const Vec2 gradient = gradientAt(smooth, x, y);
      const float steepness = length(gradient);
      if (steepness >= kFlatGradient) normals(x, y) = (-1.0F / steepness) * gradient;
    }
  });
  report = diffuse(mask, border, normals);
  return normals;
}

/// The vector at unit length; (1, 0) for one too short to have a direction.
Vec2 unit(Vec2 v) {
  constexpr float kNoDirection = 1e-6F;
  const float norm = length(v);
  return norm > kNoDirection ? (1.0F / norm) * v : Vec2{1.0F, 0.0F};
}

}  // namespace

DirectionField flowDirection(const Mask& mask, const Image<Vec2>& flow,
                             const Image<float>& distance, const Image<Vec2>& previous) {
  DirectionField result;
  result.direction = Image<Vec2>(mask.size());
  Image<Vec2>& direction = result.direction;
  Image<Vec2> normals;  // wanted in few frames only: made when the first pixel asks for them
  for (int y = 0; y < mask.height(); ++y) {
    for (int x = 0; x < mask.width(); ++x) {
      if (mask(x, y) == 0) continue;
      const Vec2 last = previous.empty() ? Vec2{} : previous(x, y);
      if (length(flow(x, y)) >= kStillPxPerFrame) {
        direction(x, y) = unit(flow(x, y));
      } else if (last.x != 0.0F || last.y != 0.0F) {
        direction(x, y) = last;
      } else {
        if (normals.empty()) normals = extendedNormals(mask, distance, result.report);
        direction(x, y) = unit(normals(x, y));
      }
    }
  }
  return result;
}

}  // namespace fluidymation
