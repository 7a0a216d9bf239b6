#pragma once

#include <set>
#include <string>
#include <vector>

#include "cli/config_file.h"
#include "cli/option_table.h"

namespace fluidymation::cli {

using Names = std::set<std::string>;  ///< of options: "--border-width"

/// Sets what a file says, in the order of the table. @return  the options' names.
/// @throws UsageError naming the line.
Names applyEntries(const std::vector<ConfigEntry>& entries, const std::vector<Spec>& table,
                   CommandLine& line);

/// @throws UsageError naming all options that are required and not `given`.
void requireOptions(const std::vector<Spec>& table, const Names& given);

/// @throws UsageError where frames are chosen in two ways at once.
void requireOneChoice(const Names& given);

}  // namespace fluidymation::cli
