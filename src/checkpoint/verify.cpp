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
  if (!manifest.complete) {
    result.faults.push_back(manifestPath + ": not all frames of the shot are painted");
  }
  return result;
}

}  // namespace fluidymation
