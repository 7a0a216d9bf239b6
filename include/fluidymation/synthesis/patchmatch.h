#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "fluidymation/options.h"
#include "fluidymation/synthesis/exemplar.h"
#include "fluidymation/synthesis/nnf.h"
#include "fluidymation/synthesis/occurrence.h"
#include "fluidymation/synthesis/patch_distance.h"
#include "fluidymation/synthesis/target_level.h"

namespace fluidymation {

/// Memory that the searches of one level hand on to each other: it is as large as the exemplar, and
/// to clear what was used of it costs less than to make it anew. Says nothing that shows in a
/// result.
struct SearchMemory {
  std::optional<OccurrenceMap> occurrence;
  std::vector<UseChanges> ownChanges;  ///< of each thread; all zero
};

/// What a search works on: one level of one frame.
struct SearchProblem {
  const ExemplarLevel& exemplar;
  const ExpectedUse& expectedUse;
  const TargetLevel& target;
  const SynthesisOptions& options;
  Place place;
  SearchMemory* memory = nullptr;  ///< of this exemplar and radius, if given
};

/// Draws a match for a target pixel at random from its segment, turned so that the flows align
/// (one of the two ways, see `alignedRotation`).
[[nodiscard]] Match randomMatch(const SearchProblem& problem, int x, int y, int pass);

/// The rotation that turns the exemplar's flow at (sx, sy, k) into the target's at (x, y); the
/// search also tries the opposite one (thesis §3.6, §4.3).
[[nodiscard]] Rotation alignedRotation(const SearchProblem& problem, int x, int y, int sx, int sy,
                                       int k);

/// Gives every pixel of the mask a match and makes every match legal: missing ones are drawn at
/// random, illegal ones move to the nearest legal pixel of their frame within kRepairRadiusPx, else
/// are drawn anew. Pixels outside the mask lose theirs.
inline constexpr int kRepairRadiusPx = 4;
void repair(const SearchProblem& problem, int pass, NearestNeighborField& nnf);

/// Patch distance plus uniformity term of every existing match; infinite where the match is not
/// legal or missing. Occurrence is counted from `nnf` itself.
/// @param bounds  if given: an error that is not below its bound may be reported as infinite, which
///   saves much of its computation. 0 where it is not wanted at all.
[[nodiscard]] Image<float> matchErrors(const SearchProblem& problem, const DistanceWeights& weights,
                                       const NearestNeighborField& nnf,
                                       const Image<float>* bounds = nullptr);

/// Side of the tiles that are searched independently between two synchronizations, px of the
/// level. A property of the picture: the number of threads must not show.
inline constexpr int kTileSidePx = 64;

/// What a sweep tries at a pixel.
enum class Candidates {
  kAll,        ///< the neighbours' matches, then some drawn at random; §2.2
  kNeighbors,  ///< the neighbours' matches alone: settles what is nearly right at a tenth of the
               ///< cost
};

/// What a search has done.
struct SearchStatistics {
  std::uint64_t distances = 0;  ///< patch distances computed
  std::uint64_t samples = 0;    ///< pixels of windows compared in them before they stopped

  SearchStatistics& operator+=(const SearchStatistics& other) {
    distances += other.distances;
    samples += other.samples;
    return *this;
  }
};

/// findNNF: `iterations` sweeps of PatchMatch (thesis §2.2, §4.3, §4.4.2). All matches must be
/// legal before; they are after.
///
/// Tiles are cut from the box that is worked with, never from the thread count, and the result does
/// not depend on it: across a tile's edge neighbours are read as they were before the sweep, and
/// occurrence is read as of before the sweep plus the tile's own changes (UseChanges).
/// @param firstPass  number of the first sweep within this level of this frame: every sweep has its
///   own random numbers, and the scan order alternates with it.
/// @param changing   if given: where the last sweep changed the match, nonzero; empty at first,
///   which says that all may change. With SearchEffort::kWhereItChanges the next search on the
///   same level draws at random only there.
SearchStatistics findNearestNeighbors(const SearchProblem& problem, const DistanceWeights& weights,
                                      int iterations, int firstPass, NearestNeighborField& nnf,
                                      Candidates candidates = Candidates::kAll,
                                      Mask* changing = nullptr);

}  // namespace fluidymation
