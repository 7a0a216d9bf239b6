#include "fluidymation/guides/diffusion.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "fluidymation/core/index.h"
#include "fluidymation/core/parallel.h"
#include "pixel_level.h"
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
constexpr int kSmoothings = 2;  // Gauss-Seidel sweeps after each correction

int pieceCount(int unknowns) { return (unknowns + kUnknownsAtATime - 1) / kUnknownsAtATime; }

/// body(piece) for each piece of work; a single one does not bother the other threads.
template <typename Body>
void forEachPiece(int begin, int end, const Body& body) {
  if (end - begin == 1) {
    body(begin);
  } else {
    parallelFor(end - begin, 1, [&](int i) { body(begin + i); });
  }
}

/// body(i) for i in [begin, end), in pieces.
template <typename Body>
void forEachUnknown(int begin, int end, const Body& body) {
  forEachPiece(0, pieceCount(end - begin), [&](int piece) {
    const int from = begin + piece * kUnknownsAtATime;
    const int to = std::min(from + kUnknownsAtATime, end);
    for (int i = from; i < to; ++i) body(at(i));
  });
}

/// Component by component; nothing where there is nothing left to do.
Vec2d ratio(Vec2d numerator, Vec2d denominator) {
  return {denominator.x > 0.0 ? numerator.x / denominator.x : 0.0,
          denominator.y > 0.0 ? numerator.y / denominator.y : 0.0};
}

/// Sum of the pieces' sums, the same for any number of threads.
Vec2d total(const std::vector<Vec2d>& partial) {
  Vec2d sum;
  for (const Vec2d& part : partial) sum += part;
  return sum;
}

/// The values of the four neighbours of the pixels of a span: one array each, of zeros where there
/// is no such neighbour.
template <typename Value>
struct Beside {
  Beside(const PixelSpan& span, const std::vector<Value>& field, const std::vector<Value>& zeros)
      : left(valuesFrom(span.left, field, zeros)),
        right(valuesFrom(span.right, field, zeros)),
        up(valuesFrom(span.up, field, zeros)),
        down(valuesFrom(span.down, field, zeros)) {}

  static const Value* valuesFrom(int unknown, const std::vector<Value>& field,
                                 const std::vector<Value>& zeros) {
    return unknown == kNoUnknown ? zeros.data() : field.data() + unknown;
  }

  /// Of the k-th pixel. Begins at zero, as a sum over a list of neighbours does.
  [[nodiscard]] Value sum(int k) const { return Value{} + left[k] + right[k] + up[k] + down[k]; }

  const Value* left;
  const Value* right;
  const Value* up;
  const Value* down;
};

Vec2 weightedNeighbours(const GraphLevel& level, const Field& field, std::size_t i) {
  Vec2 sum;
  for (int link = level.firstLink[i]; link < level.firstLink[i + 1]; ++link) {
    sum += level.linkWeight[at(link)] * field[at(level.linkTo[at(link)])];
  }
  return sum;
}

class Multigrid {
 public:
  Multigrid(PixelLevel finest, Size size, Pixel origin) : finest_(std::move(finest)) {
    int side = 2;
    if (finest_.hasLinks()) levels_.push_back(coarserLevel(finest_, size, origin));
    while (!levels_.empty() && !levels_.back().linkTo.empty()) {
      side *= 2;
      GraphLevel coarser = coarserLevel(levels_.back(), side);
      levels_.push_back(std::move(coarser));
    }
    for (const GraphLevel& level : levels_) {
      right_.emplace_back(at(level.count()));
      value_.emplace_back(at(level.count()));
      shares_.emplace_back();
      for (const float diagonal : level.diagonal) shares_.back().push_back(1.0F / diagonal);
    }
    finestRight_ = Field(at(finest_.count));
    finestValue_ = Field(at(finest_.count));
    plain_ = Field(at(finest_.count));
    zeros_ = Field(at(longestSpan(finest_)));
  }

  [[nodiscard]] const PixelLevel& finest() const { return finest_; }

  /// Takes what is left over of one piece of work, before `cycle`.
  void setResidual(int piece, const PreciseField& residual) {
    forEachSpan(piece, [&](const PixelSpan& span) {
      const float share = 1.0F / span.diagonal;
      for (int i = span.begin; i < span.end; ++i) {
        finestRight_[at(i)] = toFloat(residual[at(i)]);
        plain_[at(i)] = share * finestRight_[at(i)];
      }
    });
  }

