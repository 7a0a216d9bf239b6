#include "fluidymation/verify.h"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <set>
#include <system_error>

#include "checkpoint/manifest.h"
#include "fluidymation/core/error.h"
#include "fluidymation/io/frame_pattern.h"

namespace fluidymation {
namespace {

namespace fs = std::filesystem;

/// What the manifest's frames are called; nothing where it does not say.
[[nodiscard]] std::optional<FramePattern> namePattern(const Manifest& manifest) {
  for (const auto& [option, value] : manifest.paths) {
    if (option != "--out-path") continue;
    try {
      return FramePattern(fs::path(value).filename().string());
    } catch (const Error&) {
      return std::nullopt;
    }
  }
  return std::nullopt;
}

/// Names in `folder` of the manifest's pattern that it does not tell of, sorted.
[[nodiscard]] std::vector<std::string> extraNames(const Manifest& manifest,
                                                  const fs::path& folder) {
  const std::optional<FramePattern> pattern = namePattern(manifest);
  std::vector<std::string> extra;
  if (!pattern) return extra;
  std::set<std::string> known;
  for (const Manifest::Frame& frame : manifest.frames) known.insert(frame.file);
  std::error_code failure;
  fs::directory_iterator entry(folder, failure);
  for (; !failure && entry != fs::directory_iterator(); entry.increment(failure)) {
    const std::string name = entry->path().filename().string();
    if (pattern->numberOf(name) && known.count(name) == 0) extra.push_back(name);
  }
  std::sort(extra.begin(), extra.end());
  return extra;
}

/// What is wrong with a frame; nothing where it is as it was painted.
[[nodiscard]] std::optional<std::string> faultOf(const Manifest::Frame& frame,
                                                 const std::string& path) {
  std::error_code ignored;
  if (!fs::exists(path, ignored)) return path + ": missing";
  if (!fs::is_regular_file(path, ignored)) return path + ": is no regular file";
  try {
    if (digestOfFile(path) == frame.digest) return std::nullopt;
  } catch (const Error& error) {
    return error.what();
  }
  return path + ": changed";
}

/// Frames of the target that the manifest does not tell of: "7, 9-12", cut where it becomes long.
/// Empty where all are there, or the manifest does not say what the target has.
[[nodiscard]] std::string missingFrames(const Manifest& manifest) {
  constexpr std::size_t kLongestList = 160;  // bytes
  std::set<int> painted;
  for (const Manifest::Frame& frame : manifest.frames) painted.insert(frame.number);
  std::string text;
  std::size_t unlisted = 0;
  for (const InputDigests& input : manifest.fingerprint.inputs) {
    if (input.option != "--target-path") continue;
    const std::vector<InputDigests::File>& files = input.files;  // sorted by number
    for (std::size_t i = 0; i < files.size(); ++i) {
      const std::size_t begin = i;
      while (i < files.size() && painted.count(files[i].number) == 0) ++i;
      if (i == begin) continue;
      if (text.size() > kLongestList) {
        unlisted += i - begin;
        continue;
      }
      const std::string first = std::to_string(files[begin].number);
      const std::string last = std::to_string(files[i - 1].number);
      text += (text.empty() ? "" : ", ") + first;
      if (i - begin > 1) text += (first[0] == '-' || last[0] == '-' ? " to " : "-") + last;
    }
  }
  return unlisted == 0 ? text : text + " and " + std::to_string(unlisted) + " more";
}

}  // namespace

Verification verify(const std::string& manifestPath, const std::function<void()>& beforeEach) {
  const Manifest manifest = readManifest(manifestPath);
  const fs::path folder = fs::path(manifestPath).parent_path();
  Verification result;
  result.frames = static_cast<int>(manifest.frames.size());
  for (const Manifest::Frame& frame : manifest.frames) {
    if (beforeEach) beforeEach();
    if (auto fault = faultOf(frame, (folder / frame.file).string())) {
      result.faults.push_back(std::move(*fault));
    }
  }
  const fs::path listed = folder.empty() ? fs::path(".") : folder;
  for (const std::string& name : extraNames(manifest, listed)) {
    result.faults.push_back((folder / name).string() + ": extra, not in the manifest");
  }
  const std::string missing = missingFrames(manifest);
  if (!manifest.complete || !missing.empty()) {
    result.faults.push_back(manifestPath + ": not all frames of the shot are painted" +
                            (missing.empty() ? "" : "; it lacks " + missing));
  }
  return result;
}

}  // namespace fluidymation
