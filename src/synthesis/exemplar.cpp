#include "fluidymation/synthesis/exemplar.h"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <limits>
#include <utility>

#include "fluidymation/core/parallel.h"
#include "fluidymation/synthesis/shape_rules.h"
#include "synthesis/patch_kernels.h"

namespace fluidymation {

ExemplarLevel::ExemplarLevel(Size size, int frameCount, float borderWidthPx,
                             const ShapeRules& rules)
    : kernels_(&bestKernels()),
      size_(size),
      frameCount_(frameCount),
      borderWidthPx_(borderWidthPx),
      rules_(rules) {
  const std::size_t volume = offset(0, 0, frameCount);
  assert(volume <= std::numeric_limits<std::uint32_t>::max());  // candidates are 32-bit indices
  texels_.resize(padded(-kMarginPx, -kMarginPx, frameCount));
  extentsPx_.resize(volume);
  directions_.resize(volume);
  segments_.resize(volume, Segment::kOutside);
  if (!edgeGuideTellsDistance(rules)) distancesPx_.resize(volume);
}

template <typename Set>
void ExemplarLevel::setTexels(int x, int y, int k, const Set& set) {
  const int left = x == 0 ? -kMarginPx : x;
  const int right = x == size_.width - 1 ? x + kMarginPx : x;
  const int top = y == 0 ? -kMarginPx : y;
  const int bottom = y == size_.height - 1 ? y + kMarginPx : y;
  for (int py = top; py <= bottom; ++py) {
    for (int px = left; px <= right; ++px) set(texels_[padded(px, py, k)]);
  }
}

void ExemplarLevel::setColor(int frame, const Image<Lab>& color) {
  assert(color.size() == size_);
  forEachRow(size_.height, [&](int y) {
    for (int x = 0; x < size_.width; ++x) {
      const FixedLab fixed = FixedLab::of(color(x, y));
      setTexels(x, y, frame, [&](Texel& texel) { texel.color = fixed; });
    }
  });
}

void ExemplarLevel::setGuides(int frame, const GuideLevel& guides) {
  assert(guides.mask.size() == size_);
  const Image<float> distancesPx =
      distancesPx_.empty() ? Image<float>{} : modulationDistances(guides, borderWidthPx_, rules_);
  forEachRow(size_.height, [&](int y) {
    for (int x = 0; x < size_.width; ++x) {
      const std::size_t i = offset(x, y, frame);
      const std::int16_t edge =
          toFixed(shapeChannel(guides, x, y, borderWidthPx_, rules_), kEdgeSteps);
      setTexels(x, y, frame, [&](Texel& texel) { texel.guides.edge = edge; });
      const Vec2 extents{guides.extForward(x, y), guides.extBackward(x, y)};
      if (scalesAtOnce()) {
        setExtents(x, y, frame, extents);
      } else {
        extentsPx_[i] = extents;
      }
      const Vec2 direction = guides.direction(x, y);
      directions_[i] = {toFixed(direction.x, kDirectionSteps),
                        toFixed(direction.y, kDirectionSteps)};
      segments_[i] = guides.segment(x, y, borderWidthPx_);
      if (!distancesPx.empty()) distancesPx_[i] = distancesPx(x, y);
    }
  });
}

void ExemplarLevel::setExtentScale(const ExtentScale& extentScale) {
  extentScale_ = extentScale;
  comparesAges_ = extentScale.isOfAges();
  extentSteps_ = extentScale.stepsPerUnit();
  std::vector<Vec2>().swap(extentsPx_);
}

void ExemplarLevel::setExtents(int x, int y, int k, Vec2 extentsPx) {
  const std::int16_t forward = toFixed(extentScale_(extentsPx.x), extentSteps_);
  const std::int16_t backward = toFixed(extentScale_(extentsPx.y), extentSteps_);
  setTexels(x, y, k, [&](Texel& texel) {
    texel.guides.extForward = forward;
    texel.guides.extBackward = backward;
  });
}

void ExemplarLevel::dropFirst(int count) {
  assert(0 <= count && count <= frameCount_);
  if (count == 0) return;
  const auto drop = [](auto& volume, std::size_t dropped) {
    if (volume.empty()) return;
    std::move(volume.begin() + static_cast<std::ptrdiff_t>(dropped), volume.end(), volume.begin());
  };
  drop(texels_, padded(-kMarginPx, -kMarginPx, count));
  drop(extentsPx_, offset(0, 0, count));
  drop(directions_, offset(0, 0, count));
  drop(segments_, offset(0, 0, count));
  drop(distancesPx_, offset(0, 0, count));
}

void ExemplarLevel::finish(const ExtentScale& extentScale) {
  if (!scalesAtOnce()) {
    const std::vector<Vec2> extentsPx = std::move(extentsPx_);
    setExtentScale(extentScale);
    forEachRow(size_.height * frameCount_, [&](int row) {
      const int y = row % size_.height;
      const int k = row / size_.height;
      for (int x = 0; x < size_.width; ++x) setExtents(x, y, k, extentsPx[offset(x, y, k)]);
    });
  }
  listPixels();
}

void ExemplarLevel::listPixels() {
  borderPixels_.clear();
  interiorPixels_.clear();
  allPixels_.clear();
  for (std::size_t i = 0; i < segments_.size(); ++i) {
    if (segments_[i] == Segment::kOutside) continue;
    (segments_[i] == Segment::kBorder ? borderPixels_ : interiorPixels_)
        .push_back(static_cast<std::uint32_t>(i));
    if (!rules_.hardSegments) allPixels_.push_back(static_cast<std::uint32_t>(i));
  }
  segmented_ = !borderPixels_.empty() && !interiorPixels_.empty();
}

const std::vector<std::uint32_t>& ExemplarLevel::candidates(Segment segment) const {
  return rules_.hardSegments ? pixelsOf(segment) : allPixels_;
}

const std::vector<std::uint32_t>& ExemplarLevel::pixelsOf(Segment segment) const {
  if (segmented_) return segment == Segment::kBorder ? borderPixels_ : interiorPixels_;
  return borderPixels_.empty() ? interiorPixels_ : borderPixels_;
}

ExemplarLevel::Position ExemplarLevel::position(std::uint32_t volumeIndex) const {
  const auto width = static_cast<std::uint32_t>(size_.width);
  const auto height = static_cast<std::uint32_t>(size_.height);
  const std::uint32_t row = volumeIndex / width;
  return {static_cast<int>(volumeIndex % width), static_cast<int>(row % height),
          static_cast<int>(row / height)};
}

Exemplar::Exemplar(Size size, int frameCount, int coarsest, float borderWidthPx,
                   const ShapeRules& rules) {
  for (int l = 0; l <= coarsest; ++l) {
    levels_.emplace_back(size, frameCount, borderWidthPx, rules);
    size = halvedSize(size);
  }
  accForward_.resize(static_cast<std::size_t>(frameCount));
  accBackward_.resize(static_cast<std::size_t>(frameCount));
}

void Exemplar::setExtentScale(const ExtentScale& scale) {
  extentScale_ = scale;
  scaleIsSet_ = true;
  for (ExemplarLevel& level : levels_) level.setExtentScale(scale);
}

void Exemplar::setColor(int frame, const Image<Lab>& color) {
  levels_.front().setColor(frame, color);
  if (levelCount() == 1) return;
  Image<Lab> coarser = halve(color);
  for (int l = 1; l < levelCount(); ++l) {
    if (l > 1) coarser = halve(coarser);
    levels_[static_cast<std::size_t>(l)].setColor(frame, coarser);
  }
}

void Exemplar::setGuides(int frame, const GuideFrame& guides) {
  if (!scaleIsSet_) extents_.add(guides);
  GuideLevel guideLevel = finestLevel(guides);
  for (int l = 0; l < levelCount(); ++l) {
    if (l > 0) guideLevel = halve(guideLevel);
    levels_[static_cast<std::size_t>(l)].setGuides(frame, guideLevel);
  }
  accForward_[static_cast<std::size_t>(frame)] = guides.accForward.clone();
  accBackward_[static_cast<std::size_t>(frame)] = guides.accBackward.clone();
}

void Exemplar::use(const PatchKernels& kernels) {
  for (ExemplarLevel& level : levels_) level.use(kernels);
}

void Exemplar::finish(ExtentUnit unit) {
  if (!scaleIsSet_) extentScale_ = extents_.scale(unit);
  for (ExemplarLevel& level : levels_) level.finish(extentScale_);
}

void Exemplar::advance(int count) {
  if (count == 0) return;
  firstFrame_ += count;
  const int dropped = std::min(count, frameCount());
  for (ExemplarLevel& level : levels_) level.dropFirst(dropped);
  for (auto* acc : {&accForward_, &accBackward_}) {
    std::move(acc->begin() + dropped, acc->end(), acc->begin());
  }
}

}  // namespace fluidymation
