#include "cli/command_line.h"

#include <omp.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <cstring>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "cli/apply_options.h"
#include "cli/command_syntax.h"
#include "cli/config_file.h"
#include "cli/input_folders.h"
#include "cli/nearest.h"
#include "cli/option_table.h"
#include "cli/values.h"
#include "fluidymation/core/error.h"
#include "fluidymation/core/version.h"
#include "fluidymation/option_ranges.h"

namespace fluidymation::cli {
namespace {

constexpr const char* kHelp = "--help";
constexpr const char* kShortHelp = "-h";
constexpr const char* kVersion = "--version";

/// "--flow-weight" for "--flow", "--src-path, --src-mask-path, ..." for "--src"; else empty.
[[nodiscard]] std::string optionsBeginningWith(const std::string& name,
                                               const std::vector<Spec>& table) {
  constexpr std::size_t kShortestName = 3;  // two hyphens begin all of them
  std::string names;
  for (const Spec& spec : table) {
    if (name.size() < kShortestName || spec.name.compare(0, name.size(), name) != 0) continue;
    names += (names.empty() ? "" : ", ") + spec.name;
  }
  return names;
}

[[nodiscard]] std::vector<std::string> namesOf(const std::vector<Spec>& table) {
  std::vector<std::string> names;
  names.reserve(table.size());
  for (const Spec& spec : table) names.push_back(spec.name);
  return names;
}

[[noreturn]] void refuseArgument(const std::string& argument, const std::vector<Spec>& table) {
  if (argument.empty() || argument[0] != '-') {
    throw UsageError(shown("argument", argument) +
                     ": belongs to no option; wanted --option value (see --help)");
  }
  const std::string name = argument.substr(0, argument.find('='));
  std::string likely = optionsBeginningWith(name, table);
  if (likely.empty()) likely = nearest(name, namesOf(table));
  throw UsageError(shown("option", name) + ": there is no such option" +
                   (likely.empty() ? "; see --help" : "; did you mean " + likely + "?"));
}

/// Of what belongs to no option, the argument that the command takes; nothing where it takes none.
/// @throws UsageError for all others, and where it is missing.
[[nodiscard]] std::optional<std::string> operandAmong(const std::vector<std::string>& extras,
                                                      const CommandSyntax& syntax) {
  const bool takesOne = !syntax.operand.empty();
  for (const std::string& extra : extras) {
    const bool isOption = extra.empty() || extra[0] == '-';
    if (!takesOne || isOption) refuseArgument(extra, syntax.table);
  }
  if (extras.size() > 1) refuseArgument(extras[1], syntax.table);
  if (!extras.empty()) return extras.front();
  if (!takesOne) return std::nullopt;
  throw UsageError(syntax.operand + ": the file is missing (see --help)");
}

[[nodiscard]] bool isFlag(const std::string& name, const std::vector<Spec>& table) {
  if (name == kHelp || name == kShortHelp || name == kVersion) return true;
  return std::any_of(table.begin(), table.end(),
                     [&](const Spec& spec) { return spec.name == name && spec.valueName.empty(); });
}

/// What CLI11 would let pass: it takes "--seed= 5" for "--seed 5", which to us is an option without
/// a value, and lets flags be set by "--quiet=true".
/// @return  names of the options that are given as "--option=value".
Names checkAssignments(int argc, const char* const* argv, const std::vector<Spec>& table) {
  Names assigned;
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    const std::size_t equals = argument.find('=');
    if (argument.compare(0, 1, "-") != 0 || equals == std::string::npos) continue;
    const std::string name = argument.substr(0, equals);
    const std::string value = argument.substr(equals + 1);
    if (isFlag(name, table)) throw UsageError(shown(name, value) + ": takes no value");
    if (value.empty()) throw UsageError(shown(name, "") + ": wanted --option=value");
    assigned.insert(name);
  }
  return assigned;
}

/// The values given for `spec`, checked for number and for a forgotten value.
/// @param assigned  whether as "--option=value": then nothing was forgotten, however it looks.
void applyOption(const Spec& spec, const std::vector<std::string>& values, bool assigned,
                 CommandLine& line) {
  if (values.size() > 1) {
    throw UsageError(spec.name + ": given " + std::to_string(values.size()) +
                     " times; wanted once");
  }
  const std::string& value = values.front();
  if (!spec.valueName.empty() && !assigned && value.compare(0, 2, "--") == 0) {
    throw UsageError(spec.name + ": the value is missing (" + shown("option", value) +
                     " follows at once)");
  }
  spec.apply(line, value);
}

[[nodiscard]] const Spec& specOf(const std::string& name, const std::vector<Spec>& table) {
  return *std::find_if(table.begin(), table.end(),
                       [&](const Spec& spec) { return spec.name == name; });
}

/// --verify wants nothing but its manifest.
void refuseOthers(const std::string& alone, const std::vector<Spec>& table, const CLI::App& app) {
  for (const Spec& spec : table) {
    if (spec.name == alone || app.get_option(spec.name)->count() == 0) continue;
    std::string message = alone;
    message += ", " + spec.name + ": wanted ";
    throw UsageError(message + alone + " alone");
  }
}

/// The options of a config file. @return  their names.
Names applyConfig(const std::string& path, const std::vector<Spec>& table, CommandLine& line) {
  Config config = readConfig(path, table);
  Names names = applyEntries(config.entries, table, line);
  if (!config.note.empty()) line.notes.push_back(std::move(config.note));
  return names;
}

[[nodiscard]] int firstNumber(const char* text) {
  if (text == nullptr) return 0;
  int value = 0;
  const char* const end = text + std::strlen(text);
  const auto [stop, failure] = std::from_chars(text, end, value);
  const bool complete = stop == end || *stop == ',';  // OMP_NUM_THREADS=4,2: one number per nesting
  return failure == std::errc{} && complete && ranges::kThreads.contains(value) ? value : 0;
}

/// What the command is and how it is called, then its options.
void describe(CLI::App& app, const CommandSyntax& syntax) {
  constexpr std::size_t kHelpColumn = 36;
  app.description(syntax.description);
  app.get_formatter()->column_width(kHelpColumn);
  for (const Spec& spec : syntax.table) {
    CLI::Option* option = spec.valueName.empty()
                              ? app.add_flag(spec.name, spec.help)
                              : app.add_option(spec.name, CLI::callback_t{}, spec.help);
    option->group(spec.group);
    if (!spec.valueName.empty()) option->option_text(spec.valueName);
    option->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  }
  // CLI11 lists groups in the order of their first option, so its own flags come last.
  app.set_help_flag(std::string(kShortHelp) + "," + kHelp, "print this text")->group(kRunningGroup);
  app.add_flag(kVersion, "print the version")->group(kRunningGroup);
  app.allow_extras();  // so that the complaint is ours
}

/// CLI11 leaves two blank lines between groups.
[[nodiscard]] std::string withSingleBlankLines(std::string text) {
  for (std::size_t at = text.find("\n\n\n"); at != std::string::npos;) {
    text.erase(at, 1);
    at = text.find("\n\n\n", at);
  }
  return text;
}

}  // namespace

