#include "synthesis/tile_sweep.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace fluidymation {
namespace {

/// From a pixel to a neighbour that a sweep in row order has visited before it.
struct Step {
  int x;
  int y;
};
constexpr std::array<Step, kAllNeighbors> kNeighbors{{{-1, 0}, {0, -1}, {-1, -1}, {1, -1}}};

/// To the neighbours that a match is to continue.
constexpr std::array<Step, 4> kBeside{{{-1, 0}, {1, 0}, {0, -1}, {0, 1}}};

/// One sweep of PatchMatch over one tile.
class TileSweep {
 public:
  TileSweep(const SweepInputs& in, const Tile& tile, UseChanges* ownChanges,
            NearestNeighborField& nnf, Image<float>& errors, Mask& changed)
      : in_(in),
        tile_(tile),
        ownChanges_(ownChanges),
        nnf_(nnf),
        errors_(errors),
        changed_(changed),
        draws_(in.boxes.size()) {}

  SearchStatistics run() {
    const int step = in_.pass % 2 == 0 ? 1 : -1;
    const int firstY = step > 0 ? tile_.top : tile_.bottom - 1;
    const int firstX = step > 0 ? tile_.left : tile_.right - 1;
    for (int y = firstY; y >= tile_.top && y < tile_.bottom; y += step) {
      for (int x = firstX; x >= tile_.left && x < tile_.right; x += step) {
        if (!in_.problem.target.inside(x, y)) continue;
        visit(x, y);
        for (std::size_t i = 0; i < in_.neighbors; ++i) {
          propagate(step * kNeighbors[i].x, step * kNeighbors[i].y);
        }
        if (isSearchedAtRandom()) searchAtRandom();
        keepBest();
      }
    }
    if (in_.drawsAtRandom) takeBackChanges();
    return statistics_;
  }

 private:
  void visit(int x, int y) {
    x_ = x;
    y_ = y;
    segment_ = in_.problem.target.segment(x, y);
    scale_ = in_.uniformity(segment_);
    start_ = best_ = nnf_(x, y);
    startX_ = start_.nearestX();
    startY_ = start_.nearestY();
    isReady_ = false;
  }

  /// What comparing takes, made only for pixels that have something to compare.
  void prepare() {
    if (isReady_) return;
    isReady_ = true;
    in_.distance.gather(x_, y_, window_);
    gatherContinuations();
    bestDistance_ = errors_(x_, y_);
    if (bestDistance_ == kUnknown) {
      int samples = 0;
      bestDistance_ = in_.distance(window_, start_, kNever, &samples);
      count(1, samples);
      errors_(x_, y_) = bestDistance_;
    }
    bestTotal_ =
        bestDistance_ + uniformityTerm(startX_, startY_, start_.frame) + incoherenceTerm(start_);
  }

  /// A neighbour's match as it stands, or beyond the tile's edge as it was before the sweep.
  [[nodiscard]] const Match& matchAt(int x, int y) const {
    return tile_.contains(x, y) ? nnf_(x, y) : in_.before(x, y);
  }

  void gatherContinuations() {
    continuationCount_ = 0;
    if (in_.problem.options.coherenceWeight == 0.0F) return;
    for (const Step& step : kBeside) {
      const int nx = x_ + step.x;
      const int ny = y_ + step.y;
      if (!nnf_.contains(nx, ny) || !matchAt(nx, ny).exists()) continue;
      continuations_[continuationCount_++] =
          matchAt(nx, ny).moved({static_cast<float>(-step.x), static_cast<float>(-step.y)});
    }
  }

  /// The share of the neighbours whose patches the match does not continue, weighted.
  [[nodiscard]] float incoherenceTerm(const Match& match) const {
    if (continuationCount_ == 0) return 0.0F;
    const auto broken = std::count_if(
        continuations_.begin(), continuations_.begin() + continuationCount_,
        [&match](const Match& continuation) { return !continues(match, continuation); });
    return in_.problem.options.coherenceWeight * static_cast<float>(broken) /
           static_cast<float>(continuationCount_);
  }

  /// lambda Omega / omega_best, of the uses by all other pixels. The visited pixel's own match is
  /// in the counts, what it might take is not; charged for that, a match loses to any as good that
  /// lies elsewhere, and small targets, whose omega_best is small, change for ever.
  [[nodiscard]] float uniformityTerm(int sx, int sy, int frame) const {
    const std::int32_t own =
        in_.occurrence.contribution(startX_, startY_, start_.frame, sx, sy, frame);
    const auto others = static_cast<float>(in_.occurrence.windowSum(sx, sy, frame) - own);
    return scale_ * (in_.drawsAtRandom ? others + ownChanges_->windowSum(sx, sy, frame) : others);
  }

  /// @param sx  nearest pixel of the candidate, in the image.
  void tryMatch(const Match& candidate, int sx, int sy) {
    prepare();
    const float charge = uniformityTerm(sx, sy, candidate.frame) + incoherenceTerm(candidate);
    if (charge >= bestTotal_) return;
    int samples = 0;
    const float distance = in_.distance(window_, candidate, bestTotal_ - charge, &samples);
    count(1, samples);
    keepIfBetter(candidate, distance, charge);
  }

