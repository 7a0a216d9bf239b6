#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "fluidymation/core/color.h"
#include "fluidymation/core/image.h"
#include "fluidymation/guides/guide_frame.h"
#include "fluidymation/options.h"
#include "fluidymation/synthesis/channels.h"
#include "fluidymation/synthesis/film_extents.h"
#include "fluidymation/synthesis/nnf.h"
#include "fluidymation/synthesis/pyramid.h"
#include "fluidymation/synthesis/texel.h"

namespace fluidymation {

struct PatchKernels;

/// All frames of the exemplar on one pyramid level, with everything the search reads of a pixel
/// side by side. Volumes are stored frame by frame, row-major.
class ExemplarLevel {
 public:
  ExemplarLevel(Size size, int frameCount, float borderWidthPx, const ShapeRules& rules = {});

  /// Fill frame k, in any order. `color` and `guides` have this level's size.
  void setColor(int frame, const Image<Lab>& color);
  void setGuides(int frame, const GuideLevel& guides);

  /// The inner loops that read the level: those of the fastest instruction set of this processor,
  /// unless others are wanted. All give the same bytes.
  [[nodiscard]] const PatchKernels& kernels() const { return *kernels_; }
  void use(const PatchKernels& kernels) { kernels_ = &kernels; }

  /// Says how extents are scaled before any frame is filled: then they are not kept unscaled until
  /// all are, which takes less memory.
  void setExtentScale(const ExtentScale& extentScale);

  /// Lets go of the first frames: those behind them move up, and as many at the end are to be
  /// filled anew, before `finish`.
  /// @param count  in [0, frameCount()].
  void dropFirst(int count);

  /// Completes the level when all frames are filled: scales the extents, lists the pixels of each
  /// segment.
  /// @param extentScale  the one that was set, where one was.
  void finish(const ExtentScale& extentScale = {});

  [[nodiscard]] Size size() const { return size_; }
  [[nodiscard]] int frameCount() const { return frameCount_; }
  [[nodiscard]] float borderWidthPx() const { return borderWidthPx_; }

  /// The texel at (x, y) of frame k. The edge is repeated beyond the image, so that windows of
  /// matches in the image can be read without a look at its bounds: x in
  /// [-kMarginPx, width + kMarginPx), y likewise.
  [[nodiscard]] const Texel& texel(int x, int y, int k) const { return texels_[padded(x, y, k)]; }
  /// Texels from row to row.
  [[nodiscard]] int stride() const { return size_.width + 2 * kMarginPx; }
  static constexpr int kMarginPx = 5;  ///< a turned window's reach, interpolation, half a pixel

  /// Asks the cache for what `isLegal` reads.
  void prefetchSegment(int x, int y, int k) const {
    __builtin_prefetch(&segments_[offset(x, y, k)]);
  }
  /// Asks the cache for what a comparison with a window round (x, y) reads first.
  void prefetchWindow(int x, int y, int k) const {
    __builtin_prefetch(&directions_[offset(x, y, k)]);
    const Texel* left = &texel(x - kPatchRadius, y - kPatchRadius, k);
    for (int row = 0; row < kPatchSize; ++row, left += stride()) {
      __builtin_prefetch(left);
      __builtin_prefetch(left + kPatchSize - 1);
    }
  }

  [[nodiscard]] Segment segment(int x, int y, int k) const { return segments_[offset(x, y, k)]; }
  [[nodiscard]] Vec2 direction(int x, int y, int k) const {
    constexpr float kUnit = 1.0F / kDirectionSteps;
    const FixedDirection d = directions_[offset(x, y, k)];
    return {kUnit * static_cast<float>(d.x), kUnit * static_cast<float>(d.y)};
  }
  /// Of the extents' fixed point.
  [[nodiscard]] float extentSteps() const { return extentSteps_; }

  /// Whether (x, y) of frame k may be a match's centre for a target pixel of `wanted`: inside the
  /// image, inside the mask and in that segment. When the exemplar lacks one of the segments at
  /// this level, or where segments are not hard, any mask pixel serves.
  [[nodiscard]] bool isLegal(int x, int y, int k, Segment wanted) const {
    if (x < 0 || y < 0 || x >= size_.width || y >= size_.height) return false;
    const Segment found = segment(x, y, k);
    return found == wanted || (!constrained() && found != Segment::kOutside);
  }
  [[nodiscard]] bool isLegal(const Match& match, Segment wanted) const {
    return match.exists() && isLegal(match.nearestX(), match.nearestY(), match.frame, wanted);
  }

  /// False when a segment has no pixel at this level: then there is no telling them apart.
  [[nodiscard]] bool segmented() const { return segmented_; }

  /// Whether the extents' place is taken by ages, which have no direction.
  [[nodiscard]] bool comparesAges() const { return comparesAges_; }

  /// Volume indices of a segment's pixels; of the other one's where it has none.
  [[nodiscard]] const std::vector<std::uint32_t>& pixelsOf(Segment segment) const;

  /// Distance to the edge as the temporal modulation compares it: clamped at the border width, or
  /// unclamped and then infinite in frames without an edge.
  [[nodiscard]] float modulationDistancePx(int x, int y, int k) const {
    if (!distancesPx_.empty()) return distancesPx_[offset(x, y, k)];
    const float edge = static_cast<float>(texel(x, y, k).guides.edge) / kEdgeSteps;
    return edge / kEdgeScale * borderWidthPx_;
  }