  /// One V-cycle from zero, without pre-smoothing: an approximate solution of
  /// (operator) x = residual.
  const Field& cycle() {
    // Without links one division per unknown is the solution
    if (levels_.empty()) return plain_;
    restrictFinest();
    for (std::size_t l = 0; l + 1 < levels_.size(); ++l) restrict(l);

    const GraphLevel& coarsest = levels_.back();
    forEachUnknown(0, coarsest.count(),
                   [&](std::size_t i) { value_.back()[i] = shares_.back()[i] * right_.back()[i]; });
    for (std::size_t l = levels_.size() - 1; l-- > 0;) {
      prolongate(l);
      for (int sweep = 0; sweep < kSmoothings; ++sweep) smooth(l);
    }
    prolongateFinest();
    for (int sweep = 0; sweep < kSmoothings; ++sweep) smoothFinest();
    return finestValue_;
  }

 private:
  static int longestSpan(const PixelLevel& level) {
    int longest = 0;
    for (const PixelSpan& span : level.spans) longest = std::max(longest, span.end - span.begin);
    return longest;
  }

  template <typename Body>
  void forEachSpan(int piece, const Body& body) const {
    for (int s = finest_.firstSpan[at(piece)]; s < finest_.firstSpan[at(piece) + 1]; ++s) {
      body(finest_.spans[at(s)]);
    }
  }

  /// Transpose of `prolongate`. What is left over right next to the border has to count little on
  /// coarse levels: there the border is many pixels away from the block's centre. Plain sums would
  /// make the first correction too large by the number of those pixels.
  void restrict(std::size_t l) {
    const GraphLevel& fine = levels_[l];
    const GraphLevel& coarse = levels_[l + 1];
    forEachUnknown(0, fine.count(),
                   [&](std::size_t i) { plain_[i] = shares_[l][i] * right_[l][i]; });
    forEachUnknown(0, coarse.count(), [&](std::size_t i) {
      Vec2 sum;
      for (int c = coarse.firstChild[i]; c < coarse.firstChild[i + 1]; ++c) {
        sum += weightedNeighbours(fine, plain_, at(coarse.child[at(c)]));
      }
      right_[l + 1][i] = sum;
    });
  }

  void restrictFinest() {
    forEachPiece(0, pieceCount(finest_.count), [&](int piece) {
      forEachSpan(piece, [&](const PixelSpan& span) {
        const Beside<Vec2> beside(span, plain_, zeros_);
        Vec2* sums = finestValue_.data() + span.begin;
#pragma omp simd
        for (int k = 0; k < span.end - span.begin; ++k) sums[k] = beside.sum(k);
      });
    });
    const GraphLevel& coarse = levels_.front();
    forEachUnknown(0, coarse.count(), [&](std::size_t i) {
      Vec2 sum;
      for (int c = coarse.firstChild[i]; c < coarse.firstChild[i + 1]; ++c) {
        sum += finestValue_[at(coarse.child[at(c)])];
      }
      right_.front()[i] = sum;
    });
  }

  /// Every unknown takes its parent's value, then the mean of its neighbours' (one Jacobi step).
  /// On a regular grid that is linear interpolation between the parents. The smoothing that follows
  /// begins with the red unknowns and asks for the black ones only, whose neighbours are all red.
  void prolongate(std::size_t l) {
    const GraphLevel& level = levels_[l];
    forEachUnknown(0, level.redCount,
                   [&](std::size_t i) { plain_[i] = value_[l + 1][at(level.parent[i])]; });
    forEachUnknown(level.redCount, level.count(), [&](std::size_t i) {
      value_[l][i] = shares_[l][i] * weightedNeighbours(level, plain_, i);
    });
  }

  void prolongateFinest() {
    forEachUnknown(0, finest_.redCount,
                   [&](std::size_t i) { plain_[i] = value_.front()[at(finest_.parent[i])]; });
    forEachColorSpan(finest_.redSpans, static_cast<int>(finest_.spans.size()),
                     [&](const PixelSpan& span) {
                       const float share = 1.0F / span.diagonal;
                       const Beside<Vec2> beside(span, plain_, zeros_);
                       Vec2* out = finestValue_.data() + span.begin;
#pragma omp simd
                       for (int k = 0; k < span.end - span.begin; ++k)
                         out[k] = share * beside.sum(k);
                     });
  }

  /// Gauss-Seidel, first the red unknowns, then the black ones.
  void smooth(std::size_t l) {
    const GraphLevel& level = levels_[l];
    const auto relax = [&](std::size_t i) {
      value_[l][i] = shares_[l][i] * (right_[l][i] + weightedNeighbours(level, value_[l], i));
    };
    forEachUnknown(0, level.redCount, relax);
    forEachUnknown(level.redCount, level.count(), relax);
  }

