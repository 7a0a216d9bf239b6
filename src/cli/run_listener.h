#pragma once

#include <string>

#include "fluidymation/pipeline.h"

namespace fluidymation::cli {

/// Is told what a run does, while it does it.
class RunListener {
 public:
  virtual ~RunListener() = default;

  virtual void readingBegins() = 0;
  /// Called now and then, see `Throttle`.
  virtual void reading(const ReadingReport& report) = 0;
  /// @param frame  to be painted first, from 0.
  virtual void paintingBegins(int frame, int frameCount) = 0;
  virtual void frameDone(const FrameReport& report) = 0;
  /// The run ends without having painted all; `reason` is one line.
  virtual void failed(const std::string& reason) = 0;
};

}  // namespace fluidymation::cli
