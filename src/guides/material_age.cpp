#include "fluidymation/guides/material_age.h"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "components.h"
#include "fluidymation/core/index.h"

namespace fluidymation {
namespace {

constexpr int kNone = -1;

}  // namespace

Image<float> TargetAges::next(const Mask& mask) {
  return next(mask, {0, 0, mask.width(), mask.height()});
}

Image<float> TargetAges::next(const Mask& mask, const Box& box) {
  const std::size_t before = countInside(mask_);
  mask_ = recropped(mask_, box_, box);
  ages_ = recropped(ages_, box_, box);
  box_ = box;
  const bool isCut = countInside(mask_) != before;
  const bool isSame = !isCut && std::equal(mask.begin(), mask.end(), mask_.begin());
  grown_ = !isFirst_ && !isSame;
  isFirst_ = false;
  for (std::size_t i = 0; i < mask.pixelCount(); ++i) {
    float& age = ages_.data()[i];
    const bool stays = mask.data()[i] != 0 && mask_.data()[i] != 0;
    if (!stays) {
      age = 0.0F;
    } else if (grown_) {
      age += 1.0F;
    }
  }
  mask_ = mask.clone();
  return ages_.clone();
}

Image<float> FilmAges::next(const Mask& mask) {
  if (births_.empty()) births_ = Image<int>(mask.size(), kNone);
  const Components parts = findComponents(mask);
  std::vector<int> earliest(at(parts.count), frame_);
  for (std::size_t i = 0; i < mask.pixelCount(); ++i) {
    if (mask.data()[i] == 0 || births_.data()[i] == kNone) continue;
    int& birth = earliest[at(parts.label.data()[i])];
    birth = std::min(birth, births_.data()[i]);
  }
  Image<float> ages(mask.size());
  for (std::size_t i = 0; i < mask.pixelCount(); ++i) {
    int& birth = births_.data()[i];
    if (mask.data()[i] == 0) {
      birth = kNone;
      continue;
    }
    if (birth == kNone) birth = earliest[at(parts.label.data()[i])];
    ages.data()[i] = static_cast<float>(frame_ - birth);
  }
  ++frame_;
  return ages;
}

}  // namespace fluidymation
