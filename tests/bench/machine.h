#pragma once

#include <string>
#include <utility>
#include <vector>

namespace fluidymation::bench {

/// What a timing depends on besides the case: names and values, in the order in which to print
/// them.
using Facts = std::vector<std::pair<std::string, std::string>>;

/// Commit, compiler, flags, processor, and the number of threads given.
[[nodiscard]] Facts factsOfMachine(int threads);

}  // namespace fluidymation::bench