  /// @param charge  what the candidate costs besides its patch distance.
  bool keepIfBetter(const Match& candidate, float distance, float charge) {
    if (!(distance + charge < bestTotal_)) return false;  // nor a NaN
    best_ = candidate;
    bestDistance_ = distance;
    bestTotal_ = distance + charge;
    return true;
  }

  void count(int distances, int samples) {
    statistics_.distances += static_cast<std::uint64_t>(distances);
    statistics_.samples += static_cast<std::uint64_t>(distances * samples);
  }

  /// Tries to continue a neighbour's patch (§2.2); its position moves by R_-theta(step).
  void propagate(int dx, int dy) {
    const int nx = x_ + dx;
    const int ny = y_ + dy;
    if (!nnf_.contains(nx, ny)) return;
    const bool isOwn = tile_.contains(nx, ny);
    // Beyond the tile's edge a change is seen one sweep late, and has to be tried when it is
    const bool isNew = !isOwn || in_.changing(nx, ny) != 0 || changed_(nx, ny) != 0;
    if (!in_.everyNeighbor && !isNew) return;
    const Match& neighbor = matchAt(nx, ny);
    if (!neighbor.exists()) return;
    const Match candidate = neighbor.moved({static_cast<float>(-dx), static_cast<float>(-dy)});
    if (areAlike(candidate, best_)) return;
    const int sx = candidate.nearestX();
    const int sy = candidate.nearestY();
    if (in_.problem.exemplar.isLegal(sx, sy, candidate.frame, segment_)) {
      tryMatch(candidate, sx, sy);
    }
  }

  [[nodiscard]] bool isSearchedAtRandom() const {
    if (!in_.drawsAtRandom) return false;
    return in_.everywhere || in_.changing(x_, y_) != 0 || !sameSource(best_, start_);
  }

  /// Draws from boxes that shrink round the best match so far (§4.3); of the rotations only those
  /// that align the flows, the same way and opposite, are tried. All places are drawn at once, so
  /// that their memory is at hand when their turn comes, and those that are left are drawn again
  /// from the same random numbers where the centre has moved.
  void searchAtRandom() {
    const Pixel origin = in_.problem.place.origin;
    Random random = in_.random.at(origin.x + x_, origin.y + y_);
    for (Draw& draw : draws_) draw.number = random.next64();
    drawFrom(0);
    prepare();
    std::size_t ahead = 0;
    for (std::size_t i = 0; i < draws_.size(); ++i) {
      for (; ahead < std::min(i + kAhead, draws_.size()); ++ahead) lookAt(draws_[ahead].place);
      if (!tryPlace(draws_[i].place)) continue;
      drawFrom(i + 1);
      ahead = i + 1;
    }
  }

  struct Place {
    int x = 0;
    int y = 0;
    int frame = 0;
    bool isLegal = false;
  };
  struct Draw {
    std::uint64_t number = 0;
    Place place;
  };
  static constexpr std::size_t kAhead = 3;  ///< windows asked for before their turn

  void drawFrom(std::size_t first) {
    for (std::size_t i = first; i < draws_.size(); ++i) {
      Place& place = draws_[i].place;
      place = placeIn(in_.boxes[i], draws_[i].number);
      in_.problem.exemplar.prefetchSegment(place.x, place.y, place.frame);
    }
  }

  void lookAt(Place& place) {
    place.isLegal = in_.problem.exemplar.isLegal(place.x, place.y, place.frame, segment_);
    if (!place.isLegal) return;
    in_.problem.exemplar.prefetchWindow(place.x, place.y, place.frame);
    in_.occurrence.prefetch(place.x, place.y, place.frame);
  }

  /// The place that a random number stands for in a box round the best match.
  [[nodiscard]] Place placeIn(const SearchBox& box, std::uint64_t number) const {
    const Size size = in_.problem.exemplar.size();
    return {drawAround(best_.nearestX(), box.x, size.width, number >> 42U),
            drawAround(best_.nearestY(), box.y, size.height, number >> 21U),
            drawAround(best_.frame, box.frames, in_.problem.exemplar.frameCount(), number), false};
  }

  /// From [0, length), at most `reach` from the centre; by the lowest 21 bits of a random number.
  static int drawAround(int centre, int reach, int length, std::uint64_t number) {
    constexpr unsigned kBits = 21;
    constexpr std::uint64_t kMask = (1U << kBits) - 1U;
    const int low = std::max(centre - reach, 0);
    const int high = std::min(centre + reach, length - 1);
    const std::uint64_t range = static_cast<std::uint64_t>(high - low) + 1;
    return low + static_cast<int>(((number & kMask) * range) >> kBits);
  }

