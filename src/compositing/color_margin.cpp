#include "compositing/color_margin.h"

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "fluidymation/core/geometry.h"

namespace fluidymation {
namespace {

/// Calls `visit(x, y)` for the eight pixels round one, as far as they lie in the image.
template <typename Visit>
void forNeighbors(Size size, Pixel center, const Visit& visit) {
  for (int y = std::max(center.y - 1, 0); y <= std::min(center.y + 1, size.height - 1); ++y) {
    for (int x = std::max(center.x - 1, 0); x <= std::min(center.x + 1, size.width - 1); ++x) {
      if (x != center.x || y != center.y) visit(x, y);
    }
  }
}

template <typename Color>
void spread(Image<Color>& image) {
  const Size size = image.size();
  constexpr std::uint8_t kUnknown = 255;
  Image<std::uint8_t> ring(size, kUnknown);  // 0: painted
  std::vector<Pixel> last;
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      if (image(x, y).a == 0) continue;
      ring(x, y) = 0;
      bool isEdge = false;
      forNeighbors(size, {x, y}, [&](int nx, int ny) { isEdge = isEdge || image(nx, ny).a == 0; });
      if (isEdge) last.push_back({x, y});
    }
  }
  for (int number = 1; number <= kColorMarginPx; ++number) {
    std::vector<Pixel> next;
    for (const Pixel from : last) {
      forNeighbors(size, from, [&](int x, int y) {
        if (ring(x, y) != kUnknown) return;
        ring(x, y) = static_cast<std::uint8_t>(number);
        next.push_back({x, y});
      });
    }
    for (const Pixel to : next) {
      std::uint32_t r = 0;
      std::uint32_t g = 0;
      std::uint32_t b = 0;
      std::uint32_t count = 0;
      forNeighbors(size, to, [&](int x, int y) {
        if (ring(x, y) >= number) return;
        const Color& known = image(x, y);
        r += known.r;
        g += known.g;
        b += known.b;
        ++count;
      });
      using Channel = decltype(Color::r);
      const auto mean = [count](std::uint32_t sum) {
        return static_cast<Channel>((sum + count / 2) / count);
      };
      image(to.x, to.y) = {mean(r), mean(g), mean(b), 0};
    }
    last = std::move(next);
  }
}

}  // namespace

void spreadColors(Image<Rgba8>& image) { spread(image); }

void spreadColors(Image<Rgba16>& image) { spread(image); }

}  // namespace fluidymation
