#pragma once

#include <string>

namespace fluidymation {

/// Beginning of the names of all files dumped for one frame: `folder`/NNNNN, the frame's own number
/// as `%05d` writes it (-0001 for -1). A dumped file is NNNNN.<channel>.<extension>.
[[nodiscard]] std::string dumpStem(const std::string& folder, int frameNumber);

/// Whether `fileName` (without folder) is one that a dump could write, for whatever frame.
[[nodiscard]] bool isDumpName(const std::string& fileName);

}  // namespace fluidymation
