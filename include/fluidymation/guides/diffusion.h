#pragma once

#include "fluidymation/core/image.h"

namespace fluidymation {

/// The diffusion stops once a V-cycle changes no value by more than this share of the largest
/// border value. A small residual would bound nothing; a small change does, since a cycle leaves
/// about a fifth of the error.
inline constexpr float kDiffusionTolerance = 1e-3F;

/// What an iterative solver did.
struct SolveReport {
  int cycles = 0;           ///< V-cycles run
  float lastChange = 0.0F;  ///< largest change of any value in the last cycle, unit of the field
  bool converged = true;
};

/// What to report of two solves: the one that did not settle, else the one that took longer.
[[nodiscard]] inline SolveReport worse(const SolveReport& a, const SolveReport& b) {
  if (a.converged != b.converged) return a.converged ? b : a;
  return b.cycles > a.cycles ? b : a;
}

/// Spreads values of the border over the interior: solves laplace(u) = 0 on `region`, with
/// u given where `isBorder` (Dirichlet) and no flux across the edge of the image or towards
/// pixels outside the region (thesis §3.8).
///
///      . . B B B . .      B  border pixel: value given, kept
///      . B i i i B .      i  interior pixel: solved for
///      . . B B B . .      .  outside: set to zero
///
/// Connected parts of the region (4-neighbours) do not mix; a part without any border pixel gets
/// zero. Multigrid V-cycles without pre-smoothing, Gauss-Seidel as post-smoothing, accelerated by
/// conjugate gradients; at most 100. Stops when no value changed by more than `kDiffusionTolerance`
/// times the largest border value in one cycle: after 4 to 6 cycles on shapes with a border all
/// round, 5 to 20 where most of the outline is free. Paths one pixel wide and thousands long that
/// are given at their ends only take more than 100; in the border of a mask there are none.
/// @param region    nonzero where u lives.
/// @param isBorder  nonzero where u is given; a subset of `region`.
/// @param field     in: values at the border pixels; out: the solution, zero outside the region.
/// @param origin    even (asserted): where the first pixel lies in the image that these are part
/// of.
///   Part or whole, the same result.
SolveReport diffuse(const Mask& region, const Mask& isBorder, Image<Vec2>& field,
                    Pixel origin = {});

}  // namespace fluidymation
