#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/input_folders.h"
#include "cli/nearest.h"
#include "cli/option_table.h"
#include "cli/values.h"
#include "fluidymation/core/error.h"
#include "fluidymation/core/text.h"
#include "fluidymation/option_ranges.h"

namespace fluidymation::cli {

/// A group of the help text that Table's patterns belong to.
inline constexpr const char* kFilesGroup = "Inputs and outputs";

/// Finds a field in a CommandLine, to read its default and to set it.
template <typename T>
using Field = T& (*)(CommandLine&);

template <typename T>
[[nodiscard]] T valueOf(Field<T> field, const CommandLine& line) {
  CommandLine copy = line;
  return field(copy);
}

template <typename T>
[[nodiscard]] T defaultOf(Field<T> field) {
  CommandLine defaults;
  return field(defaults);
}

[[nodiscard]] inline std::string facts(const std::string& defaultText, const std::string& unit,
                                       const std::string& range, const std::string& section) {
  return "\n(default " + defaultText + (unit.empty() ? "" : " " + unit) +
         (range.empty() ? "" : "; in " + range) + "; " + section + ")";
}

/// The words that an option takes, and what each stands for.
template <typename T>
using Words = std::vector<std::pair<std::string, T>>;

template <typename T>
[[nodiscard]] std::string wordFor(const Words<T>& words, T wanted) {
  for (const auto& [word, value] : words) {
    if (value == wanted) return word;
  }
  return {};
}

template <typename T>
[[nodiscard]] std::vector<std::string> namesOf(const Words<T>& words) {
  std::vector<std::string> names;
  for (const auto& [word, value] : words) names.push_back(word);
  return names;
}

template <typename T>
[[nodiscard]] T parseWord(const std::string& option, const std::string& text,
                          const Words<T>& words) {
  std::vector<std::string> names;
  for (const auto& [word, value] : words) {
    if (text == word) return value;
    names.push_back(word);
  }
  throw UsageError(shown(option, text) + ": " + wantedWord(text, names));
}

/// What a config file has for a flag.
[[nodiscard]] inline std::optional<std::string> flagText(bool on) { return on ? "true" : "false"; }

/// The table, built by one function a kind of value.
class Table {
 public:
  using Text = std::optional<std::string>;
  using PatternCheck = void (*)(const std::string& option, const std::string& pattern);

  void pattern(const char* name, const char* what, const char* section, Field<std::string> field,
               PatternCheck check = checkInputPath) {
    const std::string option = name;
    specs_.push_back({option, kFilesGroup, "PATTERN",
                      std::string(what) + "\n(required; " + section + ")", true,
                      [option, field, check](CommandLine& line, const std::string& value) {
                        check(option, value);
                        field(line) = value;
                      },
                      [field](const CommandLine& line) -> Text {
                        const std::string path = valueOf(field, line);
                        return path.empty() ? Text() : path;
                      }});
  }

  void optionalPattern(const char* name, const char* what, const char* section,
                       Field<std::optional<std::string>> field) {
    const std::string option = name;
    specs_.push_back({option, kFilesGroup, "PATTERN", what + facts("off", "", "", section), false,
                      [option, field](CommandLine& line, const std::string& value) {
                        if (value.empty()) {
                          throw UsageError(shown(option, value) + ": wanted a path with a number");
                        }
                        checkInputPath(option, value);
                        field(line) = value;
                      },
                      [field](const CommandLine& line) { return valueOf(field, line); }});
  }

  void integer(const char* name, const char* group, const char* what, const char* unit,
               const Range& range, const char* section, Field<int> field, bool zeroAllowed = true) {
    const std::string option = name;
    specs_.push_back(
        {option, group, "N",
         what + facts(std::to_string(defaultOf(field)), unit,
                      range.text() + (zeroAllowed ? "" : ", not 0"), section),
         false,
         [option, range, zeroAllowed, field](CommandLine& line, const std::string& value) {
           field(line) = parseInt(option, value, range, zeroAllowed);
         },
         [field](const CommandLine& line) { return Text(std::to_string(valueOf(field, line))); }});
  }

  void real(const char* name, const char* group, const char* what, const char* unit,
            const Range& range, const char* section, Field<float> field) {
    const std::string option = name;
    specs_.push_back(
        {option, group, "X",
         what + facts(numberText(defaultOf(field)), unit, range.text(), section), false,
         [option, range, field](CommandLine& line, const std::string& value) {
           field(line) = parseFloat(option, value, range);
         },
         [field](const CommandLine& line) { return Text(numberText(valueOf(field, line))); }});
  }

  void real(const char* name, const char* group, const char* what, const char* unit,
            const Range& range, const char* section, Field<double> field) {
    const std::string option = name;
    specs_.push_back(
        {option, group, "X",
         what + facts(numberText(defaultOf(field)), unit, range.text(), section), false,
         [option, range, field](CommandLine& line, const std::string& value) {
           field(line) = parseDouble(option, value, range);
         },
         [field](const CommandLine& line) { return Text(numberText(valueOf(field, line))); }});
  }

  void integers(const char* name, const char* group, const char* what, const Range& range,
                const char* section, Field<std::vector<int>> field) {
    const std::string option = name;
    specs_.push_back(
        {option, group, "N,N,...",
         what + facts(listText(defaultOf(field)), "",
                      range.text() + ", 1 to " + std::to_string(ranges::kLongestList) + " numbers",
                      section),
         false,
         [option, range, field](CommandLine& line, const std::string& value) {
           field(line) = parseIntList(option, value, range);
         },
         [field](const CommandLine& line) { return Text(listText(valueOf(field, line))); }});
  }

  /// A number in px of a field that is found from the inputs where it is not given, or "auto".
  void automatic(const char* name, const char* group, const char* what,
                 const std::string& automaticValue, const Range& range, const char* section,
                 Field<std::optional<float>> field) {
    const std::string option = name;
    specs_.push_back({option, group, "X",
                      std::string(what) + "\n(default " + automaticValue + ";\nin " + range.text() +
                          " px; " + section + ")",
                      false,
                      [option, range, field](CommandLine& line, const std::string& value) {
                        field(line) = parseAutomatic(option, value, range);
                      },
                      [field](const CommandLine& line) {
                        const std::optional<float> width = valueOf(field, line);
                        return Text(width ? numberText(*width) : kAutomaticWord);
                      }});
  }

  /// One of a few words.
  template <typename T>
  void word(const char* name, const char* group, const char* what, const Words<T>& words,
            const char* section, Field<T> field) {
    const std::string option = name;
    specs_.push_back({option, group, "NAME",
                      what + facts(wordFor(words, defaultOf(field)), "", "", section), false,
                      [option, words, field](CommandLine& line, const std::string& value) {
                        field(line) = parseWord(option, value, words);
                      },
                      [words, field](const CommandLine& line) {
                        return Text(wordFor(words, valueOf(field, line)));
                      },
                      namesOf(words)});
  }

  /// The option added last stands in a config file only where `applies`.
  void writtenOnlyWhere(bool (*applies)(const CommandLine&)) {
    auto& text = specs_.back().text;
    text = [applies, all = std::move(text)](const CommandLine& line) {
      return applies(line) ? all(line) : Text();
    };
  }

  void add(Spec spec) { specs_.push_back(std::move(spec)); }

  [[nodiscard]] std::vector<Spec> take() { return std::move(specs_); }

 private:
  std::vector<Spec> specs_;
};

// Groups that have a file of their own.
void addConfig(Table& table);
void addFiles(Table& table);
void addGoingOn(Table& table);
void addPreview(Table& table);
void addSequences(Table& table);

}  // namespace fluidymation::cli
