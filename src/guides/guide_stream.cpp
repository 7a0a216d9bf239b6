#include "fluidymation/guides/guide_stream.h"

#include <algorithm>
#include <cassert>
#include <deque>
#include <utility>

#include "fluidymation/core/parallel.h"
#include "fluidymation/guides/accumulation.h"
#include "fluidymation/guides/direction.h"
#include "fluidymation/guides/distance_field.h"
#include "fluidymation/guides/motion.h"
#include "fluidymation/guides/temporal_smoothing.h"

namespace fluidymation {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// The values inside the mask, in row order.
std::vector<Vec2> gather(const Mask& mask, const Image<Vec2>& image) {
  std::vector<Vec2> values;
  values.reserve(countInside(mask));
  for (std::size_t i = 0; i < mask.pixelCount(); ++i) {
    if (mask.data()[i] != 0) values.push_back(image.data()[i]);
  }
  return values;
}

/// The inverse of `gather`; zero outside.
Image<Vec2> scatter(const Mask& mask, const std::vector<Vec2>& values) {
  Image<Vec2> image(mask.size());
  auto value = values.begin();
  for (std::size_t i = 0; i < mask.pixelCount(); ++i) {
    if (mask.data()[i] != 0) image.data()[i] = *value++;
  }
  assert(value == values.end());
  return image;
}

/// A shape without an edge within the image has no distance to it.
bool hasEdge(const Mask& mask) {
  const std::size_t inside = countInside(mask);
  return inside != 0 && inside != mask.pixelCount();
}

/// What the shapes of a run of frames, all of which have an edge, say about their movement. Asked
/// for in the order of the frames; only the distance fields that the temporal kernel reaches exist
/// at a time.
class ShapeChanges {
 public:
  using MaskOf = std::function<Mask(int frame)>;  ///< frames count from the beginning of the run

  ShapeChanges(int frameCount, float sigmaFrames, MaskOf maskOf)
      : frameCount_(frameCount), sigmaFrames_(sigmaFrames), maskOf_(std::move(maskOf)) {}

  /// The change that leads to `frame`; the first frame moves as it does towards the second. Valid
  /// until the next call.
  ShapeChange at(int frame) {
    const TemporalWeights window = temporalWeights(frame, frameCount_, sigmaFrames_);
    const TemporalWeights steps = stepWeights(std::max(frame, 1), frameCount_, sigmaFrames_);
    provide(std::min(window.firstFrame, steps.firstFrame),
            std::max(endOf(window), endOf(steps) + 1));
    smooth_ = average(window);
    ShapeChange change{field(frame), smooth_, {}, steps.weights};
    for (int i = steps.firstFrame; i <= endOf(steps); ++i) change.fields.push_back(&field(i));
    return change;
  }

 private:
  static int endOf(const TemporalWeights& window) {
    return window.firstFrame + static_cast<int>(window.weights.size());
  }

  [[nodiscard]] const Image<float>& field(int frame) const {
    return fields_[static_cast<std::size_t>(frame - firstField_)];
  }

  void provide(int first, int end) {
    for (; firstField_ < first; ++firstField_) fields_.pop_front();
    while (firstField_ + static_cast<int>(fields_.size()) < end) {
      const int frame = firstField_ + static_cast<int>(fields_.size());
      fields_.push_back(motionDistance(signedDistance(maskOf_(frame))));
    }
  }

  [[nodiscard]] Image<float> average(const TemporalWeights& window) const {
    Image<float> smooth(fields_.front().size());
    forEachRow(smooth.height(), [&](int y) {
      float* out = smooth.row(y);
      for (std::size_t i = 0; i < window.weights.size(); ++i) {
        const float weight = window.weights[i];
        const float* in = field(window.firstFrame + static_cast<int>(i)).row(y);
        for (int x = 0; x < smooth.width(); ++x) out[x] += weight * in[x];
      }
    });
    return smooth;
  }

