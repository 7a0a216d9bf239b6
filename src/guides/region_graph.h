#pragma once

#include <vector>

#include "fluidymation/core/image.h"

namespace fluidymation {

/// One of the coarser levels of the multigrid hierarchy: unknowns and how they are linked. On the
/// finest level, `PixelLevel`, an unknown is an interior pixel; on level l it is a connected set of
/// interior pixels within one block of 2^l x 2^l. A block crossed by two parts that do not touch in
/// it holds two unknowns, so that no level joins what is separate.
///
/// Unknowns of even blocks (x + y even, "red") come before those of odd ones ("black"). Links lead
/// only to 4-neighbouring blocks, hence from red to black or back on every level: Gauss-Seidel may
/// update all of one colour at once, and the order of threads cannot show.
struct GraphLevel {
  int redCount = 0;
  std::vector<int> blockX;
  std::vector<int> blockY;
  std::vector<int> firstLink;     ///< links of i: firstLink[i] .. firstLink[i + 1] - 1
  std::vector<int> linkTo;        ///< the unknown at the other end
  std::vector<float> linkWeight;  ///< flux per difference
  std::vector<float> linkPairs;   ///< pairs of neighbouring pixels the link stands for
  std::vector<float> diagonal;    ///< all link weights plus that of the given values
  std::vector<float> givenPairs;  ///< pairs (pixel of this unknown, border pixel)
  std::vector<float> pixelCount;  ///< pixels in this unknown
  std::vector<int> parent;        ///< unknown of the next coarser level; empty on the coarsest
  std::vector<int> firstChild;    ///< as firstLink
  std::vector<int> child;         ///< unknowns of the next finer level

  [[nodiscard]] int count() const { return static_cast<int>(diagonal.size()); }
};

/// Fills in `firstChild` and `child`: the members of each coarse unknown, in order.
void listChildren(const std::vector<int>& parent, GraphLevel& coarse);

/// Lists the links of a coarser level, one unknown after the other, each unknown's in the order in
/// which they turn up.
class LinkCollector {
 public:
  /// @param coarse  its `blockX` tells how many unknowns there will be.
  explicit LinkCollector(GraphLevel& coarse);

  /// `pairs` more pairs of neighbouring pixels between the current unknown and `to`; nothing where
  /// these are the same.
  void add(int to, float pairs);

  /// All links of the current unknown are known.
  void endUnknown();

 private:
  GraphLevel& coarse_;
  std::vector<int> linkOf_;  ///< the link of the current unknown that leads to this one
  int current_ = 0;
};

/// Fills in `linkWeight` and `diagonal`. @param blockSide  of the level's blocks, px.
void weighLinks(GraphLevel& coarse, int blockSide);

/// The next coarser level of `fine`, whose `parent` is filled in. `blockSide` is the side of the
/// coarser blocks in pixels.
[[nodiscard]] GraphLevel coarserLevel(GraphLevel& fine, int blockSide);

}  // namespace fluidymation