  void smoothFinest() {
    const auto relax = [&](const PixelSpan& span) {
      const float share = 1.0F / span.diagonal;
      const Beside<Vec2> beside(span, finestValue_, zeros_);
      const Vec2* right = finestRight_.data() + span.begin;
      Vec2* out = finestValue_.data() + span.begin;
#pragma omp simd
      for (int k = 0; k < span.end - span.begin; ++k) {
        out[k] = share * (right[k] + beside.sum(k));
      }
    };
    forEachColorSpan(0, finest_.redSpans, relax);
    forEachColorSpan(finest_.redSpans, static_cast<int>(finest_.spans.size()), relax);
  }

  /// body(span) for spans begin..end-1, in the pieces of work that they lie in.
  template <typename Body>
  void forEachColorSpan(int begin, int end, const Body& body) const {
    if (begin == end) return;
    const int firstPiece = finest_.spans[at(begin)].begin / kUnknownsAtATime;
    const int lastPiece = finest_.spans[at(end - 1)].begin / kUnknownsAtATime;
    forEachPiece(firstPiece, lastPiece + 1, [&](int piece) {
      const int from = std::max(begin, finest_.firstSpan[at(piece)]);
      const int to = std::min(end, finest_.firstSpan[at(piece) + 1]);
      for (int s = from; s < to; ++s) body(finest_.spans[at(s)]);
    });
  }

  PixelLevel finest_;
  Field finestRight_;                       ///< right-hand side
  Field finestValue_;                       ///< correction; sums of neighbours while restricting
  std::vector<GraphLevel> levels_;          ///< the coarser ones, finest first
  std::vector<Field> right_;                ///< as finestRight_, of each of these
  std::vector<Field> value_;                ///< likewise
  std::vector<std::vector<float>> shares_;  ///< one over each level's diagonal
  Field plain_;                             ///< scratch of restrict and prolongate
  Field zeros_;                             ///< stands for the neighbours that are no unknowns
};

/// What the given values of the border contribute to each unknown.
PreciseField borderSums(const PixelLevel& level, const Mask& isBorder, const Image<Vec2>& field) {
  constexpr std::array<std::pair<int, int>, 4> kNeighbours = {{{-1, 0}, {1, 0}, {0, -1}, {0, 1}}};
  PreciseField sums(at(level.count));
  for (const PixelSpan& span : level.spans) {
    if (span.given == 0) continue;
    for (int i = span.begin; i < span.end; ++i) {
      for (const auto& [dx, dy] : kNeighbours) {
        const int x = span.x + 2 * (i - span.begin) + dx;
        const int y = span.y + dy;
        if (isBorder.contains(x, y) && isBorder(x, y) != 0) sums[at(i)] += toDouble(field(x, y));
      }
    }
  }
  return sums;
}

/// Conjugate gradients, each direction from one V-cycle. A cycle is not symmetric, so directions
/// are made conjugate explicitly (the flexible variant, Notay 2000). A cycle's change is the larger
/// of what it proposed and of what was made of it: a short step along a bad direction is no sign of
/// being near the solution.
class ConjugateGradients {
 public:
  /// @param residual  right-hand side; the first guess is zero.
  ConjugateGradients(Multigrid multigrid, PreciseField residual)
      : multigrid_(std::move(multigrid)),
        pieces_(pieceCount(finest().count)),
        residual_(std::move(residual)),
        direction_(residual_.size()),
        image_(residual_.size()),
        solution_(residual_.size()),
        zeros_(at(kUnknownsAtATime)) {
    forEachPiece(0, pieces_, [&](int piece) { multigrid_.setResidual(piece, residual_); });
  }

  SolveReport solve(double smallestChange) {
    SolveReport report;
    report.converged = false;
    Vec2d energy;  // direction * image
    while (!report.converged && report.cycles < kMaxCycles) {
      const Field& correction = multigrid_.cycle();
      makeConjugate(correction, energy);
      const Vec2d slope = applyOperator(energy);
      const double largestMove = std::sqrt(move(correction, ratio(slope, energy)));
      report.lastChange = static_cast<float>(largestMove);
      ++report.cycles;
      report.converged = largestMove <= smallestChange;
    }
    return report;
  }

  [[nodiscard]] const PixelLevel& finest() const { return multigrid_.finest(); }
  [[nodiscard]] const PreciseField& solution() const { return solution_; }

 private:
  /// The next direction, made of the correction and of the last one.
  void makeConjugate(const Field& correction, Vec2d energy) {
    std::vector<Vec2d> overlaps(at(pieces_));
    forEachPieceOfUnknowns([&](int piece, int from, int to) {
      Vec2d sum;
      for (int i = from; i < to; ++i) sum += toDouble(correction[at(i)]) * image_[at(i)];
      overlaps[at(piece)] = sum;
    });
    const Vec2d overlap = ratio(total(overlaps), energy);
    forEachUnknown(0, finest().count, [&](std::size_t i) {
      direction_[i] = toDouble(correction[i]) - overlap * direction_[i];
    });
  }

