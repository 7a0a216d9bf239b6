#include "fluidymation/synthesis/occurrence.h"

#include <algorithm>
#include <cstdlib>

#include "fluidymation/core/parallel.h"

namespace fluidymation {
namespace {

/// A window reaches kPatchRadius from its centre, and so does the box of each of its positions.
constexpr int kReachPx = 2 * kPatchRadius;

/// Number of window positions p in [0, length) within kPatchRadius of both `centre` and `other`:
/// the weight of a use at `other` in the window sum at `centre`, along one axis.
int sharedPositions(int centre, int other, int length) {
  const int first = std::max({centre - kPatchRadius, other - kPatchRadius, 0});
  const int last = std::min({centre + kPatchRadius, other + kPatchRadius, length - 1});
  return std::max(0, last - first + 1);
}

}  // namespace

OccurrenceMap::OccurrenceMap(Size size, int frameCount, int radiusFrames)
    : size_(size),
      frameCount_(frameCount),
      radiusFrames_(radiusFrames),
      sums_(index(0, size.height, 0), 0) {}

void OccurrenceMap::clear() { std::fill(sums_.begin(), sums_.end(), 0); }

std::int32_t OccurrenceMap::windowSum(const Match& match) const {
  return windowSum(std::clamp(match.nearestX(), 0, size_.width - 1),
                   std::clamp(match.nearestY(), 0, size_.height - 1), match.frame);
}

void OccurrenceMap::add(const Match& match, int delta) {
  const int cx = std::clamp(match.nearestX(), 0, size_.width - 1);
  const int cy = std::clamp(match.nearestY(), 0, size_.height - 1);
  const int firstFrame = std::max(match.frame - radiusFrames_, 0);
  const int lastFrame = std::min(match.frame + radiusFrames_, frameCount_ - 1);
  const int firstX = std::max(cx - kReachPx, 0);
  const int lastX = std::min(cx + kReachPx, size_.width - 1);
  for (int y = std::max(cy - kReachPx, 0); y <= std::min(cy + kReachPx, size_.height - 1); ++y) {
    const int rowWeight = delta * sharedPositions(y, cy, size_.height);
    for (int x = firstX; x <= lastX; ++x) {
      const int weight = rowWeight * sharedPositions(x, cx, size_.width);
      std::int32_t* run = sums_.data() + index(x, y, 0);
      for (int k = firstFrame; k <= lastFrame; ++k) run[k] += weight;
    }
  }
}

std::int32_t OccurrenceMap::contribution(const Match& used, const Match& centre) const {
  if (std::abs(used.frame - centre.frame) > radiusFrames_) return 0;
  const auto clampedX = [&](const Match& m) {
    return std::clamp(m.nearestX(), 0, size_.width - 1);
  };
  const auto clampedY = [&](const Match& m) {
    return std::clamp(m.nearestY(), 0, size_.height - 1);
  };
  return sharedPositions(clampedX(centre), clampedX(used), size_.width) *
         sharedPositions(clampedY(centre), clampedY(used), size_.height);
}

void OccurrenceMap::rebuild(const NearestNeighborField& nnf) {
  clear();
  for (const Match& match : nnf) {
    if (!match.exists()) continue;
    ++sums_[index(std::clamp(match.nearestX(), 0, size_.width - 1),
                  std::clamp(match.nearestY(), 0, size_.height - 1), match.frame)];
  }
  filter();
}

void OccurrenceMap::filter() {
  spreadOverFrames();
  // The box of each position, then the positions of each window.
  for (int pass = 0; pass < 2; ++pass) {
    boxAlongX();
    boxAlongY();
  }
}

void OccurrenceMap::spreadOverFrames() {
  forEachRow(size_.height, [&](int y) {
    std::vector<std::int32_t> prefix(static_cast<std::size_t>(frameCount_) + 1);
    for (int x = 0; x < size_.width; ++x) {
      std::int32_t* run = sums_.data() + index(x, y, 0);
      for (int k = 0; k < frameCount_; ++k) {
        const auto i = static_cast<std::size_t>(k);
        prefix[i + 1] = prefix[i] + run[k];
      }
      for (int k = 0; k < frameCount_; ++k) {
        const auto end = static_cast<std::size_t>(std::min(k + radiusFrames_ + 1, frameCount_));
        const auto begin = static_cast<std::size_t>(std::max(k - radiusFrames_, 0));
        run[k] = prefix[end] - prefix[begin];
      }
    }
  });
}

void OccurrenceMap::boxAlongX() {
  scratch_.resize(sums_.size());
  const auto frames = static_cast<std::size_t>(frameCount_);
  forEachRow(size_.height, [&](int y) {
    for (int x = 0; x < size_.width; ++x) {
      std::int32_t* out = scratch_.data() + index(x, y, 0);
      std::fill(out, out + frames, 0);
      for (int sx = std::max(x - kPatchRadius, 0);
           sx <= std::min(x + kPatchRadius, size_.width - 1); ++sx) {
        const std::int32_t* in = sums_.data() + index(sx, y, 0);
        for (std::size_t k = 0; k < frames; ++k) out[k] += in[k];
      }
    }
  });
  sums_.swap(scratch_);
}

void OccurrenceMap::boxAlongY() {
  scratch_.resize(sums_.size());
  const std::size_t rowLength = index(0, 1, 0);
  forEachRow(size_.height, [&](int y) {
    std::int32_t* out = scratch_.data() + index(0, y, 0);
    std::fill(out, out + rowLength, 0);
    for (int sy = std::max(y - kPatchRadius, 0); sy <= std::min(y + kPatchRadius, size_.height - 1);
         ++sy) {
      const std::int32_t* in = sums_.data() + index(0, sy, 0);
      for (std::size_t i = 0; i < rowLength; ++i) out[i] += in[i];
    }
  });
  sums_.swap(scratch_);
}

double OccurrenceMap::meanOfUniformUse(const ExemplarLevel& exemplar,
                                       const std::vector<std::uint32_t>& pixels, int radiusFrames) {
  if (pixels.empty()) return 0.0;
  OccurrenceMap map(exemplar.size(), exemplar.frameCount(), radiusFrames);
  for (const std::uint32_t i : pixels) {
    const ExemplarLevel::Position p = exemplar.position(i);
    ++map.sums_[map.index(p.x, p.y, p.frame)];
  }
  map.filter();
  double sum = 0.0;
  for (const std::uint32_t i : pixels) {
    const ExemplarLevel::Position p = exemplar.position(i);
    sum += map.windowSum(p.x, p.y, p.frame);
  }
  return sum / static_cast<double>(pixels.size()) / kPatchArea;
}

ExpectedUse::ExpectedUse(const ExemplarLevel& exemplar, int radiusFrames)
    : segmented_(exemplar.segmented()) {
  const auto perUse = [&](Segment segment) {
    const std::vector<std::uint32_t>& pixels = exemplar.pixelsOf(segment);
    if (pixels.empty()) return 0.0;
    return OccurrenceMap::meanOfUniformUse(exemplar, pixels, radiusFrames) /
           static_cast<double>(pixels.size());
  };
  borderPerUse_ = perUse(Segment::kBorder);
  interiorPerUse_ = segmented_ ? perUse(Segment::kInterior) : borderPerUse_;
}

float ExpectedUse::best(const TargetLevel& target, Segment segment) const {
  const std::size_t count =
      segmented_ ? target.count(segment) : target.borderCount + target.interiorCount;
  const double perUse = segment == Segment::kInterior ? interiorPerUse_ : borderPerUse_;
  return static_cast<float>(perUse * static_cast<double>(count));
}

}  // namespace fluidymation
