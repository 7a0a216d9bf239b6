#include "region_graph.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

#include "fluidymation/core/index.h"

namespace fluidymation {
namespace {

constexpr std::array<std::pair<int, int>, 4> kNeighbours = {{{-1, 0}, {1, 0}, {0, -1}, {0, 1}}};

bool isRed(int blockX, int blockY) { return ((blockX + blockY) & 1) == 0; }

/// Interior pixels that are connected to a border pixel, by flooding inwards from the border.
Mask solvablePixels(const Mask& region, const Mask& isBorder) {
  Mask solvable(region.size());
  std::vector<std::pair<int, int>> open;
  const auto visitNeighbours = [&](int x, int y) {
    for (const auto& [dx, dy] : kNeighbours) {
      const int nx = x + dx;
      const int ny = y + dy;
      if (!region.contains(nx, ny) || region(nx, ny) == 0 || isBorder(nx, ny) != 0) continue;
      if (solvable(nx, ny) != 0) continue;
      solvable(nx, ny) = 1;
      open.emplace_back(nx, ny);
    }
  };
  for (int y = 0; y < region.height(); ++y) {
    for (int x = 0; x < region.width(); ++x) {
      if (isBorder(x, y) == 0) continue;
      visitNeighbours(x, y);
      while (!open.empty()) {
        const auto [openX, openY] = open.back();
        open.pop_back();
        visitNeighbours(openX, openY);
      }
    }
  }
  return solvable;
}

/// Sets of unknowns that grow together.
class DisjointSets {
 public:
  explicit DisjointSets(int count) : parent_(at(count)) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }
  int find(int i) {
    while (parent_[at(i)] != i) {
      parent_[at(i)] = parent_[at(parent_[at(i)])];
      i = parent_[at(i)];
    }
    return i;
  }
  void join(int i, int j) {
    const int a = find(i);
    const int b = find(j);
    parent_[at(std::max(a, b))] = std::min(a, b);
  }

 private:
  std::vector<int> parent_;
};

/// Numbers the sets of linked unknowns that share a block of twice the side: red before black.
void numberParents(GraphLevel& fine, GraphLevel& coarse) {
  DisjointSets sets(fine.count());
  for (int i = 0; i < fine.count(); ++i) {
    for (int link = fine.firstLink[at(i)]; link < fine.firstLink[at(i) + 1]; ++link) {
      const int j = fine.linkTo[at(link)];
      if (j < i && fine.blockX[at(i)] / 2 == fine.blockX[at(j)] / 2 &&
          fine.blockY[at(i)] / 2 == fine.blockY[at(j)] / 2) {
        sets.join(i, j);
      }
    }
  }
  fine.parent.assign(at(fine.count()), -1);
  for (const bool red : {true, false}) {
    for (int i = 0; i < fine.count(); ++i) {
      const int blockX = fine.blockX[at(i)] / 2;
      const int blockY = fine.blockY[at(i)] / 2;
      if (isRed(blockX, blockY) != red) continue;
      int& number = fine.parent[at(sets.find(i))];  // the root is the set's first: it comes first
      if (number < 0) {
        number = static_cast<int>(coarse.blockX.size());
        coarse.blockX.push_back(blockX);
        coarse.blockY.push_back(blockY);
      }
      fine.parent[at(i)] = number;
    }
    if (red) coarse.redCount = static_cast<int>(coarse.blockX.size());
  }
}

/// Flux per difference between coarse unknowns, seen as pieces of sheet: one over the resistance.
/// Sums of the fine weights (Galerkin) would be too stiff for interpolated corrections, by a factor
/// of 2 a level; too soft a link would overshoot, without bound where two large blocks touch in a
/// single pixel.
///
/// A block with `pixels` pixels is on average pixels / side wide. Through its length it resists by
/// length / width; a passage narrower than that adds the spreading of the flux around it.
constexpr float kSpreading = 0.64F;  // 2 / pi: flux that converges to a point of a straight edge

float spreading(float width, float pairs) {
  return width > pairs ? kSpreading * std::log(width / pairs) : 0.0F;
}

/// Between the centres of two neighbouring blocks, one side apart.
float linkFlux(float pairs, float pixels, float side) {
  const float width = pixels / side;
  return 1.0F / (side / std::max(width, pairs) + spreading(width, pairs));
}

/// From the border, half a pixel beyond the last unknown pixel, to the centre of a block. Thin
/// parts have more border than a block's side, and no pixel far from it.
float borderFlux(float pairs, float pixels, float side) {
  const float width = pixels / side;
  const float depth = pairs < width ? side / width : pixels / (pairs * pairs);
  return 1.0F / (0.5F / pairs + 0.5F * depth + spreading(width, pairs));
}

void listChildren(const GraphLevel& fine, GraphLevel& coarse) {
  coarse.firstChild.assign(coarse.blockX.size() + 1, 0);
  for (const int parent : fine.parent) ++coarse.firstChild[at(parent) + 1];
  std::partial_sum(coarse.firstChild.begin(), coarse.firstChild.end(), coarse.firstChild.begin());
  std::vector<int> next(coarse.firstChild.begin(), coarse.firstChild.end() - 1);
  coarse.child.resize(fine.parent.size());
  for (int i = 0; i < fine.count(); ++i) coarse.child[at(next[at(fine.parent[at(i)])]++)] = i;
}

}  // namespace