  /// image = Laplacian of the direction, with the border at zero.
  /// @param energy  out: direction * image. @return  direction * residual.
  Vec2d applyOperator(Vec2d& energy) {
    std::vector<Vec2d> energies(at(pieces_));
    std::vector<Vec2d> slopes(at(pieces_));
    forEachPieceOfUnknowns([&](int piece, int from, int to) {
      const auto& firstSpan = finest().firstSpan;
      for (int s = firstSpan[at(piece)]; s < firstSpan[at(piece) + 1]; ++s) {
        const PixelSpan& span = finest().spans[at(s)];
        const Beside<Vec2d> beside(span, direction_, zeros_);
        const auto diagonal = static_cast<double>(span.diagonal);
        const Vec2d* here = direction_.data() + span.begin;
        Vec2d* out = image_.data() + span.begin;
#pragma omp simd
        for (int k = 0; k < span.end - span.begin; ++k) {
          out[k] = Vec2d{diagonal, diagonal} * here[k] - beside.left[k] - beside.right[k] -
                   beside.up[k] - beside.down[k];
        }
      }
      Vec2d ownEnergy;
      Vec2d ownSlope;
      for (int i = from; i < to; ++i) {
        ownEnergy += direction_[at(i)] * image_[at(i)];
        ownSlope += direction_[at(i)] * residual_[at(i)];
      }
      energies[at(piece)] = ownEnergy;
      slopes[at(piece)] = ownSlope;
    });
    energy = total(energies);
    return total(slopes);
  }

  /// Goes by `step` along the direction. @return  square of the largest change of a value.
  double move(const Field& correction, Vec2d step) {
    std::vector<double> change(at(pieces_));
    forEachPieceOfUnknowns([&](int piece, int from, int to) {
      double largest = 0.0;
      for (int i = from; i < to; ++i) {
        const Vec2d moved = step * direction_[at(i)];
        const Vec2d proposed = toDouble(correction[at(i)]);
        solution_[at(i)] += moved;
        residual_[at(i)] = residual_[at(i)] - step * image_[at(i)];
        largest = std::max({largest, squaredLength(moved), squaredLength(proposed)});
      }
      change[at(piece)] = largest;
      multigrid_.setResidual(piece, residual_);
    });
    return *std::max_element(change.begin(), change.end());
  }

  /// body(piece, from, to) for the unknowns from..to-1 of each piece of work.
  template <typename Body>
  void forEachPieceOfUnknowns(const Body& body) {
    forEachPiece(0, pieces_, [&](int piece) {
      const int from = piece * kUnknownsAtATime;
      body(piece, from, std::min(from + kUnknownsAtATime, finest().count));
    });
  }

  Multigrid multigrid_;
  int pieces_;
  PreciseField residual_;
  PreciseField direction_;
  PreciseField image_;  ///< operator applied to the direction
  PreciseField solution_;
  PreciseField zeros_;  ///< stands for the neighbours that are no unknowns
};

}  // namespace

SolveReport diffuse(const Mask& region, const Mask& isBorder, Image<Vec2>& field, Pixel origin) {
  assert(origin.x % 2 == 0 && origin.y % 2 == 0);
  // Keep what is given, forget the rest
  float largestSquare = 0.0F;
  for (int y = 0; y < region.height(); ++y) {
    const std::uint8_t* given = isBorder.row(y);
    Vec2* values = field.row(y);
    for (int x = 0; x < region.width(); ++x) {
      if (given[x] == 0) {
        values[x] = Vec2{};
      } else {
        largestSquare = std::max(largestSquare, dot(values[x], values[x]));
      }
    }
  }
  const float largest = std::sqrt(largestSquare);
  if (!(largest > 0.0F)) return {};

  PixelLevel level = pixelLevel(region, isBorder);
  if (level.count == 0) return {};
  PreciseField right = borderSums(level, isBorder, field);
  ConjugateGradients gradients(Multigrid(std::move(level), region.size(), origin),
                               std::move(right));
  const SolveReport report =
      gradients.solve(static_cast<double>(kDiffusionTolerance) * static_cast<double>(largest));
  const PreciseField& solution = gradients.solution();
  for (const PixelSpan& span : gradients.finest().spans) {
    Vec2* out = field.row(span.y) + span.x;
    for (int i = span.begin; i < span.end; ++i, out += 2) *out = toFloat(solution[at(i)]);
  }
  return report;
}

}  // namespace fluidymation