int defaultThreads(const char* ompNumThreads, const char* slurmCpusPerTask, int processors) {
  if (const int threads = firstNumber(ompNumThreads)) return threads;
  if (const int threads = firstNumber(slurmCpusPerTask)) return threads;
  return std::clamp(processors, static_cast<int>(ranges::kThreads.low),
                    static_cast<int>(ranges::kThreads.high));
}

CommandLine parseCommandLine(const CommandSyntax& syntax, int argc, const char* const* argv) {
  const std::vector<Spec>& table = syntax.table;
  CLI::App app("", syntax.name + (syntax.operand.empty() ? "" : " " + syntax.operand));
  describe(app, syntax);
  CommandLine line;
  Names assigned;
  try {
    assigned = checkAssignments(argc, argv, table);
    std::vector<std::string> arguments(argv + std::min(argc, 1), argv + argc);
    std::reverse(arguments.begin(), arguments.end());  // CLI11 takes them from the back
    app.parse(std::move(arguments));
  } catch (const CLI::CallForHelp&) {
    line.information = withSingleBlankLines(app.help());
    return line;
  } catch (const CLI::ArgumentMismatch& error) {
    const std::string message = error.what();  // begins with the option's name
    throw UsageError(message.substr(0, message.find(':')) + ": the value is missing (see --help)");
  } catch (const CLI::ParseError& error) {
    throw UsageError(oneLine(error.what()) + " (see --help)");
  }
  if (app.count(kVersion) > 0) {
    line.information = "fluidymation " + version() + "\n";
    return line;
  }
  // NOLINTBEGIN(concurrency-mt-unsafe): no other thread runs yet
  line.options.threads = defaultThreads(std::getenv("OMP_NUM_THREADS"),
                                        std::getenv("SLURM_CPUS_PER_TASK"), omp_get_num_procs());
  // NOLINTEND(concurrency-mt-unsafe)
  Names given;
  std::vector<std::string> files;
  if (const CLI::Option* const config = app.get_option_no_throw("--config")) {
    files = config->results();
  }
  if (files.size() == 1) {  // else it is refused below
    applyOption(specOf("--config", table), files, assigned.count("--config") > 0, line);
    given = applyConfig(*line.configFile, table, line);
    line.preview.configFile = line.configFile;
  }
  Names givenHere;
  for (const Spec& spec : table) {
    const std::vector<std::string> values = app.get_option(spec.name)->results();
    if (values.empty()) continue;
    applyOption(spec, values, assigned.count(spec.name) > 0, line);
    givenHere.insert(spec.name);
  }
  requireOneChoice(givenHere);
  given.insert(givenHere.begin(), givenHere.end());
  // After the values: what a forgotten value pushed aside is not the user's mistake.
  const std::vector<std::string> extras = app.remaining();
  line.operand = operandAmong(extras, syntax);
  if (line.manifest) {
    refuseOthers("--verify", table, app);
    return line;
  }
  if (!line.printsConfig) requireOptions(table, given);
  resolveFolders(given, line.options);
  if (line.printsConfig) line.information = configText(table, line);
  return line;
}

}  // namespace fluidymation::cli
