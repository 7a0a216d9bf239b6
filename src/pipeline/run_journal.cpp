#include "pipeline/run_journal.h"

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <utility>

#include "fluidymation/core/index.h"
#include "fluidymation/io/atomic_file.h"

namespace fluidymation {
namespace {

void removeQuietly(const std::string& path) {
  std::error_code ignored;
  std::filesystem::remove(path, ignored);
}

}  // namespace

bool CheckpointClock::isDue(int framesSince, Seconds elapsed) const {
  if (every_) return framesSince >= *every_;
  return total_ + last_ <= kCheckpointShare * elapsed;
}

void CheckpointClock::saved(Seconds duration) {
  total_ += duration;
  last_ = duration;
}

RunJournal::RunJournal(RunIdentity run, FrameSpan wanted, const StartingPoint& start,
                       std::vector<std::pair<std::string, std::string>> paths,
                       const ContinuationOptions& options)
    : run_(std::move(run)),
      wanted_(wanted),
      chainBegin_(start.chainBegin),
      frames_(start.known),
      paths_(std::move(paths)),
      keepStates_(options.keepStates),
      startsAnew_(!start.state && isWhole(wanted, run_)),
      restarts_(options.restart),
      statePath_(start.statePath),
      clock_(options.checkpointEvery) {}

void RunJournal::discardOldStates() const {
  if (startsAnew_) {
    for (const auto& [number, path] : run_.files.states()) removeQuietly(path);
  } else if (restarts_) {
    for (int j = wanted_.begin; j < wanted_.end; ++j) {
      removeQuietly(run_.files.state(run_.numbers[at(j)]));
    }
  }
}

void RunJournal::frameWritten(int frame, const Digest& digest,
                              std::shared_ptr<const SynthesisState> state) {
  const Clock::time_point now = Clock::now();
  const std::chrono::duration<double> seconds = now - std::exchange(lastWritten_, now);
  // A clock may be wrong; a state that knows of a negative time would be taken for damaged.
  frames_[at(frame)] = FrameRecord{digest, std::max(0.0, seconds.count())};
  ++framesSince_;
  if (!state) return;
  latest_ = std::move(state);
  if (frame + 1 < wanted_.end && clock_.isDue(framesSince_, now - begun_)) save();
}

bool RunJournal::save() {
  if (!latest_) return !statePath_.empty();
  const Clock::time_point begun = Clock::now();
  // The manifest first: it may know of a frame more than the state, never of one less.
  writeManifest(false);
  const std::string path = run_.files.state(run_.numbers[at(latest_->frame - 1)]);
  writeAtomically(path, encode(run_.fingerprint, chainBegin_, frames_, *latest_));
  replaceState(path);
  latest_.reset();
  framesSince_ = 0;
  clock_.saved(Clock::now() - begun);
  return true;
}

void RunJournal::finish() {
  const bool atTheEnd = wanted_.end == run_.frameCount();
  const bool complete =
      std::all_of(frames_.begin(), frames_.end(), [](const auto& f) { return f.has_value(); });
  if (!atTheEnd) save();  // for the frames that follow
  writeManifest(complete);
  if (!atTheEnd || keepStates_) return;
  replaceState("");
  if (!complete || chainBegin_ != 0) return;
  for (const auto& [number, path] : run_.files.states()) removeQuietly(path);
}

void RunJournal::writeManifest(bool complete) const {
  Manifest manifest{run_.fingerprint, paths_, complete, {}};
  for (std::size_t j = 0; j < frames_.size(); ++j) {
    if (!frames_[j]) continue;
    const std::string name = std::filesystem::path(run_.framePaths[j]).filename().string();
    manifest.frames.push_back({run_.numbers[j], name, frames_[j]->digest});
  }
  writeAtomically(run_.files.times(), encodeTimes(frames_, run_.numbers));
  writeAtomically(run_.files.manifest(), encode(manifest));
}

void RunJournal::replaceState(const std::string& path) {
  if (statePath_ == path) return;
  if (!statePath_.empty() && !keepStates_) removeQuietly(statePath_);
  statePath_ = path;
}

}  // namespace fluidymation
