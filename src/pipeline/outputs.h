#pragma once

#include <string>
#include <vector>

#include "checkpoint/run_files.h"
#include "fluidymation/options.h"
#include "pipeline/inputs.h"
#include "pipeline/protected_files.h"

namespace fluidymation {

/// The frames to be written: none may replace a file that is read, nor any other of the input
/// patterns, whether it exists or not; the same for the dump. Changes nothing on the disk.
/// @return  one path per target frame.
/// @throws UsageError naming the option and the file; Error naming a folder or file that can
///   foreseeably not be written.
[[nodiscard]] std::vector<std::string> checkOutput(const Options& options, const Inputs& inputs);

/// The same where more is to be protected than the run's own inputs.
[[nodiscard]] std::vector<std::string> checkOutput(const Options& options, const Inputs& inputs,
                                                   const ProtectedFiles& protectedFiles);

/// @throws UsageError where what a run keeps beside its frames, manifest and hidden folder, would
/// replace
///   an input.
void requireNoInputAmongRecords(const RunFiles& files, const ProtectedFiles& protectedFiles);

/// Creates the folders of the frames and of the dump, and makes sure that files can be written
/// there. @throws Error naming folder or file.
void createOutputFolders(const Options& options, const std::vector<std::string>& paths);

/// Where the guides of "source" or "target" are dumped; only with `--dump-guides`.
[[nodiscard]] std::string dumpFolder(const Options& options, const std::string& sequence);

}  // namespace fluidymation
