#include "fluidymation/synthesis/patchmatch.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "fluidymation/core/parallel.h"
#include "fluidymation/core/random.h"

namespace fluidymation {
namespace {

constexpr float kNever = std::numeric_limits<float>::infinity();

Random randomAt(const SearchProblem& problem, int pass, int x, int y) {
  return Random({problem.options.seed, problem.place.frame, problem.place.level, pass, x, y});
}

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

/// One sweep of PatchMatch over one tile.
class TileSweep {
 public:
  /// @param before      all matches as they were before the sweep.
  /// @param occurrence  all uses as of before the sweep.
  /// @param ownChanges  scratch, all zero before and after: the tile's own changes meanwhile.
  /// @param errors      patch distances, without uniformity term, of the matches in `nnf`.
  TileSweep(const SearchProblem& problem, const PatchDistance& distance,
            const UniformityScale& uniformity, const NearestNeighborField& before,
            const OccurrenceMap& occurrence, OccurrenceMap& ownChanges, const Tile& tile,
            NearestNeighborField& nnf, Image<float>& errors)
      : problem_(problem),
        distance_(distance),
        uniformity_(uniformity),
        before_(before),
        occurrence_(occurrence),
        ownChanges_(ownChanges),
        tile_(tile),
        nnf_(nnf),
        errors_(errors) {}

  /// Visits every pixel once, in row order or, on odd passes, in the opposite order.
  void run(int pass, Candidates candidates) {
    const int step = pass % 2 == 0 ? 1 : -1;
    const int firstY = step > 0 ? tile_.top : tile_.bottom - 1;
    const int firstX = step > 0 ? tile_.left : tile_.right - 1;
    for (int y = firstY; y >= tile_.top && y < tile_.bottom; y += step) {
      for (int x = firstX; x >= tile_.left && x < tile_.right; x += step) {
        if (!problem_.target.inside(x, y)) continue;
        visit(x, y);
        propagate(x, y, x - step, y);
        propagate(x, y, x, y - step);
        if (candidates == Candidates::kAll) searchAtRandom(x, y, pass);
        keepBest(x, y);
      }
    }
    forgetOwnChanges();
  }

 private:
  void visit(int x, int y) {
    segment_ = problem_.target.segment(x, y);
    scale_ = uniformity_(segment_);
    start_ = best_ = nnf_(x, y);
    bestDistance_ = errors_(x, y);
    bestTotal_ = bestDistance_ + uniformityTerm(best_);
    distance_.gather(x, y, window_);
  }

  /// lambda Omega / omega_best, of the uses by all other pixels. What the visited pixel takes now
  /// is in the counts, what it might take is not; charged for that, a match loses to any as good
  /// that lies elsewhere, and small targets, whose omega_best is small, change for ever.
  [[nodiscard]] float uniformityTerm(const Match& match) const {
    const std::int32_t uses = occurrence_.windowSum(match) + ownChanges_.windowSum(match);
    return scale_ * static_cast<float>(uses - occurrence_.contribution(start_, match));
  }

  void tryMatch(const Match& candidate) {
    const float uniformityOfCandidate = uniformityTerm(candidate);
    if (uniformityOfCandidate >= bestTotal_) return;
    const float distance = distance_(window_, candidate, bestTotal_ - uniformityOfCandidate);
    if (!(distance + uniformityOfCandidate < bestTotal_)) return;  // nor a NaN
    best_ = candidate;
    bestDistance_ = distance;
    bestTotal_ = distance + uniformityOfCandidate;
  }

  /// Tries to continue the neighbour's patch (§2.2); its position moves by R_-theta(step).
  void propagate(int x, int y, int neighborX, int neighborY) {
    if (!before_.contains(neighborX, neighborY)) return;
    const Match& neighbor = tile_.contains(neighborX, neighborY) ? nnf_(neighborX, neighborY)
                                                                 : before_(neighborX, neighborY);
    if (!neighbor.exists()) return;
    const Match candidate =
        neighbor.moved({static_cast<float>(x - neighborX), static_cast<float>(y - neighborY)});
    if (problem_.exemplar.isLegal(candidate, segment_)) tryMatch(candidate);
  }

  /// Draws from boxes that shrink round the best match so far (§4.3); of the rotations only those
  /// that align the flows, the same way and opposite, are tried.
  void searchAtRandom(int x, int y, int pass) {
    Random random = randomAt(problem_, pass, x, y);
    const ExemplarLevel& exemplar = problem_.exemplar;
    const Size size = exemplar.size();
    const int longest = std::max({size.width, size.height, exemplar.frameCount()});
    const auto draw = [&random](int centre, float radius, int length) {
      const int reach = static_cast<int>(radius);
      return random.uniform(std::max(centre - reach, 0), std::min(centre + reach, length - 1));
    };
    for (float ratio = 1.0F; ratio * static_cast<float>(longest) >= 1.0F;
         ratio *= problem_.options.patchmatchAlpha) {
      const int sx = draw(best_.nearestX(), ratio * static_cast<float>(size.width), size.width);
      const int sy = draw(best_.nearestY(), ratio * static_cast<float>(size.height), size.height);
      const int k = draw(best_.frame, ratio * static_cast<float>(exemplar.frameCount()),
                         exemplar.frameCount());
      if (!exemplar.isLegal(sx, sy, k, segment_)) continue;
      const Rotation aligned = alignedRotation(problem_, x, y, sx, sy, k);
      const auto fx = static_cast<float>(sx);
      const auto fy = static_cast<float>(sy);
      tryMatch({fx, fy, k, aligned});
      tryMatch({fx, fy, k, aligned.opposite()});
    }
  }

