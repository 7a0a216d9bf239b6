#include <string>

#include "cli/table_builder.h"

namespace fluidymation::cli {
namespace {

constexpr const char* kFromAFile = "Options from a file";

}  // namespace

void addConfig(Table& table) {
  table.add(
      {"--config", kFromAFile, "FILE",
       "read options from lines such as border-width = 12, or from the\nmanifest of a run, "
       "fluidymation.json, to paint it once more;\nwhat else is given prevails\n(default off)",
       false, [](CommandLine& line, const std::string& value) {
         if (value.empty()) {
           throw UsageError(shown("--config", value) + ": wanted a file's name");
         }
         line.configFile = value;
       }});
  table.add({"--print-config", kFromAFile, "",
             "paint nothing; print all options as they are now, as such a\nfile\n(default off)",
             false, [](CommandLine& line, const std::string&) { line.printsConfig = true; }});
}

}  // namespace fluidymation::cli
