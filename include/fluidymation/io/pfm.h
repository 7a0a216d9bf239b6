#pragma once

#include <string>

#include "fluidymation/core/image.h"

namespace fluidymation {

struct Float3 {
  float x = 0.0F;
  float y = 0.0F;
  float z = 0.0F;
};

/// Portable float map, little endian (scale -1.0), rows bottom to top; "Pf" for one channel, "PF"
/// for three. Written atomically. @throws Error naming the file.
void writePfm(const std::string& path, const Image<float>& image);
void writePfm(const std::string& path, const Image<Float3>& image);

}  // namespace fluidymation
