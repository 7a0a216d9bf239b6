#pragma once

#include <optional>
#include <string>
#include <vector>

#include "inspect/shape_figures.h"

namespace fluidymation {

/// What is known of a run before it is painted.
struct KnownRun {
  SequenceFigures exemplar;
  SequenceFigures target;
  float borderWidthPx = 0.0F;
  float rimWidthPx = 1.0F;  ///< of the exemplar, `measuredBorderWidthPx`
  float blurSigmaPx = 0.0F;
  float targetBlurSigmaPx = 0.0F;
  int sourceSpeed = 1;
};

// From when on something is told of. Shares are of a frame's smoothed shape unless told otherwise.

inline constexpr double kTellThinShare = 0.05;    ///< in parts thinner than a patch
inline constexpr double kTellLostShare = 0.1;     ///< of the stored area that smoothing takes away
inline constexpr double kTellOverlapShare = 0.5;  ///< of the smaller shape, both frames have it
inline constexpr double kTellAreaStep = 0.25;     ///< from frame to frame, of the largest area
inline constexpr double kTellBareShare = 0.1;     ///< of the picture, bare surface of the exemplar
inline constexpr double kTellFewFrames =
    0.1;  ///< of the frames: of some things fewer are not worth a word
/// Border speeds of a target frame and of the exemplar. The thesis' animations are up to 3.5 times
/// as fast as the bundled films in single frames, and paint well.
inline constexpr double kTellSpeedRatio = 4.0;
/// Border width by rim. The bundled films paint well at up to 3.5. A border too narrow is not told
/// of: where colours change all the way inwards no rim can be told from them.
inline constexpr double kTellWidthRatio = 4.0;

/// What will look bad, the frames it happens in, the figures, and what to turn: a line each.
[[nodiscard]] std::vector<std::string> expectations(const KnownRun& run);

/// Frame numbers in their order, runs of successive frames as "5-9", a long list cut.
/// @param all  numbers of the sequence; `chosen` are indices of it, growing.
[[nodiscard]] std::string framesText(const std::vector<int>& all, const std::vector<int>& chosen);

}  // namespace fluidymation
