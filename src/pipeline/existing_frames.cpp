#include "pipeline/existing_frames.h"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <system_error>

#include "checkpoint/manifest.h"
#include "fluidymation/core/error.h"
#include "fluidymation/core/index.h"
#include "fluidymation/io/frame_pattern.h"
#include "fluidymation/io/frame_sequence.h"
#include "fluidymation/option_ranges.h"

namespace fluidymation {
namespace {

namespace fs = std::filesystem;

/// Also for a link that leads nowhere: it would be replaced.
[[nodiscard]] bool isThere(const std::string& path) {
  std::error_code ignored;
  return fs::symlink_status(path, ignored).type() > fs::file_type::not_found;
}

/// Whether a run was stopped or killed there: the frames that it had not recorded yet are its own.
[[nodiscard]] bool wasStopped(const RunFiles& files) {
  std::error_code ignored;
  if (!fs::is_directory(files.hiddenFolder(), ignored)) return false;
  if (!fs::exists(files.manifest(), ignored)) return true;
  try {
    return !readManifest(files.manifest()).complete;
  } catch (const Error&) {
    return false;
  }
}

/// What the manifest says of the frames, by their names; nothing where there is none to read.
[[nodiscard]] std::map<std::string, Digest> paintedFrames(const RunFiles& files) {
  std::map<std::string, Digest> painted;
  std::error_code ignored;
  if (!fs::exists(files.manifest(), ignored)) return painted;
  try {
    for (const Manifest::Frame& frame : readManifest(files.manifest()).frames) {
      painted[frame.file] = frame.digest;
    }
  } catch (const Error&) {
    painted.clear();
  }
  return painted;
}

}  // namespace

DoubtfulFrames requireOwnFrames(const ContinuationOptions& options, const RunIdentity& run,
                                const StartingPoint& start,
                                const std::function<void()>& beforeEach) {
  const bool stopped = wasStopped(run.files);
  if (options.existing == ExistingFrames::kReplace || (options.restart && stopped)) return {};
  const std::map<std::string, Digest> painted = paintedFrames(run.files);
  DoubtfulFrames others;
  for (int j = start.span.begin; j < start.span.end; ++j) {
    const std::string& path = run.framePaths[at(j)];
    if (!isThere(path)) continue;
    const auto known = painted.find(fs::path(path).filename().string());
    beforeEach();
    if (known == painted.end() || digestOfFile(path) != known->second) others.insert(j);
  }
  if (start.state || (options.resume && stopped)) return others;
  if (others.empty()) return {};
  const std::size_t more = others.size() - 1;
  throw Error(
      run.framePaths[at(*others.begin())] +
      ": is there already, and not as a run that is recorded there has painted it" +
      (more == 0 ? "" : (more == 1 ? "; so is " : "; so are ") + std::to_string(more) + " more") +
      "; wanted " + options.waysOut);
}

void requireSame(const std::string& path, const Digest& digest, const std::string& waysOut) {
  if (!isThere(path)) return;
  std::error_code ignored;
  if (fs::is_regular_file(path, ignored) && digestOfFile(path) == digest) return;
  throw Error(path + ": is there already, and not as this run paints it; wanted " + waysOut);
}

std::vector<Options> runsForMissingFrames(const Options& given, const Observer& observer) {
  validate(given);
  const std::vector<int> numbers =
      findFrames(FramePattern(given.target.path), given.target, "--target-path").numbers;
  const FrameSpan wanted = wantedFrames(given, numbers);
  const FramePattern pattern(given.outPath);
  std::vector<FrameSpan> missing;
  int kept = 0;
  for (int j = wanted.begin; j < wanted.end; ++j) {
    if (isThere(pattern.path(numbers[at(j)]))) {
      ++kept;
    } else if (!missing.empty() && missing.back().end == j) {
      ++missing.back().end;
    } else {
      missing.push_back({j, j + 1});
    }
  }
  if (kept > 0 && observer.note) {
    observer.note("--skip-existing: " + std::to_string(kept) + " of " +
                  std::to_string(wanted.end - wanted.begin) + " frames are there and kept");
  }
  std::vector<Options> runs;
  for (const FrameSpan& span : missing) {
    Options run = given;
    run.continuation.existing = ExistingFrames::kOwn;
    if (kept > 0) {
      run.continuation.render = FrameNumbers{numbers[at(span.begin)], numbers[at(span.end - 1)]};
    }
    runs.push_back(std::move(run));
  }
  return runs;
}

}  // namespace fluidymation
