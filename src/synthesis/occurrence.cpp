#include "fluidymation/synthesis/occurrence.h"

#include <algorithm>
#include <cstdlib>

#include "fluidymation/core/parallel.h"

namespace fluidymation {
namespace {

/// A window reaches kPatchRadius from its centre, and so does the box of each of its positions.
constexpr int kReachPx = 2 * kPatchRadius;

/// Columns of a map that are filtered along y at a time: their rows stay in the second-level cache.
constexpr int kChunkColumns = 32;

/// Sums over kPatchSize neighbours, twice, along a line of vectors of integers, in place: the box
/// of each position first, then the positions of each window. What lies past the ends counts
/// nothing.
class TwoBoxes {
 public:
  /// @param length  of the vectors.
  explicit TwoBoxes(std::size_t length)
      : length_(length),
        in_(kSlots * length),
        box_(kSlots * length),
        boxRun_(length),
        run_(length) {}

  /// @param line   the first of `count` vectors.
  /// @param step   integers from one vector to the next.
  void along(std::int32_t* line, int count, std::size_t step) {
    // A vector is read in step i, its box known kPatchRadius steps later, and its sum of boxes
    // another kPatchRadius: by then the vector itself is not needed any more.
    for (int i = 0; i < count + kReachPx; ++i) {
      const std::int32_t* in = i < count ? line + static_cast<std::size_t>(i) * step : nullptr;
      addBox(i, in);
      const int centre = i - kPatchRadius;
      addSum(centre, centre >= 0 && centre < count);
      if (i >= kReachPx) {
        std::copy(run_.begin(), run_.end(), line + static_cast<std::size_t>(i - kReachPx) * step);
      }
    }
  }

 private:
  static constexpr int kSlots = kPatchSize;  ///< as many as a sum has to forget again

  static std::size_t slot(int i) { return static_cast<std::size_t>((i + kSlots) % kSlots); }

  /// boxRun_ becomes the box that ends with vector i, null: zeros.
  void addBox(int i, const std::int32_t* in) {
    std::int32_t* const old = in_.data() + slot(i) * length_;  // of kPatchSize steps ago
    if (in == nullptr) {
      for (std::size_t l = 0; l < length_; ++l) boxRun_[l] -= old[l];
      std::fill(old, old + length_, 0);
      return;
    }
    for (std::size_t l = 0; l < length_; ++l) {
      boxRun_[l] += in[l] - old[l];
      old[l] = in[l];
    }
  }

  /// run_ becomes the sum of boxes that ends with the one at `centre`.
  void addSum(int centre, bool counts) {
    std::int32_t* const old = box_.data() + slot(centre) * length_;
    const std::int32_t use = counts ? 1 : 0;
    for (std::size_t l = 0; l < length_; ++l) {
      const std::int32_t box = use * boxRun_[l];
      run_[l] += box - old[l];
      old[l] = box;
    }
  }

