#include "preview/sheet.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>

namespace fluidymation {
namespace {

constexpr int kGapPx = 4;
constexpr Rgb kGapColor{1.0F, 1.0F, 1.0F};

void place(const Image<Rgb>& picture, int left, int top, Image<Rgb>& onto) {
  for (int y = 0; y < picture.height(); ++y) {
    std::copy_n(picture.row(y), picture.width(), onto.row(top + y) + left);
  }
}

}  // namespace

Size fitted(Size size, int longest) {
  const double scale =
      std::min(1.0, static_cast<double>(longest) / std::max(size.width, size.height));
  const auto even = [scale](int side) {
    return std::max(2, 2 * static_cast<int>(std::lround(0.5 * scale * side)));
  };
  return {even(size.width), even(size.height)};
}

Image<Rgb> besideEachOther(const std::vector<Image<Rgb>>& pictures) {
  assert(!pictures.empty());
  int width = 0;
  int height = 0;
  for (const Image<Rgb>& picture : pictures) {
    width += picture.width() + kGapPx;
    height = std::max(height, picture.height());
  }
  Image<Rgb> all({width - kGapPx, height}, kGapColor);
  int left = 0;
  for (const Image<Rgb>& picture : pictures) {
    place(picture, left, 0, all);
    left += picture.width() + kGapPx;
  }
  return all;
}

Image<Rgb> inRows(const std::vector<Image<Rgb>>& pictures) {
  assert(!pictures.empty());
  constexpr int kColumns = 4;
  const int count = static_cast<int>(pictures.size());
  const int columns = std::min(count, kColumns);
  const int rows = (count + columns - 1) / columns;
  const Size cell = pictures.front().size();
  Image<Rgb> all({columns * (cell.width + kGapPx) - kGapPx, rows * (cell.height + kGapPx) - kGapPx},
                 kGapColor);
  for (int i = 0; i < count; ++i) {
    place(pictures[static_cast<std::size_t>(i)], i % columns * (cell.width + kGapPx),
          i / columns * (cell.height + kGapPx), all);
  }
  return all;
}

std::vector<int> evenly(int count, int most) {
  assert(most >= 2);
  std::vector<int> chosen;
  const int wanted = std::min(count, most);
  chosen.reserve(static_cast<std::size_t>(wanted));
  for (int i = 0; i < wanted; ++i) {
    chosen.push_back(
        wanted == count ? i : static_cast<int>(std::int64_t{i} * (count - 1) / (wanted - 1)));
  }
  return chosen;
}

}  // namespace fluidymation
