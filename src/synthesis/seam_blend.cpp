#include "synthesis/seam_blend.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "fluidymation/core/parallel.h"

namespace fluidymation {
namespace {

constexpr std::size_t kCounts = 3;  ///< lane of a wanted step that says how much it counts

/// How far to go beyond the mean of the neighbours, and how often.
struct Relaxation {
  float factor;
  int sweeps;
};

/// The best factor for a screened Poisson equation on a grid (Young 1954), and as many sweeps as
/// leave about kLeftOver of an error in the long run, with some more, since over-relaxed errors
/// fall late.
Relaxation relaxationFor(float weight) {
  constexpr float kLeftOver = 1.0F / 250.0F;  // of a seam of 10 dE, 0.04 dE
  constexpr int kMore = 2;  // keeps all within 1/100 of elimination, at weights of 0.05 to 100
  // What an error keeps in a sweep of Jacobi's method, at most: four neighbours of five terms
  const float kept = 4.0F * weight / (1.0F + 4.0F * weight);
  const float factor = 2.0F / (1.0F + std::sqrt(1.0F - kept * kept));
  const float keptRelaxed = factor - 1.0F;
  const float sweeps = keptRelaxed > 0.0F ? std::log(kLeftOver) / std::log(keptRelaxed) : 0.0F;
  return {factor, static_cast<int>(std::ceil(sweeps)) + kMore};
}

}  // namespace

Image<Float4> seamChanges(const WantedSteps& steps, float weight) {
  assert(weight >= 0.0F && steps.right.size() == steps.down.size());
  const Size size = steps.right.size();
  Image<Float4> changes(size, Float4{});
  if (weight == 0.0F) return changes;
  const Relaxation relaxation = relaxationFor(weight);

  const auto relax = [&](int x, int y) {
    Float4 sum{};
    float count = 1.0F;
    const auto add = [&](const Float4& step, const Float4& wanted) {
      const float counts = weight * step[kCounts];
      sum += counts * wanted;
      count += counts;
    };
    if (x > 0) {
      const Float4& step = steps.right(x - 1, y);
      add(step, changes(x - 1, y) + step);
    }
    if (y > 0) {
      const Float4& step = steps.down(x, y - 1);
      add(step, changes(x, y - 1) + step);
    }
    if (x + 1 < size.width) add(steps.right(x, y), changes(x + 1, y) - steps.right(x, y));
    if (y + 1 < size.height) add(steps.down(x, y), changes(x, y + 1) - steps.down(x, y));
    Float4& change = changes(x, y);
    change += relaxation.factor * ((1.0F / count) * sum - change);
  };
  for (int sweep = 0; sweep < relaxation.sweeps; ++sweep) {
    for (int color = 0; color < 2; ++color) {
      forEachRow(size.height, [&](int y) {
        for (int x = (y + color) % 2; x < size.width; x += 2) relax(x, y);
      });
    }
  }
  return changes;
}

}  // namespace fluidymation
