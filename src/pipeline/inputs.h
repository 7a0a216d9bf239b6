#pragma once

#include <cstdint>
#include <string>

#include "fluidymation/core/color.h"
#include "fluidymation/core/geometry.h"
#include "fluidymation/core/image.h"
#include "fluidymation/io/frame_sequence.h"
#include "fluidymation/options.h"
#include "fluidymation/pipeline.h"

namespace fluidymation {

/// The exemplar is held whole, at about 80 bytes a pixel and frame with its guides and levels.
inline constexpr std::int64_t kMaxExemplarPixels = 250'000'000;

/// A sequence as found on disk, the size of its frames and the one they are scaled to.
struct InputSequence {
  FrameFiles files;
  Size stored;
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

/// Reads mask `frame` of a sequence, scales it as gray and cuts it at one half.
/// @throws Error naming the file, also when its size is no longer the one found at first.
[[nodiscard]] Mask readMask(const InputSequence& masks, int frame);

/// Reads and scales picture `frame` of a sequence; sRGB-encoded. @throws Error likewise.
[[nodiscard]] Image<Rgb> readPicture(const InputSequence& pictures, int frame);

}  // namespace fluidymation
