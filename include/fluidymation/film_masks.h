#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "fluidymation/option_ranges.h"
#include "fluidymation/options.h"

namespace fluidymation {

namespace ranges {

/// Frames whose median is the bare surface; they are held in memory together.
inline constexpr Range kBareFrames{1, 25};
/// CIELAB colour differences: black and white are 100 apart, no colours of a screen more than 260.
inline constexpr Range kDifferences{0, 260, true};
/// Of parts and holes, in pixels; as many as a picture may have.
inline constexpr Range kPartSizesPx{0, 120'000'000};

}  // namespace ranges

/// How masks are made of a film, and where they go.
struct FilmMaskOptions {
  SequenceOptions film;                      ///< all frames there are, at scale 1
  std::string maskPath;                      ///< pattern of the masks to write
  std::optional<std::string> barePath;       ///< a picture of the bare surface, of the film's size
  int bareFrames = 1;                        ///< else the median of so many first frames
  std::optional<std::string> barePaintPath;  ///< mask of paint that lies on it already
  std::optional<float> threshold;            ///< CIELAB difference; else chosen by the whole film
  float grainSigmaPx = 1.0F;                 ///< what differs is averaged by such a Gaussian
  std::optional<int> smallestPartPx;         ///< smaller parts go; else `kSmallestShare`
  std::optional<int> smallestHolePx;         ///< smaller holes are filled; likewise
  bool soft = false;                         ///< anti-aliased masks
  std::optional<std::string> sheetPath;      ///< PNG file: outlines over some frames
  std::optional<std::string> mattePath;      ///< pattern of the pigment without the surface
  bool overwrite = false;                    ///< masks and mattes that are there already
  int threads = 1;

  FilmMaskOptions();
};

/// Parts and holes smaller than this share of the picture are dirt: 44 px of 400x222.
inline constexpr double kSmallestShare = 0.0005;

/// What `maskFilm` has done and seen.
struct FilmMasks {
  int frames = 0;
  float threshold = 0.0F;             ///< that was used
  std::vector<std::string> report;    ///< lines for people
  std::vector<std::string> warnings;  ///< what is wrong with film or masks, and what to do
};

/// Makes a mask of every frame of a film: where its colours differ from the bare surface's by
/// `threshold` or more, without small parts and small holes. 8-bit gray PNG, 0 and 255, or what is
/// between where they are soft; numbers as the film's. Reads the film twice and holds one frame at
/// a time, and `bareFrames` of them at the beginning.
/// @param cancelled  asked before each frame; may be empty.
/// @throws UsageError for options that contradict each other or would replace an input; Error
///   naming the file that cannot be read or written; Interrupted, every file written being whole.
[[nodiscard]] FilmMasks maskFilm(const FilmMaskOptions& options,
                                 const std::function<bool()>& cancelled);

}  // namespace fluidymation
