#include "cli/input_folders.h"

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <system_error>
#include <vector>

#include "cli/values.h"
#include "fluidymation/core/error.h"
#include "fluidymation/io/frame_folder.h"
#include "fluidymation/option_ranges.h"

namespace fluidymation::cli {
namespace {

/// What flow is read from.
const std::vector<std::string> kFlowEndings = {".flo", ".png"};
const std::vector<std::string> kPictureEndings = {".png"};

[[nodiscard]] bool isFolder(const std::string& path) {
  std::error_code ignored;
  return std::filesystem::is_directory(path, ignored);
}

/// Whether a name ends as files do, .png for instance, and not with a version, as in shot.v2 and
/// shot.v1.2.
[[nodiscard]] bool endsAsFile(const std::string& name) {
  const std::size_t dot = name.rfind('.');
  if (dot == std::string::npos) return false;
  const std::size_t number = name.compare(dot, 2, ".v") == 0 ? dot + 2 : dot + 1;
  return number == name.size() || name.find_first_not_of("0123456789", number) != std::string::npos;
}

/// Whether `path` can only mean a folder, though none is there yet.
[[nodiscard]] bool looksLikeFolder(const std::string& path) {
  const std::size_t slash = path.rfind('/');
  const std::string name = path.substr(slash == std::string::npos ? 0 : slash + 1);
  return !path.empty() && name.find_first_of("%#") == std::string::npos && !endsAsFile(name);
}

[[nodiscard]] bool isOutputFolder(const std::string& path) {
  return isFolder(path) || looksLikeFolder(path);
}

/// Which frames of a folder are meant, where the user has not said.
void fillRange(const FolderSequence& found, const std::string& prefix,
               const std::set<std::string>& given, SequenceOptions& sequence) {
  const auto isGiven = [&](const char* name) { return given.count(prefix + name) > 0; };
  if (isGiven("-range")) return;
  if (!isGiven("-start")) sequence.start = sequence.speed > 0 ? found.lowest : found.highest;
  if (isGiven("-frames")) return;
  const std::int64_t last = sequence.speed > 0 ? found.highest : found.lowest;
  const std::int64_t steps = (last - sequence.start) / sequence.speed;
  if (steps >= 0 && ranges::kFrameCounts.contains(static_cast<double>(steps + 1))) {
    sequence.frames = static_cast<int>(steps + 1);
  }
}

void resolveSequence(const std::string& prefix, const std::set<std::string>& given,
                     SequenceOptions& sequence) {
  if (!isFolder(sequence.path)) return;
  const FolderSequence found = sequenceIn(sequence.path, prefix + "-path", kPictureEndings);
  fillRange(found, prefix, given, sequence);
  sequence.path = found.pattern;
}

void resolvePath(const std::string& option, const std::vector<std::string>& endings,
                 std::string& path) {
  if (isFolder(path)) path = sequenceIn(path, option, endings).pattern;
}

}  // namespace

void checkInputPath(const std::string& option, const std::string& path) {
  if (isFolder(path)) return;
  constexpr const char* kWanted =
      "; wanted a folder of frames, or a path with one frame number, e.g. frames/%05d.png";
  std::error_code ignored;
  if (path.find_first_of("%#") == std::string::npos && std::filesystem::exists(path, ignored)) {
    throw UsageError(shown(option, path) + ": is a single file" + kWanted);
  }
  if (looksLikeFolder(path)) throw UsageError(shown(option, path) + ": no such folder" + kWanted);
  checkPattern(option, path);
}

void checkOutputPath(const std::string& option, const std::string& path) {
  if (!isOutputFolder(path)) checkOutputPattern(option, path);
}

void resolveFolders(const std::set<std::string>& given, Options& options) {
  resolveSequence("--src", given, options.source);
  resolvePath("--src-mask-path", kPictureEndings, options.sourceMaskPath);
  resolveSequence("--target", given, options.target);
  if (options.sourceFlowPath) {
    resolvePath("--src-flow-path", kFlowEndings, *options.sourceFlowPath);
  }
  if (options.targetFlowPath) {
    resolvePath("--target-flow-path", kFlowEndings, *options.targetFlowPath);
  }
  if (!options.outPath.empty() && isOutputFolder(options.outPath)) {
    options.outPath = patternIn(options.outPath);
  }
}

}  // namespace fluidymation::cli
