#include "region_graph.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

#include "disjoint_sets.h"
#include "fluidymation/core/index.h"

namespace fluidymation {
namespace {

bool isRed(int blockX, int blockY) { return ((blockX + blockY) & 1) == 0; }

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

}  // namespace

void listChildren(const std::vector<int>& parent, GraphLevel& coarse) {
  coarse.firstChild.assign(coarse.blockX.size() + 1, 0);
  for (const int number : parent) ++coarse.firstChild[at(number) + 1];
  std::partial_sum(coarse.firstChild.begin(), coarse.firstChild.end(), coarse.firstChild.begin());
  std::vector<int> next(coarse.firstChild.begin(), coarse.firstChild.end() - 1);
  coarse.child.resize(parent.size());
  for (std::size_t i = 0; i < parent.size(); ++i) {
    coarse.child[at(next[at(parent[i])]++)] = static_cast<int>(i);
  }
}

LinkCollector::LinkCollector(GraphLevel& coarse)
    : coarse_(coarse), linkOf_(coarse.blockX.size(), -1) {
  constexpr std::size_t kUsualLinks = 4;  // to the blocks beside
  coarse_.firstLink.reserve(linkOf_.size() + 1);
  coarse_.firstLink.push_back(0);
  coarse_.linkTo.reserve(kUsualLinks * linkOf_.size());
  coarse_.linkPairs.reserve(kUsualLinks * linkOf_.size());
}

void LinkCollector::add(int to, float pairs) {
  if (to == current_) return;
  if (linkOf_[at(to)] < coarse_.firstLink.back()) {
    linkOf_[at(to)] = static_cast<int>(coarse_.linkTo.size());
    coarse_.linkTo.push_back(to);
    coarse_.linkPairs.push_back(0.0F);
  }
  coarse_.linkPairs[at(linkOf_[at(to)])] += pairs;
}

void LinkCollector::endUnknown() {
  coarse_.firstLink.push_back(static_cast<int>(coarse_.linkTo.size()));
  ++current_;
}

void weighLinks(GraphLevel& coarse, int blockSide) {
  const auto side = static_cast<float>(blockSide);
  const std::size_t count = coarse.blockX.size();
  coarse.linkWeight.reserve(coarse.linkTo.size());
  coarse.diagonal.reserve(count);
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
}

GraphLevel coarserLevel(GraphLevel& fine, int blockSide) {
  GraphLevel coarse;
  numberParents(fine, coarse);
  listChildren(fine.parent, coarse);
  LinkCollector links(coarse);
  for (std::size_t i = 0; i < coarse.blockX.size(); ++i) {
    float given = 0.0F;
    float pixels = 0.0F;
    for (int c = coarse.firstChild[i]; c < coarse.firstChild[i + 1]; ++c) {
      const std::size_t child = at(coarse.child[at(c)]);
      given += fine.givenPairs[child];
      pixels += fine.pixelCount[child];
      for (int link = fine.firstLink[child]; link < fine.firstLink[child + 1]; ++link) {
        links.add(fine.parent[at(fine.linkTo[at(link)])], fine.linkPairs[at(link)]);
      }
    }
    coarse.givenPairs.push_back(given);
    coarse.pixelCount.push_back(pixels);
    links.endUnknown();
  }
  weighLinks(coarse, blockSide);
  return coarse;
}

}  // namespace fluidymation