  /// Tries both rotations at a place. @return  whether one of them is the best match now.
  bool tryPlace(const Place& place) {
    if (!place.isLegal) return false;
    const float uniformity = uniformityTerm(place.x, place.y, place.frame);
    if (uniformity >= bestTotal_) return false;
    Match sameWay{static_cast<float>(place.x), static_cast<float>(place.y), place.frame,
                  alignedRotation(in_.problem, x_, y_, place.x, place.y, place.frame)};
    Match opposite = sameWay;
    opposite.rotation = sameWay.rotation.opposite();
    const float sameWayCharge = uniformity + incoherenceTerm(sameWay);
    const float oppositeCharge = uniformity + incoherenceTerm(opposite);
    const float bound = bestTotal_ - std::min(sameWayCharge, oppositeCharge);
    if (bound <= 0.0F) return false;
    int samples = 0;
    const std::array<float, 2> distances =
        in_.distance.ofBothWays(window_, sameWay, bound, samples);
    count(2, samples);
    const bool isSameWayKept = keepIfBetter(sameWay, distances[0], sameWayCharge);
    return keepIfBetter(opposite, distances[1], oppositeCharge) || isSameWayKept;
  }

  void keepBest() {
    if (sameSource(best_, start_)) return;
    if (in_.drawsAtRandom) {
      ownChanges_->add(start_, -1);
      ownChanges_->add(best_, +1);
    }
    changed_(x_, y_) = 1;
    ++changeCount_;
    nnf_(x_, y_) = best_;
    errors_(x_, y_) = bestDistance_;
  }

  void takeBackChanges() {
    if (ownChanges_->isCheaperToClear(2 * changeCount_)) {
      ownChanges_->clear();
      return;
    }
    for (int y = tile_.top; y < tile_.bottom; ++y) {
      for (int x = tile_.left; x < tile_.right; ++x) {
        if (changed_(x, y) == 0) continue;
        ownChanges_->add(in_.before(x, y), +1);
        ownChanges_->add(nnf_(x, y), -1);
      }
    }
  }

  static bool sameSource(const Match& a, const Match& b) {
    return a.x == b.x && a.y == b.y && a.frame == b.frame &&
           a.rotation.cosine == b.rotation.cosine && a.rotation.sine == b.rotation.sine;
  }

  const SweepInputs& in_;
  Tile tile_;
  UseChanges* ownChanges_;
  NearestNeighborField& nnf_;
  Image<float>& errors_;
  Mask& changed_;
  SearchStatistics statistics_;
  std::size_t changeCount_ = 0;

  // Of the pixel being visited:
  std::vector<Draw> draws_;  ///< one a box
  int x_ = 0;
  int y_ = 0;
  TargetWindow window_;
  bool isReady_ = false;  ///< whether `window_` and the best distances are this pixel's
  Segment segment_ = Segment::kOutside;
  float scale_ = 0.0F;
  Match start_;
  int startX_ = 0;  ///< nearest pixel of `start_`
  int startY_ = 0;
  Match best_;
  float bestDistance_ = 0.0F;
  float bestTotal_ = 0.0F;
  std::array<Match, kBeside.size()> continuations_;  ///< of the neighbours' patches, at this pixel
  std::size_t continuationCount_ = 0;                ///< how many neighbours have one
};

}  // namespace

/// Tiles with at least one pixel inside the mask, those with the most first: so that threads that
/// share them end at about the same time. For the result their order is of no account.
std::vector<Tile> occupiedTiles(const TargetLevel& target) {
  const Size size = target.size();
  std::vector<std::pair<int, Tile>> counted;
  for (int top = 0; top < size.height; top += kTileSidePx) {
    for (int left = 0; left < size.width; left += kTileSidePx) {
      const Tile tile{left, top, std::min(left + kTileSidePx, size.width),
                      std::min(top + kTileSidePx, size.height)};
      int inside = 0;
      for (int y = tile.top; y < tile.bottom; ++y) {
        for (int x = tile.left; x < tile.right; ++x) inside += target.inside(x, y) ? 1 : 0;
      }
      if (inside > 0) counted.emplace_back(inside, tile);
    }
  }
  std::stable_sort(counted.begin(), counted.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<Tile> tiles;
  tiles.reserve(counted.size());
  for (const auto& [inside, tile] : counted) tiles.push_back(tile);
  return tiles;
}

/// The whole exemplar first, then ever smaller by `patchmatchAlpha`, down to a pixel (§4.3).
std::vector<SearchBox> searchBoxes(const SearchProblem& problem) {
  const Size size = problem.exemplar.size();
  const int frames = problem.exemplar.frameCount();
  const int longest = std::max({size.width, size.height, frames});
  std::vector<SearchBox> boxes;
  for (float ratio = 1.0F; ratio * static_cast<float>(longest) >= 1.0F;
       ratio *= problem.options.patchmatchAlpha) {
    const auto reach = [ratio](int length) {
      return static_cast<int>(ratio * static_cast<float>(length));
    };
    boxes.push_back({reach(size.width), reach(size.height), reach(frames)});
  }
  return boxes;
}

SearchStatistics sweepTile(const SweepInputs& in, const Tile& tile, UseChanges* ownChanges,
                           NearestNeighborField& nnf, Image<float>& errors, Mask& changed) {
  return TileSweep(in, tile, ownChanges, nnf, errors, changed).run();
}

}  // namespace fluidymation
