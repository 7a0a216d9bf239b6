#include "fluidymation/synthesis/exemplar.h"

#include <algorithm>
#include <cassert>
#include <limits>

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
      extentsPx_[i] = {guides.extForward(x, y), guides.extBackward(x, y)};
      const Vec2 direction = guides.direction(x, y);
      directions_[i] = {toFixed(direction.x, kDirectionSteps),
                        toFixed(direction.y, kDirectionSteps)};
      segments_[i] = guides.segment(x, y, borderWidthPx_);
      if (!distancesPx.empty()) distancesPx_[i] = distancesPx(x, y);
    }
  });
}

void ExemplarLevel::finish(const ExtentScale& extentScale) {
  comparesAges_ = extentScale.isOfAges();
  extentSteps_ = extentScale.stepsPerUnit();
  forEachRow(size_.height * frameCount_, [&](int row) {
    const int y = row % size_.height;
    const int k = row / size_.height;
    for (int x = 0; x < size_.width; ++x) {
      const Vec2 extentPx = extentsPx_[offset(x, y, k)];
      const std::int16_t forward = toFixed(extentScale(extentPx.x), extentSteps_);
      const std::int16_t backward = toFixed(extentScale(extentPx.y), extentSteps_);
      setTexels(x, y, k, [&](Texel& texel) {
        texel.guides.extForward = forward;
        texel.guides.extBackward = backward;
      });
    }
  });
  std::vector<Vec2>().swap(extentsPx_);
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
  hasAges_ = !guides.age.empty();
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
  if (hasAges_) {
    extentScale_ = ExtentScale::ofAges(static_cast<float>(frameCount() - 1));
  } else if (unit == ExtentUnit::kExemplar) {
    const float meanPx = meanExtentPx();
    if (meanPx > 0.0F) extentScale_ = ExtentScale::boundedAt(kHalfExtentShare * meanPx);
  }
  for (ExemplarLevel& level : levels_) level.finish(extentScale_);
}

float Exemplar::meanExtentPx() const {
  double sum = 0.0;
  std::size_t count = 0;
  const ExemplarLevel& finest = level(0);
  for (int k = 0; k < frameCount(); ++k) {
    for (int y = 0; y < finest.size().height; ++y) {
      for (int x = 0; x < finest.size().width; ++x) {
        if (finest.segment(x, y, k) == Segment::kOutside) continue;
        sum += static_cast<double>(length(accForward(k)(x, y))) +
               static_cast<double>(length(accBackward(k)(x, y)));
        count += 2;
      }
    }
  }
  return count == 0 ? 0.0F : static_cast<float>(sum / static_cast<double>(count));
}

}  // namespace fluidymation
