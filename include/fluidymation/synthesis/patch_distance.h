#pragma once

#include <array>

#include "fluidymation/options.h"
#include "fluidymation/synthesis/exemplar.h"
#include "fluidymation/synthesis/target_level.h"

namespace fluidymation {

/// Weights of the terms of the patch distance; thesis §3.7. Colours alone, unless told otherwise.
struct DistanceWeights {
  float color = 1.0F;  ///< 0 in the very first search, which knows no picture yet (§4.2)
  float dist = 0.0F;
  float flow = 0.0F;
  float prev = 0.0F;
  float dir = 0.0F;
};

/// Largest |tan| of the angle between two directions of movement: at right angles it has no bound.
inline constexpr float kLargestMisalignment = 10.0F;

/// The target's side of a patch comparison, gathered once per target pixel.
///
/// The colour and the temporal term compare the same source pixel with two colours, t and p:
/// a |s - t|^2 + b |s - p|^2 = (a + b) |s - (a t + b p) / (a + b)|^2 + a b / (a + b) |t - p|^2.
/// The window therefore holds one blended colour, one weight, and the constant rest.
struct TargetWindow {
  std::array<Lanes, kPatchArea> value;
  /// Of the squared differences; 0 where a term is undefined.
  std::array<Lanes, kPatchArea> weight;
  std::array<Float4, kPatchArea> swappedHigh;  ///< `value.high` with ext+ and ext- exchanged
  float constant = 0.0F;
  Vec2 direction;  ///< of the target's flow at the centre
  /// Weight of the directions, which are in `value`; filled only where DistanceWeights::dir is
  /// not 0.
  std::array<float, kPatchArea> directionWeight;
};

/// The patch distance of thesis §3.7 without its uniformity term:
///   mean over the window of [ |S^lab - T^lab|^2 / 3 + dist (S^edge - T^edge)^2
///     + flow ((S^ext+ - T^ext+)^2 + (S^ext- - T^ext-)^2) + m(q) prev |S^lab - T^prev|^2 / 3 ].
/// The colour terms are means over the window's pixels inside the target mask, respectively over
/// those where T^prev exists. Where source and target flow roughly in opposite directions, tested
/// once at the centres, the source's ext+ and ext- are exchanged (§3.5).
/// Where `dir` is not 0, that times the mean of |tan(S^dir + theta - T^dir)| over the window's
/// pixels inside the target mask is added (P§3.2): |cross / dot| of the directions, at most
/// kLargestMisalignment; 0 where the exemplar has no material and so no direction.
class PatchDistance {
 public:
  PatchDistance(const ExemplarLevel& exemplar, const TargetLevel& target,
                const DistanceWeights& weights)
      : exemplar_(exemplar), target_(target), weights_(weights) {}

  /// Fills `window` for the target pixel (x, y), which must be inside the mask. Pixels past the
  /// edge of the image repeat the edge for edge and extent; they have no colour.
  void gather(int x, int y, TargetWindow& window) const;

  /// Distance of `match`, which must exist and whose nearest pixel must be in the image. May stop
  /// once the sum reaches `stopAt`, and then returns some value >= `stopAt`.
  [[nodiscard]] float operator()(const TargetWindow& window, const Match& match,
                                 float stopAt) const;

 private:
  template <bool kDirected>
  [[nodiscard]] float compare(const TargetWindow& window, const Match& match, float stopAt) const;

  const ExemplarLevel& exemplar_;
  const TargetLevel& target_;
  DistanceWeights weights_;
};

}  // namespace fluidymation
