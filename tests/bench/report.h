#pragma once

#include <iosfwd>
#include <optional>

#include "bench/machine.h"
#include "bench/measure.h"

namespace fluidymation::bench {

enum class Format {
  kTable,  ///< aligned columns
  kTsv,    ///< facts as lines "# name<TAB>value", then a header line and rows
};

/// Facts of the case, to be printed below those of the machine.
[[nodiscard]] Facts factsOfCase(const BenchmarkCase& benchmarkCase, const LoadedCase& loaded,
                                const Measurement& measurement);

void printFacts(std::ostream& out, const Facts& facts, Format format);

/// A row a stage and level: by the clock in milliseconds, by processor time in microseconds x cores
/// per pixel, and what a search did. Pixels are those inside the full-resolution mask on all
/// levels.
/// @param only  where given, the rows of this stage alone.
void printCosts(std::ostream& out, const std::string& caseName, const Measurement& measurement,
                std::optional<TimedStage> only, Format format);

}  // namespace fluidymation::bench
