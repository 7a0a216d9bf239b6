#pragma once

#include <string>

namespace fluidymation::cli {

/// The command that goes on where this one (the arguments of `main`) was stopped, to be pasted into
/// a POSIX shell: with --resume, and without --restart.
[[nodiscard]] std::string resumeCommand(int argc, const char* const* argv);

}  // namespace fluidymation::cli
