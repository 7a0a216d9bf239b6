#include "fluidymation/synthesis/patchmatch.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <optional>
#include <utility>
#include <vector>

#include "fluidymation/core/parallel.h"
#include "synthesis/tile_sweep.h"

namespace fluidymation {
namespace {

/// Sweeps after which every neighbour's match has been tried once: a sweep takes matches from the
/// neighbours on one side, the next one from those on the other. What is tried again without a
/// change loses again.
constexpr int kSweepsPerDirection = 2;

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

/// From the first to the last pixel inside, of each row.
std::vector<RowSpan> spansOf(const TargetLevel& target) {
  std::vector<RowSpan> rows;
  for (int y = 0; y < target.size().height; ++y) {
    RowSpan span{0, target.size().width};
    while (span.begin < span.end && !target.inside(span.begin, y)) ++span.begin;
    while (span.end > span.begin && !target.inside(span.end - 1, y)) --span.end;
    rows.push_back(span);
  }
  return rows;
}

/// The memory that a problem brings along, or else some of its own.
class Memory {
 public:
  explicit Memory(const SearchProblem& problem)
      : problem_(problem), memory_(problem.memory != nullptr ? *problem.memory : own_) {}

  /// The map of the matches of `nnf`.
  const OccurrenceMap& occurrenceOf(const NearestNeighborField& nnf) {
    map().rebuild(nnf);
    return map();
  }
  /// The same where there are none but in these rows.
  const OccurrenceMap& occurrenceOf(const NearestNeighborField& nnf,
                                    const std::vector<RowSpan>& rows) {
    map().rebuild(nnf, rows);
    return map();
  }

  /// One scratch map per thread, all zero between tiles.
  std::vector<UseChanges>& ownChanges(int threads) {
    const auto wanted = static_cast<std::size_t>(threads);
    memory_.ownChanges.reserve(wanted);
    while (memory_.ownChanges.size() < wanted) {
      memory_.ownChanges.emplace_back(size(), frames(), radius());
    }
    return memory_.ownChanges;
  }

 private:
  OccurrenceMap& map() {
    if (!memory_.occurrence) memory_.occurrence.emplace(size(), frames(), radius());
    return *memory_.occurrence;
  }
  [[nodiscard]] Size size() const { return problem_.exemplar.size(); }
  [[nodiscard]] int frames() const { return problem_.exemplar.frameCount(); }
  [[nodiscard]] int radius() const { return problem_.options.occRadiusFrames; }

  const SearchProblem& problem_;
  SearchMemory own_;
  SearchMemory& memory_;
};

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
  Memory memory(problem);
  const OccurrenceMap& occurrence = memory.occurrenceOf(nnf);
  const UniformityScale uniformity(problem);
  const PatchDistance distance(problem.exemplar, problem.target, weights);
  Image<float> errors(nnf.size(), kNever);
  forEachRow(nnf.height(), [&](int y) {
    TargetWindow window;
    for (int x = 0; x < nnf.width(); ++x) {
      const Segment segment = problem.target.segment(x, y);
      if (segment == Segment::kOutside || !problem.exemplar.isLegal(nnf(x, y), segment)) continue;
      const float bound = bounds == nullptr ? kNever : (*bounds)(x, y);
      if (bound <= 0.0F) continue;  // before its use is looked up
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
  Memory memory(problem);
  const bool draws = candidates == Candidates::kAll;
  // Only threads that can have work, and only those that draw, take changes of their own
  const int workers = std::min(threadLimit(), static_cast<int>(tiles.size()));
  std::vector<UseChanges>& ownChanges = memory.ownChanges(draws ? workers : 0);
  const std::vector<SearchBox> boxes = searchBoxes(problem);
  const std::vector<RowSpan> rows = spansOf(problem.target);
  const bool focused = problem.options.searchEffort == SearchEffort::kWhereItChanges;
  const bool isFirst = changing == nullptr || changing->empty();
  Mask changed = isFirst ? Mask(nnf.size(), 1) : std::move(*changing);

  for (int i = 0; i < iterations; ++i) {
    const NearestNeighborField before = nnf.clone();
    const OccurrenceMap& occurrence = memory.occurrenceOf(before, rows);
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
    inputs.neighbors = focused && draws ? kAllNeighbors : kAdjacentNeighbors;
    inputs.everyNeighbor = !focused || i < kSweepsPerDirection;
    inputs.drawsAtRandom = draws;
    inputs.everywhere = !focused || (isFirst && i == 0);
    std::vector<SearchStatistics> ofTiles(tiles.size());
    parallelFor(
        static_cast<int>(tiles.size()), 1,
        [&](int t) {
          const auto tile = static_cast<std::size_t>(t);
          UseChanges* const own =
              draws ? &ownChanges[static_cast<std::size_t>(threadIndex())] : nullptr;
          ofTiles[tile] = sweepTile(inputs, tiles[tile], own, nnf, errors, changed);
        },
        workers);
    for (const SearchStatistics& tile : ofTiles) statistics += tile;
  }
  if (changing != nullptr) *changing = std::move(changed);
  return statistics;
}

}  // namespace fluidymation
