#pragma once

#include <cstdint>
#include <string>

#include "fluidymation/core/geometry.h"
#include "fluidymation/options.h"

namespace fluidymation {

/// What is kept in memory of the frames of a sequence that wait for their turn; the rest waits in a
/// temporary file (`RecordStore`), which costs no time that shows.
inline constexpr std::int64_t kWaitingBytes = std::int64_t{16} << 20;

/// What decides about the memory of a run. Rules that are left out are those of a run that is given
/// none.
struct RunSize {
  Size exemplar;           ///< as scaled
  int exemplarFrames = 0;  ///< of the whole film
  Size target;             ///< as scaled
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
  BitDepth bitDepth = BitDepth::k8;
  bool hasBackground = false;   ///< whether frames are laid over one
  bool hasBareSurface = false;  ///< whether that is the exemplar's bare surface
  bool dumps = false;           ///< whether guides and matches are written too
  /// The most mask pixels of any frame after smoothing. As long as they are not known, 0: then the
  /// bytes are those that are needed in any case.
  std::int64_t exemplarMaskPixels = 0;
  std::int64_t targetMaskPixels = 0;
  int heldFrames = 0;  ///< of the film, at a time (`FilmWindow`); 0: all
};

/// Bytes a run needs at most: the exemplar with its levels, the search's maps, one frame at work
/// (with several threads one in each stage: guides, search, writing), those of a window where
/// frames are painted in both directions of time, and what waits in memory. The length of the
/// target counts for its files' names only.
[[nodiscard]] std::int64_t bytesOfRun(const RunSize& run);

/// "3.4 GiB" or "812 MiB", rounded up.
[[nodiscard]] std::string memoryText(std::int64_t bytes);

}  // namespace fluidymation
