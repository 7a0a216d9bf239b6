#include "pipeline/stopping.h"

#include <algorithm>
#include <string>

#include "fluidymation/core/error.h"

namespace fluidymation {

void Stopping::check() const {
  if (!observer_.cancelled || !observer_.cancelled()) return;
  throw Interrupted("interrupted; " + std::to_string(written_) + " of " +
                    std::to_string(frameCount_) + " frames written");
}

void paintSavingState(RunJournal& journal, const std::function<void()>& paint) {
  try {
    paint();
  } catch (const Interrupted& stop) {
    std::string text = stop.what();
    bool canResume = false;
    try {
      canResume = journal.save();
      if (canResume) text += "; --resume goes on from there";
    } catch (const Error& error) {
      text += std::string("; the state cannot be saved: ") + error.what();
    }
    throw Interrupted(text, canResume);
  } catch (...) {
    try {
      journal.save();
    } catch (const Error&) {  // NOLINT(bugprone-empty-catch): the first fault is the one to tell of
    }
    throw;
  }
  journal.finish();
}

std::function<void()> countsReading(const Stopping& stopping, const Observer& observer,
                                    ReadingStage stage, int count) {
  return [&stopping, &observer, stage, count, done = 0]() mutable {
    stopping.check();
    // Hard masks that turn out to be soft are read twice
    done = std::min(done + 1, count);
    if (observer.reading) observer.reading({stage, done, count});
  };
}

}  // namespace fluidymation
