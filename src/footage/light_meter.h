#pragma once

#include <optional>
#include <vector>

#include "fluidymation/core/color.h"
#include "fluidymation/core/image.h"

namespace fluidymation {

/// Follows the light of a film on what is never painted: the picture is cut into cells, whose mean
/// colours are kept for every frame (7 KB at most).
class LightMeter {
 public:
  explicit LightMeter(const Image<Lab>& bare);

  /// A frame of the bare surface's size (asserted).
  void add(const Image<Lab>& frame);

  /// How much lighter each frame is than the bare surface, as the mean of L (in [-100, 100]), a and
  /// b over the cells that neither hold `everPainted` pixels nor touch such a cell.
  /// @return  one colour a frame; empty where there are too few such cells to tell.
  [[nodiscard]] std::vector<Lab> drift(const Mask& everPainted) const;

 private:
  using Cells = std::vector<Lab>;
  [[nodiscard]] Cells meansOf(const Image<Lab>& picture) const;
  [[nodiscard]] std::vector<std::size_t> unpaintedCells(const Mask& everPainted) const;

  Size size_;
  Size cells_;  ///< along x and y
  Cells bare_;
  std::vector<Cells> frames_;
};

}  // namespace fluidymation
