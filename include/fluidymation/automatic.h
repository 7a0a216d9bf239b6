#pragma once

#include <optional>
#include <vector>

#include "fluidymation/core/geometry.h"

namespace fluidymation {

// Widths that are found from the inputs where none are given, so that no guide's effect depends on
// the resolution of a film or an animation.

/// Sigma of the mask smoothing as a share of the square root of the masks' mean area. 8 px for a
/// shape that covers 0.64 of a square of 800 px, 3 px for one that covers 0.47 of 350 px. Figures
/// that cover a third to a half of these squares get somewhat less, 5.8 to 7.1 px and 2.5 to 3.1
/// px, which keeps more of their thin parts.
inline constexpr float kBlurSigmaShare = 0.0125F;

/// Border width as a share of sqrt(width x height) of the exemplar: 10 px for 400x222, where the
/// rims of filmed media end.
inline constexpr float kBorderWidthShare = 0.035F;

/// @param areas  of each frame's mask, px^2: the sum of its coverage, so that faint soft masks
/// count; frames without any do not.
/// @return  px, rounded to tenths; 0 when no frame has any.
[[nodiscard]] float automaticBlurSigmaPx(const std::vector<double>& areas);

/// @param exemplar  size as scaled. @return  px, rounded to tenths, at least 1.
[[nodiscard]] float automaticBorderWidthPx(Size exemplar);

/// A measured border width is taken as far as it lies between these multiples of the above: a film
/// whose colours change all the way inwards has no rim that a border segment could stand for.
inline constexpr float kLeastMeasuredShare = 0.5F;
inline constexpr float kMostMeasuredShare = 2.0F;

/// @param measuredPx  nothing where the film has no edge to measure at. @return  px, likewise.
[[nodiscard]] float boundedBorderWidthPx(std::optional<float> measuredPx, Size exemplar);

}  // namespace fluidymation
