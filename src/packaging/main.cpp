// Writes the documents that are made from the option table: run by the build, not installed.

#include <exception>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>

#include "fluidymation/core/error.h"
#include "packaging/completion.h"
#include "packaging/man_page.h"
#include "packaging/option_list.h"

namespace {

using fluidymation::Error;
namespace packaging = fluidymation::packaging;

constexpr const char* kOptionsLine = "OPTIONS_OF_THE_TABLE\n";

void write(const std::string& path, const std::string& text) {
  std::ofstream file(path, std::ios::binary);
  file << text << std::flush;
  if (!file.good()) throw Error(path + ": cannot be written");
}

/// The hand-written page with the options in their place.
[[nodiscard]] std::string manPage(const std::string& templatePath, const std::string& options) {
  std::ifstream file(templatePath, std::ios::binary);
  std::string page{std::istreambuf_iterator<char>(file), {}};
  const std::size_t place = page.find(kOptionsLine);
  if (!file.good() || place == std::string::npos) {
    throw Error(templatePath + ": cannot be read, or has no line OPTIONS_OF_THE_TABLE");
  }
  return page.replace(place, std::string(kOptionsLine).size(), options);
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
    write(argv[2], manPage(argv[1], packaging::manPageOptions(options)));
    write(argv[3], packaging::bashCompletion(options));
    write(argv[4], packaging::zshCompletion(options));
  } catch (const std::exception& error) {
    std::cerr << error.what() << "\n";
    return 1;
  }
  return 0;
}
