#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "fluidymation/options.h"
#include "pipeline/inputs.h"

namespace fluidymation {

/// Every input of a run, as far as it can be used.
struct CheckedInputs {
  std::optional<Inputs> inputs;     ///< only where there is no fault
  std::vector<std::string> faults;  ///< naming file or option, one line each, at most `kMostFaults`
  std::vector<std::string> notes;   ///< sentences for the user
  int filesRead = 0;
};

/// More faults than these are counted in a last line.
inline constexpr int kMostFaults = 40;

/// Finds the files of all sequences and decodes each of them. Painting lists what headers tell, and
/// stops at the first file that cannot be decoded; this goes on and lists all.
/// @param options  validated.
/// @param beforeFile  called before each file; may throw to stop.
[[nodiscard]] CheckedInputs checkInputs(const Options& options,
                                        const std::function<void()>& beforeFile);

}  // namespace fluidymation
