#pragma once

#include <functional>
#include <string>

#include "fluidymation/options.h"
#include "pipeline/inputs.h"

namespace fluidymation {

/// Gives a value to every width that the user has left open (see automatic.h): mask smoothing of
/// exemplar and target from the areas of their masks, the border width from the exemplar's size or,
/// where that is wanted, from its colours.
/// @param beforeFrame  called before each mask that is looked at; may throw to stop.
void fillAutomaticWidths(const Inputs& inputs, MaskChannel sourceChannel, MaskChannel targetChannel,
                         const std::function<void()>& beforeFrame, Options& options);

/// How wide the rim of the film's medium is by its colours, px: what --border-width auto stands
/// for. Looks at a bounded number of frames, evenly spread; within the bounds that the size gives.
/// @param smoothing  of the exemplar's masks.
[[nodiscard]] float measuredBorderWidthPx(const Inputs& inputs, MaskChannel sourceChannel,
                                          const MaskOptions& smoothing,
                                          const std::function<void()>& beforeFrame);

/// The widths that `given` leaves open, as options that would give what was found for them: "chosen
/// by size: --border-width 9.7"; empty where it leaves none open.
[[nodiscard]] std::string chosenWidths(const Options& given, const Options& found);

}  // namespace fluidymation
