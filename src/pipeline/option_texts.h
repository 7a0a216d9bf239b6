#pragma once

#include <string>
#include <utility>
#include <vector>

#include "fluidymation/options.h"

namespace fluidymation {

/// Names and values of options as the command line takes them.
using OptionTexts = std::vector<std::pair<std::string, std::string>>;

/// Every option that changes a byte of the painted frames, but for the names of the inputs; given
/// to the tool after those of `pathOptions`, they give the same frames. `--compression-level` is
/// among them: it leaves the pixels alone, but not the files. Widths that are still to be found are
/// left out. What only a preset sets is `--preset`; a mixture that no preset has is told in words
/// there, and no command line gives it.
[[nodiscard]] OptionTexts shapingOptions(const Options& options);

/// Where the files of a run lie: inputs and frames.
[[nodiscard]] OptionTexts pathOptions(const Options& options);

}  // namespace fluidymation
