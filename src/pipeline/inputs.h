#pragma once

#include <cstdint>
#include <string>

#include "fluidymation/core/geometry.h"
#include "fluidymation/core/image.h"
#include "fluidymation/io/frame_sequence.h"
#include "fluidymation/options.h"
#include "fluidymation/pipeline.h"

namespace fluidymation {

/// The exemplar is held whole, at about 80 bytes a pixel and frame with its guides and levels.
inline constexpr std::int64_t kMaxExemplarPixels = 250'000'000;

/// A sequence as found on disk and the size its frames are scaled to.
struct InputSequence {
  FrameFiles files;
  Size scaled;
};

/// Everything that is read, checked as far as headers and folders tell.
struct Inputs {
  InputSequence color;
  InputSequence sourceMask;
  InputSequence target;
};

/// Finds all files, reads all headers, and checks that they fit together and the limits.
/// @throws Error, UsageError naming file or option.
[[nodiscard]] Inputs openInputs(const Options& options, const Observer& observer);

/// Reads a mask image, scales it as gray and cuts it at one half.
[[nodiscard]] Mask readMask(const std::string& path, Size size);

}  // namespace fluidymation
