// Any list of arguments, each ended by a zero byte as in /proc/PID/cmdline, as a command line.
#include <cstdint>
#include <string>
#include <vector>

#include "cli/command_line.h"
#include "cli/painter_syntax.h"
#include "cli/resume_command.h"
#include "cli/values.h"
#include "fluidymation/core/error.h"
#include "fluidymation/option_ranges.h"
#include "fuzz_target.h"

namespace fluidymation::fuzz {
namespace {

[[nodiscard]] std::vector<std::string> argumentsIn(const std::uint8_t* data,
                                                   std::size_t byteCount) {
  std::vector<std::string> arguments = {"fluidymation"};
  std::string argument;
  for (std::size_t i = 0; i < byteCount; ++i) {
    if (data[i] != 0) {
      argument += static_cast<char>(data[i]);
      continue;
    }
    arguments.push_back(argument);
    argument.clear();
  }
  if (!argument.empty()) arguments.push_back(argument);
  return arguments;
}

/// What was parsed is what the engine accepts, but for contradictions between options.
void checkParsed(const cli::CommandLine& line) {
  if (line.information || line.manifest) return;
  try {
    validate(line.options);
  } catch (const UsageError& error) {
    require(std::string(error.what()).compare(0, 2, "--") == 0, "a complaint names the option");
  }
}

}  // namespace
}  // namespace fluidymation::fuzz

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t byteCount) {
  using namespace fluidymation;
  const std::vector<std::string> arguments = fuzz::argumentsIn(data, byteCount);
  std::vector<const char*> argv;
  for (const std::string& argument : arguments) argv.push_back(argument.c_str());
  const int argc = static_cast<int>(argv.size());
  argv.push_back(nullptr);
  try {
    fuzz::checkParsed(cli::parseCommandLine(cli::painterSyntax(), argc, argv.data()));
    (void)cli::resumeCommand(argc, argv.data());
  } catch (const UsageError& error) {
    fuzz::require(!cli::oneLine(error.what()).empty(), "a complaint says something");
  }
  return 0;
}
