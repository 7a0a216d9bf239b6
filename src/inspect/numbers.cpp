#include "inspect/numbers.h"

#include <array>
#include <charconv>
#include <cmath>

namespace fluidymation {

std::string fixedText(double value, int digits) {
  constexpr double kLargest = 1e15;
  if (!(std::abs(value) < kLargest)) return "beyond 1e15";
  std::array<char, 64> buffer{};
  const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                                    std::chars_format::fixed, digits);
  return {buffer.data(), result.ptr};
}

std::string percentText(double share) {
  const double percent = 100.0 * share;
  constexpr double kRounded = 9.95;
  return fixedText(percent, percent < kRounded && percent > 0.0 ? 1 : 0) + " %";
}

}  // namespace fluidymation
