#include "fluidymation/core/version.h"

namespace fluidymation {

std::string version() { return FLUIDYMATION_VERSION; }

}  // namespace fluidymation
