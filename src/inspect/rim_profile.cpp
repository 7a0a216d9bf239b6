#include "inspect/rim_profile.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>

namespace fluidymation {

void RimProfile::add(const GuideFrame& frame, const Image<Lab>& picture) {
  assert(picture.size() == frame.mask.size());
  const std::size_t inside = countInside(frame.mask);
  if (inside == 0 || inside == frame.mask.pixelCount()) return;  // no edge
  for (int y = 0; y < picture.height(); ++y) {
    for (int x = 0; x < picture.width(); ++x) {
      if (frame.mask(x, y) == 0) continue;
      const auto step = static_cast<std::size_t>(std::max(frame.distance(x, y), 0.0F));
      if (step >= steps_.size()) steps_.resize(step + 1);
      const Lab color = picture(x, y);
      steps_[step].sum[0] += static_cast<double>(color.l);
      steps_[step].sum[1] += static_cast<double>(color.a);
      steps_[step].sum[2] += static_cast<double>(color.b);
      steps_[step].count += 1.0;
    }
  }
}

std::optional<float> RimProfile::rimWidthPx(float borderWidthPx) const {
  double all = 0.0;
  for (const Step& step : steps_) all += step.count;
  const auto isKnown = [&](const Step& step) {
    return step.count >= std::max(1.0, kLeastShare * all);
  };
  // Between pixel centres hard masks know no distance below 1
  const auto first = std::find_if(steps_.begin(), steps_.end(), isKnown);
  const auto end = std::find_if_not(first, steps_.end(), isKnown);
  const auto begin = static_cast<std::size_t>(first - steps_.begin());
  const auto reach = static_cast<std::size_t>(std::ceil(kReach * double{borderWidthPx}));
  const std::size_t depths = std::min(static_cast<std::size_t>(end - steps_.begin()), reach);
  if (depths < begin + 2) return std::nullopt;

  Step deep;
  for (std::size_t i = (begin + depths) / 2; i < depths; ++i) {
    for (std::size_t c = 0; c < deep.sum.size(); ++c) deep.sum[c] += steps_[i].sum[c];
    deep.count += steps_[i].count;
  }
  std::vector<double> differences;
  for (std::size_t i = begin; i < depths; ++i) {
    double squares = 0.0;
    for (std::size_t c = 0; c < deep.sum.size(); ++c) {
      const double difference = steps_[i].sum[c] / steps_[i].count - deep.sum[c] / deep.count;
      squares += difference * difference;
    }
    differences.push_back(std::sqrt(squares));
  }
  const double largest = *std::max_element(differences.begin(), differences.end());
  if (largest < kLeastContrast) return std::nullopt;
  std::size_t settled = differences.size();
  while (settled > 0 && differences[settled - 1] <= kSettledShare * largest) --settled;
  return static_cast<float>(begin + settled);
}

}  // namespace fluidymation
