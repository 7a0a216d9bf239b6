#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fluidymation/options.h"
#include "fluidymation/pipeline.h"

namespace fluidymation {

/// What `inspect` has found.
struct Inspection {
  /// One line for each fault that keeps the run from being painted, naming file or option.
  std::vector<std::string> faults;
  std::vector<std::string> notes;   ///< what painting would remark, too
  std::vector<std::string> report;  ///< lines for people; as far as the faults let it be known
};

/// Looks at everything that a run with these options would read, and paints nothing.
/// @param given  as for `stylize`; `outPath` may be empty, and is checked where it is not.
/// @param guidesFolder  where pictures of the guides are written, if that is wanted.
/// @param observer  `cancelled` is asked before each file.
/// @throws UsageError for options that `validate` refuses, and where a picture would replace an
/// input; Error naming a picture that cannot be written; Interrupted.
[[nodiscard]] Inspection inspect(const Options& given,
                                 const std::optional<std::string>& guidesFolder,
                                 const Observer& observer);

}  // namespace fluidymation
