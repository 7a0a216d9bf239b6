#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "fluidymation/core/box.h"
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
/// million matches, four times what fits into the memory that a run may take.
class OccurrenceMap {
 public:
  OccurrenceMap(Size size, int frameCount, int radiusFrames);

  /// Counts the matches of `nnf`, at their nearest pixels, clamped to the image, in the place of
  /// those counted before. Takes time in proportion to the places that any of them reach. Runs in
  /// parallel.
  void rebuild(const NearestNeighborField& nnf);
  /// The same where row y of `nnf` has no matches but in `rows[y]`.
  void rebuild(const NearestNeighborField& nnf, const std::vector<RowSpan>& rows);

  /// Sum of Omega over the n x n window centred on (x, y) of frame k: n^2 Omega(window).
  [[nodiscard]] std::int32_t windowSum(int x, int y, int k) const { return sums_[index(x, y, k)]; }
  /// Asks the cache for it.
  void prefetch(int x, int y, int k) const { __builtin_prefetch(&sums_[index(x, y, k)]); }
  /// The same at the nearest pixel of a match, clamped to the image.
  [[nodiscard]] std::int32_t windowSum(const Match& match) const;

  /// What one use at `used` adds to the window sum at (x, y) of `frame`: n^2 at its own place, less
  /// where either window is cut by the image, 0 where they do not meet. Places in the image.
  [[nodiscard]] std::int32_t contribution(int usedX, int usedY, int usedFrame, int x, int y,
                                          int frame) const;

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
  [[nodiscard]] std::size_t usedIndex(int slab, int y, int block) const {
    return (static_cast<std::size_t>(slab) * static_cast<std::size_t>(size_.height) +
            static_cast<std::size_t>(y)) *
               static_cast<std::size_t>(blocks_) +
           static_cast<std::size_t>(block);
  }

  /// Sets all sums to zero.
  void clear();
  /// Counts one use in all frames that its box reaches, at its own pixel.
  void use(int x, int y, int frame);
  /// The first row of the exemplar that belongs to a band, of so many.
  [[nodiscard]] int rowOfBand(int band, int bands) const;
  /// Turns these counts into window sums.
  void filter();
  void filter(int slab);

  /// Columns and rows of some frames that may hold anything but zeros.
  struct Region {
    int left = 0;
    int top = 0;
    int right = 0;   ///< exclusive
    int bottom = 0;  ///< exclusive
    int firstFrame = 0;
    int frames = 0;
  };

  Size size_;
  int frameCount_;
  int radiusFrames_;
  int slabs_;                       ///< of kSlabFrames frames
  int blocks_;                      ///< of kBlockColumns columns, in a row
  std::vector<std::uint8_t> used_;  ///< of each block of each row and slab: whether it is, until
                                    ///< the filter has run
  std::vector<Region> filtered_;    ///< of all slabs
  std::vector<std::int32_t> sums_;  ///< frames side by side: filters run along contiguous vectors
};

/// What a few changed matches add to the window sums of an OccurrenceMap, cheap to keep: exact in
/// the plane, while frames are counted by groups, of which a sum takes the share that lies within
/// the box's reach.
class UseChanges {
 public:
  UseChanges(Size size, int frameCount, int radiusFrames);

  /// Frames that are counted as one: a third of the box.
  [[nodiscard]] static int framesPerGroup(int frameCount, int radiusFrames) {
    return std::max((2 * std::min(radiusFrames, frameCount) + 1) / kGroupsPerBox, 1);
  }

  /// Counts one match more or less at its nearest pixel, clamped to the image: `delta` is +1 or -1.
  void add(const Match& match, int delta);

  /// Sets all to zero.
  void clear() { std::fill(sums_.begin(), sums_.end(), 0); }
  /// Whether that costs less than so many calls of `add`.
  [[nodiscard]] bool isCheaperToClear(std::size_t adds) const {
    return adds * kSumsPerAdd > sums_.size();
  }

  /// Change of the window sum at (x, y) of frame k.
  [[nodiscard]] float windowSum(int x, int y, int k) const {
    const Reach& reach = reaches_[static_cast<std::size_t>(k)];
    const std::int32_t* at = sums_.data() + index(x, y, reach.firstGroup);
    float sum = 0.0F;
    for (int g = 0; g < reach.groups; ++g, at += plane_) {
      sum += reach.share[static_cast<std::size_t>(g)] * static_cast<float>(*at);
    }
    return sum;
  }

 private:
  /// Groups on which a box of 2 radius + 1 frames is spread. Three are nearly as good as all
  /// frames.
  static constexpr int kGroupsPerBox = 3;
  static constexpr std::size_t kSumsPerAdd = 81;         ///< 4 * kPatchRadius + 1, squared
  static constexpr int kMostGroups = kGroupsPerBox + 2;  ///< that a box can touch

  /// The groups within reach of a frame.
  struct Reach {
    int firstGroup = 0;
    int groups = 0;
    std::array<float, kMostGroups> share{};  ///< of each group's frames
  };

  [[nodiscard]] std::size_t index(int x, int y, int group) const {
    return static_cast<std::size_t>(group) * plane_ +
           static_cast<std::size_t>(y) * static_cast<std::size_t>(size_.width) +
           static_cast<std::size_t>(x);
  }

  Size size_;
  std::size_t plane_;  ///< sums of one group, row by row: an update runs along rows
  int framesPerGroup_;
  int groups_;
  std::vector<Reach> reaches_;  ///< of each frame
  std::vector<std::int32_t> sums_;
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
