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
#include "multigrid.h"
#include "pixel_level.h"

namespace fluidymation {
namespace {

constexpr int kMaxCycles = 100;

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
