#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "fluidymation/options.h"
#include "fluidymation/synthesis/exemplar.h"
#include "fluidymation/synthesis/target_level.h"
#include "fluidymation/synthesis/texel.h"

namespace fluidymation {

struct PatchKernels;
struct WindowWeights;

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

/// The target's side of a patch comparison, gathered once per target pixel. Samples are in the
/// order in which they are compared.
///
/// The colour and the temporal term compare the same source pixel with two colours, t and p:
/// a |s - t|^2 + b |s - p|^2 = (a + b) |s - (a t + b p) / (a + b)|^2 + a b / (a + b) |t - p|^2.
/// The window therefore holds one blended colour, one weight, and the constant rest.
struct TargetWindow {
  /// One more than the window has: kernels take two at a time. The last one weighs nothing.
  static constexpr std::size_t kSamples = kPatchArea + 1;
  /// Of the summed squares of two lanes of a Texel each: L and a; b; edge; ext+ and ext-. 0 where a
  /// term is undefined.
  using Weights = std::array<float, 4>;

  alignas(32) std::array<Texel, kSamples> value{};
  alignas(32) std::array<Texel, kSamples> swapped{};  ///< `value` with ext+ and ext- exchanged
  alignas(32) std::array<Weights, kSamples> weight{};
  float constant = 0.0F;
  Vec2 direction;  ///< of the target's flow at the centre
  /// Directions of the target's flow, and their weights; filled only where DistanceWeights::dir is
  /// not 0.
  std::array<Vec2, kPatchArea> directions;
  std::array<float, kPatchArea> directionWeight;
};

/// The patch distance of thesis §3.7 without its uniformity term:
///   mean over the window of [ |S^lab - T^lab|^2 / 3 + dist (S^edge - T^edge)^2
///     + flow ((S^ext+ - T^ext+)^2 + (S^ext- - T^ext-)^2) + m(q) prev |S^lab - T^prev|^2 / 3 ].
/// The colour terms are means over the window's pixels that have a colour, which are those inside
/// the target mask, respectively over those where T^prev exists. Where source and target flow
/// roughly in opposite directions, tested once at the centres, the source's ext+ and ext- are
/// exchanged (§3.5). Where `dir` is not 0, that times the mean of |tan(S^dir + theta - T^dir)| over
/// the window's pixels inside the target mask is added (P§3.2): |cross / dot| of the directions, at
/// most kLargestMisalignment; 0 where the exemplar has no material and so no direction.
class PatchDistance {
 public:
  PatchDistance(const ExemplarLevel& exemplar, const TargetLevel& target,
                const DistanceWeights& weights);

  /// Fills `window` for the target pixel (x, y), which must be inside the mask. Pixels past the
  /// edge of the image repeat the edge for edge and extent; they have no colour.
  void gather(int x, int y, TargetWindow& window) const;

  /// Distance of `match`, which must exist and whose nearest pixel must be in the image. May stop
  /// once the sum reaches `stopAt`, and then returns some value >= `stopAt`.
  /// @param samples  if given, is set to the number of the window's samples that were compared.
  [[nodiscard]] float operator()(const TargetWindow& window, const Match& match, float stopAt,
                                 int* samples = nullptr) const;

  /// The same for a match at a pixel that aligns the directions of movement, and for the one turned
  /// by 180 degrees from it: both read the same pixels, so that they cost little more than one.
  /// @param aligned  at a whole pixel, as `alignedRotation` turns it.
  /// @return  of the aligned match, of the opposite one.
  [[nodiscard]] std::array<float, 2> ofBothWays(const TargetWindow& window, const Match& aligned,
                                                float stopAt, int& samples) const;

 private:
  /// `gather` where the window is cut by the edge of the image.
  void gatherAtEdge(int x, int y, const WindowWeights& weights, TargetWindow& window) const;
  void gatherDirections(int x, int y, TargetWindow& window) const;
  [[nodiscard]] float directionTerm(const TargetWindow& window, const Match& match) const;

  const ExemplarLevel& exemplar_;
  const TargetLevel& target_;
  const PatchKernels& kernels_;
  DistanceWeights weights_;
  std::array<std::int32_t, TargetWindow::kSamples> offsets_{};  ///< see WindowSource
};

}  // namespace fluidymation
