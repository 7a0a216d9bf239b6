#pragma once

#include <string>

namespace fluidymation {

/// Of the engine: "0.1.0".
[[nodiscard]] std::string version();

}  // namespace fluidymation
