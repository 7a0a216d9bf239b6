#pragma once

#include "fluidymation/synthesis/channels.h"

namespace fluidymation {

/// Four floats that the compiler keeps in one vector register (GCC and Clang, any architecture).
using Float4 = float __attribute__((vector_size(16)));

/// The channels of one pixel side by side, see `Channel`: 32 bytes, half a cache line.
struct Lanes {
  Float4 low{};   ///< L, a, b, edge
  Float4 high{};  ///< ext+, ext-, direction

  [[nodiscard]] float operator[](int channel) const {
    return channel < 4 ? low[channel] : high[channel - 4];
  }
};

}  // namespace fluidymation
