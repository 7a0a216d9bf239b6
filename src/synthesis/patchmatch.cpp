#include "fluidymation/synthesis/patchmatch.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "fluidymation/core/parallel.h"
#include "fluidymation/core/random.h"

namespace fluidymation {
namespace {

constexpr float kUnknown = -1.0F;  // a distance that has not been computed
constexpr float kNever = std::numeric_limits<float>::infinity();

Random randomOf(const SearchProblem& problem, int pass) {
  return Random::ofPass(problem.options.seed, problem.place.frame, problem.place.level, pass);
}

/// Sweeps after which every neighbour's match has been tried once: a sweep takes matches from the
/// neighbours on one side, the next one from those on the other. What is tried again without a
/// change loses again.
constexpr int kSweepsPerDirection = 2;

/// The uniformity term of the patch distance, lambda Omega(window) / omega_best (thesis §2.5), per
/// unit of a window sum, for each segment of the target.
class UniformityScale {
 public:
  explicit UniformityScale(const SearchProblem& problem)
      : border_(scale(problem, Segment::kBorder)), interior_(scale(problem, Segment::kInterior)) {}

  [[nodiscard]] float operator()(Segment segment) const {
    return segment == Segment::kInterior ? interior_ : border_;
  }

 private:
  static float scale(const SearchProblem& problem, Segment segment) {
    const float best = problem.expectedUse.best(problem.target, segment);
    return best > 0.0F ? problem.options.lambda / (best * static_cast<float>(kPatchArea)) : 0.0F;
  }

  float border_;
  float interior_;
};

struct Tile {
  int left = 0;
  int top = 0;
  int right = 0;   ///< exclusive
  int bottom = 0;  ///< exclusive

  [[nodiscard]] bool contains(int x, int y) const {
    return x >= left && x < right && y >= top && y < bottom;
  }
};

/// Tiles with at least one pixel inside the mask, in row order.
std::vector<Tile> occupiedTiles(const TargetLevel& target) {
  const Size size = target.size();
  std::vector<Tile> tiles;
  for (int top = 0; top < size.height; top += kTileSidePx) {
    for (int left = 0; left < size.width; left += kTileSidePx) {
      const Tile tile{left, top, std::min(left + kTileSidePx, size.width),
                      std::min(top + kTileSidePx, size.height)};
      bool occupied = false;
      for (int y = tile.top; y < tile.bottom && !occupied; ++y) {
        for (int x = tile.left; x < tile.right && !occupied; ++x) occupied = target.inside(x, y);
      }
      if (occupied) tiles.push_back(tile);
    }
  }
  return tiles;
}

/// How far a random place may lie from the best match along each axis: px, px, frames.
struct SearchBox {
  int x = 0;
  int y = 0;
  int frames = 0;
};

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

/// From a pixel to a neighbour that a sweep in row order has visited before it.
struct Step {
  int x;
  int y;
};
constexpr std::array<Step, 4> kNeighbors{{{-1, 0}, {0, -1}, {-1, -1}, {1, -1}}};
constexpr std::size_t kAdjacentNeighbors = 2;

/// What a sweep reads and does not change.
struct SweepInputs {
  const SearchProblem& problem;
  const PatchDistance& distance;
  const UniformityScale& uniformity;
  const NearestNeighborField& before;  ///< all matches as they were before the sweep
  const OccurrenceMap& occurrence;     ///< all uses as of then
  const std::vector<SearchBox>& boxes;
  Random random;              ///< of the sweep, before any pixel's
  const Mask& changing;       ///< where the sweep before this one changed the match
  int pass = 0;               ///< number of the sweep within the level of the frame
  std::size_t neighbors = 0;  ///< how many of kNeighbors are asked for their matches
  bool everyNeighbor = true;  ///< false: neighbours' matches tried before are not tried again
  bool drawsAtRandom = true;
  bool everywhere = true;  ///< false: nothing is drawn for what no longer changes
};

/// One sweep of PatchMatch over one tile.
class TileSweep {
 public:
  /// @param ownChanges  scratch, all zero before and after: what the tile changes meanwhile.
  ///   Without it all pixels of a small target flock to what few use, in every sweep anew.
  /// @param errors   patch distances, without uniformity term, of the matches in `nnf`, as far as
  ///   they are known; kUnknown elsewhere.
  /// @param changed  is set where the sweep changes the match; zero before.
  TileSweep(const SweepInputs& in, const Tile& tile, UseChanges& ownChanges,
            NearestNeighborField& nnf, Image<float>& errors, Mask& changed)
      : in_(in),
        tile_(tile),
        ownChanges_(ownChanges),
        nnf_(nnf),
        errors_(errors),
        changed_(changed),
        draws_(in.boxes.size()) {}

  /// Visits every pixel once, in row order or, on odd passes, in the opposite order.
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
    bestDistance_ = errors_(x_, y_);
    if (bestDistance_ == kUnknown) {
      int samples = 0;
      bestDistance_ = in_.distance(window_, start_, kNever, &samples);
      count(1, samples);
      errors_(x_, y_) = bestDistance_;
    }
    bestTotal_ = bestDistance_ + uniformityTerm(startX_, startY_, start_.frame);
  }

