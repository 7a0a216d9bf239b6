#pragma once

#include <cstdint>
#include <string>

#include "fluidymation/core/geometry.h"

namespace fluidymation {

/// "640x480", for messages. 64 bits: a damaged file may claim any size.
[[nodiscard]] inline std::string sizeText(std::int64_t width, std::int64_t height) {
  return std::to_string(width) + "x" + std::to_string(height);
}
[[nodiscard]] inline std::string sizeText(Size size) { return sizeText(size.width, size.height); }

}  // namespace fluidymation
