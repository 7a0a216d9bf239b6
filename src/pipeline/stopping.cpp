#include "pipeline/stopping.h"

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

}  // namespace fluidymation
