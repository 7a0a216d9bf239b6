#include "fluidymation/guides/outline_distance.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <vector>

#include "fluidymation/core/parallel.h"

namespace fluidymation {
namespace {

/// The crossing between a pixel and its lower (or right) neighbour; none where x < 0.
struct Site {
  std::int16_t x = -1;
  std::int16_t y = -1;
};

Image<float> transposed(const Image<float>& image) {
  Image<float> result(Size{image.height(), image.width()});
  forEachRow(result.height(), [&](int y) {
    for (int x = 0; x < result.width(); ++x) result(x, y) = image(y, x);
  });
  return result;
}

/// y of the nearest crossing along the column, -1 in a column that has none.
Image<std::int16_t> nearestInColumn(const Image<float>& down) {
  constexpr int kColumnsAtATime = 64;  // a strip of rows that long stays in the nearest cache
  Image<std::int16_t> nearest(down.size(), std::int16_t{-1});
  const int strips = (down.width() + kColumnsAtATime - 1) / kColumnsAtATime;
  parallelFor(strips, 1, [&](int strip) {
    const int begin = strip * kColumnsAtATime;
    const int end = std::min(begin + kColumnsAtATime, down.width());
    for (int y = 1; y < down.height(); ++y) {
      for (int x = begin; x < end; ++x) {
        nearest(x, y) =
            down(x, y - 1) > 0.0F ? static_cast<std::int16_t>(y - 1) : nearest(x, y - 1);
      }
    }
    std::array<std::int16_t, kColumnsAtATime> below{};
    below.fill(-1);
    for (int y = down.height() - 1; y >= 0; --y) {
      for (int x = begin; x < end; ++x) {
        std::int16_t& candidate = below[static_cast<std::size_t>(x - begin)];
        if (down(x, y) > 0.0F) candidate = static_cast<std::int16_t>(y);
        if (candidate < 0) continue;
        std::int16_t& best = nearest(x, y);
        const auto offset = [&](int row) {
          return std::abs(static_cast<float>(row - y) + down(x, row));
        };
        if (best < 0 || offset(candidate) < offset(best)) best = candidate;
      }
    }
  });
  return nearest;
}

/// The nearest crossing of every pixel: lower envelope of the parabolas (x - i)^2 + height(i)^2,
/// row by row.
/// @param left  x of the first column in the frame. The parabolas meet at places of the frame, so
///   that these are rounded alike in all its parts.
Image<Site> nearestSites(const Image<float>& down, int left) {
  const Image<std::int16_t> column = nearestInColumn(down);
  const int width = down.width();
  Image<Site> nearest(down.size());
  forEachRow(down.height(), [&](int y) {
    struct Piece {
      int centre;
      double height;  ///< squared
      double begin;   ///< lowest from this x on
    };
    std::vector<Piece> pieces;
    for (int i = 0; i < width; ++i) {
      const int row = column(i, y);
      if (row < 0) continue;
      const double offset = static_cast<double>(row - y) + static_cast<double>(down(i, row));
      const double height = offset * offset;
      double begin = 0.0;
      while (!pieces.empty()) {
        const Piece& last = pieces.back();
        const double c = left + last.centre;
        const double here = left + i;
        begin = 0.5 * ((height - last.height) / (here - c) + here + c);
        if (begin > last.begin) break;
        pieces.pop_back();
        begin = 0.0;
      }
      pieces.push_back({i, height, begin});
    }
    std::size_t piece = 0;
    for (int x = 0; x < width && !pieces.empty(); ++x) {
      while (piece + 1 < pieces.size() && pieces[piece + 1].begin <= left + x) ++piece;
      const int i = pieces[piece].centre;
      nearest(x, y) = {static_cast<std::int16_t>(i), column(i, y)};
    }
  });
  return nearest;
}

/// The outline as line segments, one or two in each square between four pixel centres.
class Polygon {
 public:
  Polygon(const Mask& mask, const Crossings& crossings) : mask_(mask), crossings_(crossings) {}

  /// Square of the distance from pixel (x, y) to the segments that meet between pixel (u, v) and
  /// its lower neighbour.
  [[nodiscard]] float toDown(int x, int y, int u, int v) const {
    const Vec2 corner{static_cast<float>(u - x), static_cast<float>(v - y) + crossings_.down(u, v)};
    const bool isLast = u == 0 || u + 1 == mask_.width();
    return std::min(toPartner(x, y, corner, u - 1, v, Side::kRight, isLast),
                    toPartner(x, y, corner, u, v, Side::kLeft, isLast));
  }

  /// The same between (u, v) and its right neighbour.
  [[nodiscard]] float toRight(int x, int y, int u, int v) const {
    const Vec2 corner{static_cast<float>(u - x) + crossings_.right(u, v),
                      static_cast<float>(v - y)};
    const bool isLast = v == 0 || v + 1 == mask_.height();
    return std::min(toPartner(x, y, corner, u, v - 1, Side::kBottom, isLast),
                    toPartner(x, y, corner, u, v, Side::kTop, isLast));
  }

