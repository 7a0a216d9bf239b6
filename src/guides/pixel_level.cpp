#include "pixel_level.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "disjoint_sets.h"
#include "fluidymation/core/index.h"

namespace fluidymation {
namespace {

/// Neighbouring interior pixels of one row.
struct Run {
  int y = 0;
  int beginX = 0;
  int endX = 0;
  std::array<int, 2> first{};  ///< number of the run's first red and black unknown

  /// First pixel of a colour: 0 red, 1 black. May lie past the end.
  [[nodiscard]] int firstX(int color) const { return beginX + ((beginX + y + color) & 1); }
  [[nodiscard]] int pixels(int color) const { return (endX - firstX(color) + 1) / 2; }
  /// The unknown at x.
  [[nodiscard]] int unknownAt(int x) const {
    const int color = (x + y) & 1;
    return first[at(color)] + (x - firstX(color)) / 2;
  }
};

/// Runs in row order, those of row y from firstOfRow[y] on.
struct Runs {
  std::vector<Run> runs;
  std::vector<int> firstOfRow;
};

Runs findRuns(const Mask& region, const Mask& isBorder) {
  Runs result;
  result.firstOfRow.reserve(at(region.height()) + 1);
  for (int y = 0; y < region.height(); ++y) {
    result.firstOfRow.push_back(static_cast<int>(result.runs.size()));
    const std::uint8_t* inside = region.row(y);
    const std::uint8_t* border = isBorder.row(y);
    const int width = region.width();
    for (int x = 0; x < width; ++x) {
      if (inside[x] == 0 || border[x] != 0) continue;
      const int begin = x;
      while (x < width && inside[x] != 0 && border[x] == 0) ++x;
      result.runs.push_back({y, begin, x, {}});
    }
  }
  result.firstOfRow.push_back(static_cast<int>(result.runs.size()));
  return result;
}

bool touchesBorder(const Run& run, const Mask& isBorder) {
  const auto given = [&](int x, int y) { return isBorder.contains(x, y) && isBorder(x, y) != 0; };
  if (given(run.beginX - 1, run.y) || given(run.endX, run.y)) return true;
  for (int x = run.beginX; x < run.endX; ++x) {
    if (given(x, run.y - 1) || given(x, run.y + 1)) return true;
  }
  return false;
}

/// Drops the parts that no border pixel touches.
void keepSolvable(const Mask& isBorder, Runs& runs) {
  DisjointSets parts(static_cast<int>(runs.runs.size()));
  const int rows = static_cast<int>(runs.firstOfRow.size()) - 1;
  for (int y = 1; y < rows; ++y) {
    int above = runs.firstOfRow[at(y - 1)];
    int here = runs.firstOfRow[at(y)];
    while (above < runs.firstOfRow[at(y)] && here < runs.firstOfRow[at(y + 1)]) {
      const Run& a = runs.runs[at(above)];
      const Run& b = runs.runs[at(here)];
      if (a.beginX < b.endX && b.beginX < a.endX) parts.join(above, here);
      ++(a.endX < b.endX ? above : here);
    }
  }
  std::vector<bool> solvable(runs.runs.size());
  for (std::size_t i = 0; i < runs.runs.size(); ++i) {
    const auto part = at(parts.find(static_cast<int>(i)));
    if (!solvable[part]) solvable[part] = touchesBorder(runs.runs[i], isBorder);
  }
  std::vector<Run> kept;
  std::vector<int> firstOfRow;
  for (int y = 0; y < rows; ++y) {
    firstOfRow.push_back(static_cast<int>(kept.size()));
    for (int i = runs.firstOfRow[at(y)]; i < runs.firstOfRow[at(y + 1)]; ++i) {
      if (solvable[at(parts.find(i))]) kept.push_back(runs.runs[at(i)]);
    }
  }
  firstOfRow.push_back(static_cast<int>(kept.size()));
  runs = {std::move(kept), std::move(firstOfRow)};
}

/// The row above or below a run, walked along with it.
class NeighbourRow {
 public:
  /// @param dy  -1 above, 1 below.
  NeighbourRow(const Runs& runs, const Mask& isBorder, int y, int dy)
      : y_(y + dy), isBorder_(&isBorder) {
    if (y_ < 0 || y_ >= isBorder.height()) return;
    run_ = runs.runs.data() + runs.firstOfRow[at(y_)];
    end_ = runs.runs.data() + runs.firstOfRow[at(y_ + 1)];
  }

