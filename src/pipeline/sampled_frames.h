#pragma once

#include <vector>

namespace fluidymation {

/// How many frames of a sequence are looked at where a figure of all of it is estimated, each of
/// which has to be decoded once more for it. Of the 20 to 50 frames that films usually have
/// (README) these are all, or every second or third.
inline constexpr int kMostSampledFrames = 24;

/// The frames to look at of a sequence of `frameCount`, counted from 0: all, or
/// `kMostSampledFrames` from the first one on, evenly spread.
[[nodiscard]] std::vector<int> sampledFrames(int frameCount);

}  // namespace fluidymation
