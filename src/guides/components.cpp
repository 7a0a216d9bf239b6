#include "components.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace fluidymation {

Components findComponents(const Mask& mask) {
  Components result{Image<int>(mask.size(), -1), 0};
  std::vector<std::pair<int, int>> open;
  for (int startY = 0; startY < mask.height(); ++startY) {
    for (int startX = 0; startX < mask.width(); ++startX) {
      if (mask(startX, startY) == 0 || result.label(startX, startY) >= 0) continue;
      result.label(startX, startY) = result.count;
      open.emplace_back(startX, startY);
      while (!open.empty()) {
        const auto [x, y] = open.back();
        open.pop_back();
        for (int ny = std::max(y - 1, 0); ny <= std::min(y + 1, mask.height() - 1); ++ny) {
          for (int nx = std::max(x - 1, 0); nx <= std::min(x + 1, mask.width() - 1); ++nx) {
            if (mask(nx, ny) == 0 || result.label(nx, ny) >= 0) continue;
            result.label(nx, ny) = result.count;
            open.emplace_back(nx, ny);
          }
        }
      }
      ++result.count;
    }
  }
  return result;
}

}  // namespace fluidymation
