#pragma once

#include <cstddef>
#include <vector>

#include "fluidymation/core/color.h"
#include "fluidymation/synthesis/exemplar.h"

namespace fluidymation {

/// What the exemplar's colours are on average at each distance to the edge, frame by frame: how
/// the medium changes at a place that the front passes over. The distance is told by the edge
/// guide, from the edge to the border width; all that lies deeper is one. Only the medium counts:
/// outside it is as at its edge.
///
/// Frames are averaged with those near them, distances with those beside them, and where a frame
/// has few pixels of a distance, the whole exemplar speaks.
class DepthColors {
 public:
  explicit DepthColors(const ExemplarLevel& exemplar);

  /// The mean colour of frame `k`; between the distances that are told apart it changes linearly.
  /// @param edge  FixedGuides::edge, any value.
  [[nodiscard]] Lab mean(int k, int edge) const;

  /// By how much colours of frame `k` at `to` differ from those at `from`.
  /// @param from, to  FixedGuides::edge, any values.
  [[nodiscard]] Lab change(int k, int from, int to) const;

 private:
  float step_;  ///< of the edge guide, in its steps, from one distance to the next, from 0 on
  std::size_t distances_;
  std::vector<Lab> colors_;  ///< of each distance, outermost first; one frame after the other
};

}  // namespace fluidymation
