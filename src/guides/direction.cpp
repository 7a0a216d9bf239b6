#include "fluidymation/guides/direction.h"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "fluidymation/core/box.h"
#include "fluidymation/core/parallel.h"
#include "fluidymation/guides/diffusion.h"
#include "fluidymation/guides/gaussian.h"
#include "fluidymation/guides/motion.h"
#include "gradient.h"

namespace fluidymation {
namespace {

/// Outward normals of the border, spread over the inside. Not of unit length.
struct ExtendedNormals {
  Box box;  ///< what the mask reaches, and how far its gradients look
  Image<Vec2> normals;
  SolveReport report;
};

ExtendedNormals extendNormals(const Mask& mask, const Image<float>& distance, Pixel origin) {
  const Box box = fromEvenPixel(grown(boundingBox(mask), directionMarginPx(), mask.size()));
  const Mask part = cropped(mask, box);
  const Mask border = borderPixels(part);
  const Image<float> smooth = motionDistance(cropped(distance, box));
  ExtendedNormals result{box, Image<Vec2>(part.size()), {}};
  forEachRow(part.height(), [&](int y) {
    for (int x = 0; x < part.width(); ++x) {
      if (border(x, y) == 0) continue;
      const Vec2 gradient = gradientAt(smooth, x, y);
      const float steepness = length(gradient);
      if (steepness >= kFlatGradient) result.normals(x, y) = (-1.0F / steepness) * gradient;
    }
  });
  result.report =
      diffuse(part, border, result.normals, {origin.x + box.beginX, origin.y + box.beginY});
  return result;
}

/// The vector at unit length; (1, 0) for one too short to have a direction.
Vec2 unit(Vec2 v) {
  constexpr float kNoDirection = 1e-6F;
  const float norm = length(v);
  return norm > kNoDirection ? (1.0F / norm) * v : Vec2{1.0F, 0.0F};
}

bool isZero(Vec2 v) { return v.x == 0.0F && v.y == 0.0F; }

}  // namespace

int directionMarginPx() { return 1 + gaussianReach(kStaircaseSigmaPx); }

DirectionField flowDirection(const Mask& mask, const Image<Vec2>& flow,
                             const Image<float>& distance, Image<Vec2> previous, Pixel origin) {
  DirectionField result;
  result.direction = previous.empty() ? Image<Vec2>(mask.size()) : std::move(previous);
  // What moves or has moved knows its direction; whether any pixel has to ask for more
  std::atomic<bool> asks{false};
  forEachRow(mask.height(), [&](int y) {
    const std::uint8_t* inside = mask.row(y);
    const Vec2* moved = flow.row(y);
    Vec2* out = result.direction.row(y);
    bool rowAsks = false;
    for (int x = 0; x < mask.width(); ++x) {
      if (inside[x] == 0) {
        out[x] = Vec2{};
      } else if (length(moved[x]) >= kStillPxPerFrame) {
        out[x] = unit(moved[x]);
      } else if (isZero(out[x])) {
        rowAsks = true;
      }
    }
    if (rowAsks) asks = true;
  });
  if (!asks) return result;

  const ExtendedNormals extended = extendNormals(mask, distance, origin);
  result.report = extended.report;
  forEachRow(extended.box.size().height, [&](int row) {
    const int y = extended.box.beginY + row;
    for (int x = extended.box.beginX; x < extended.box.endX; ++x) {
      if (mask(x, y) == 0 || !isZero(result.direction(x, y))) continue;
      result.direction(x, y) = unit(extended.normals(x - extended.box.beginX, row));
    }
  });
  return result;
}

Image<Vec2> directionOfLast(int begin, int end,
                            const std::function<MovingShape(int frame)>& frameOf,
                            const std::function<Image<float>(int frame)>& distanceOf,
                            const Image<Vec2>& before) {
  MovingShape frame = frameOf(end - 1);
  Image<Vec2> direction(frame.mask.size());
  std::vector<std::size_t> waiting;  // pixels without a direction yet
  for (std::size_t i = 0; i < frame.mask.pixelCount(); ++i) {
    if (frame.mask.data()[i] != 0) waiting.push_back(i);
  }
  for (int j = end - 1; !waiting.empty() && j >= begin; --j) {
    MovingShape previous;
    if (j > begin) previous = frameOf(j - 1);
    const auto hasPast = [&](std::size_t i) {
      if (j > begin) return previous.mask.data()[i] != 0;
      return !before.empty() && !isZero(before.data()[i]);
    };
    std::vector<std::size_t> asking;
    std::vector<std::size_t> resting;
    for (const std::size_t i : waiting) {
      const Vec2 flow = frame.flow.data()[i];
      if (length(flow) >= kStillPxPerFrame) {
        direction.data()[i] = unit(flow);
      } else {
        (hasPast(i) ? resting : asking).push_back(i);
      }
    }
    if (!asking.empty()) {
      const DirectionField normals =
          flowDirection(frame.mask, Image<Vec2>(frame.mask.size()), distanceOf(j), Image<Vec2>());
      for (const std::size_t i : asking) direction.data()[i] = normals.direction.data()[i];
    }
    waiting = std::move(resting);
    frame = std::move(previous);
  }
  for (const std::size_t i : waiting) direction.data()[i] = before.data()[i];
  return direction;
}

}  // namespace fluidymation
