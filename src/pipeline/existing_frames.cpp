#include "pipeline/existing_frames.h"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <system_error>
#include <utility>

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

/// What the manifest says of the run's frames, added to what a stopped run has `recorded`. Nothing
/// of the manifest where it cannot be read, or is of frames with other names.
[[nodiscard]] FrameDigests knownFrames(const RunIdentity& run, const FrameDigests& recorded) {
  FrameDigests known = recorded;
  std::error_code ignored;
  if (!fs::exists(run.files.manifest(), ignored)) return known;
  const FramePattern pattern(run.files.pattern());
  try {
    for (const Manifest::Frame& frame : readManifest(run.files.manifest()).frames) {
      if (fs::path(pattern.path(frame.number)).filename() == frame.file)
        add(frame.number, frame.digest, known);
    }
  } catch (const Error&) {
    return recorded;
  }
  return known;
}

/// What is known of frames that are not going to be painted, and that the run does not know itself.
[[nodiscard]] OwnFrames framesOfOthers(const RunIdentity& run, const StartingPoint& start,
                                       const FrameDigests& known) {
  OwnFrames own;
  for (int j = 0; j < run.frameCount(); ++j) {
    if ((j >= start.span.begin && j < start.span.end) || start.known[at(j)]) continue;
    const auto found = known.find(run.numbers[at(j)]);
    if (found != known.end()) own.replaceable.insert(*found);
  }
  return own;
}

/// Nothing for what is no ordinary file, or cannot be read.
[[nodiscard]] std::optional<Digest> digestIfReadable(const std::string& path) {
  std::error_code ignored;
  if (!fs::is_regular_file(path, ignored)) return std::nullopt;
  try {
    return digestOfFile(path);
  } catch (const Error&) {
    return std::nullopt;
  }
}

/// @throws Error naming the first of these frames, where there are any, and how many there are.
void requireNone(const DoubtfulFrames& others, const RunIdentity& run, const std::string& waysOut) {
  if (others.empty()) return;
  const std::size_t more = others.size() - 1;
  throw Error(
      run.framePaths[at(*others.begin())] +
      ": is there already, and not as a run that is recorded there has painted it" +
      (more == 0 ? "" : (more == 1 ? "; so is " : "; so are ") + std::to_string(more) + " more") +
      "; wanted " + waysOut);
}

}  // namespace

OwnFrames requireOwnFrames(const ContinuationOptions& options, const RunIdentity& run,
                           const StartingPoint& start, const std::function<void()>& beforeEach) {
  const bool stopped = wasStopped(run.files);
  const bool replacesAll = options.existing == ExistingFrames::kReplace;
  const bool discardsAll = !replacesAll && options.restart && stopped;
  const FrameDigests recorded = readReplaceableFrames(run.files.replaceableFrames());
  const FrameDigests known = knownFrames(run, recorded);
  OwnFrames own = framesOfOthers(run, start, known);
  DoubtfulFrames others;
  DoubtfulFrames changed;  // of others: those that a run had recorded
  for (int j = start.span.begin; j < start.span.end; ++j) {
    const int number = run.numbers[at(j)];
    const std::string& path = run.framePaths[at(j)];
    own.recorded = own.recorded || known.count(number) != 0;
    if (!isThere(path)) continue;
    beforeEach();
    std::optional<Digest> digest;
    if (discardsAll || (replacesAll && known.count(number) != 0)) {
      digest = digestIfReadable(path);
    } else if (known.count(number) != 0) {
      digest = digestOfFile(path);
    }
    if (digest && (discardsAll || holds(known, number, *digest))) {
      add(number, *digest, own.replaceable);
    } else {
      others.insert(j);
      if (recorded.count(number) != 0) changed.insert(j);
    }
  }
  own.recorded = own.recorded || !own.replaceable.empty();
  if (replacesAll || discardsAll) return own;
  const bool goesOn = start.state || (options.resume && stopped);
  requireNone(goesOn ? changed : others, run, options.waysOut);
  own.doubtful = std::move(others);
  return own;
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
