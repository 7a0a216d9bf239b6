#pragma once

#include <functional>
#include <string>
#include <vector>

#include "cli/command_line.h"

namespace fluidymation::cli {

using Arguments = std::vector<std::string>;

/// The four options that every run needs.
extern const Arguments kRequired;

[[nodiscard]] CommandLine parse(const Arguments& arguments);

/// With the four required options before `more`.
[[nodiscard]] Arguments complete(const Arguments& more);

/// Why the arguments are refused; "" where they are not.
[[nodiscard]] std::string complaint(const Arguments& arguments);

/// An option with a value, and whether the value has arrived.
struct Reaching {
  const char* option;
  const char* value;
  std::function<bool(const CommandLine&)> reached;
};

using List = std::vector<int>;

/// Every option that takes a value, with a value that is not its default.
[[nodiscard]] const std::vector<Reaching>& reachingOptions();

}  // namespace fluidymation::cli
