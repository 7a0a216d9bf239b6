#include "compositing/quilt.h"

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <limits>
#include <vector>

#include "fluidymation/core/geometry.h"
#include "fluidymation/core/index.h"
#include "fluidymation/core/random.h"

namespace fluidymation {
namespace {

// None of these is measured; Efros and Freeman leave the block's size to the user, as the one thing
// that has to be as large as what a texture consists of.

/// Smallest block, px a side: its overlap of 4 px is the least in which a cut has some ways to go.
constexpr int kLeastSidePx = 16;
/// A block is at most this part of the texture's shorter side, so that there are places to choose
/// from: along each side it has two thirds of the texture to lie in.
constexpr int kBlocksPerTextureSide = 3;
/// A block laps over this part of its side over the one before; Efros and Freeman take a sixth.
/// Blocks here are small, and a sixth of the smallest would be 2 px.
constexpr int kOverlapsPerBlockSide = 4;
/// Wanted places for blocks, in areas of a block: blocks are halved until there are as many. Four
/// areas are what a bare square of three blocks' side has, (3 - 1)^2; places that overlap each
/// other more than that would all show the same.
constexpr int kPlacesPerBlockArea = 4;
/// Places for the smallest blocks that are enough where there are no more: about as many as are
/// tried for one block, so that not every block shows the same few.
constexpr std::size_t kFewestPlaces = 64;
/// Places drawn at random that a block is the best fitting of: with so many, one of the best
/// twentieth is among them in 95 of 100 blocks (1 - 0.95^60 = 0.954). Efros and Freeman try all
/// and draw among those within a tenth of the best.
constexpr int kTriedPlaces = 60;

[[nodiscard]] float squaredDifference(Rgb a, Rgb b) {
  const float r = a.r - b.r;
  const float g = a.g - b.g;
  const float blue = a.b - b.b;
  return r * r + g * g + blue * blue;
}

/// Upper left corners of all blocks of `side` px that hold usable pixels only.
[[nodiscard]] std::vector<Pixel> placesFor(const Mask& usable, int side) {
  std::vector<Pixel> places;
  // How many rows, up to this one, are usable at each column without a gap
  std::vector<int> above(at(usable.width()), 0);
  for (int y = 0; y < usable.height(); ++y) {
    int along = 0;  // columns in a row that are usable `side` px up
    for (int x = 0; x < usable.width(); ++x) {
      above[at(x)] = usable(x, y) != 0 ? above[at(x)] + 1 : 0;
      along = above[at(x)] >= side ? along + 1 : 0;
      if (along >= side) places.push_back({x - side + 1, y - side + 1});
    }
  }
  return places;
}

/// Puts blocks into a picture, row by row.
class Quilt {
 public:
  Quilt(const Image<Rgb>& texture, int side, Size size)
      : texture_(texture), side_(side), overlap_(side / kOverlapsPerBlockSide), picture_(size) {}

  [[nodiscard]] int step() const { return side_ - overlap_; }

  /// How badly the texture's block at `from` fits to what lies round `to`.
  [[nodiscard]] float misfit(Pixel from, Pixel to, float worst) const {
    float sum = 0.0F;
    for (int y = 0; y < side_ && sum < worst; ++y) {
      const int until = to.y > 0 && y < overlap_ ? side_ : (to.x > 0 ? overlap_ : 0);
      for (int x = 0; x < until; ++x) {
        if (picture_.contains(to.x + x, to.y + y)) sum += difference(from, to, x, y);
      }
    }
    return sum;
  }

  /// Lays the block over what is there, right of and below the lines that show least.
  void put(Pixel from, Pixel to) {
    const std::vector<int> left = to.x > 0 ? cut(from, to, true) : std::vector<int>(at(side_), 0);
    const std::vector<int> top = to.y > 0 ? cut(from, to, false) : std::vector<int>(at(side_), 0);
    for (int y = 0; y < side_; ++y) {
      for (int x = 0; x < side_; ++x) {
        if (x < left[at(y)] || y < top[at(x)] || !picture_.contains(to.x + x, to.y + y)) continue;
        picture_(to.x + x, to.y + y) = texture_(from.x + x, from.y + y);
      }
    }
  }

  [[nodiscard]] Image<Rgb> take() { return std::move(picture_); }

 private:
  [[nodiscard]] float difference(Pixel from, Pixel to, int x, int y) const {
    return squaredDifference(texture_(from.x + x, from.y + y), picture_(to.x + x, to.y + y));
  }

  /// The way through the overlap at the block's left side (`down`) or its top, from end to end,
  /// along which old and new differ least: a place across it for each one along it.
  [[nodiscard]] std::vector<int> cut(Pixel from, Pixel to, bool down) const {
    const auto cost = [&](int along, int across) {
      const Pixel p = down ? Pixel{across, along} : Pixel{along, across};
      // Outside of the picture all ways are alike
      return picture_.contains(to.x + p.x, to.y + p.y) ? difference(from, to, p.x, p.y) : 0.0F;
    };
    Image<float> sums({overlap_, side_});
    for (int along = 0; along < side_; ++along) {
      for (int across = 0; across < overlap_; ++across) {
        float before = 0.0F;
        if (along > 0) {
          before = sums(across, along - 1);
          if (across > 0) before = std::min(before, sums(across - 1, along - 1));
          if (across + 1 < overlap_) before = std::min(before, sums(across + 1, along - 1));
        }
        sums(across, along) = before + cost(along, across);
      }
    }
    std::vector<int> way(at(side_));
    const float* const last = sums.row(side_ - 1);
    int place = static_cast<int>(std::min_element(last, last + overlap_) - last);
    for (int along = side_ - 1; along >= 0; --along) {
      way[at(along)] = place;
      if (along == 0) break;
      const float* const row = sums.row(along - 1);
      const float* const begin = row + std::max(place - 1, 0);
      const float* const end = row + std::min(place + 2, overlap_);
      place = static_cast<int>(std::min_element(begin, end) - row);
    }
    return way;
  }

  const Image<Rgb>& texture_;
  int side_;
  int overlap_;
  Image<Rgb> picture_;
};

}  // namespace

std::optional<Image<Rgb>> quilted(const Image<Rgb>& texture, const Mask& usable, Size size) {
  assert(texture.size() == usable.size());
  int side =
      std::max(kLeastSidePx, std::min(texture.width(), texture.height()) / kBlocksPerTextureSide);
  std::vector<Pixel> places = placesFor(usable, side);
  while (places.size() < at(kPlacesPerBlockArea * side * side) && side / 2 >= kLeastSidePx) {
    side /= 2;
    places = placesFor(usable, side);
  }
  if (places.size() < kFewestPlaces) return std::nullopt;
  Quilt quilt(texture, side, size);
  for (int y = 0; y < size.height; y += quilt.step()) {
    for (int x = 0; x < size.width; x += quilt.step()) {
      Random random({0, 0, 0, 0, x, y});
      Pixel best = places.front();
      float least = std::numeric_limits<float>::max();
      for (int i = 0; i < kTriedPlaces; ++i) {
        const Pixel place = places[random.below(places.size())];
        const float misfit = quilt.misfit(place, {x, y}, least);
        if (misfit >= least) continue;
        least = misfit;
        best = place;
      }
      quilt.put(best, {x, y});
    }
  }
  return quilt.take();
}

}  // namespace fluidymation
