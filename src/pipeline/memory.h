#pragma once

#include <cstdint>
#include <string>

#include "fluidymation/core/geometry.h"
#include "fluidymation/guides/packed_shape.h"
#include "fluidymation/options.h"

namespace fluidymation {

/// What a run may need: a machine with 8 GiB has to finish it, and some of that is its system's.
inline constexpr std::int64_t kMaxRunBytes = std::int64_t{6} << 30;

/// What decides about the memory of a run. Rules that are left out are those of a run that is given
/// none.
struct RunSize {
  Size exemplar;  ///< as scaled
  int exemplarFrames = 0;
  Size target;  ///< as scaled
  int targetFrames = 0;
  int threads = 1;
  float timeBlurSigmaFrames = 0.0F;
  Size largestStored;  ///< of all frames read, before scaling
  float flowBlurSigmaFrames = 0.0F;
  ShapeRules shape = SynthesisOptions{}.shape;
  Size exemplarFlow{};  ///< as stored; 0x0 where the flow is derived
  Size targetFlow{};
  FinestLevel finestLevel = SynthesisOptions{}.finestLevel;
  bool mayCompareAges = true;  ///< in the place of extents; false where material is painted plainly
  int occRadiusFrames = SynthesisOptions{}.occRadiusFrames;
  TemporalCoherence temporalCoherence = SynthesisOptions{}.temporalCoherence;
  bool dumps = false;  ///< whether guides and matches are written too
};

/// What is kept of every mask pixel of a target that is still to be painted: its flow and the
/// motion still to come, a Vec2 each.
inline constexpr std::int64_t kBytesPerMaskPixel = 16;

/// Bytes kept of a target's smoothed masks: `kBytesPerMaskPixel`, and the outlines of soft ones.
[[nodiscard]] std::int64_t bytesKept(const ShapeTally& target);

/// Bytes a run needs as far as sizes tell: the exemplar with its levels, the search's maps, one
/// frame at work (with several threads one in each stage: guides, search, writing), those of a
/// window where frames are painted in both directions of time, and the packed masks of the target.
/// `bytesKept` comes on top for the target's mask pixels and outlines, whose number shows only when
/// the masks are read and smoothed.
[[nodiscard]] std::int64_t bytesOfRun(const RunSize& run);

/// "3.4 GiB", rounded up.
[[nodiscard]] std::string gibibytes(std::int64_t bytes);

}  // namespace fluidymation
