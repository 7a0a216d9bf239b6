#include "checkpoint/replaceable_frames.h"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <optional>
#include <string_view>
#include <system_error>

#include "checkpoint/checkpoint_file.h"
#include "checkpoint/fingerprint.h"
#include "fluidymation/core/error.h"

namespace fluidymation {
namespace {

constexpr std::int64_t kLineBytes = 12 + 32 + 1;  // a number and a space, a digest, a line's end
/// What the manifest knew, what a stopped run was writing, and what a restarted one found.
constexpr std::int64_t kMostLines = 3;  // of a frame
constexpr std::int64_t kMostBytes =
    kLineBytes * kMostLines * static_cast<std::int64_t>(kMostFrames);

/// @param line  without its end.
void addLine(std::string_view line, FrameDigests& frames) {
  int number = 0;
  const auto [end, failure] = std::from_chars(line.data(), line.data() + line.size(), number);
  const auto length = static_cast<std::size_t>(end - line.data());
  if (failure != std::errc() || length >= line.size() || line[length] != ' ') return;
  const std::optional<Digest> digest = Digest::parse(std::string(line.substr(length + 1)));
  if (digest) add(number, *digest, frames);
}

}  // namespace

bool holds(const FrameDigests& frames, int number, const Digest& digest) {
  const auto found = frames.find(number);
  return found != frames.end() &&
         std::find(found->second.begin(), found->second.end(), digest) != found->second.end();
}

void add(int number, const Digest& digest, FrameDigests& frames) {
  if (!holds(frames, number, digest)) frames[number].push_back(digest);
}

std::string lineOf(int number, const Digest& digest) {
  return std::to_string(number) + " " + digest.text() + "\n";
}

std::vector<std::uint8_t> encode(const FrameDigests& frames) {
  std::string text;
  for (const auto& [number, digests] : frames) {
    for (const Digest& digest : digests) text += lineOf(number, digest);
  }
  return {text.begin(), text.end()};
}

FrameDigests readReplaceableFrames(const std::string& path) {
  FrameDigests frames;
  std::vector<std::uint8_t> file;
  try {
    file = readWhole(path, kMostBytes, "a list of frames of fluidymation");
  } catch (const Error&) {
    return frames;
  }
  const std::string_view text(reinterpret_cast<const char*>(file.data()), file.size());
  std::size_t begin = 0;
  for (std::size_t end = text.find('\n'); end != std::string_view::npos;
       end = text.find('\n', begin)) {
    addLine(text.substr(begin, end - begin), frames);
    begin = end + 1;
  }
  return frames;
}

}  // namespace fluidymation