  void keepBest(int x, int y) {
    if (bestDistance_ == errors_(x, y) && sameSource(best_, start_)) return;
    ownChanges_.add(start_, -1);
    ownChanges_.add(best_, +1);
    nnf_(x, y) = best_;
    errors_(x, y) = bestDistance_;
  }

  static bool sameSource(const Match& a, const Match& b) {
    return a.x == b.x && a.y == b.y && a.frame == b.frame &&
           a.rotation.cosine == b.rotation.cosine && a.rotation.sine == b.rotation.sine;
  }

  /// Leaves the scratch map as it was found: all zero.
  void forgetOwnChanges() {
    for (int y = tile_.top; y < tile_.bottom; ++y) {
      for (int x = tile_.left; x < tile_.right; ++x) {
        if (!problem_.target.inside(x, y) || sameSource(before_(x, y), nnf_(x, y))) continue;
        ownChanges_.add(before_(x, y), +1);
        ownChanges_.add(nnf_(x, y), -1);
      }
    }
  }

  const SearchProblem& problem_;
  const PatchDistance& distance_;
  const UniformityScale& uniformity_;
  const NearestNeighborField& before_;
  const OccurrenceMap& occurrence_;
  OccurrenceMap& ownChanges_;
  Tile tile_;
  NearestNeighborField& nnf_;
  Image<float>& errors_;

  // Of the pixel being visited:
  TargetWindow window_;
  Segment segment_ = Segment::kOutside;
  float scale_ = 0.0F;
  Match start_;
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

/// Patch distance, without uniformity term, of every match; kNever where not legal.
Image<float> patchDistances(const SearchProblem& problem, const PatchDistance& distance,
                            const NearestNeighborField& nnf) {
  Image<float> errors(nnf.size(), kNever);
  forEachRow(nnf.height(), [&](int y) {
    TargetWindow window;
    for (int x = 0; x < nnf.width(); ++x) {
      if (!problem.target.inside(x, y) ||
          !problem.exemplar.isLegal(nnf(x, y), problem.target.segment(x, y))) {
        continue;
      }
      distance.gather(x, y, window);
      errors(x, y) = distance(window, nnf(x, y), kNever);
    }
  });
  return errors;
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
  Random random = randomAt(problem, pass, x, y);
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
                         const NearestNeighborField& nnf) {
  OccurrenceMap occurrence = emptyOccurrence(problem);
  occurrence.rebuild(nnf);
  const UniformityScale uniformity(problem);
  const PatchDistance distance(problem.exemplar, problem.target, weights);
  Image<float> errors = patchDistances(problem, distance, nnf);
  forEachRow(nnf.height(), [&](int y) {
    for (int x = 0; x < nnf.width(); ++x) {
      if (errors(x, y) == kNever) continue;
      errors(x, y) += uniformity(problem.target.segment(x, y)) *
                      static_cast<float>(occurrence.windowSum(nnf(x, y)));
    }
  });
  return errors;
}

void findNearestNeighbors(const SearchProblem& problem, const DistanceWeights& weights,
                          int iterations, int firstPass, NearestNeighborField& nnf,
                          Candidates candidates) {
  const PatchDistance distance(problem.exemplar, problem.target, weights);
  const UniformityScale uniformity(problem);
  const std::vector<Tile> tiles = occupiedTiles(problem.target);
  if (tiles.empty()) return;
  Image<float> errors = patchDistances(problem, distance, nnf);
  OccurrenceMap occurrence = emptyOccurrence(problem);
  // One scratch map per thread that can have work, all zero between tiles.
  const int workers = std::min(threadLimit(), static_cast<int>(tiles.size()));
  std::vector<OccurrenceMap> ownChanges;
  ownChanges.reserve(static_cast<std::size_t>(workers));
  for (int t = 0; t < workers; ++t) ownChanges.push_back(emptyOccurrence(problem));

  for (int i = 0; i < iterations; ++i) {
    const NearestNeighborField before = nnf.clone();
    occurrence.rebuild(before);
    parallelFor(
        static_cast<int>(tiles.size()), 1,
        [&](int t) {
          TileSweep(problem, distance, uniformity, before, occurrence,
                    ownChanges[static_cast<std::size_t>(threadIndex())],
                    tiles[static_cast<std::size_t>(t)], nnf, errors)
              .run(firstPass + i, candidates);
        },
        workers);
  }
}

}  // namespace fluidymation