  std::size_t length_;
  std::vector<std::int32_t> in_;   ///< the last kSlots vectors
  std::vector<std::int32_t> box_;  ///< the last kSlots boxes
  std::vector<std::int32_t> boxRun_;
  std::vector<std::int32_t> run_;
};

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
  const auto clampedX = [&](const Match& m) {
    return std::clamp(m.nearestX(), 0, size_.width - 1);
  };
  const auto clampedY = [&](const Match& m) {
    return std::clamp(m.nearestY(), 0, size_.height - 1);
  };
  return contribution(clampedX(used), clampedY(used), used.frame, clampedX(centre),
                      clampedY(centre), centre.frame);
}

std::int32_t OccurrenceMap::contribution(int usedX, int usedY, int usedFrame, int x, int y,
                                         int frame) const {
  if (std::abs(usedX - x) > kReachPx || std::abs(usedY - y) > kReachPx ||
      std::abs(usedFrame - frame) > radiusFrames_) {
    return 0;
  }
  return sharedPositions(x, usedX, size_.width) * sharedPositions(y, usedY, size_.height);
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
  const auto frames = static_cast<std::size_t>(frameCount_);
  const std::size_t row = index(0, 1, 0);
  forEachRow(size_.height, [&](int y) {
    spreadOverFrames(y);
    TwoBoxes(frames).along(sums_.data() + index(0, y, 0), size_.width, frames);
  });
  const int chunks = (size_.width + kChunkColumns - 1) / kChunkColumns;
  parallelFor(chunks, 1, [&](int chunk) {
    const int first = chunk * kChunkColumns;
    const int columns = std::min(kChunkColumns, size_.width - first);
    TwoBoxes(frames * static_cast<std::size_t>(columns))
        .along(sums_.data() + index(first, 0, 0), size_.height, row);
  });
}

void OccurrenceMap::spreadOverFrames(int y) {
  std::vector<std::int32_t> prefix(static_cast<std::size_t>(frameCount_) + 1);
  for (int x = 0; x < size_.width; ++x) {
    std::int32_t* run = sums_.data() + index(x, y, 0);
    for (int k = 0; k < frameCount_; ++k) {
      const auto i = static_cast<std::size_t>(k);
      prefix[i + 1] = prefix[i] + run[k];
    }
    if (prefix.back() == 0) continue;
    for (int k = 0; k < frameCount_; ++k) {
      const auto end = static_cast<std::size_t>(std::min(k + radiusFrames_ + 1, frameCount_));
      const auto begin = static_cast<std::size_t>(std::max(k - radiusFrames_, 0));
      run[k] = prefix[end] - prefix[begin];
    }
  }
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

UseChanges::UseChanges(Size size, int frameCount, int radiusFrames)
    : size_(size),
      plane_(static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height)),
      framesPerGroup_(framesPerGroup(frameCount, radiusFrames)),
      groups_((frameCount + framesPerGroup_ - 1) / framesPerGroup_),
      reaches_(static_cast<std::size_t>(frameCount)),
      sums_(index(0, 0, groups_)) {
  for (int k = 0; k < frameCount; ++k) {
    const int first = std::max(k - radiusFrames, 0);
    const int last = std::min(k + std::min(radiusFrames, frameCount), frameCount - 1);
    Reach& reach = reaches_[static_cast<std::size_t>(k)];
    reach.firstGroup = first / framesPerGroup_;
    reach.groups = last / framesPerGroup_ - reach.firstGroup + 1;
    for (int g = 0; g < reach.groups; ++g) {
      const int begin = (reach.firstGroup + g) * framesPerGroup_;
      const int end = std::min(begin + framesPerGroup_, frameCount);
      const int within = std::min(end, last + 1) - std::max(begin, first);
      reach.share[static_cast<std::size_t>(g)] =
          static_cast<float>(within) / static_cast<float>(end - begin);
    }
  }
}

void UseChanges::add(const Match& match, int delta) {
  const int cx = std::clamp(match.nearestX(), 0, size_.width - 1);
  const int cy = std::clamp(match.nearestY(), 0, size_.height - 1);
  const int firstX = std::max(cx - kReachPx, 0);
  const int lastX = std::min(cx + kReachPx, size_.width - 1);
  std::array<std::int32_t, 2 * kReachPx + 1> weights{};
  std::size_t count = 0;
  for (int x = firstX; x <= lastX; ++x) {
    weights[count++] = delta * sharedPositions(x, cx, size_.width);
  }
  for (int y = std::max(cy - kReachPx, 0); y <= std::min(cy + kReachPx, size_.height - 1); ++y) {
    const int rowWeight = sharedPositions(y, cy, size_.height);
    std::int32_t* sums = sums_.data() + index(firstX, y, match.frame / framesPerGroup_);
    for (std::size_t i = 0; i < count; ++i) sums[i] += rowWeight * weights[i];
  }
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
