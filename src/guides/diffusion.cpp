#include "fluidymation/guides/diffusion.h"

#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "fluidymation/core/parallel.h"
#include "region_graph.h"

namespace fluidymation {
namespace {

using Field = std::vector<Vec2>;

constexpr int kMaxCycles = 100;
constexpr int kSmoothings = 2;          // Gauss-Seidel sweeps after each correction
constexpr int kUnknownsAtATime = 4096;  // a piece of work; also one partial sum

std::size_t at(int i) { return static_cast<std::size_t>(i); }

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

/// The two components of a vector product or quotient; they are solved side by side and each has
/// its own scalars.
struct Pair {
  double x = 0.0;
  double y = 0.0;
};

Pair ratio(Pair numerator, Pair denominator) {
  return {denominator.x > 0.0 ? numerator.x / denominator.x : 0.0,
          denominator.y > 0.0 ? numerator.y / denominator.y : 0.0};
}

Vec2 scaled(Pair s, Vec2 v) {
  return {static_cast<float>(s.x) * v.x, static_cast<float>(s.y) * v.y};
}

Pair product(const Field& a, const Field& b) {
  const int count = static_cast<int>(a.size());
  std::vector<Pair> partial(at((count + kUnknownsAtATime - 1) / kUnknownsAtATime));
  forEachUnknown(0, count, [&](std::size_t i) {
    Pair& sum = partial[i / at(kUnknownsAtATime)];
    sum.x += static_cast<double>(a[i].x) * static_cast<double>(b[i].x);
    sum.y += static_cast<double>(a[i].y) * static_cast<double>(b[i].y);
  });
  Pair total;
  for (const Pair& sum : partial) {
    total.x += sum.x;
    total.y += sum.y;
  }
  return total;
}

Vec2 weightedNeighbours(const GraphLevel& level, const Field& field, std::size_t i) {
  Vec2 sum;
  for (int link = level.firstLink[i]; link < level.firstLink[i + 1]; ++link) {
    sum += level.linkWeight[at(link)] * field[at(level.linkTo[at(link)])];
  }
  return sum;
}

/// Laplacian with the border at zero: diagonal x value - neighbours.
void applyOperator(const GraphLevel& level, const Field& field, Field& result) {
  forEachUnknown(0, level.count(), [&](std::size_t i) {
    result[i] = level.diagonal[i] * field[i] - weightedNeighbours(level, field, i);
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

  /// One V-cycle from zero: an approximate solution of (operator) x = residual. Without
  /// pre-smoothing the way down only adds up.
  const Field& cycle(const Field& residual) {
    right_.front() = residual;
    for (std::size_t l = 1; l < levels_.size(); ++l) {
      const GraphLevel& level = levels_[l];
      forEachUnknown(0, level.count(), [&](std::size_t i) {
        Vec2 sum;
        for (int c = level.firstChild[i]; c < level.firstChild[i + 1]; ++c) {
          sum += right_[l - 1][at(level.child[at(c)])];
        }
        right_[l][i] = sum;
      });
    }

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
  Field plain_;                     ///< parents' values, in prolongate
};

/// What the given values of the border contribute to each unknown.
Field borderSums(const GraphLevel& level, const Mask& isBorder, const Image<Vec2>& field) {
  constexpr std::array<std::pair<int, int>, 4> kNeighbours = {{{-1, 0}, {1, 0}, {0, -1}, {0, 1}}};
  Field sums(at(level.count()));
  forEachUnknown(0, level.count(), [&](std::size_t i) {
    for (const auto& [dx, dy] : kNeighbours) {
      const int x = level.blockX[i] + dx;
      const int y = level.blockY[i] + dy;
      if (isBorder.contains(x, y) && isBorder(x, y) != 0) sums[i] += field(x, y);
    }
  });
  return sums;
}

/// Conjugate gradients, each direction from one V-cycle. A cycle is not symmetric, so directions
/// are made conjugate explicitly (the flexible variant, Notay 2000).
SolveReport solve(Multigrid& multigrid, Field residual, float smallestChange, Field& solution) {
  const GraphLevel& level = multigrid.finest();
  const int count = level.count();
  Field direction(at(count));
  Field image(at(count));  // operator applied to `direction`
  Pair energy;             // direction * image
  std::vector<float> change(at((count + kUnknownsAtATime - 1) / kUnknownsAtATime));

  SolveReport report;
  report.converged = false;
  while (!report.converged && report.cycles < kMaxCycles) {
    const Field& correction = multigrid.cycle(residual);
    const Pair overlap = ratio(product(correction, image), energy);
    forEachUnknown(0, count, [&](std::size_t i) {
      direction[i] = correction[i] - scaled(overlap, direction[i]);
    });
    applyOperator(level, direction, image);
    energy = product(direction, image);
    const Pair step = ratio(product(direction, residual), energy);
    std::fill(change.begin(), change.end(), 0.0F);
    forEachUnknown(0, count, [&](std::size_t i) {
      const Vec2 move = scaled(step, direction[i]);
      solution[i] += move;
      residual[i] = residual[i] - scaled(step, image[i]);
      float& largest = change[i / at(kUnknownsAtATime)];
      largest = std::max(largest, length(move));
    });
    report.lastChange = *std::max_element(change.begin(), change.end());
    ++report.cycles;
    report.converged = report.lastChange <= smallestChange;
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
  GraphLevel finest = finestLevel(region, isBorder, unknownAt);
  if (finest.count() == 0) return {};
  Field right = borderSums(finest, isBorder, field);
  Field solution(at(finest.count()));
  Multigrid multigrid(std::move(finest));
  const SolveReport report =
      solve(multigrid, std::move(right), kDiffusionTolerance * largest, solution);
  forEachRow(region.height(), [&](int y) {
    for (int x = 0; x < region.width(); ++x) {
      if (unknownAt(x, y) >= 0) field(x, y) = solution[at(unknownAt(x, y))];
    }
  });
  return report;
}

}  // namespace fluidymation
