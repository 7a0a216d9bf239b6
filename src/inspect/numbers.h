#pragma once

#include <string>

namespace fluidymation {

/// With so many digits behind the decimal point, in any locale.
[[nodiscard]] std::string fixedText(double value, int digits);

/// "23 %", below ten "2.3 %".
[[nodiscard]] std::string percentText(double share);

}  // namespace fluidymation
