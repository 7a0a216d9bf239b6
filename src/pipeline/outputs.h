#pragma once

#include <string>
#include <vector>

#include "fluidymation/options.h"
#include "pipeline/inputs.h"

namespace fluidymation {

/// The frames to be written: checked not to replace anything that is read, in a folder that exists
/// and can be written; likewise the folders of the dump.
/// @return  one path per target frame.
/// @throws Error, UsageError naming file, folder or option; before any work.
[[nodiscard]] std::vector<std::string> prepareOutput(const Options& options, const Inputs& inputs);

/// Where the guides of "source" or "target" are dumped; only with `--dump-guides`.
[[nodiscard]] std::string dumpFolder(const Options& options, const std::string& sequence);

}  // namespace fluidymation
