#pragma once

#include <optional>
#include <string>

#include "fluidymation/options.h"
#include "fluidymation/preview.h"

namespace fluidymation::cli {

/// Whom the progress of a run is told.
enum class ProgressFormat { kHuman, kJson, kOpenJobDescription };

/// What the user asked for.
struct CommandLine {
  Options options;
  ProgressFormat progress = ProgressFormat::kHuman;
  PreviewOptions preview;
  bool quiet = false;
  std::optional<std::string> manifest;     ///< check the frames against it and do nothing else
  std::optional<std::string> information;  ///< help or version: print it and do nothing else
};

struct CommandSyntax;

/// Reads the arguments of a command (argv[0] is its name). Every option appears at most once, as
/// "--option value" or "--option=value"; only with '=' may a value begin with "--". Flags take no
/// value.
/// @throws UsageError with one line that names the option, what was found and what is wanted.
[[nodiscard]] CommandLine parseCommandLine(const CommandSyntax& syntax, int argc,
                                           const char* const* argv);

/// Threads when --threads is not given: OMP_NUM_THREADS (its first number), else
/// SLURM_CPUS_PER_TASK, else `processors`. A variable that is missing (null) or no number in
/// [1, 1024] is passed over.
[[nodiscard]] int defaultThreads(const char* ompNumThreads, const char* slurmCpusPerTask,
                                 int processors);

}  // namespace fluidymation::cli
