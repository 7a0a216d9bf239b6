#include "components.h"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "disjoint_sets.h"
#include "fluidymation/core/index.h"

namespace fluidymation {
namespace {

/// Neighbouring inside pixels of one row.
struct Run {
  int y = 0;
  int beginX = 0;
  int endX = 0;
};

/// In row order.
std::vector<Run> findRuns(const Mask& mask) {
  std::vector<Run> runs;
  for (int y = 0; y < mask.height(); ++y) {
    const std::uint8_t* row = mask.row(y);
    const std::uint8_t* end = row + mask.width();
    for (const std::uint8_t* p = row; p != end;) {
      p = std::find_if(p, end, [](std::uint8_t m) { return m != 0; });
      if (p == end) break;
      const std::uint8_t* begin = p;
      p = std::find(p, end, 0);
      runs.push_back({y, static_cast<int>(begin - row), static_cast<int>(p - row)});
    }
  }
  return runs;
}

/// Joins the runs of neighbouring rows that touch, be it by their corners.
DisjointSets joinRuns(const std::vector<Run>& runs) {
  DisjointSets parts(static_cast<int>(runs.size()));
  std::size_t above = 0;
  for (std::size_t here = 0; here < runs.size(); ++here) {
    const Run& run = runs[here];
    const auto isPassed = [&](const Run& other) {
      return other.y < run.y - 1 || (other.y == run.y - 1 && other.endX < run.beginX);
    };
    while (isPassed(runs[above])) ++above;
    for (std::size_t i = above; runs[i].y == run.y - 1 && runs[i].beginX <= run.endX; ++i) {
      parts.join(static_cast<int>(i), static_cast<int>(here));
    }
  }
  return parts;
}

}  // namespace

Components findComponents(const Mask& mask) {
  const std::vector<Run> runs = findRuns(mask);
  DisjointSets parts = joinRuns(runs);
  Components result{Image<int>(mask.size(), -1), 0};
  std::vector<int> labels(runs.size());
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const auto first = at(parts.find(static_cast<int>(i)));
    labels[i] = first == i ? result.count++ : labels[first];
    int* row = result.label.row(runs[i].y);
    std::fill(row + runs[i].beginX, row + runs[i].endX, labels[i]);
  }
  return result;
}

}  // namespace fluidymation
