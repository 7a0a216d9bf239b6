// Writes the documents that are made from the option table: run by the build, not installed.

#include <exception>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>

#include "cli/subcommand.h"
#include "fluidymation/core/error.h"
#include "packaging/completion.h"
#include "packaging/man_page.h"
#include "packaging/option_list.h"

namespace {

using fluidymation::Error;
namespace cli = fluidymation::cli;
namespace packaging = fluidymation::packaging;

constexpr const char* kOptionsLine = "OPTIONS_OF_THE_TABLE\n";
constexpr const char* kCommandsLine = "COMMANDS_OF_THE_TOOL\n";

void write(const std::string& path, const std::string& text) {
  std::ofstream file(path, std::ios::binary);
  file << text << std::flush;
  if (!file.good()) throw Error(path + ": cannot be written");
}

/// @throws Error where the page has no such line.
void replaceLine(const std::string& line, const std::string& text, const std::string& path,
                 std::string& page) {
  const std::size_t place = page.find(line);
  if (place == std::string::npos)
    throw Error(path + ": has no line " + line.substr(0, line.size() - 1));
  page.replace(place, line.size(), text);
}

/// The hand-written page with commands and options in their places.
[[nodiscard]] std::string manPage(const std::string& templatePath, const std::string& commands,
                                  const std::string& options) {
  std::ifstream file(templatePath, std::ios::binary);
  std::string page{std::istreambuf_iterator<char>(file), {}};
  if (!file.good()) throw Error(templatePath + ": cannot be read");
  replaceLine(kCommandsLine, commands, templatePath, page);
  replaceLine(kOptionsLine, options, templatePath, page);
  return page;
}

}  // namespace

int main(int argc, char** argv) {
  constexpr int kArguments = 5;
  if (argc != kArguments) {
    std::cerr << "wanted: MAN_TEMPLATE MAN_PAGE BASH_COMPLETION ZSH_COMPLETION\n";
    return 2;
  }
  try {
    const auto options = packaging::allOptions();
    write(argv[2], manPage(argv[1], packaging::manPageCommands(cli::subcommands()),
                           packaging::manPageOptions(options)));
    write(argv[3], packaging::bashCompletion(options, packaging::allCommands()));
    write(argv[4], packaging::zshCompletion(options, packaging::allCommands()));
  } catch (const std::exception& error) {
    std::cerr << error.what() << "\n";
    return 1;
  }
  return 0;
}