  /// To x, which never goes back.
  void moveTo(int x) {
    x_ = x;
    while (run_ != end_ && run_->endX <= x) ++run_;
  }

  /// The unknown at x, which is not beyond those alike; `kNoUnknown` where there is none.
  [[nodiscard]] int unknownAt(int x) const { return isUnknown() ? run_->unknownAt(x) : kNoUnknown; }
  [[nodiscard]] bool given() const { return isGiven(x_); }

  /// How far, at most up to endX, all pixels are like that at the current x.
  [[nodiscard]] int alikeUpTo(int endX) const {
    if (isUnknown()) return std::min(endX, run_->endX);
    const int gapEnd = run_ != end_ ? std::min(endX, run_->beginX) : endX;
    int x = x_ + 1;
    while (x < gapEnd && isGiven(x) == given()) ++x;
    return x;
  }

 private:
  [[nodiscard]] bool isUnknown() const { return run_ != end_ && run_->beginX <= x_; }
  [[nodiscard]] bool isGiven(int x) const {
    return isBorder_->contains(x, y_) && (*isBorder_)(x, y_) != 0;
  }

  int y_;
  const Mask* isBorder_;
  const Run* run_ = nullptr;
  const Run* end_ = nullptr;
  int x_ = 0;
};

/// Takes spans in the order of their unknowns, cut where a piece of work ends.
void appendCut(PixelSpan span, std::vector<PixelSpan>& spans) {
  while (span.begin < span.end) {
    PixelSpan piece = span;
    piece.end = std::min(span.end, (span.begin / kUnknownsAtATime + 1) * kUnknownsAtATime);
    spans.push_back(piece);
    const int step = piece.end - span.begin;
    span.begin = piece.end;
    span.x += 2 * step;
    for (int* link : {&span.left, &span.right, &span.up, &span.down}) {
      if (*link != kNoUnknown) *link += step;
    }
  }
}

/// The spans of both colours of pixels beginX..endX-1 of a run, which all have the same neighbours.
void appendSpans(const Run& run, int beginX, int endX, const NeighbourRow& above,
                 const NeighbourRow& below, const Mask& isBorder,
                 std::array<std::vector<PixelSpan>, 2>& spans) {
  const auto given = [&](int x) { return isBorder.contains(x, run.y) && isBorder(x, run.y) != 0; };
  for (int shift = 0; shift < std::min(2, endX - beginX); ++shift) {
    PixelSpan span;
    span.x = beginX + shift;
    span.y = run.y;
    span.begin = run.unknownAt(span.x);
    span.end = span.begin + (endX - span.x + 1) / 2;
    if (span.x > run.beginX) span.left = run.unknownAt(span.x - 1);
    if (span.x + 1 < run.endX) span.right = run.unknownAt(span.x + 1);
    span.up = above.unknownAt(span.x);
    span.down = below.unknownAt(span.x);
    const auto sideGiven = [](int unknown, bool isGiven) {
      return unknown == kNoUnknown && isGiven ? 1 : 0;
    };
    span.given = sideGiven(span.left, given(span.x - 1)) +
                 sideGiven(span.right, given(span.x + 1)) + sideGiven(span.up, above.given()) +
                 sideGiven(span.down, below.given());
    int linked = 0;
    for (const int link : {span.left, span.right, span.up, span.down}) {
      if (link != kNoUnknown) ++linked;
    }
    span.diagonal = static_cast<float>(span.given + linked);
    appendCut(span, spans[at((span.x + span.y) & 1)]);
  }
}

/// Numbers the sets of linked pixels that share a 2x2 block: red before black, and in the order of
/// the pixels. A block holds one set, or two pixels that only touch by their corners.
void numberParents(PixelLevel& fine, Size size, Pixel origin, GraphLevel& coarse) {
  Image<int> numberOf(Size{(size.width + 1) / 2, (size.height + 1) / 2}, kNoUnknown);
  fine.parent.resize(at(fine.count));
  const Pixel firstBlock{origin.x / 2, origin.y / 2};
  for (const int color : {0, 1}) {
    for (const PixelSpan& span : fine.spans) {
      const int blockY = span.y / 2;
      const int beside = span.x % 2 == 0 ? span.right : span.left;  // within the block
      const int across = span.y % 2 == 0 ? span.down : span.up;
      const bool alone = beside == kNoUnknown && across == kNoUnknown;
      const int firstBlockX = span.x / 2;
      const int begin =
          span.begin + ((firstBlockX + blockY + firstBlock.x + firstBlock.y + color) & 1);
      for (int i = begin; i < span.end; i += 2) {
        const int blockX = firstBlockX + i - span.begin;
        int number = alone ? kNoUnknown : numberOf(blockX, blockY);
        if (number == kNoUnknown) {
          number = static_cast<int>(coarse.blockX.size());
          coarse.blockX.push_back(firstBlock.x + blockX);
          coarse.blockY.push_back(firstBlock.y + blockY);
          if (!alone) numberOf(blockX, blockY) = number;
        }
        fine.parent[at(i)] = number;
      }
    }
    if (color == 0) coarse.redCount = static_cast<int>(coarse.blockX.size());
  }
}

}  // namespace

bool PixelLevel::hasLinks() const {
  return std::any_of(spans.begin(), spans.end(), [](const PixelSpan& span) {
    return span.diagonal > static_cast<float>(span.given);
  });
}

PixelLevel pixelLevel(const Mask& region, const Mask& isBorder) {
  Runs runs = findRuns(region, isBorder);
  keepSolvable(isBorder, runs);

  PixelLevel level;
  for (const int color : {0, 1}) {
    for (Run& run : runs.runs) {
      run.first[at(color)] = level.count;
      level.count += run.pixels(color);
    }
    if (color == 0) level.redCount = level.count;
  }

  std::array<std::vector<PixelSpan>, 2> spans;
  for (int y = 0; y < region.height(); ++y) {
    NeighbourRow above(runs, isBorder, y, -1);
    NeighbourRow below(runs, isBorder, y, 1);
    for (int r = runs.firstOfRow[at(y)]; r < runs.firstOfRow[at(y + 1)]; ++r) {
      const Run& run = runs.runs[at(r)];
      for (int x = run.beginX; x < run.endX;) {
        above.moveTo(x);
        below.moveTo(x);
        // The run's first and last pixel lack a neighbour that the others have
        const bool isEnd = x == run.beginX || x == run.endX - 1;
        const int limit = isEnd ? x + 1 : run.endX - 1;
        const int endX = std::min(above.alikeUpTo(limit), below.alikeUpTo(limit));
        appendSpans(run, x, endX, above, below, isBorder, spans);
        x = endX;
      }
    }
  }
  level.redSpans = static_cast<int>(spans[0].size());
  level.spans = std::move(spans[0]);
  level.spans.insert(level.spans.end(), spans[1].begin(), spans[1].end());
  for (std::size_t s = 0; s < level.spans.size(); ++s) {
    while (static_cast<int>(level.firstSpan.size()) * kUnknownsAtATime <= level.spans[s].begin) {
      level.firstSpan.push_back(static_cast<int>(s));
    }
  }
  level.firstSpan.push_back(static_cast<int>(level.spans.size()));
  return level;
}

GraphLevel coarserLevel(PixelLevel& fine, Size size, Pixel origin) {
  GraphLevel coarse;
  numberParents(fine, size, origin, coarse);
  listChildren(fine.parent, coarse);

  // The parents of each pixel's neighbours, left, right, above, below
  std::vector<std::array<int, 4>> parentsBeside(at(fine.count));
  coarse.givenPairs.assign(coarse.blockX.size(), 0.0F);
  const auto parentOf = [&](int unknown, int k) {
    return unknown == kNoUnknown ? kNoUnknown : fine.parent[at(unknown + k)];
  };
  for (const PixelSpan& span : fine.spans) {
    for (int k = 0; k < span.end - span.begin; ++k) {
      parentsBeside[at(span.begin + k)] = {parentOf(span.left, k), parentOf(span.right, k),
                                           parentOf(span.up, k), parentOf(span.down, k)};
    }
    if (span.given == 0) continue;
    for (int i = span.begin; i < span.end; ++i) {
      coarse.givenPairs[at(fine.parent[at(i)])] += static_cast<float>(span.given);
    }
  }

  LinkCollector links(coarse);
  for (std::size_t i = 0; i < coarse.blockX.size(); ++i) {
    for (int c = coarse.firstChild[i]; c < coarse.firstChild[i + 1]; ++c) {
      for (const int to : parentsBeside[at(coarse.child[at(c)])]) {
        if (to != kNoUnknown) links.add(to, 1.0F);
      }
    }
    coarse.pixelCount.push_back(
        static_cast<float>(coarse.firstChild[i + 1] - coarse.firstChild[i]));
    links.endUnknown();
  }
  constexpr int kBlockSidePx = 2;
  weighLinks(coarse, kBlockSidePx);
  return coarse;
}

}  // namespace fluidymation
