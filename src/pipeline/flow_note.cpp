#include "pipeline/flow_note.h"

#include "fluidymation/option_ranges.h"

namespace fluidymation {

std::optional<std::string> flowNote(const std::string& option, int frameNumber,
                                    const SolveReport& report) {
  if (report.converged) return std::nullopt;
  return option + ": frame " + std::to_string(frameNumber) +
         ": the motion inside the shape, or its direction, still changed by " +
         numberText(report.lastChange) + " after " + std::to_string(report.cycles) +
         " cycles; it is painted as it stands";
}

}  // namespace fluidymation
