#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "fluidymation/core/random.h"
#include "fluidymation/synthesis/nnf.h"
#include "fluidymation/synthesis/occurrence.h"
#include "fluidymation/synthesis/patch_distance.h"
#include "fluidymation/synthesis/patchmatch.h"
#include "synthesis/uniformity_scale.h"

namespace fluidymation {

inline constexpr float kUnknown = -1.0F;  ///< a distance that has not been computed
inline constexpr float kNever = std::numeric_limits<float>::infinity();

/// The random numbers of all pixels of a pass.
[[nodiscard]] inline Random randomOf(const SearchProblem& problem, int pass) {
  return Random::ofPass(problem.options.seed, problem.place.frame, problem.place.level, pass);
}

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
[[nodiscard]] std::vector<Tile> occupiedTiles(const TargetLevel& target);

/// How far a random place may lie from the best match along each axis: px, px, frames.
struct SearchBox {
  int x = 0;
  int y = 0;
  int frames = 0;
};

/// The whole exemplar first, then ever smaller by `patchmatchAlpha`, down to a pixel (§4.3).
[[nodiscard]] std::vector<SearchBox> searchBoxes(const SearchProblem& problem);

/// Neighbours whose matches a sweep may ask for: those beside a pixel, then those across a corner.
inline constexpr std::size_t kAdjacentNeighbors = 2;
inline constexpr std::size_t kAllNeighbors = 4;

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
  std::size_t neighbors = 0;  ///< how many of kAllNeighbors are asked for their matches
  bool everyNeighbor = true;  ///< false: neighbours' matches tried before are not tried again
  bool drawsAtRandom = true;
  bool everywhere = true;  ///< false: nothing is drawn for what no longer changes
};

/// One sweep of PatchMatch over one tile: visits every pixel once, in row order or, on odd passes,
/// in the opposite order.
/// @param ownChanges  scratch, all zero before and after: what the tile changes meanwhile. Without
///   it all pixels of a small target flock to what few use, in every sweep anew; not so where
///   nothing is drawn at random, and there it is null.
/// @param errors   patch distances, without uniformity term, of the matches in `nnf`, as far as
///   they are known; kUnknown elsewhere.
/// @param changed  is set where the sweep changes the match; zero before.
SearchStatistics sweepTile(const SweepInputs& in, const Tile& tile, UseChanges* ownChanges,
                           NearestNeighborField& nnf, Image<float>& errors, Mask& changed);

}  // namespace fluidymation
