#pragma once

#include <string>

#include "fluidymation/core/image.h"

namespace fluidymation {

/// Middlebury .flo: "PIEH", width, height, then (x, y) pairs, rows top to bottom, little endian.
/// Written atomically. @throws Error naming the file.
void writeFlow(const std::string& path, const Image<Vec2>& flow);

}  // namespace fluidymation
