#include "pipeline/starting_point.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <system_error>
#include <utility>

#include "checkpoint/checkpoint_file.h"
#include "checkpoint/manifest.h"
#include "fluidymation/core/error.h"
#include "fluidymation/core/index.h"
#include "pipeline/film_window.h"
#include "pipeline/run_fingerprint.h"

namespace fluidymation {
namespace {

constexpr const char* kRestartHint = "--restart discards it and begins anew";

/// The manifest of the frames, where there is one; nothing where it cannot be read either.
[[nodiscard]] std::optional<Manifest> manifestOf(const RunFiles& files) {
  std::error_code ignored;
  if (!std::filesystem::exists(files.manifest(), ignored)) return std::nullopt;
  try {
    return readManifest(files.manifest());
  } catch (const Error&) {
    return std::nullopt;
  }
}

/// @throws Error where the manifest tells of frames with other names: patterns that differ in the
/// number's place or width, or in the ending, have one manifest.
void requireSameNames(const Manifest& manifest, const RunIdentity& run) {
  constexpr const char* kReplaced = "\xEF\xBF\xBD";  // for a byte that is no UTF-8
  const auto nameOf = [](const FramePattern& pattern) {
    return std::filesystem::path(pattern.path(0)).filename();
  };
  for (const auto& [option, value] : manifest.paths) {
    if (option != "--out-path" || value.find(kReplaced) != std::string::npos) continue;
    try {
      if (nameOf(FramePattern(value)) == nameOf(FramePattern(run.files.pattern()))) continue;
    } catch (const UsageError&) {
      continue;  // somebody has edited it
    }
    throw Error(run.files.manifest() + ": is of the frames " + value + ", not of " +
                run.files.pattern() + "; wanted another name or folder; " + kRestartHint);
  }
}

/// What the manifest tells of the frames, where it is one of this run.
[[nodiscard]] FrameRecords recordsOf(const std::optional<Manifest>& manifest,
                                     const RunIdentity& run) {
  FrameRecords records(run.numbers.size());
  if (!manifest || !isOf(*manifest, run.fingerprint)) return records;
  std::map<int, Digest> digests;
  for (const Manifest::Frame& frame : manifest->frames) digests[frame.number] = frame.digest;
  for (std::size_t j = 0; j < records.size(); ++j) {
    const auto found = digests.find(run.numbers[j]);
    if (found != digests.end()) records[j] = FrameRecord{found->second, 0.0};
  }
  return records;
}

/// What is wrong with a frame that was painted before; nothing where it is still the same.
[[nodiscard]] std::optional<std::string> faultOf(const FrameRecord& frame,
                                                 const std::string& path) {
  std::error_code ignored;
  if (!std::filesystem::exists(path, ignored)) return path + ": is missing";
  if (digestOfFile(path) != frame.digest) return path + ": has changed";
  return std::nullopt;
}

/// States that are there, by how many frames of the target are painted then.
[[nodiscard]] std::map<int, std::string> statesByFrames(const RunIdentity& run) {
  std::map<int, std::string> states;
  for (const auto& [number, path] : run.files.states()) {
    const auto found = std::find(run.numbers.begin(), run.numbers.end(), number);
    if (found == run.numbers.end()) continue;
    states[static_cast<int>(found - run.numbers.begin()) + 1] = path;
  }
  return states;
}

/// What a state is worth to a run over some frames: it goes on from `checkpoint`, or cannot, and
/// `fault` says why.
struct FoundState {
  std::string path;
  int painted = 0;  ///< frames of the target, up to the one that it is the state of
  std::optional<Checkpoint> checkpoint;
  std::string fault;
  /// Where the only fault is that its frames were painted as a part: the first one, from 0.
  std::optional<int> partBegin;
};

[[nodiscard]] FoundState readState(const std::string& path, int painted, FrameSpan wanted,
                                   const RunIdentity& run) {
  FoundState state{path, painted, {}, {}, {}};
  try {
    FoundCheckpoint found = readCheckpoint(path, run.fingerprint, run.limits);
    if (!found.checkpoint) {
      state.fault = path + ": is the state of another run (" + found.differs + ")";
    } else if (found.checkpoint->next() != painted) {
      state.fault = path + ": is the state of another frame";
    } else if (found.checkpoint->begin != 0 && found.checkpoint->begin != wanted.begin) {
      state.partBegin = found.checkpoint->begin;
      state.fault = path + ": its frames start afresh with frame " +
                    std::to_string(run.numbers[at(*state.partBegin)]) +
                    ", those wanted with frame " + std::to_string(run.numbers[at(wanted.begin)]);
    } else {
      state.checkpoint = std::move(found.checkpoint);
    }
  } catch (const Error& error) {
    state.fault = error.what();
  }
  return state;
}

/// The newest state that a run over `wanted` can have left. States of parts that were painted by
/// themselves are passed over, unless there are no others.
[[nodiscard]] std::optional<FoundState> newestState(const RunIdentity& run, FrameSpan wanted) {
  const std::map<int, std::string> states = statesByFrames(run);
  std::optional<FoundState> newest;
  for (auto state = states.rbegin(); state != states.rend(); ++state) {
    const auto& [painted, path] = *state;
    if (painted <= wanted.begin || painted > wanted.end) continue;
    FoundState found = readState(path, painted, wanted, run);
    if (!found.partBegin) return found;
    if (!newest) newest = std::move(found);
  }
  return newest;
}

/// Takes over what the checkpoint knows. Of the frames after it the manifest may know more: other
/// parts may have been painted since. `start.known` comes with what the manifest knows.
void goOnFrom(Checkpoint checkpoint, StartingPoint& start) {
  start.span.begin = checkpoint.next();
  start.chainBegin = checkpoint.begin;
  const FrameRecords told = std::exchange(start.known, std::move(checkpoint.frames));
  for (std::size_t j = at(start.span.begin); j < told.size(); ++j) {
    std::optional<FrameRecord>& known = start.known[j];
    if (told[j] && (!known || known->digest != told[j]->digest)) known = told[j];
  }
  start.state = std::move(checkpoint.synthesis);
}

/// @throws Error naming the file when the state or the frames before it are not what this run would
/// have made.
void resumeFrom(FoundState state, const RunIdentity& run, const std::function<void()>& beforeEach,
                StartingPoint& start) {
  if (!state.checkpoint) throw Error(state.fault + "; " + kRestartHint);
  Checkpoint& checkpoint = *state.checkpoint;
  for (int j = 0; j < checkpoint.next(); ++j) {
    if (!checkpoint.frames[at(j)]) continue;
    beforeEach();
    const auto fault = faultOf(*checkpoint.frames[at(j)], run.framePaths[at(j)]);
    if (fault) throw Error(*fault + " since it was painted; --restart paints all anew");
  }
  goOnFrom(std::move(checkpoint), start);
  start.statePath = std::move(state.path);
  if (start.span.begin < start.span.end) {
    start.note = "going on with frame " + std::to_string(run.numbers[at(start.span.begin)]) + ", " +
                 std::to_string(start.span.begin) + " of " + std::to_string(run.frameCount()) +
                 " are painted";
  }
}

[[nodiscard]] std::string afreshNote(const RunIdentity& run, int frame, const std::string& reason) {
  return "frame " + std::to_string(run.numbers[at(frame)]) +
         " starts afresh and looks other than after the frames before it: " + reason;
}

/// Begins with a frame that is not the target's first: from the state of the frame before it, where
/// there is one.
void beginInside(const RunIdentity& run, StartingPoint& start) {
  const std::string before = std::to_string(run.numbers[at(start.span.begin - 1)]);
  const std::string path = run.files.state(run.numbers[at(start.span.begin - 1)]);
  std::string reason = "there is no state of frame " + before;
  std::error_code ignored;
  if (std::filesystem::exists(path, ignored)) {
    try {
      FoundCheckpoint found = readCheckpoint(path, run.fingerprint, run.limits);
      if (found.checkpoint && found.checkpoint->next() == start.span.begin &&
          found.checkpoint->begin == 0) {
        goOnFrom(std::move(*found.checkpoint), start);
        start.note = "going on after the state of frame " + before;
        return;
      }
      reason = found.checkpoint ? path + " has started afresh itself"
                                : path + " is of another run (" + found.differs + ")";
    } catch (const Error& error) {
      reason = error.what();
    }
  }
  start.chainBegin = start.span.begin;
  start.note = afreshNote(run, start.span.begin, reason);
}

/// @throws Error where a run over the whole target was stopped, or has painted a part, and may be
/// gone on with: says how.
void requireDecision(const RunIdentity& run, FrameSpan wanted,
                     const std::optional<Manifest>& manifest) {
  if (manifest && manifest->complete) return;
  const std::optional<FoundState> state = newestState(run, wanted);
  if (!state) return;
  const std::string count = std::to_string(run.frameCount());
  if (state->partBegin) {
    const auto between = [&run](int begin, int end, const char* separator) {
      // Of an animation that is played or painted backwards too, the smaller number comes first
      const auto [low, high] = std::minmax(run.numbers[at(begin)], run.numbers[at(end - 1)]);
      return std::to_string(low) + separator + std::to_string(high);
    };
    const int begin = *state->partBegin;
    throw Error(run.files.hiddenFolder() +
                ": holds the state of a part that was painted by itself, frames " +
                between(begin, state->painted, " to ") + "; wanted --render-frames " +
                between(begin, run.frameCount(), "-") +
                " --resume to go on with it, or --restart to discard it and paint all " + count);
  }
  if (!state->checkpoint) throw Error(state->fault + "; " + kRestartHint);
  throw Error(run.files.hiddenFolder() + ": holds the state of a run that ended after " +
              std::to_string(state->painted) + " of " + count +
              " frames; wanted --resume to go on with it, or --restart to discard it");
}

}  // namespace

RunIdentity identityOf(const Options& options, const Inputs& inputs,
                       const std::vector<std::string>& outPaths,
                       const std::function<void()>& beforeEach) {
  const CheckpointLimits limits{
      inputs.color.scaled, inputs.color.files.count(),
      FilmWindow(options, inputs.color.files.count(), inputs.target.files.count()).heldFrames(),
      inputs.target.scaled, inputs.target.files.count()};
  return {RunFiles(FramePattern(options.outPath)), inputs.target.files.numbers, outPaths,
          fingerprintOf(options, inputs, beforeEach), limits};
}

bool isWhole(FrameSpan wanted, const RunIdentity& run) {
  return wanted.begin == 0 && wanted.end == run.frameCount();
}

FrameSpan wantedFrames(const Options& options, const std::vector<int>& numbers) {
  const auto count = static_cast<int>(numbers.size());
  if (!options.continuation.render) return {0, count};
  const auto indexOf = [&](int number) {
    const auto found = std::find(numbers.begin(), numbers.end(), number);
    if (found != numbers.end()) return static_cast<int>(found - numbers.begin());
    throw UsageError("--render-frames: " + std::to_string(number) +
                     " is no frame of --target-path; wanted frames among " +
                     std::to_string(numbers.front()) + " to " + std::to_string(numbers.back()));
  };
  const int first = indexOf(options.continuation.render->first);
  const int last = indexOf(options.continuation.render->last);
  return {std::min(first, last), std::max(first, last) + 1};
}

StartingPoint findStart(const ContinuationOptions& options, FrameSpan wanted,
                        const RunIdentity& run, const std::function<void()>& beforeEach) {
  StartingPoint start;
  start.span = wanted;
  start.known = FrameRecords(run.numbers.size());
  if (options.restart && isWhole(wanted, run)) return start;

  const std::optional<Manifest> manifest = manifestOf(run.files);
  if (options.restart) {
    start.known = recordsOf(manifest, run);
    start.chainBegin = wanted.begin;
    if (wanted.begin > 0) start.note = afreshNote(run, wanted.begin, "--restart was given");
    return start;
  }
  if (manifest) requireSameNames(*manifest, run);
  if (options.resume) {
    if (auto state = newestState(run, wanted)) {
      start.known = recordsOf(manifest, run);
      resumeFrom(std::move(*state), run, beforeEach, start);
      return start;
    }
    const FrameRecords records = recordsOf(manifest, run);
    const auto isThere = [&](int j) {
      beforeEach();
      return records[at(j)] && !faultOf(*records[at(j)], run.framePaths[at(j)]);
    };
    bool allThere = manifest && manifest->complete;
    for (int j = wanted.begin; j < wanted.end && allThere; ++j) allThere = isThere(j);
    if (allThere) {
      start.span.begin = start.span.end;
      start.known = records;
      start.note = "all frames are painted already";
      return start;
    }
    start.note = "there is no state to go on from; beginning with frame " +
                 std::to_string(run.numbers[at(wanted.begin)]);
  } else if (isWhole(wanted, run)) {
    requireDecision(run, wanted, manifest);
  }
  if (!isWhole(wanted, run)) start.known = recordsOf(manifest, run);
  if (wanted.begin > 0) beginInside(run, start);
  return start;
}

}  // namespace fluidymation
