#pragma once

#include <cstddef>

namespace fluidymation {

/// Index of a container for a number that is never negative: `values[at(i)]`.
[[nodiscard]] constexpr std::size_t at(int i) { return static_cast<std::size_t>(i); }

}  // namespace fluidymation
