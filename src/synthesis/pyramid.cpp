#include "fluidymation/synthesis/pyramid.h"

#include <algorithm>
#include <array>

#include "fluidymation/core/parallel.h"
#include "fluidymation/guides/direction.h"
#include "fluidymation/synthesis/channels.h"

namespace fluidymation {
namespace {

/// Mean directions shorter than this cancel each other; the first one is taken instead.
constexpr float kCancelledLength = 1e-3F;

Vec2 levelDirection(Vec2 flow, Vec2 meanDirection, Vec2 first) {
  const float speed = length(flow);
  if (speed >= kStillPxPerFrame) return (1.0F / speed) * flow;
  const float agreement = length(meanDirection);
  return agreement > kCancelledLength ? (1.0F / agreement) * meanDirection : first;
}

/// Means of the blocks of 2x2, as far as the image reaches.
Image<float> blockMeans(const Image<float>& fine) {
  Image<float> coarse(halvedSize(fine.size()));
  const auto wholeBlocks = static_cast<std::size_t>(fine.width() / 2);
  forEachRow(coarse.height(), [&](int y) {
    const bool hasLower = 2 * y + 1 < fine.height();
    const float* upper = fine.row(2 * y);
    const float* lower = hasLower ? fine.row(2 * y + 1) : nullptr;
    float* out = coarse.row(y);
    for (std::size_t x = 0; x < wholeBlocks; ++x) {
      const float sum = upper[2 * x] + upper[2 * x + 1];
      out[x] = hasLower ? (sum + lower[2 * x] + lower[2 * x + 1]) / 4.0F : sum / 2.0F;
    }
    if (fine.width() % 2 == 0) return;
    const float last = upper[2 * wholeBlocks];
    out[wholeBlocks] = hasLower ? (last + lower[2 * wholeBlocks]) / 2.0F : last;
  });
  return coarse;
}

Lab weighted(const std::array<Lab, 4>& c) {
  constexpr float kOuter = 1.0F / 8.0F;
  constexpr float kInner = 3.0F / 8.0F;
  return {kOuter * (c[0].l + c[3].l) + kInner * (c[1].l + c[2].l),
          kOuter * (c[0].a + c[3].a) + kInner * (c[1].a + c[2].a),
          kOuter * (c[0].b + c[3].b) + kInner * (c[1].b + c[2].b)};
}

}  // namespace

int coarsestLevel(Size source, Size target) {
  const int smallest = std::min({source.width, source.height, target.width, target.height});
  int level = 0;
  while (kPatchSize << (level + 1) <= smallest) ++level;
  return level;
}

Size halvedSize(Size size) { return {(size.width + 1) / 2, (size.height + 1) / 2}; }

bool GuideLevel::edgeless() const {
  return std::all_of(distance.begin(), distance.end(),
                     [first = distance.data()](float d) { return d == *first; });
}

GuideLevel finestLevel(const GuideFrame& frame) {
  GuideLevel level{frame.mask.clone(),
                   frame.distance.clone(),
                   Image<float>(frame.mask.size()),
                   Image<float>(frame.mask.size()),
                   frame.flow.clone(),
                   frame.direction.clone(),
                   frame.shape.clone()};
  if (!frame.age.empty()) {
    level.extForward = frame.age.clone();
    return level;
  }
  forEachRow(frame.mask.height(), [&](int y) {
    for (int x = 0; x < frame.mask.width(); ++x) {
      if (frame.mask(x, y) == 0) continue;  // nothing accumulates outside
      level.extForward(x, y) = length(frame.accForward(x, y));
      level.extBackward(x, y) = length(frame.accBackward(x, y));
    }
  });
  return level;
}

GuideLevel halve(const GuideLevel& fine) {
  const Size size = halvedSize(fine.mask.size());
  const bool shaped = !fine.shape.empty();
  GuideLevel coarse{Mask(size),
                    blockMeans(fine.distance),
                    Image<float>(size),
                    Image<float>(size),
                    Image<Vec2>(size),
                    Image<Vec2>(size),
                    shaped ? blockMeans(fine.shape) : Image<float>()};
  forEachRow(size.height, [&](int y) {
    const std::uint8_t* upper = fine.mask.row(2 * y);
    const std::uint8_t* lower = fine.mask.row(std::min(2 * y + 1, fine.mask.height() - 1));
    for (int x = 0; x < size.width; ++x) {
      const std::size_t left = std::size_t{2} * static_cast<std::size_t>(x);
      const std::size_t right =
          left + 1 < static_cast<std::size_t>(fine.mask.width()) ? left + 1 : left;
      if ((upper[left] | upper[right] | lower[left] | lower[right]) == 0) continue;
      int inside = 0;
      float extForward = 0.0F;
      float extBackward = 0.0F;
      Vec2 flow;
      Vec2 direction;
      Vec2 firstDirection;
      for (int i = 0; i < 4; ++i) {
        const int fx = 2 * x + i % 2;
        const int fy = 2 * y + i / 2;
        if (!fine.mask.contains(fx, fy) || fine.mask(fx, fy) == 0) continue;
        if (inside++ == 0) firstDirection = fine.direction(fx, fy);
        extForward += fine.extForward(fx, fy);
        extBackward += fine.extBackward(fx, fy);
        flow += fine.flow(fx, fy);
        direction += fine.direction(fx, fy);
      }
      const float share = 1.0F / static_cast<float>(inside);
      coarse.mask(x, y) = 1;
      coarse.extForward(x, y) = share * extForward;
      coarse.extBackward(x, y) = share * extBackward;
      coarse.flow(x, y) = share * flow;
      coarse.direction(x, y) = levelDirection(share * flow, share * direction, firstDirection);
    }
  });
  return coarse;
}

Image<Lab> halve(const Image<Lab>& fine) {
  const Size size = halvedSize(fine.size());
  Image<Lab> narrow(Size{size.width, fine.height()});
  forEachRow(fine.height(), [&](int y) {
    for (int x = 0; x < size.width; ++x) {
      narrow(x, y) = weighted({fine.clamped(2 * x - 1, y), fine.clamped(2 * x, y),
                               fine.clamped(2 * x + 1, y), fine.clamped(2 * x + 2, y)});
    }
  });
  Image<Lab> coarse(size);
  forEachRow(size.height, [&](int y) {
    for (int x = 0; x < size.width; ++x) {
      coarse(x, y) = weighted({narrow.clamped(x, 2 * y - 1), narrow.clamped(x, 2 * y),
                               narrow.clamped(x, 2 * y + 1), narrow.clamped(x, 2 * y + 2)});
    }
  });
  return coarse;
}

}  // namespace fluidymation
