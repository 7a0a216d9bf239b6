#pragma once

#include <cstdint>
#include <vector>

#include "fluidymation/options.h"
#include "fluidymation/synthesis/exemplar.h"
#include "fluidymation/synthesis/nnf.h"
#include "fluidymation/synthesis/target_level.h"

namespace fluidymation {

/// How often the pixels of the exemplar are used (thesis §3.3).
///
/// Omega(p, k) counts the matches whose n x n x (2 occ-radius + 1) box covers (p, k). What the
/// search needs is Omega(window), the mean over the n x n positions of a window; the map holds
/// that sum ready for every centre, so that a candidate costs one look-up. The box is not turned
/// with the match: its corners matter less than its size. Positions outside the image count 0.
/// Counts are integers, so that sums do not depend on their order; 32 bits hold 2^31 / n^2 = 85
/// million matches, and the levels searched of the largest target read have 30 million pixels.
class OccurrenceMap {
 public:
  OccurrenceMap(Size size, int frameCount, int radiusFrames);

  /// Counts the matches of `nnf` anew. Runs in parallel.
  void rebuild(const NearestNeighborField& nnf);

  /// Counts one match more or less: `delta` is +1 or -1. Matches are counted at their nearest
  /// pixel, clamped to the image.
  void add(const Match& match, int delta);

  /// Sets all counts to zero.
  void clear();

  /// Sum of Omega over the n x n window centred on (x, y) of frame k: n^2 Omega(window).
  [[nodiscard]] std::int32_t windowSum(int x, int y, int k) const { return sums_[index(x, y, k)]; }
  /// The same at the nearest pixel of a match, clamped to the image.
  [[nodiscard]] std::int32_t windowSum(const Match& match) const;

  /// What one use at `used` adds to the window sum at `centre`, both at their nearest pixels: n^2
  /// at its own place, less where either window is cut by the image, 0 where they do not meet.
  [[nodiscard]] std::int32_t contribution(const Match& used, const Match& centre) const;

  /// Mean of Omega(window) over `pixels` (volume indices) if each of them were used once.
  [[nodiscard]] static double meanOfUniformUse(const ExemplarLevel& exemplar,
                                               const std::vector<std::uint32_t>& pixels,
                                               int radiusFrames);

 private:
  [[nodiscard]] std::size_t index(int x, int y, int k) const {
    return (static_cast<std::size_t>(y) * static_cast<std::size_t>(size_.width) +
            static_cast<std::size_t>(x)) *
               static_cast<std::size_t>(frameCount_) +
           static_cast<std::size_t>(k);
  }
  /// Turns counts of matches at their own places into window sums.
  void filter();
  void spreadOverFrames();
  void boxAlongX();
  void boxAlongY();

  Size size_;
  int frameCount_;
  int radiusFrames_;
  std::vector<std::int32_t> sums_;     ///< frames side by side: an update touches contiguous runs
  std::vector<std::int32_t> scratch_;  ///< second buffer of the filters
};

/// omega_best of thesis §3.3 per segment: the mean of Omega(window) over a segment's source pixels
/// if every one of them were used |T segment| / |S segment| times. The printed formula
/// n^2 (2 occ-radius + 1) |T| / |S| overstates this, because boxes are clipped at the exemplar's
/// ends and a moving front belongs to the border segment in few frames (uniform use then has
/// 0.19 to 0.28 of it), so that lambda would silently weaken.
class ExpectedUse {
 public:
  ExpectedUse(const ExemplarLevel& exemplar, int radiusFrames);

  /// omega_best of a segment for a target with these pixel counts; > 0 where the segment has any.
  [[nodiscard]] float best(const TargetLevel& target, Segment segment) const;

 private:
  bool segmented_;
  double borderPerUse_ = 0.0;  ///< omega_best per target pixel
  double interiorPerUse_ = 0.0;
};

}  // namespace fluidymation
