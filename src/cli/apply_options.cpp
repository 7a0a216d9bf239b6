#include "cli/apply_options.h"

#include "cli/values.h"
#include "fluidymation/core/error.h"

namespace fluidymation::cli {
namespace {

/// An option with the value that a file has for it.
void applyEntry(const Spec& spec, const std::string& value, CommandLine& line) {
  if (!spec.valueName.empty()) return spec.apply(line, value);
  if (value != "true" && value != "false") {
    throw UsageError(shown(spec.name, value) + ": wanted true or false");
  }
  if (value == "true") spec.apply(line, "");
}

}  // namespace

Names applyEntries(const std::vector<ConfigEntry>& entries, const std::vector<Spec>& table,
                   CommandLine& line) {
  Names names;
  for (const Spec& spec : table) {
    for (const ConfigEntry& entry : entries) {
      if (entry.option != spec.name) continue;
      names.insert(entry.option);
      try {
        applyEntry(spec, entry.value, line);
      } catch (const UsageError& error) {
        throw UsageError(entry.place + ": " + error.what());
      }
    }
  }
  requireOneChoice(names);
  return names;
}

void requireOptions(const std::vector<Spec>& table, const Names& given) {
  std::string missing;
  for (const Spec& spec : table) {
    if (!spec.required || given.count(spec.name) > 0) continue;
    missing += (missing.empty() ? "" : ", ") + spec.name;
  }
  if (!missing.empty()) throw UsageError(missing + ": required, but not given (see --help)");
}

void requireOneChoice(const Names& given) {
  for (const std::string prefix : {"--src", "--target"}) {
    if (given.count(prefix + "-range") == 0) continue;
    for (const char* other : {"-start", "-frames", "-speed"}) {
      if (given.count(prefix + other) == 0) continue;
      std::string message = prefix;
      message += "-range, ";
      message += prefix;
      message += other;
      throw UsageError(message + ": wanted one of them at most");
    }
  }
}

}  // namespace fluidymation::cli
