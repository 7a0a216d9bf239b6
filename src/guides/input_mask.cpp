#include "fluidymation/guides/input_mask.h"

#include <algorithm>
#include <cstdint>

namespace fluidymation {

InputMask::InputMask(const Mask& mask) : coverage(mask.size()) {
  std::transform(mask.begin(), mask.end(), coverage.begin(),
                 [](std::uint8_t m) { return m != 0 ? 1.0F : 0.0F; });
}

Mask InputMask::cut() const {
  constexpr float kInsideCoverage = 0.5F;
  Mask mask(coverage.size());
  std::transform(coverage.begin(), coverage.end(), mask.begin(),
                 [](float c) { return static_cast<std::uint8_t>(c >= kInsideCoverage ? 1 : 0); });
  return mask;
}

}  // namespace fluidymation
