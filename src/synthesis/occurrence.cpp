#include "fluidymation/synthesis/occurrence.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <cstring>

#include "fluidymation/core/parallel.h"

namespace fluidymation {
namespace {

/// A window reaches kPatchRadius from its centre, and so does the box of each of its positions.
constexpr int kReachPx = 2 * kPatchRadius;

/// Columns and frames that are filtered at a time, where any of them is used. Columns: no fewer
/// than a use reaches to either side, so that the neighbouring block is as far as it gets.
constexpr int kBlockColumns = 8;
constexpr int kSlabFrames = 32;
static_assert(kBlockColumns >= kReachPx);

/// Four integers that the compiler keeps in one vector register (GCC and Clang, any architecture).
using Int4 = std::int32_t __attribute__((vector_size(16)));

template <typename Lanes>
Lanes loadLanes(const std::int32_t* from) {
  Lanes lanes;
  std::memcpy(&lanes, from, sizeof(lanes));
  return lanes;
}

/// Sums over kPatchSize neighbours, twice, along a line of `count` integers, or of as many `Lanes`,
/// that are `step` apart, in place: the box of each position first, then the positions of each
/// window. What lies past the ends counts nothing.
template <typename Lanes>
void sumTwice(std::int32_t* line, int count, std::size_t step) {
  // A value is read in step i, its box known kPatchRadius steps later, and its sum of boxes
  // another kPatchRadius: by then the value itself is not needed any more.
  std::array<Lanes, kPatchSize> values{};  // those that the next box has to forget, and the boxes
  std::array<Lanes, kPatchSize> boxes{};   // that the next sum has to
  Lanes box{};
  Lanes sum{};
  std::int32_t* in = line;
  std::int32_t* out = line;
  for (int first = 0; first < count + kReachPx; first += kPatchSize) {
    for (int slot = 0; slot < kPatchSize; ++slot) {
      const int i = first + slot;
      Lanes value{};
      if (i < count) {
        value = loadLanes<Lanes>(in);
        in += step;
      }
      auto& oldValue = values[static_cast<std::size_t>(slot)];
      box += value - oldValue;
      oldValue = value;
      const int centre = i - kPatchRadius;
      const Lanes counted = centre >= 0 && centre < count ? box : Lanes{};
      auto& oldBox =
          boxes[static_cast<std::size_t>((slot + kPatchSize - kPatchRadius) % kPatchSize)];
      sum += counted - oldBox;
      oldBox = counted;
      if (i >= kReachPx && i < count + kReachPx) {
        std::memcpy(out, &sum, sizeof(sum));
        out += step;
      }
    }
  }
}

/// The same for `lanes` lines side by side.
void sumTwiceAlong(std::int32_t* lines, int lanes, int count, std::size_t step) {
  constexpr int kWidth = sizeof(Int4) / sizeof(std::int32_t);
  int lane = 0;
  for (; lane + kWidth <= lanes; lane += kWidth) sumTwice<Int4>(lines + lane, count, step);
  for (; lane < lanes; ++lane) sumTwice<std::int32_t>(lines + lane, count, step);
}

/// Calls `body(begin, end)` for every longest run of positions in [0, count) within `reach` of one
/// for which `isUsed` holds.
template <typename IsUsed, typename Body>
void forEachRun(int count, int reach, const IsUsed& isUsed, const Body& body) {
  int begin = 0;
  int end = 0;  // of the run so far
  for (int i = 0; i < count; ++i) {
    if (!isUsed(i)) continue;
    if (i - reach > end) {
      if (end > begin) body(begin, end);
      begin = i - reach;
    }
    end = std::min(i + reach + 1, count);
  }
  if (end > begin) body(begin, end);
}

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
      radiusFrames_(std::min(radiusFrames, frameCount)),
      slabs_((frameCount + kSlabFrames - 1) / kSlabFrames),
      blocks_((size.width + kBlockColumns - 1) / kBlockColumns),
      used_(usedIndex(slabs_, 0, 0), 0),
      sums_(index(0, size.height, 0), 0) {}

std::int32_t OccurrenceMap::windowSum(const Match& match) const {
  return windowSum(std::clamp(match.nearestX(), 0, size_.width - 1),
                   std::clamp(match.nearestY(), 0, size_.height - 1), match.frame);
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
  rebuild(nnf, std::vector<RowSpan>(static_cast<std::size_t>(nnf.height()), {0, nnf.width()}));
}

void OccurrenceMap::rebuild(const NearestNeighborField& nnf, const std::vector<RowSpan>& rows) {
  clear();
  // Each thread goes through all matches, for the rows of the exemplar that are its own
  const int bands = std::min(threadLimit(), size_.height);
  parallelFor(bands, 1, [&](int band) {
    const int top = rowOfBand(band, bands);
    const int bottom = rowOfBand(band + 1, bands);
    for (int row = 0; row < nnf.height(); ++row) {
      const RowSpan& span = rows[static_cast<std::size_t>(row)];
      for (int column = span.begin; column < span.end; ++column) {
        const Match& match = nnf(column, row);
        if (!match.exists()) continue;
        const int y = std::clamp(match.nearestY(), 0, size_.height - 1);
        if (y < top || y >= bottom) continue;
        use(std::clamp(match.nearestX(), 0, size_.width - 1), y, match.frame);
      }
    }
  });
  filter();
}

int OccurrenceMap::rowOfBand(int band, int bands) const {
  return static_cast<int>(static_cast<std::int64_t>(size_.height) * band / bands);
}

void OccurrenceMap::clear() {
  const auto bytes = [](const Region& r) {
    return static_cast<std::size_t>(r.frames) * sizeof(std::int32_t);
  };
  parallelFor(static_cast<int>(filtered_.size()), 8, [&](int i) {
    const Region& region = filtered_[static_cast<std::size_t>(i)];
    for (int y = region.top; y < region.bottom; ++y) {
      for (int x = region.left; x < region.right; ++x) {
        std::memset(sums_.data() + index(x, y, region.firstFrame), 0, bytes(region));
      }
    }
  });
  filtered_.clear();
}

void OccurrenceMap::use(int x, int y, int frame) {
  const int first = std::max(frame - radiusFrames_, 0);
  const int last = std::min(frame + radiusFrames_, frameCount_ - 1);
  std::int32_t* const run = sums_.data() + index(x, y, 0);
  for (int k = first; k <= last; ++k) ++run[k];
  for (int slab = first / kSlabFrames; slab <= last / kSlabFrames; ++slab) {
    used_[usedIndex(slab, y, x / kBlockColumns)] = 1;
  }
}

void OccurrenceMap::filter() {
  for (int slab = 0; slab < slabs_; ++slab) filter(slab);
}

void OccurrenceMap::filter(int slab) {
  const int firstFrame = slab * kSlabFrames;
  const int frames = std::min(kSlabFrames, frameCount_ - firstFrame);
  const auto isUsed = [&](int block, int y) { return used_[usedIndex(slab, y, block)] != 0; };

  forEachRow(size_.height, [&](int y) {
    forEachRun(
        blocks_, 1, [&](int block) { return isUsed(block, y); },
        [&](int begin, int end) {
          const int left = begin * kBlockColumns;
          const int right = std::min(end * kBlockColumns, size_.width);
          sumTwiceAlong(sums_.data() + index(left, y, firstFrame), frames, right - left,
                        index(1, 0, 0));
        });
  });

  // What of a column of blocks is used, is near a use along y too.
  std::vector<std::vector<Region>> regions(static_cast<std::size_t>(blocks_));
  parallelFor(blocks_, 1, [&](int block) {
    const int left = block * kBlockColumns;
    const int right = std::min(left + kBlockColumns, size_.width);
    const auto isReached = [&](int y) {
      return isUsed(block, y) || (block > 0 && isUsed(block - 1, y)) ||
             (block + 1 < blocks_ && isUsed(block + 1, y));
    };
    forEachRun(size_.height, kReachPx, isReached, [&](int top, int bottom) {
      regions[static_cast<std::size_t>(block)].push_back(
          {left, top, right, bottom, firstFrame, frames});
      for (int x = left; x < right; ++x) {
        sumTwiceAlong(sums_.data() + index(x, top, firstFrame), frames, bottom - top,
                      index(0, 1, 0));
      }
    });
  });
  for (const std::vector<Region>& ofBlock : regions) {
    filtered_.insert(filtered_.end(), ofBlock.begin(), ofBlock.end());
  }
  std::fill_n(used_.begin() + static_cast<std::ptrdiff_t>(usedIndex(slab, 0, 0)),
              usedIndex(1, 0, 0), std::uint8_t{0});
}

double OccurrenceMap::meanOfUniformUse(const ExemplarLevel& exemplar,
                                       const std::vector<std::uint32_t>& pixels, int radiusFrames) {
  if (pixels.empty()) return 0.0;
  OccurrenceMap map(exemplar.size(), exemplar.frameCount(), radiusFrames);
  for (const std::uint32_t i : pixels) {
    const ExemplarLevel::Position p = exemplar.position(i);
    map.use(p.x, p.y, p.frame);
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
