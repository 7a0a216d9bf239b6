#pragma once

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace fluidymation {

/// A fault of the input, the options or the disk. The text is one line that says which file or
/// option, what was found and what was wanted. A broken promise of our own code is an assert.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Several faults found together; the text of each is one line.
class Faults : public Error {
 public:
  /// @param lines  at least one.
  explicit Faults(std::vector<std::string> lines)
      : Error(joined(lines)), lines_(std::move(lines)) {}

  [[nodiscard]] const std::vector<std::string>& lines() const { return lines_; }

 private:
  static std::string joined(const std::vector<std::string>& lines) {
    std::string text;
    for (const std::string& line : lines) text += (text.empty() ? "" : "; ") + line;
    return text;
  }

  std::vector<std::string> lines_;
};

/// A contradiction or a value out of range among the options: the call itself is wrong, no file is.
class UsageError : public Error {
 public:
  using Error::Error;
};

/// The caller asked the work to stop. No fault, hence no Error; the text says how far it came.
class Interrupted : public std::runtime_error {
 public:
  /// @param canResume  whether a state is there that `--resume` goes on from.
  explicit Interrupted(const std::string& text, bool canResume = false)
      : std::runtime_error(text), canResume_(canResume) {}

  [[nodiscard]] bool canResume() const { return canResume_; }

 private:
  bool canResume_;
};

}  // namespace fluidymation
