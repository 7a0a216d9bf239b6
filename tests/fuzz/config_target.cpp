// Any file as a config file, and the options that it gives.
#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "cli/command_line.h"
#include "cli/config_file.h"
#include "cli/painter_syntax.h"
#include "cli/values.h"
#include "fluidymation/core/error.h"
#include "fuzz_target.h"

namespace fluidymation::fuzz {
namespace {

/// What a file gives is an option of the table, and may stand in a file.
void checkEntries(const cli::Config& config, const std::vector<cli::Spec>& table) {
  for (const cli::ConfigEntry& entry : config.entries) {
    const auto spec = std::find_if(table.begin(), table.end(), [&](const cli::Spec& candidate) {
      return candidate.name == entry.option;
    });
    require(spec != table.end() && spec->text, "an option of a file is one for files");
  }
}

}  // namespace
}  // namespace fluidymation::fuzz

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t byteCount) {
  using namespace fluidymation;
  const fuzz::MemoryFile file(data, byteCount);
  static const cli::CommandSyntax syntax = cli::painterSyntax();
  try {
    fuzz::checkEntries(cli::readConfig(file.path(), syntax.table), syntax.table);
  } catch (const Error& error) {
    fuzz::requireNaming(error.what(), file.path());
  }
  const char* const argv[] = {
      "fluidymation",      "--src-path", "s/%d",       "--src-mask-path", "m/%d",
      "--target-path",     "t/%d",       "--out-path", "o/%d.png",        "--config",
      file.path().c_str(), nullptr};
  constexpr int kArguments = 11;
  try {
    (void)cli::parseCommandLine(syntax, kArguments, argv);
  } catch (const Error& error) {
    fuzz::require(!cli::oneLine(error.what()).empty(), "a complaint says something");
  }
  return 0;
}
