#pragma once

#include <string>
#include <vector>

#include "inspect/expectations.h"
#include "inspect/time_estimate.h"
#include "pipeline/inputs.h"

namespace fluidymation {

/// What the report says besides the expectations.
struct ReportFacts {
  int filesRead = 0;
  std::string chosenWidths;  ///< `chosenWidths`
  std::int64_t mostBytes = 0;
  std::int64_t limitBytes = 0;
  TimeEstimate time;
  int threads = 1;
  bool drawsLines = false;
};

/// Lines for people.
[[nodiscard]] std::vector<std::string> reportLines(const Inputs& inputs, const KnownRun& run,
                                                   const ReportFacts& facts);

}  // namespace fluidymation
