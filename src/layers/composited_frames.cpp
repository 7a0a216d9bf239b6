#include "layers/composited_frames.h"

#include <string>
#include <utility>
#include <vector>

#include "pipeline/existing_frames.h"
#include "pipeline/run_lock.h"

namespace fluidymation {

RunIdentity compositedFrames(const LayeredShot& shot, const LayerInputs& layers) {
  const FramePattern pattern(shot.outPath);
  std::vector<std::string> paths;
  for (const int number : layers.numbers) paths.push_back(pattern.path(number));
  return {RunFiles(pattern), layers.numbers, std::move(paths), {}, {}};
}

StartingPoint wholeShot(const LayerInputs& layers) {
  StartingPoint start;
  start.span = {0, static_cast<int>(layers.numbers.size())};
  start.known = FrameRecords(layers.numbers.size());
  return start;
}

void requireOwnComposite(const LayeredShot& shot, const LayerInputs& layers,
                         const std::function<void()>& beforeEach) {
  const RunIdentity run = compositedFrames(shot, layers);
  RunLock lock(run.files);
  lock.takeIfUsed();
  lock.setUnfinished(true);  // nothing of what a stopped run has left goes
  (void)requireOwnFrames(shot.continuation, run, wholeShot(layers), beforeEach);
}

}  // namespace fluidymation
