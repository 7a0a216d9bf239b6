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
/// The length of a vector of Gaussian noise exceeds four times its median once in a million at
/// most.
constexpr double kMediansOfGrain = 4.0;

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

/// Median of the differences in the first `bins` bins.
[[nodiscard]] double medianBelow(const std::vector<std::int64_t>& counts, std::size_t bins) {
  std::int64_t total = 0;
  for (std::size_t i = 0; i < bins; ++i) total += counts[i];
  std::int64_t below = 0;
  for (std::size_t i = 0; i < bins; ++i) {
    below += counts[i];
    if (2 * below >= total) return middleOf(i);
  }
  return 0.0;
}

}  // namespace

DifferenceHistogram::DifferenceHistogram() : counts_(kBins, 0) {}

void DifferenceHistogram::add(const Image<float>& difference) {
  for (const float d : difference) {
    const double bin = std::min(static_cast<double>(d) / kBinWidth, static_cast<double>(kBins - 1));
    ++counts_[static_cast<std::size_t>(bin)];
  }
}

float DifferenceHistogram::automaticThreshold() const {
  const std::size_t split = otsuSplit(counts_);
  const double grain = split == 0 ? 0.0 : kMediansOfGrain * medianBelow(counts_, split);
  return static_cast<float>(std::max({kBinWidth * static_cast<double>(split), grain, kJustSeen}));
}

}  // namespace fluidymation
