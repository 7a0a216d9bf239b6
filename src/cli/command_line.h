#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fluidymation/options.h"
#include "fluidymation/preview.h"

namespace fluidymation::cli {

/// Whom the progress of a run is told.
enum class ProgressFormat { kHuman, kJson, kOpenJobDescription };

/// What the user asked for.
struct CommandLine {
  Options options;
  ProgressFormat progress = ProgressFormat::kHuman;
  bool progressIsGiven = false;  ///< `progress`, be it the default's value
  PreviewOptions preview;
  std::string preset = "standard";  ///< the last one applied; the options hold what it set
  bool threadsAreGiven = false;     ///< or found from the machine
  bool quiet = false;
  std::optional<std::string> configFile;
  std::optional<std::string> operand;  ///< see `CommandSyntax::operand`
  bool printsConfig = false;
  std::vector<std::string> notes;          ///< on what was read so far, for the user
  std::optional<std::string> manifest;     ///< check the frames against it and do nothing else
  std::optional<std::string> information;  ///< help or version: print it and do nothing else
};

struct CommandSyntax;

/// Reads the arguments of a command (argv[0] is its name). Every option appears at most once, as
/// "--option value" or "--option=value"; only with '=' may a value begin with "--". Flags take no
/// value. Options of a config file are applied before those of the command line. Folders are looked
/// into and come back as patterns.
/// @throws UsageError with one line that names the option (and the file and its line), what was
/// found and what is wanted; Error where the config file or a folder cannot be read.
[[nodiscard]] CommandLine parseCommandLine(const CommandSyntax& syntax, int argc,
                                           const char* const* argv);

/// Threads when --threads is not given: OMP_NUM_THREADS (its first number), else
/// SLURM_CPUS_PER_TASK, else `processors`. A variable that is missing (null) or no number in
/// [1, 1024] is passed over.
[[nodiscard]] int defaultThreads(const char* ompNumThreads, const char* slurmCpusPerTask,
                                 int processors);

}  // namespace fluidymation::cli
