#include "fluidymation/guides/diffusion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "fluidymation/core/index.h"
#include "fluidymation/core/parallel.h"
#include "region_graph.h"

namespace fluidymation {
namespace {

using Field = std::vector<Vec2>;

/// The outer iteration is in double precision: on long thin regions that are given at their ends
/// only, single precision loses the slope (a path of n pixels multiplies rounding by n^2 / 8). Its
/// V-cycles, which only have to point in the right direction, are in single precision.
///
/// Also the scalars of the two components, which are solved side by side.
struct Vec2d {
  double x = 0.0;
  double y = 0.0;

  friend Vec2d operator+(Vec2d a, Vec2d b) { return {a.x + b.x, a.y + b.y}; }
  friend Vec2d operator-(Vec2d a, Vec2d b) { return {a.x - b.x, a.y - b.y}; }
  friend Vec2d operator*(Vec2d a, Vec2d b) { return {a.x * b.x, a.y * b.y}; }
  Vec2d& operator+=(Vec2d b) { return *this = *this + b; }
};

using PreciseField = std::vector<Vec2d>;

double squaredLength(Vec2d v) { return v.x * v.x + v.y * v.y; }
Vec2d toDouble(Vec2 v) { return {static_cast<double>(v.x), static_cast<double>(v.y)}; }
Vec2 toFloat(Vec2d v) { return {static_cast<float>(v.x), static_cast<float>(v.y)}; }

constexpr int kMaxCycles = 100;
constexpr int kSmoothings = 2;          // Gauss-Seidel sweeps after each correction
constexpr int kUnknownsAtATime = 8192;  // a piece of work; also one partial sum

/// body(i) for i in [begin, end), in pieces; a single piece does not bother the other threads.
template <typename Body>
void forEachUnknown(int begin, int end, const Body& body) {
  const auto piece = [&](int index) {
    const int from = begin + index * kUnknownsAtATime;
    const int to = std::min(from + kUnknownsAtATime, end);
    for (int i = from; i < to; ++i) body(at(i));
  };
  const int pieces = (end - begin + kUnknownsAtATime - 1) / kUnknownsAtATime;
  if (pieces == 1) {
    piece(0);
  } else {
    parallelFor(pieces, 1, piece);
  }
}

/// Component by component; nothing where there is nothing left to do.
Vec2d ratio(Vec2d numerator, Vec2d denominator) {
  return {denominator.x > 0.0 ? numerator.x / denominator.x : 0.0,
          denominator.y > 0.0 ? numerator.y / denominator.y : 0.0};
}

/// Sum of value(i) over all unknowns, the same for any number of threads.
template <typename Value>
Vec2d sumOver(int count, const Value& value) {
  std::vector<Vec2d> partial(at((count + kUnknownsAtATime - 1) / kUnknownsAtATime));
  forEachUnknown(0, count, [&](std::size_t i) { partial[i / at(kUnknownsAtATime)] += value(i); });
  Vec2d total;
  for (const Vec2d& sum : partial) total += sum;
  return total;
}

Vec2 weightedNeighbours(const GraphLevel& level, const Field& field, std::size_t i) {
  Vec2 sum;
  for (int link = level.firstLink[i]; link < level.firstLink[i + 1]; ++link) {
    sum += level.linkWeight[at(link)] * field[at(level.linkTo[at(link)])];
  }
  return sum;
}

/// Laplacian with the border at zero, on the finest level, where all weights are 1.
void applyOperator(const GraphLevel& level, const PreciseField& field, PreciseField& result) {
  forEachUnknown(0, level.count(), [&](std::size_t i) {
    const auto diagonal = static_cast<double>(level.diagonal[i]);
    Vec2d sum = Vec2d{diagonal, diagonal} * field[i];
    for (int link = level.firstLink[i]; link < level.firstLink[i + 1]; ++link) {
      sum = sum - field[at(level.linkTo[at(link)])];
    }
    result[i] = sum;
  });
}

class Multigrid {
 public:
  explicit Multigrid(GraphLevel finest) {
    levels_.push_back(std::move(finest));
    for (int side = 2; !levels_.back().linkTo.empty(); side *= 2) {
      levels_.push_back(coarserLevel(levels_.back(), side));
    }
    for (const GraphLevel& level : levels_) {
      right_.emplace_back(at(level.count()));
      value_.emplace_back(at(level.count()));
    }
    plain_ = Field(at(levels_.front().count()));
  }

