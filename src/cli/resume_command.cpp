#include "cli/resume_command.h"

#include <algorithm>
#include <cstring>

namespace fluidymation::cli {
namespace {

/// The word as it is where no shell finds anything in it, else in single quotes.
[[nodiscard]] std::string quoted(const std::string& word) {
  constexpr const char* kPlain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789%+,-./:=@_";
  if (!word.empty() && word.find_first_not_of(kPlain) == std::string::npos) return word;
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + "'";
}

}  // namespace

std::string resumeCommand(int argc, const char* const* argv) {
  std::string command;
  bool resumes = false;  // or goes on without
  for (int i = 0; i < argc; ++i) {
    if (i > 0 && std::strcmp(argv[i], "--restart") == 0) continue;
    resumes = resumes || std::strcmp(argv[i], "--resume") == 0 ||
              std::strcmp(argv[i], "--skip-existing") == 0;
    command += (i == 0 ? "" : " ") + quoted(argv[i]);
  }
  return command + (resumes ? "" : " --resume");
}

}  // namespace fluidymation::cli