  /// Volume indices of the pixels that may serve a target pixel of this segment; never empty
  /// unless all masks are.
  [[nodiscard]] const std::vector<std::uint32_t>& candidates(Segment segment) const;

  struct Position {
    int x = 0;
    int y = 0;
    int frame = 0;
  };
  [[nodiscard]] Position position(std::uint32_t volumeIndex) const;

 private:
  [[nodiscard]] std::size_t offset(int x, int y, int k) const {
    return (static_cast<std::size_t>(k) * static_cast<std::size_t>(size_.height) +
            static_cast<std::size_t>(y)) *
               static_cast<std::size_t>(size_.width) +
           static_cast<std::size_t>(x);
  }

  [[nodiscard]] std::size_t padded(int x, int y, int k) const {
    const std::ptrdiff_t row =
        static_cast<std::ptrdiff_t>(k) * (size_.height + 2 * kMarginPx) + y + kMarginPx;
    return static_cast<std::size_t>(row * stride() + x + kMarginPx);
  }

  /// Whether the scale of extents is known, so that they need not be kept unscaled.
  [[nodiscard]] bool scalesAtOnce() const { return extentsPx_.empty(); }
  void setExtents(int x, int y, int k, Vec2 extentsPx);
  void listPixels();

  /// Sets a pixel's texel, and those of the margin that repeat it, by `set(texel)`.
  template <typename Set>
  void setTexels(int x, int y, int k, const Set& set);

  /// Components of a unit vector in steps of 1 / kDirectionSteps.
  struct FixedDirection {
    std::int16_t x = 0;
    std::int16_t y = 0;
  };
  static constexpr float kDirectionSteps = 16383.0F;

  /// Whether a match has to stay in its segment.
  [[nodiscard]] bool constrained() const { return segmented_ && rules_.hardSegments; }

  const PatchKernels* kernels_;
  Size size_;
  int frameCount_;
  float borderWidthPx_;
  ShapeRules rules_;
  bool segmented_ = true;
  bool comparesAges_ = false;
  ExtentScale extentScale_;
  std::vector<float> distancesPx_;  ///< empty where the edge guide tells them
  float extentSteps_ = 1.0F;
  std::vector<Texel> texels_;    ///< with margins
  std::vector<Vec2> extentsPx_;  ///< ext+ and ext- until `finish`, which scales them
  std::vector<FixedDirection> directions_;
  std::vector<Segment> segments_;
  std::vector<std::uint32_t> borderPixels_;
  std::vector<std::uint32_t> interiorPixels_;
  std::vector<std::uint32_t> allPixels_;  ///< only where segments are not hard
};

/// The exemplar on all levels, and its accumulated motion at full resolution: a whole film, or as
/// many consecutive frames of it as are held at a time (P§5). Frames are counted from the first
/// one that is held.
class Exemplar {
 public:
  /// @param coarsest  number of the coarsest level wanted.
  Exemplar(Size size, int frameCount, int coarsest, float borderWidthPx,
           const ShapeRules& rules = {});

  /// Of a part of a film, before any frame is filled: how the whole film's extents are scaled
  /// (`FilmExtents`), so that it is the same whichever part is held.
  void setExtentScale(const ExtentScale& scale);

  /// Fill frame k; colour and guides of every frame must be set once before `finish`, guides in
  /// their order.
  void setColor(int frame, const Image<Lab>& color);
  void setGuides(int frame, const GuideFrame& guides);
  /// Where the guides hold ages, in all frames or in none, they are compared in the place of the
  /// extents, and the target's guides have to hold them too; `unit` then says nothing.
  /// Where a scale was set, that one is taken.
  void finish(ExtentUnit unit = ExtentUnit::kPixels);

  /// Lets go of the first `count` frames, and holds as many more at the end, which are to be filled
  /// before `finish` is called again; where all are let go of, as when nothing is filled yet, all.
  void advance(int count);
  /// Number, within the film, of the first frame that is held.
  [[nodiscard]] int firstFrame() const { return firstFrame_; }

  /// See `ExemplarLevel::use`; of all levels.
  void use(const PatchKernels& kernels);

  /// How the target's extents have to be scaled to compare with this exemplar's.
  [[nodiscard]] const ExtentScale& extentScale() const { return extentScale_; }

  [[nodiscard]] const ExemplarLevel& level(int l) const {
    return levels_[static_cast<std::size_t>(l)];
  }
  [[nodiscard]] int levelCount() const { return static_cast<int>(levels_.size()); }
  [[nodiscard]] int frameCount() const { return levels_.front().frameCount(); }
  [[nodiscard]] bool comparesAges() const { return extentScale_.isOfAges(); }

  /// acc+ and acc- of frame k at full resolution; §3.5.
  [[nodiscard]] const Image<Vec2>& accForward(int k) const {
    return accForward_[static_cast<std::size_t>(k)];
  }
  [[nodiscard]] const Image<Vec2>& accBackward(int k) const {
    return accBackward_[static_cast<std::size_t>(k)];
  }

 private:
  ExtentScale extentScale_;
  bool scaleIsSet_ = false;
  FilmExtents extents_;  ///< of the frames filled so far, unless the scale is set
  int firstFrame_ = 0;
  std::vector<ExemplarLevel> levels_;
  std::vector<Image<Vec2>> accForward_;
  std::vector<Image<Vec2>> accBackward_;
};

}  // namespace fluidymation
