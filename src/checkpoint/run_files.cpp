#include "checkpoint/run_files.h"

#include <filesystem>
#include <system_error>

namespace fluidymation {
namespace {

namespace fs = std::filesystem;

constexpr const char* kHiddenFolder = ".fluidymation";
constexpr const char* kManifest = "fluidymation.json";
constexpr const char* kTimes = "times.json";
constexpr const char* kLock = "lock";
constexpr const char* kReplaceableFrames = "replaceable.txt";
constexpr const char* kState = "state-%d.bin";

/// What a frame's name has round its number, less the ending: "rim_" of "out/rim_%05d.png".
[[nodiscard]] std::string stemOf(const FramePattern& frames) {
  const auto [head, tail] = frames.nameParts();
  return head + tail.substr(0, tail.rfind('.'));
}

/// In a pattern a percent sign is two.
[[nodiscard]] std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) result += c == '%' ? std::string("%%") : std::string(1, c);
  return result;
}

}  // namespace

RunFiles::RunFiles(const FramePattern& frames)
    : frames_(frames),
      folder_(frames.folder()),
      hidden_((fs::path(folder_) / kHiddenFolder).string()),
      stem_(stemOf(frames)) {}

std::string RunFiles::manifest() const {
  return (fs::path(folder_) / (stem_ + kManifest)).string();
}
std::string RunFiles::times() const { return (fs::path(hidden_) / (stem_ + kTimes)).string(); }
std::string RunFiles::lock() const { return (fs::path(hidden_) / (stem_ + kLock)).string(); }
std::string RunFiles::replaceableFrames() const {
  return (fs::path(hidden_) / (stem_ + kReplaceableFrames)).string();
}

std::string RunFiles::state(int number) const {
  return (fs::path(hidden_) / FramePattern(escaped(stem_) + kState).path(number)).string();
}

std::map<int, std::string> RunFiles::states() const {
  const FramePattern pattern(escaped(stem_) + kState);
  std::map<int, std::string> states;
  std::error_code failure;
  fs::directory_iterator entry(hidden_, failure);
  for (; !failure && entry != fs::directory_iterator(); entry.increment(failure)) {
    const std::optional<int> number = pattern.numberOf(entry->path().filename().string());
    if (number) states[*number] = entry->path().string();
  }
  return states;
}

bool RunFiles::isFrameOrManifest(const std::string& name) const {
  return frames_.numberOf(name).has_value() || name == stem_ + kManifest;
}

bool RunFiles::isHidden(const std::string& name) const {
  return name == stem_ + kTimes || name == stem_ + kReplaceableFrames ||
         FramePattern(escaped(stem_) + kState).numberOf(name).has_value();
}

}  // namespace fluidymation