  /// lambda Omega / omega_best, of the uses by all other pixels. The visited pixel's own match is
  /// in the counts, what it might take is not; charged for that, a match loses to any as good that
  /// lies elsewhere, and small targets, whose omega_best is small, change for ever.
  [[nodiscard]] float uniformityTerm(int sx, int sy, int frame) const {
    const std::int32_t own =
        in_.occurrence.contribution(startX_, startY_, start_.frame, sx, sy, frame);
    const auto others = static_cast<float>(in_.occurrence.windowSum(sx, sy, frame) - own);
    return scale_ * (in_.drawsAtRandom ? others + ownChanges_.windowSum(sx, sy, frame) : others);
  }

  /// @param sx  nearest pixel of the candidate, in the image.
  void tryMatch(const Match& candidate, int sx, int sy) {
    prepare();
    const float uniformity = uniformityTerm(sx, sy, candidate.frame);
    if (uniformity >= bestTotal_) return;
    int samples = 0;
    const float distance = in_.distance(window_, candidate, bestTotal_ - uniformity, &samples);
    count(1, samples);
    keepIfBetter(candidate, distance, uniformity);
  }

  bool keepIfBetter(const Match& candidate, float distance, float uniformity) {
    if (!(distance + uniformity < bestTotal_)) return false;  // nor a NaN
    best_ = candidate;
    bestDistance_ = distance;
    bestTotal_ = distance + uniformity;
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
    const Match& neighbor = isOwn ? nnf_(nx, ny) : in_.before(nx, ny);
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
    Match candidate{static_cast<float>(place.x), static_cast<float>(place.y), place.frame,
                    alignedRotation(in_.problem, x_, y_, place.x, place.y, place.frame)};
    int samples = 0;
    const std::array<float, 2> distances =
        in_.distance.ofBothWays(window_, candidate, bestTotal_ - uniformity, samples);
    count(2, samples);
    const bool sameWay = keepIfBetter(candidate, distances[0], uniformity);
    candidate.rotation = candidate.rotation.opposite();
    return keepIfBetter(candidate, distances[1], uniformity) || sameWay;
  }

  void keepBest() {
    if (sameSource(best_, start_)) return;
    if (in_.drawsAtRandom) {
      ownChanges_.add(start_, -1);
      ownChanges_.add(best_, +1);
    }
    changed_(x_, y_) = 1;
    ++changeCount_;
    nnf_(x_, y_) = best_;
    errors_(x_, y_) = bestDistance_;
  }

  void takeBackChanges() {
    if (ownChanges_.isCheaperToClear(2 * changeCount_)) {
      ownChanges_.clear();
      return;
    }
    for (int y = tile_.top; y < tile_.bottom; ++y) {
      for (int x = tile_.left; x < tile_.right; ++x) {
        if (changed_(x, y) == 0) continue;
        ownChanges_.add(in_.before(x, y), +1);
        ownChanges_.add(nnf_(x, y), -1);
      }
    }
  }

  static bool sameSource(const Match& a, const Match& b) {
    return a.x == b.x && a.y == b.y && a.frame == b.frame &&
           a.rotation.cosine == b.rotation.cosine && a.rotation.sine == b.rotation.sine;
  }

  const SweepInputs& in_;
  Tile tile_;
  UseChanges& ownChanges_;
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
};

/// The nearest legal pixel within kRepairRadiusPx of `match`, in its frame; the first in row order
/// among equals.
std::optional<Match> nearestLegal(const ExemplarLevel& exemplar, const Match& match,
                                  Segment segment) {
  std::optional<Match> best;
  constexpr auto kRadiusSquare = static_cast<float>(kRepairRadiusPx * kRepairRadiusPx);
  float bestSquare = kNever;
  for (int y = match.nearestY() - kRepairRadiusPx; y <= match.nearestY() + kRepairRadiusPx; ++y) {
    for (int x = match.nearestX() - kRepairRadiusPx; x <= match.nearestX() + kRepairRadiusPx; ++x) {
      if (!exemplar.isLegal(x, y, match.frame, segment)) continue;
      const Vec2 away{static_cast<float>(x) - match.x, static_cast<float>(y) - match.y};
      const float square = dot(away, away);
      if (square > kRadiusSquare || square >= bestSquare) continue;
      bestSquare = square;
      best = Match{static_cast<float>(x), static_cast<float>(y), match.frame, match.rotation};
    }
  }
  return best;
}

OccurrenceMap emptyOccurrence(const SearchProblem& problem) {
  return {problem.exemplar.size(), problem.exemplar.frameCount(), problem.options.occRadiusFrames};
}

}  // namespace

Rotation alignedRotation(const SearchProblem& problem, int x, int y, int sx, int sy, int k) {
  return Rotation::between(problem.exemplar.direction(sx, sy, k), problem.target.direction(x, y));
}

