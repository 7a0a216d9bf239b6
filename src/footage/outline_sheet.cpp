#include "footage/outline_sheet.h"

#include <algorithm>
#include <cassert>

#include "fluidymation/core/resize.h"
#include "fluidymation/io/png.h"
#include "preview/sheet.h"

namespace fluidymation {
namespace {

constexpr int kLongestCellPx = 400;
constexpr Rgb kOnDark{1.0F, 0.9F, 0.0F};
constexpr Rgb kOnLight{0.9F, 0.0F, 0.6F};

[[nodiscard]] Rgb lineColorOn(Rgb under) {
  constexpr float kMiddleLightness = 55.0F;
  return toLab(under).l < kMiddleLightness ? kOnDark : kOnLight;
}

/// Inside pixels with an outside neighbour take the colour of a line, as the picture round about
/// calls for.
void drawOutline(const Image<float>& coverage, Image<Rgb>& picture) {
  constexpr float kInside = 0.5F;
  const auto isInside = [&](int x, int y) { return coverage.clamped(x, y) >= kInside; };
  for (int y = 0; y < picture.height(); ++y) {
    for (int x = 0; x < picture.width(); ++x) {
      if (!isInside(x, y)) continue;
      const bool isEdge =
          !isInside(x - 1, y) || !isInside(x + 1, y) || !isInside(x, y - 1) || !isInside(x, y + 1);
      if (isEdge) picture(x, y) = lineColorOn(picture(x, y));
    }
  }
}

}  // namespace

OutlineSheet::OutlineSheet(int frameCount) : shown_(evenly(frameCount, kMostFrames)) {}

void OutlineSheet::add(int frame, const Image<Rgb>& picture, const Mask& mask) {
  if (!std::binary_search(shown_.begin(), shown_.end(), frame)) return;
  const Size size = fitted(picture.size(), kLongestCellPx);
  Image<float> coverage(mask.size());
  std::transform(mask.begin(), mask.end(), coverage.begin(),
                 [](std::uint8_t m) { return m != 0 ? 1.0F : 0.0F; });
  Image<Rgb> cell = resize(picture, size);
  drawOutline(resize(coverage, size), cell);
  cells_.push_back(std::move(cell));
}

void OutlineSheet::write(const std::string& path) const {
  assert(!cells_.empty());
  const Image<Rgb> sheet = inRows(cells_);
  Image<Rgba8> bytes(sheet.size());
  std::transform(sheet.begin(), sheet.end(), bytes.begin(), [](Rgb color) {
    return Rgba8{toByte(color.r), toByte(color.g), toByte(color.b), 255};
  });
  writePng(path, bytes);
}

}  // namespace fluidymation