  [[nodiscard]] const GraphLevel& finest() const { return levels_.front(); }

  /// One V-cycle from zero, without pre-smoothing: an approximate solution of
  /// (operator) x = residual.
  const Field& cycle(const PreciseField& residual) {
    forEachUnknown(0, finest().count(),
                   [&](std::size_t i) { right_.front()[i] = toFloat(residual[i]); });
    for (std::size_t l = 0; l + 1 < levels_.size(); ++l) restrict(l);

    // The coarsest level has no links left: one division per unknown is its solution
    const GraphLevel& coarsest = levels_.back();
    forEachUnknown(0, coarsest.count(), [&](std::size_t i) {
      value_.back()[i] = (1.0F / coarsest.diagonal[i]) * right_.back()[i];
    });
    for (std::size_t l = levels_.size() - 1; l-- > 0;) {
      prolongate(l);
      for (int sweep = 0; sweep < kSmoothings; ++sweep) smooth(l);
    }
    return value_.front();
  }

 private:
  /// Transpose of `prolongate`. What is left over right next to the border has to count little on
  /// coarse levels: there the border is many pixels away from the block's centre. Plain sums would
  /// make the first correction too large by the number of those pixels.
  void restrict(std::size_t l) {
    const GraphLevel& fine = levels_[l];
    const GraphLevel& coarse = levels_[l + 1];
    forEachUnknown(0, fine.count(),
                   [&](std::size_t i) { plain_[i] = (1.0F / fine.diagonal[i]) * right_[l][i]; });
    forEachUnknown(0, coarse.count(), [&](std::size_t i) {
      Vec2 sum;
      for (int c = coarse.firstChild[i]; c < coarse.firstChild[i + 1]; ++c) {
        sum += weightedNeighbours(fine, plain_, at(coarse.child[at(c)]));
      }
      right_[l + 1][i] = sum;
    });
  }

  /// Every unknown takes its parent's value, then the mean of its neighbours' (one Jacobi step).
  /// On a regular grid that is linear interpolation between the parents.
  void prolongate(std::size_t l) {
    const GraphLevel& level = levels_[l];
    forEachUnknown(0, level.count(),
                   [&](std::size_t i) { plain_[i] = value_[l + 1][at(level.parent[i])]; });
    forEachUnknown(0, level.count(), [&](std::size_t i) {
      value_[l][i] = (1.0F / level.diagonal[i]) * weightedNeighbours(level, plain_, i);
    });
  }

  /// Gauss-Seidel, first the red unknowns, then the black ones.
  void smooth(std::size_t l) {
    const GraphLevel& level = levels_[l];
    const auto relax = [&](std::size_t i) {
      value_[l][i] =
          (1.0F / level.diagonal[i]) * (right_[l][i] + weightedNeighbours(level, value_[l], i));
    };
    forEachUnknown(0, level.redCount, relax);
    forEachUnknown(level.redCount, level.count(), relax);
  }

