#include "pipeline/given_flow.h"

#include <cassert>
#include <utility>

#include "fluidymation/core/error.h"
#include "fluidymation/core/parallel.h"
#include "fluidymation/core/resize.h"
#include "fluidymation/io/flow_file.h"

namespace fluidymation {

FlowSequence openFlowSequence(const std::string& path, const std::string& option,
                              FlowConvention convention, const SequenceOptions& sequence,
                              const InputSequence& masks) {
  assert(sequence.speed == 1 || sequence.speed == -1);
  FlowSequence flow;
  flow.seenOnFrame = (convention == FlowConvention::kBackward) == (sequence.speed > 0);
  const int frameCount = masks.files.count();
  int dispensable = -1;
  if (frameCount > 1) dispensable = flow.seenOnFrame ? 0 : frameCount - 1;
  flow.files = findCompanions(FramePattern(path), masks.files, sequence, option, dispensable);
  flow.identities = identitiesOf(flow.files);
  requireSize(flow.files, masks.files, masks.stored, readFlowSize);
  flow.stored = masks.stored;
  flow.scaled = masks.scaled;
  flow.factor = static_cast<float>(sequence.speed * sequence.scale);
  return flow;
}

Image<Vec2> GivenFlow::flow(int frame, const Mask& previousMask) {
  if (sequence_.seenOnFrame) return read(has(frame) ? frame : frame + 1);
  if (frame == 0) {
    last_ = read(0);
    return last_.clone();
  }
  Image<Vec2> flow = std::move(last_);
  if (!has(frame)) return flow;
  last_ = read(frame);
  forEachRow(flow.height(), [&](int y) {
    for (int x = 0; x < flow.width(); ++x) {
      if (previousMask(x, y) == 0) flow(x, y) = last_(x, y);
    }
  });
  return flow;
}

bool GivenFlow::has(int frame) const {
  return !sequence_.files.paths[static_cast<std::size_t>(frame)].empty();
}

Image<Vec2> GivenFlow::read(int frame) const {
  const std::string& path = sequence_.files.paths[static_cast<std::size_t>(frame)];
  const Image<Vec2> stored = readFlow(path, sequence_.stored);
  requireUnchanged(path, sequence_.identities[static_cast<std::size_t>(frame)]);
  Image<Vec2> flow = resize(stored, sequence_.scaled);
  for (Vec2& v : flow) v = sequence_.factor * v;
  return flow;
}

}  // namespace fluidymation
