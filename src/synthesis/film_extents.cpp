#include "fluidymation/synthesis/film_extents.h"

#include "fluidymation/core/geometry.h"

namespace fluidymation {

void FilmExtents::add(const GuideFrame& guides) {
  ++frames_;
  haveAges_ = !guides.age.empty();
  for (int y = 0; y < guides.mask.height(); ++y) {
    for (int x = 0; x < guides.mask.width(); ++x) {
      if (guides.mask(x, y) == 0) continue;
      sumPx_ += static_cast<double>(length(guides.accForward(x, y))) +
                static_cast<double>(length(guides.accBackward(x, y)));
      count_ += 2;
    }
  }
}

ExtentScale FilmExtents::scale(ExtentUnit unit) const {
  if (haveAges_) return ExtentScale::ofAges(static_cast<float>(frames_ - 1));
  if (unit == ExtentUnit::kPixels || meanPx() <= 0.0F) return {};
  return ExtentScale::boundedAt(kHalfExtentShare * meanPx());
}

float FilmExtents::meanPx() const {
  return count_ == 0 ? 0.0F : static_cast<float>(sumPx_ / static_cast<double>(count_));
}

}  // namespace fluidymation