  int frameCount_;
  float sigmaFrames_;
  MaskOf maskOf_;
  int firstField_ = 0;
  std::deque<Image<float>> fields_;  ///< of frames firstField_, firstField_ + 1, ...
  Image<float> smooth_;
};

}  // namespace

GuideStream::GuideStream(int frameCount, const MaskReader& readMask, const GuideOptions& options) {
  assert(frameCount >= 1);
  std::vector<bool> edge;
  for (int i = 0; i < frameCount; ++i) {
    const Mask mask = smoothMask(readMask(i), options.mask);
    StoredFrame frame;
    frame.mask = PackedMask(mask);
    assert(frames_.empty() || frame.mask.size() == frames_.front().mask.size());
    frame.flow.resize(countInside(mask));  // zero, until the frame turns out to move
    frames_.push_back(std::move(frame));
    edge.push_back(hasEdge(mask));
  }

  // Flow. Frames without an edge, empty and full ones, have stand-ins for distances: they end the
  // temporal window on both sides as the ends of the sequence do.
  for (int begin = 0; begin < frameCount; ++begin) {
    if (!edge[at(begin)]) continue;
    int end = begin + 1;
    while (end < frameCount && edge[at(end)]) ++end;
    computeFlow(begin, end, options.timeBlurSigmaFrames);
    begin = end;
  }

  // Motion still to come, from the last frame backwards (§3.5)
  Mask nextMask = frames_.back().mask.unpack();
  Image<Vec2> nextFlow = scatter(nextMask, frames_.back().flow);
  Image<Vec2> accumulated(nextMask.size());
  frames_.back().accBackward.resize(frames_.back().flow.size());
  for (int i = frameCount - 2; i >= 0; --i) {
    StoredFrame& frame = frames_[at(i)];
    Mask mask = frame.mask.unpack();
    Image<Vec2> flow = scatter(mask, frame.flow);
    accumulated = accumulateBackward(accumulated, nextFlow, nextMask, flow, mask);
    frame.accBackward = gather(mask, accumulated);
    nextMask = std::move(mask);
    nextFlow = std::move(flow);
  }
}

void GuideStream::computeFlow(int begin, int end, float sigmaFrames) {
  if (end - begin < 2) return;  // a single frame does not move
  ShapeChanges changes(end - begin, sigmaFrames,
                       [&](int i) { return frames_[at(begin + i)].mask.unpack(); });
  for (int i = begin; i < end; ++i) {
    StoredFrame& frame = frames_[at(i)];
    const Mask mask = frame.mask.unpack();
    const MotionField motion = motionField(mask, changes.at(i - begin));
    frame.flow = gather(mask, motion.flow);
    frame.diffusion = motion.report;
  }
}

bool GuideStream::anyInside() const {
  assert(nextFrame_ == 0);
  return std::any_of(frames_.begin(), frames_.end(),
                     [](const StoredFrame& frame) { return !frame.flow.empty(); });
}

GuideFrame GuideStream::next() {
  assert(nextFrame_ < frameCount());
  StoredFrame& stored = frames_[at(nextFrame_)];
  GuideFrame guides;
  guides.mask = stored.mask.unpack();
  guides.distance = signedDistance(guides.mask);
  guides.flow = scatter(guides.mask, stored.flow);
  guides.accBackward = scatter(guides.mask, stored.accBackward);
  guides.diffusion = stored.diffusion;
  stored.flow = {};  // given away, and not asked for again
  stored.accBackward = {};

  guides.direction = flowDirection(guides.mask, guides.flow, guides.distance, direction_);
  guides.accForward = nextFrame_ == 0 ? Image<Vec2>(guides.mask.size())
                                      : accumulateForward(accForward_, guides.flow, guides.mask);
  direction_ = guides.direction.clone();
  accForward_ = guides.accForward.clone();
  ++nextFrame_;
  return guides;
}

}  // namespace fluidymation