Match randomMatch(const SearchProblem& problem, int x, int y, int pass) {
  const std::vector<std::uint32_t>& candidates =
      problem.exemplar.candidates(problem.target.segment(x, y));
  assert(!candidates.empty());
  const Pixel origin = problem.place.origin;
  Random random = randomOf(problem, pass).at(origin.x + x, origin.y + y);
  const ExemplarLevel::Position p =
      problem.exemplar.position(candidates[random.below(candidates.size())]);
  const Rotation aligned = alignedRotation(problem, x, y, p.x, p.y, p.frame);
  return {static_cast<float>(p.x), static_cast<float>(p.y), p.frame,
          random.uniform(0, 1) == 0 ? aligned : aligned.opposite()};
}

void repair(const SearchProblem& problem, int pass, NearestNeighborField& nnf) {
  forEachRow(nnf.height(), [&](int y) {
    for (int x = 0; x < nnf.width(); ++x) {
      Match& match = nnf(x, y);
      if (!problem.target.inside(x, y)) {
        match = Match{};
        continue;
      }
      const Segment segment = problem.target.segment(x, y);
      if (problem.exemplar.isLegal(match, segment)) continue;
      const std::optional<Match> near =
          match.exists() ? nearestLegal(problem.exemplar, match, segment) : std::nullopt;
      match = near ? *near : randomMatch(problem, x, y, pass);
    }
  });
}

Image<float> matchErrors(const SearchProblem& problem, const DistanceWeights& weights,
                         const NearestNeighborField& nnf, const Image<float>* bounds) {
  OccurrenceMap occurrence = emptyOccurrence(problem);
  occurrence.rebuild(nnf);
  const UniformityScale uniformity(problem);
  const PatchDistance distance(problem.exemplar, problem.target, weights);
  Image<float> errors(nnf.size(), kNever);
  forEachRow(nnf.height(), [&](int y) {
    TargetWindow window;
    for (int x = 0; x < nnf.width(); ++x) {
      const Segment segment = problem.target.segment(x, y);
      if (segment == Segment::kOutside || !problem.exemplar.isLegal(nnf(x, y), segment)) continue;
      const float bound = bounds == nullptr ? kNever : (*bounds)(x, y);
      const float use = uniformity(segment) * static_cast<float>(occurrence.windowSum(nnf(x, y)));
      if (use >= bound) continue;
      distance.gather(x, y, window);
      const float error = distance(window, nnf(x, y), bound - use);
      // Rounding may tell one of the two from the other
      if (error < bound - use && error + use < bound) errors(x, y) = error + use;
    }
  });
  return errors;
}

SearchStatistics findNearestNeighbors(const SearchProblem& problem, const DistanceWeights& weights,
                                      int iterations, int firstPass, NearestNeighborField& nnf,
                                      Candidates candidates, Mask* changing) {
  const PatchDistance distance(problem.exemplar, problem.target, weights);
  const UniformityScale uniformity(problem);
  const std::vector<Tile> tiles = occupiedTiles(problem.target);
  SearchStatistics statistics;
  if (tiles.empty()) return statistics;
  Image<float> errors(nnf.size(), kUnknown);
  OccurrenceMap occurrence = emptyOccurrence(problem);
  // One scratch map per thread that can have work, all zero between tiles.
  const int workers = std::min(threadLimit(), static_cast<int>(tiles.size()));
  std::vector<UseChanges> ownChanges;
  ownChanges.reserve(static_cast<std::size_t>(workers));
  for (int w = 0; w < workers; ++w) {
    ownChanges.emplace_back(problem.exemplar.size(), problem.exemplar.frameCount(),
                            problem.options.occRadiusFrames);
  }
  const std::vector<SearchBox> boxes = searchBoxes(problem);
  const bool focused = problem.options.searchEffort == SearchEffort::kWhereItChanges;
  const bool draws = candidates == Candidates::kAll;
  const bool isFirst = changing == nullptr || changing->empty();
  Mask changed = isFirst ? Mask(nnf.size(), 1) : std::move(*changing);

  for (int i = 0; i < iterations; ++i) {
    const NearestNeighborField before = nnf.clone();
    occurrence.rebuild(before);
    const Mask changedBefore = std::exchange(changed, Mask(nnf.size()));
    SweepInputs inputs{problem,
                       distance,
                       uniformity,
                       before,
                       occurrence,
                       boxes,
                       randomOf(problem, firstPass + i),
                       changedBefore};
    inputs.pass = firstPass + i;
    inputs.neighbors = focused && draws ? kNeighbors.size() : kAdjacentNeighbors;
    inputs.everyNeighbor = !focused || i < kSweepsPerDirection;
    inputs.drawsAtRandom = draws;
    inputs.everywhere = !focused || (isFirst && i == 0);
    std::vector<SearchStatistics> ofTiles(tiles.size());
    parallelFor(
        static_cast<int>(tiles.size()), 1,
        [&](int t) {
          const auto tile = static_cast<std::size_t>(t);
          UseChanges& own = ownChanges[static_cast<std::size_t>(threadIndex())];
          ofTiles[tile] = TileSweep(inputs, tiles[tile], own, nnf, errors, changed).run();
        },
        workers);
    for (const SearchStatistics& tile : ofTiles) statistics += tile;
  }
  if (changing != nullptr) *changing = std::move(changed);
  return statistics;
}

}  // namespace fluidymation
