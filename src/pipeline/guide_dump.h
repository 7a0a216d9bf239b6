#pragma once

#include <string>

#include "fluidymation/guides/guide_frame.h"

namespace fluidymation {

/// Writes `folder`/NNNNN.mask.png, .dist.pfm, .flow.flo, .ext_fwd.pfm, .ext_bwd.pfm (unscaled, px)
/// and for people .flow.png (hue = direction, intensity = magnitude, as in the thesis' figure 3.3),
/// .ext_fwd.png and .ext_bwd.png (normalized to the frame's largest value); .shape.pfm (0 to 1)
/// where that guide is used, .age.pfm (frames) where ages take the place of extents. NNNNN is the
/// frame's own number with five digits. Creates the folder.
/// @throws Error naming the file that cannot be written.
void dumpGuides(const std::string& folder, int frameNumber, const GuideFrame& guides);

}  // namespace fluidymation