  std::vector<GraphLevel> levels_;  ///< finest first
  std::vector<Field> right_;        ///< right-hand side of each level
  std::vector<Field> value_;        ///< correction of each level
  Field plain_;                     ///< scratch of restrict and prolongate
};

/// What the given values of the border contribute to each unknown.
PreciseField borderSums(const GraphLevel& level, const Mask& isBorder, const Image<Vec2>& field) {
  constexpr std::array<std::pair<int, int>, 4> kNeighbours = {{{-1, 0}, {1, 0}, {0, -1}, {0, 1}}};
  PreciseField sums(at(level.count()));
  forEachUnknown(0, level.count(), [&](std::size_t i) {
    for (const auto& [dx, dy] : kNeighbours) {
      const int x = level.blockX[i] + dx;
      const int y = level.blockY[i] + dy;
      if (isBorder.contains(x, y) && isBorder(x, y) != 0) sums[i] += toDouble(field(x, y));
    }
  });
  return sums;
}

/// Conjugate gradients, each direction from one V-cycle. A cycle is not symmetric, so directions
/// are made conjugate explicitly (the flexible variant, Notay 2000). A cycle's change is the larger
/// of what it proposed and of what was made of it: a short step along a bad direction is no sign of
/// being near the solution.
SolveReport solve(Multigrid& multigrid, PreciseField residual, double smallestChange,
                  PreciseField& solution) {
  const GraphLevel& level = multigrid.finest();
  const int count = level.count();
  PreciseField direction(at(count));
  PreciseField image(at(count));  // operator applied to `direction`
  Vec2d energy;                   // direction * image
  std::vector<double> change(at((count + kUnknownsAtATime - 1) / kUnknownsAtATime));

  SolveReport report;
  report.converged = false;
  while (!report.converged && report.cycles < kMaxCycles) {
    const Field& correction = multigrid.cycle(residual);
    const Vec2d overlap = ratio(
        sumOver(count, [&](std::size_t i) { return toDouble(correction[i]) * image[i]; }), energy);
    forEachUnknown(0, count, [&](std::size_t i) {
      direction[i] = toDouble(correction[i]) - overlap * direction[i];
    });
    applyOperator(level, direction, image);
    energy = sumOver(count, [&](std::size_t i) { return direction[i] * image[i]; });
    const Vec2d step =
        ratio(sumOver(count, [&](std::size_t i) { return direction[i] * residual[i]; }), energy);
    std::fill(change.begin(), change.end(), 0.0);
    forEachUnknown(0, count, [&](std::size_t i) {
      const Vec2d move = step * direction[i];
      const Vec2d proposed = toDouble(correction[i]);
      solution[i] += move;
      residual[i] = residual[i] - step * image[i];
      double& largest = change[i / at(kUnknownsAtATime)];
      largest = std::max({largest, squaredLength(move), squaredLength(proposed)});
    });
    const double largestMove = std::sqrt(*std::max_element(change.begin(), change.end()));
    report.lastChange = static_cast<float>(largestMove);
    ++report.cycles;
    report.converged = largestMove <= smallestChange;
  }
  return report;
}

}  // namespace

SolveReport diffuse(const Mask& region, const Mask& isBorder, Image<Vec2>& field) {
  // Keep what is given, forget the rest
  float largest = 0.0F;
  for (int y = 0; y < region.height(); ++y) {
    for (int x = 0; x < region.width(); ++x) {
      if (isBorder(x, y) == 0) field(x, y) = Vec2{};
      largest = std::max(largest, length(field(x, y)));
    }
  }
  if (!(largest > 0.0F)) return {};

  Image<int> unknownAt;
  GraphLevel finest = finestGraph(region, isBorder, unknownAt);
  if (finest.count() == 0) return {};
  PreciseField right = borderSums(finest, isBorder, field);
  PreciseField solution(at(finest.count()));
  Multigrid multigrid(std::move(finest));
  const SolveReport report =
      solve(multigrid, std::move(right),
            static_cast<double>(kDiffusionTolerance) * static_cast<double>(largest), solution);
  forEachRow(region.height(), [&](int y) {
    for (int x = 0; x < region.width(); ++x) {
      if (unknownAt(x, y) >= 0) field(x, y) = toFloat(solution[at(unknownAt(x, y))]);
    }
  });
  return report;
}

}  // namespace fluidymation
