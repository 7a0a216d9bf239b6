#include "fluidymation/inspect.h"

#include <string>

#include "fluidymation/core/error.h"
#include "fluidymation/option_ranges.h"
#include "inspect/input_check.h"

namespace fluidymation {

Inspection inspect(const Options& options, const Observer& observer) {
  Options valid = options;
  if (valid.outPath.empty()) valid.outPath = "%d.png";  // no frame is written, any name will do
  validate(valid);

  int files = 0;
  const auto stopIfWanted = [&] {
    if (observer.cancelled && observer.cancelled()) {
      throw Interrupted("interrupted; " + std::to_string(files) + " files looked at");
    }
    ++files;
  };
  Inspection found;
  CheckedInputs checked = checkInputs(options, stopIfWanted);
  found.faults = std::move(checked.faults);
  found.notes = std::move(checked.notes);
  if (found.faults.empty()) {
    found.report.push_back("files: all " + std::to_string(checked.filesRead) + " can be read");
  }
  return found;
}

}  // namespace fluidymation
