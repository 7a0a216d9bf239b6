#include "fluidymation/synthesis/nnf_scaling.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <tuple>
#include <vector>

#include "fluidymation/core/parallel.h"

namespace fluidymation {
namespace {

/// Bins round the circle in which angles count as equal when matches are counted.
constexpr int kAngleBins = 32;

/// What makes two matches of a block equal, and the order of the members.
struct Ballot {
  int frame = 0;
  int y = 0;
  int x = 0;
  int angleBin = 0;
  int member = 0;  ///< index into the block's matches, row order

  [[nodiscard]] auto choice() const { return std::tie(frame, y, x, angleBin); }
  friend bool operator<(const Ballot& a, const Ballot& b) {
    return std::tie(a.frame, a.y, a.x, a.angleBin, a.member) <
           std::tie(b.frame, b.y, b.x, b.angleBin, b.member);
  }
};

int angleBin(const Rotation& rotation) {
  const float turns = rotation.angleRad() / kTwoPi;  // [-1/2, 1/2]
  const int bin = static_cast<int>(std::lround(turns * static_cast<float>(kAngleBins)));
  return (bin + kAngleBins) % kAngleBins;
}

/// The most frequent choice; the one whose first member comes first wins ties.
int winner(std::vector<Ballot>& ballots) {
  std::sort(ballots.begin(), ballots.end());
  std::size_t bestVotes = 0;
  int bestMember = 0;
  for (std::size_t begin = 0; begin < ballots.size();) {
    std::size_t end = begin + 1;
    while (end < ballots.size() && ballots[end].choice() == ballots[begin].choice()) ++end;
    const std::size_t votes = end - begin;
    const int first = ballots[begin].member;
    if (votes > bestVotes || (votes == bestVotes && first < bestMember)) {
      bestVotes = votes;
      bestMember = first;
    }
    begin = end;
  }
  return bestMember;
}

}  // namespace

NearestNeighborField upscale(const NearestNeighborField& coarse, const Image<Segment>& fine) {
  NearestNeighborField nnf(fine.size());
  forEachRow(fine.height(), [&](int y) {
    for (int x = 0; x < fine.width(); ++x) {
      if (fine(x, y) == Segment::kOutside) continue;
      const Match& parent = coarse(x / 2, y / 2);
      if (!parent.exists()) continue;
      const Match doubled{2.0F * parent.x + 0.5F, 2.0F * parent.y + 0.5F, parent.frame,
                          parent.rotation};
      nnf(x, y) =
          doubled.moved({static_cast<float>(x % 2) - 0.5F, static_cast<float>(y % 2) - 0.5F});
    }
  });
  return nnf;
}

NearestNeighborField downscale(const NearestNeighborField& fine, int level) {
  const int block = 1 << level;
  const float centre = 0.5F * static_cast<float>(block - 1);
  const float scale = 1.0F / static_cast<float>(block);
  Size size = fine.size();
  for (int l = 0; l < level; ++l) size = halvedSize(size);

  NearestNeighborField coarse(size);
  parallelFor(size.height, 1, [&](int y) {
    std::vector<Match> matches;
    std::vector<Ballot> ballots;
    for (int x = 0; x < size.width; ++x) {
      matches.clear();
      ballots.clear();
      for (int by = 0; by < block && y * block + by < fine.height(); ++by) {
        for (int bx = 0; bx < block && x * block + bx < fine.width(); ++bx) {
          const Match& match = fine(x * block + bx, y * block + by);
          if (!match.exists()) continue;
          const Match middle =
              match.moved({centre - static_cast<float>(bx), centre - static_cast<float>(by)});
          const Match scaled{(middle.x - centre) * scale, (middle.y - centre) * scale, match.frame,
                             match.rotation};
          ballots.push_back({scaled.frame, scaled.nearestY(), scaled.nearestX(),
                             angleBin(scaled.rotation), static_cast<int>(matches.size())});
          matches.push_back(scaled);
        }
      }
      if (!matches.empty()) coarse(x, y) = matches[static_cast<std::size_t>(winner(ballots))];
    }
  });
  return coarse;
}

}  // namespace fluidymation
