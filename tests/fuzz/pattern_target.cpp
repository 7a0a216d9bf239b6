// Any text as a pattern of frames' names.
#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <string>

#include "fluidymation/core/error.h"
#include "fluidymation/io/frame_pattern.h"
#include "fluidymation/option_ranges.h"
#include "fuzz_target.h"

namespace fluidymation::fuzz {
namespace {

[[nodiscard]] std::string nameIn(const std::string& path) {
  return path.substr(path.rfind('/') + 1);  // all of it where there is no slash
}

void check(const FramePattern& pattern, int number) {
  const std::string path = pattern.path(number);
  require(path.find('\0') == std::string::npos, "a path holds no zero byte");
  const std::string name = nameIn(path);
  require(pattern.numberOf(name) == number, "a frame's name gives its number");
  const auto [head, tail] = pattern.nameParts();
  require(name.size() > head.size() + tail.size() && name.compare(0, head.size(), head) == 0 &&
              name.compare(name.size() - tail.size(), tail.size(), tail) == 0,
          "a name begins and ends as the pattern does");
}

}  // namespace
}  // namespace fluidymation::fuzz

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t byteCount) {
  using namespace fluidymation;
  const std::string text(data, data + byteCount);
  constexpr std::array<int, 6> kNumbers = {
      0, 7, -1, 100'000, std::numeric_limits<int>::max(), std::numeric_limits<int>::min()};
  try {
    const FramePattern pattern(text);
    fuzz::require(pattern.text() == text, "a pattern keeps its text");
    fuzz::require(!pattern.folder().empty(), "a folder has a name");
    for (const int number : kNumbers) fuzz::check(pattern, number);
    (void)pattern.numberOf(text);
  } catch (const UsageError& error) {
    const std::string message = error.what();
    fuzz::require(
        std::none_of(message.begin(), message.end(), [](char c) { return c >= 0 && c < ' '; }),
        "a complaint is one line");
  }
  try {
    checkOutputPattern("--out-path", text);
    (void)FramePattern(text);  // throws nothing any more
  } catch (const UsageError& error) {
    fuzz::requireNaming(error.what(), "--out-path");
  }
  return 0;
}