GraphLevel finestGraph(const Mask& region, const Mask& isBorder, Image<int>& unknownAt) {
  GraphLevel level;
  const Mask solvable = solvablePixels(region, isBorder);
  unknownAt = Image<int>(region.size(), -1);
  for (const bool red : {true, false}) {
    for (int y = 0; y < region.height(); ++y) {
      for (int x = 0; x < region.width(); ++x) {
        if (solvable(x, y) == 0 || isRed(x, y) != red) continue;
        unknownAt(x, y) = static_cast<int>(level.blockX.size());
        level.blockX.push_back(x);
        level.blockY.push_back(y);
      }
    }
    if (red) level.redCount = static_cast<int>(level.blockX.size());
  }

  const std::size_t count = level.blockX.size();
  level.firstLink.push_back(0);
  level.firstLink.reserve(count + 1);
  level.linkTo.reserve(4 * count);
  level.givenPairs.reserve(count);
  level.diagonal.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    int given = 0;
    for (const auto& [dx, dy] : kNeighbours) {
      const int x = level.blockX[i] + dx;
      const int y = level.blockY[i] + dy;
      if (!region.contains(x, y)) continue;
      if (isBorder(x, y) != 0) ++given;
      if (unknownAt(x, y) >= 0) level.linkTo.push_back(unknownAt(x, y));
    }
    const int links = static_cast<int>(level.linkTo.size()) - level.firstLink.back();
    level.firstLink.push_back(static_cast<int>(level.linkTo.size()));
    level.givenPairs.push_back(static_cast<float>(given));
    level.diagonal.push_back(static_cast<float>(given + links));
  }
  level.linkWeight.assign(level.linkTo.size(), 1.0F);
  level.linkPairs.assign(level.linkTo.size(), 1.0F);
  level.pixelCount.assign(count, 1.0F);
  return level;
}

GraphLevel coarserLevel(GraphLevel& fine, int blockSide) {
  GraphLevel coarse;
  numberParents(fine, coarse);
  listChildren(fine, coarse);
  const std::size_t count = coarse.blockX.size();
  const auto side = static_cast<float>(blockSide);
  coarse.firstLink.push_back(0);
  std::vector<int> linkOf(count, -1);  // the link of the current unknown that leads to this one
  for (std::size_t i = 0; i < count; ++i) {
    const int begin = coarse.firstLink.back();
    float given = 0.0F;
    float pixels = 0.0F;
    for (int c = coarse.firstChild[i]; c < coarse.firstChild[i + 1]; ++c) {
      const std::size_t child = at(coarse.child[at(c)]);
      given += fine.givenPairs[child];
      pixels += fine.pixelCount[child];
      for (int link = fine.firstLink[child]; link < fine.firstLink[child + 1]; ++link) {
        const int to = fine.parent[at(fine.linkTo[at(link)])];
        if (to == static_cast<int>(i)) continue;
        if (linkOf[at(to)] < begin) {
          linkOf[at(to)] = static_cast<int>(coarse.linkTo.size());
          coarse.linkTo.push_back(to);
          coarse.linkPairs.push_back(0.0F);
        }
        coarse.linkPairs[at(linkOf[at(to)])] += fine.linkPairs[at(link)];
      }
    }

    coarse.givenPairs.push_back(given);
    coarse.pixelCount.push_back(pixels);
    coarse.firstLink.push_back(static_cast<int>(coarse.linkTo.size()));
  }

  for (std::size_t i = 0; i < count; ++i) {
    const float given = coarse.givenPairs[i];
    float diagonal = given > 0.0F ? borderFlux(given, coarse.pixelCount[i], side) : 0.0F;
    for (std::size_t l = at(coarse.firstLink[i]); l < at(coarse.firstLink[i + 1]); ++l) {
      const float pixels = std::min(coarse.pixelCount[i], coarse.pixelCount[at(coarse.linkTo[l])]);
      coarse.linkWeight.push_back(linkFlux(coarse.linkPairs[l], pixels, side));
      diagonal += coarse.linkWeight.back();
    }
    coarse.diagonal.push_back(diagonal);
  }
  return coarse;
}

}  // namespace fluidymation
