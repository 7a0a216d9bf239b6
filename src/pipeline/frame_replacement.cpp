#include "pipeline/frame_replacement.h"

#include <filesystem>
#include <string>
#include <system_error>
#include <utility>

#include "fluidymation/core/index.h"
#include "fluidymation/io/atomic_file.h"

namespace fluidymation {

FrameReplacement::FrameReplacement(const RunIdentity& run, FrameSpan span, OwnFrames frames,
                                   std::string waysOut)
    : run_(run), span_(span), frames_(std::move(frames)), waysOut_(std::move(waysOut)) {}

void FrameReplacement::begin() const {
  if (frames_.recorded) {
    writeAtomically(run_.files.replaceableFrames(), encode(frames_.replaceable));
  } else {
    keep({});
  }
}

void FrameReplacement::beforeWriting(int frame, const Digest& digest) const {
  if (frames_.doubtful.count(frame) != 0) requireSame(run_.framePaths[at(frame)], digest, waysOut_);
  if (frames_.recorded) {
    appendLine(run_.files.replaceableFrames(), lineOf(run_.numbers[at(frame)], digest));
  }
}

void FrameReplacement::finish() const {
  FrameDigests others = frames_.replaceable;
  for (int j = span_.begin; j < span_.end; ++j) others.erase(run_.numbers[at(j)]);
  keep(others);
}

void FrameReplacement::keep(const FrameDigests& frames) const {
  const std::string path = run_.files.replaceableFrames();
  std::error_code ignored;
  if (frames.empty()) {
    std::filesystem::remove(path, ignored);
  } else if (std::filesystem::exists(path, ignored)) {
    writeAtomically(path, encode(frames));
  }
}

}  // namespace fluidymation
