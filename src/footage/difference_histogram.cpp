#include "footage/difference_histogram.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace fluidymation {
namespace {

constexpr double kBinWidth = 0.125;
constexpr std::size_t kBins = 1200;  // up to 150; the last one has all above
/// CIE76 difference that can just be seen (Mahy, Van Eycken, Oosterlinck 1994).
constexpr double kJustSeen = 2.3;
/// One in 16 000 values of Gaussian grain is larger, where it lies in one channel alone; in three
/// of equal size far fewer.
constexpr double kGrainLevels = 4.0;

[[nodiscard]] double middleOf(std::size_t bin) {
  constexpr double kHalf = 0.5;
  return kBinWidth * (static_cast<double>(bin) + kHalf);
}

/// First bin of the upper class. @return  0 where all is in one bin.
[[nodiscard]] std::size_t otsuSplit(const std::vector<std::int64_t>& counts) {
  double total = 0.0;
  double sum = 0.0;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    total += static_cast<double>(counts[i]);
    sum += static_cast<double>(counts[i]) * std::sqrt(middleOf(i));
  }
  double below = 0.0;
  double sumBelow = 0.0;
  double largest = 0.0;
  std::size_t split = 0;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    below += static_cast<double>(counts[i]);
    sumBelow += static_cast<double>(counts[i]) * std::sqrt(middleOf(i));
    const double above = total - below;
    if (below <= 0.0 || above <= 0.0) continue;
    const double apart = sumBelow / below - (sum - sumBelow) / above;
    const double betweenClasses = below * above * apart * apart;
    if (betweenClasses <= largest) continue;
    largest = betweenClasses;
    split = i + 1;
  }
  return split;
}

}  // namespace

DifferenceHistogram::DifferenceHistogram() : counts_(kBins, 0) {}

void DifferenceHistogram::add(const Image<float>& difference, float grainLevel) {
  for (const float d : difference) {
    const double bin = std::min(static_cast<double>(d) / kBinWidth, static_cast<double>(kBins - 1));
    ++counts_[static_cast<std::size_t>(bin)];
  }
  grainLevels_.push_back(grainLevel);
}

float DifferenceHistogram::automaticThreshold() const {
  double grain = 0.0;
  if (!grainLevels_.empty()) {
    std::vector<float> levels = grainLevels_;
    const auto middle = levels.begin() + static_cast<std::ptrdiff_t>(levels.size() / 2);
    std::nth_element(levels.begin(), middle, levels.end());
    grain = kGrainLevels * static_cast<double>(*middle);
  }
  const double split = kBinWidth * static_cast<double>(otsuSplit(counts_));
  return static_cast<float>(std::max({split, grain, kJustSeen}));
}

}  // namespace fluidymation
