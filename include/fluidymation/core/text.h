#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "fluidymation/core/geometry.h"

namespace fluidymation {

/// "640x480", for messages. 64 bits: a damaged file may claim any size.
[[nodiscard]] inline std::string sizeText(std::int64_t width, std::int64_t height) {
  return std::to_string(width) + "x" + std::to_string(height);
}
[[nodiscard]] inline std::string sizeText(Size size) { return sizeText(size.width, size.height); }

/// "4,3,2", as lists of options are given.
[[nodiscard]] inline std::string listText(const std::vector<int>& values) {
  std::string text;
  for (const int value : values) {
    if (!text.empty()) text += ',';
    text += std::to_string(value);
  }
  return text;
}

}  // namespace fluidymation
