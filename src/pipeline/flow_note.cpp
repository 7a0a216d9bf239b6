#include "pipeline/flow_note.h"

#include "fluidymation/option_ranges.h"

namespace fluidymation {

std::optional<std::string> flowNote(const std::string& option, int frameNumber,
                                    const SolveReport& report) {
  if (report.converged) return std::nullopt;
  return option + ": frame " + std::to_string(frameNumber) +
         ": the motion inside the shape still changed by " + numberText(report.lastChange) +
         " px per frame after " + std::to_string(report.cycles) +
         " cycles; it is painted as it stands";
}

}  // namespace fluidymation
