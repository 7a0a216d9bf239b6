#pragma once

#include "fluidymation/synthesis/stages.h"
#include "fluidymation/synthesis/synthesizer.h"

namespace fluidymation {

/// Tells an observer when a stage begins and ends.
class StageScope {
 public:
  StageScope(StageObserver* observer, Stage stage, int level)
      : observer_(observer), stage_(stage), level_(level) {
    if (observer_ != nullptr) observer_->begins(stage_, level_);
  }
  StageScope(const StageScope&) = delete;
  StageScope& operator=(const StageScope&) = delete;
  ~StageScope() {
    if (observer_ != nullptr) observer_->ends(stage_, level_);
  }

 private:
  StageObserver* observer_;
  Stage stage_;
  int level_;
};

template <typename Body>
auto Synthesizer::timed(Stage stage, int level, const Body& body) const {
  const StageScope scope(observer_, stage, level);
  return body();
}

}  // namespace fluidymation
