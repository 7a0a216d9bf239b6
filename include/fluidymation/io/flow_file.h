#pragma once

#include <string>

#include "fluidymation/core/image.h"
#include "fluidymation/io/input_limits.h"

namespace fluidymation {

/// Middlebury .flo: "PIEH", width, height, then (x, y) pairs, rows top to bottom, little endian.
/// Written atomically. @throws Error naming the file.
void writeFlow(const std::string& path, const Image<Vec2>& flow);

/// Size claimed by a flow file, told by its first bytes: Middlebury .flo, or a PNG file of 16-bit
/// RGB as KITTI encodes flow. The vectors are not read.
/// @throws Error naming the file when it cannot be opened, is neither, claims a size beyond
///   `kMaxImageSidePx` and `kMaxImagePixels`, or has not the length that size asks for.
[[nodiscard]] Size readFlowSize(const std::string& path);

/// Reads a flow file, pixels per frame. Unknown vectors are zero: in .flo files those with a
/// component that is no number or of 1e9 and more, in PNG files those whose third channel is 0. The
/// other two channels of a PNG file are 64 times the vector, plus 32768.
/// @param expected  the size found earlier: whoever planned with it must not meet another one.
/// @throws Error naming the file, and the pixel of a known component above `kMaxFlowPx`.
[[nodiscard]] Image<Vec2> readFlow(const std::string& path, Size expected);

}  // namespace fluidymation
