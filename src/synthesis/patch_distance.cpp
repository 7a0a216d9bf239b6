#include "fluidymation/synthesis/patch_distance.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "fluidymation/synthesis/sampling.h"

namespace fluidymation {
namespace {

/// A rotated window reaches sqrt(2) * radius from its centre; bilinear sampling one pixel further.
constexpr float kWindowReachPx = 1.4143F * kPatchRadius;

/// |tan| of the angle between two directions of any length; 0 where one has none.
float misalignment(Vec2 a, Vec2 b) {
  const float sine = std::abs(a.x * b.y - a.y * b.x);
  const float cosine = std::abs(dot(a, b));
  if (sine < kLargestMisalignment * cosine) return sine / cosine;
  return sine > 0.0F ? kLargestMisalignment : 0.0F;
}

float sum(const Lanes& v) {
  const Float4 s = v.low + v.high;
  return (s[0] + s[1]) + (s[2] + s[3]);
}

}  // namespace

void PatchDistance::gather(int x, int y, TargetWindow& window) const {
  int colored = 0;
  int remembered = 0;
  for (int dy = -kPatchRadius; dy <= kPatchRadius; ++dy) {
    for (int dx = -kPatchRadius; dx <= kPatchRadius; ++dx) {
      const int qx = x + dx;
      const int qy = y + dy;
      if (!target_.segment.contains(qx, qy)) continue;
      colored += target_.inside(qx, qy) ? 1 : 0;
      remembered += target_.hasPrevious(qx, qy) != 0 ? 1 : 0;
    }
  }
  assert(colored > 0);
  const float colorWeight = weights_.color / static_cast<float>(kColorChannels * colored);
  const float previousWeight = remembered == 0
                                   ? 0.0F
                                   : target_.modulation(x, y) * weights_.prev /
                                         static_cast<float>(kColorChannels * remembered);
  const float distWeight = weights_.dist / static_cast<float>(kPatchArea);
  const float flowWeight = weights_.flow / static_cast<float>(kPatchArea);
  const bool directed = weights_.dir != 0.0F;
  const float directionWeight = weights_.dir / static_cast<float>(colored);

  window.direction = target_.direction(x, y);
  window.constant = 0.0F;
  std::size_t i = 0;
  for (int dy = -kPatchRadius; dy <= kPatchRadius; ++dy) {
    for (int dx = -kPatchRadius; dx <= kPatchRadius; ++dx, ++i) {
      const int qx = std::clamp(x + dx, 0, target_.size().width - 1);
      const int qy = std::clamp(y + dy, 0, target_.size().height - 1);
      const bool inImage = qx == x + dx && qy == y + dy;
      const float a = inImage && target_.inside(qx, qy) ? colorWeight : 0.0F;
      const float b = inImage && target_.hasPrevious(qx, qy) != 0 ? previousWeight : 0.0F;
      const float both = a + b;
      const Lab t = target_.picture(qx, qy);
      const Lab p = target_.previous(qx, qy);
      const float share = both > 0.0F ? b / both : 0.0F;
      const Lab blend{t.l + share * (p.l - t.l), t.a + share * (p.a - t.a),
                      t.b + share * (p.b - t.b)};
      window.constant +=
          a * share *
          ((t.l - p.l) * (t.l - p.l) + (t.a - p.a) * (t.a - p.a) + (t.b - p.b) * (t.b - p.b));
      const float extForward = target_.extForward(qx, qy);
      const float extBackward = target_.extBackward(qx, qy);
      window.value[i].low = Float4{blend.l, blend.a, blend.b, target_.edge(qx, qy)};
      const Vec2 direction = directed ? target_.direction(qx, qy) : Vec2{};
      window.value[i].high = Float4{extForward, extBackward, direction.x, direction.y};
      window.swappedHigh[i] = Float4{extBackward, extForward, direction.x, direction.y};
      window.weight[i].low = Float4{both, both, both, distWeight};
      window.weight[i].high = Float4{flowWeight, flowWeight, 0.0F, 0.0F};
      if (directed) {
        window.directionWeight[i] = inImage && target_.inside(qx, qy) ? directionWeight : 0.0F;
      }
    }
  }
}

float PatchDistance::operator()(const TargetWindow& window, const Match& match,
                                float stopAt) const {
  return weights_.dir == 0.0F ? compare<false>(window, match, stopAt)
                              : compare<true>(window, match, stopAt);
}

template <bool kDirected>
float PatchDistance::compare(const TargetWindow& window, const Match& match, float stopAt) const {
  const Size size = exemplar_.size();
  const Lanes* frame = exemplar_.frame(match.frame);
  const Vec2 sourceDirection = exemplar_.direction(match.nearestX(), match.nearestY(), match.frame);
  const bool opposite =
      !exemplar_.comparesAges() && isOpposite(window.direction, sourceDirection, match.rotation);

  // Window offset (dx, dy) lies at (x, y) + dx * right + dy * down in the source.
  const Vec2 right = match.rotation.inverse().apply({1.0F, 0.0F});
  const Vec2 down = match.rotation.inverse().apply({0.0F, 1.0F});
  const bool inside = match.x >= kWindowReachPx && match.y >= kWindowReachPx &&
                      match.x < static_cast<float>(size.width - 1) - kWindowReachPx &&
                      match.y < static_cast<float>(size.height - 1) - kWindowReachPx;
  float distance = window.constant;
  std::size_t i = 0;
  for (int dy = -kPatchRadius; dy <= kPatchRadius; ++dy) {
    Lanes row;
    float directions = 0.0F;
    for (int dx = -kPatchRadius; dx <= kPatchRadius; ++dx, ++i) {
      const float sx = match.x + static_cast<float>(dx) * right.x + static_cast<float>(dy) * down.x;
      const float sy = match.y + static_cast<float>(dx) * right.y + static_cast<float>(dy) * down.y;
      const Lanes s =
          inside ? sampleInside(frame, size.width, sx, sy) : sampleClamped(frame, size, sx, sy);
      const Float4 low = s.low - window.value[i].low;
      const Float4 high = s.high - (opposite ? window.swappedHigh[i] : window.value[i].high);
      row.low += low * low * window.weight[i].low;
      row.high += high * high * window.weight[i].high;
      if constexpr (kDirected) {
        const Vec2 turned = match.rotation.apply({s.high[2], s.high[3]});
        const Float4& wanted = window.value[i].high;
        directions += window.directionWeight[i] * misalignment(turned, {wanted[2], wanted[3]});
      }
    }
    distance += sum(row) + directions;
    if (distance >= stopAt) return distance;
  }
  return distance;
}

}  // namespace fluidymation