 private:
  enum class Side { kTop, kRight, kBottom, kLeft };

  /// How far, px, the outline goes on past its last corner: for the pixels near by, which what lies
  /// outside the frame cuts. From further away its direction, which is less exact, would show.
  static float pastTheFrame(Vec2 corner) { return std::clamp(2.0F - length(corner), 0.0F, 1.0F); }

  /// Where the segment that enters the square with upper left pixel (u, v) by `side` leaves it.
  [[nodiscard]] Side partner(int u, int v, Side side) const {
    const bool top = crossings_.right(u, v) > 0.0F;
    const bool bottom = crossings_.right(u, v + 1) > 0.0F;
    const bool left = crossings_.down(u, v) > 0.0F;
    const bool right = crossings_.down(u + 1, v) > 0.0F;
    if (top && bottom && left && right) {
      // Inside pixels that touch at a corner are connected, so the outside ones are cut off
      const bool cutsUpperLeft = mask_(u, v) == 0;
      switch (side) {
        case Side::kTop:
          return cutsUpperLeft ? Side::kLeft : Side::kRight;
        case Side::kLeft:
          return cutsUpperLeft ? Side::kTop : Side::kBottom;
        case Side::kBottom:
          return cutsUpperLeft ? Side::kRight : Side::kLeft;
        case Side::kRight:
          return cutsUpperLeft ? Side::kBottom : Side::kTop;
      }
    }
    if (top && side != Side::kTop) return Side::kTop;
    if (right && side != Side::kRight) return Side::kRight;
    if (bottom && side != Side::kBottom) return Side::kBottom;
    assert(left && side != Side::kLeft);
    return Side::kLeft;
  }

  /// From pixel (x, y) to the segment from `corner`, relative to it, through a square; at the edge
  /// of the image, where there is no square, to the corner.
  /// @param isLast  whether the corner is the outline's last: its segment goes on past the edge of
  ///   the image.
  [[nodiscard]] float toPartner(int x, int y, Vec2 corner, int u, int v, Side side,
                                bool isLast) const {
    if (u < 0 || v < 0 || u + 1 >= mask_.width() || v + 1 >= mask_.height()) {
      return dot(corner, corner);
    }
    Vec2 other{static_cast<float>(u - x), static_cast<float>(v - y)};
    switch (partner(u, v, side)) {
      case Side::kTop:
        other += {crossings_.right(u, v), 0.0F};
        break;
      case Side::kRight:
        other += {1.0F, crossings_.down(u + 1, v)};
        break;
      case Side::kBottom:
        other += {crossings_.right(u, v + 1), 1.0F};
        break;
      case Side::kLeft:
        other += {0.0F, crossings_.down(u, v)};
        break;
    }
    const Vec2 along = other - corner;
    const float squaredLength = dot(along, along);
    if (squaredLength == 0.0F) return dot(corner, corner);
    const float first = isLast ? -pastTheFrame(corner) / std::sqrt(squaredLength) : 0.0F;
    const float share = std::clamp(-dot(corner, along) / squaredLength, first, 1.0F);
    const Vec2 nearest = corner + share * along;
    return dot(nearest, nearest);
  }

  const Mask& mask_;
  const Crossings& crossings_;
};

}  // namespace

Image<float> outlineDistance(const Mask& mask, const Outline& outline, Pixel origin) {
  assert(outline.crossingCount() > 0);
  const Crossings crossings = outline.crossings(mask);
  const Polygon polygon(mask, crossings);
  const Image<Site> onVertical = nearestSites(crossings.down, origin.x);
  const Image<Site> onHorizontal = nearestSites(transposed(crossings.right), origin.y);
  Image<float> distance(mask.size());
  forEachRow(mask.height(), [&](int y) {
    for (int x = 0; x < mask.width(); ++x) {
      const Site vertical = onVertical(x, y);
      const Site horizontal = onHorizontal(y, x);
      float squared = INFINITY;
      if (vertical.x >= 0) squared = polygon.toDown(x, y, vertical.x, vertical.y);
      if (horizontal.x >= 0) {
        squared = std::min(squared, polygon.toRight(x, y, horizontal.y, horizontal.x));
      }
      distance(x, y) = mask(x, y) != 0 ? std::sqrt(squared) : -std::sqrt(squared);
    }
  });
  return distance;
}

Image<float> pixelCentreDistance(const Mask& mask, const Image<float>& distance) {
  Image<float> result(mask.size());
  forEachRow(mask.height(), [&](int y) {
    for (int x = 0; x < mask.width(); ++x) {
      result(x, y) = distance(x, y) + (mask(x, y) != 0 ? 0.5F : -0.5F);
    }
  });
  return result;
}

}  // namespace fluidymation
