#pragma once

#include <algorithm>
#include <cstdint>

#include "fluidymation/core/geometry.h"
#include "fluidymation/core/image.h"

namespace fluidymation {

/// Half-open rectangle of pixels; empty where an end does not lie behind its begin.
struct Box {
  int beginX = 0;
  int beginY = 0;
  int endX = 0;
  int endY = 0;

  [[nodiscard]] Pixel begin() const { return {beginX, beginY}; }
  [[nodiscard]] Size size() const { return {endX - beginX, endY - beginY}; }
  [[nodiscard]] bool empty() const { return endX <= beginX || endY <= beginY; }

  friend bool operator==(const Box& a, const Box& b) {
    return a.beginX == b.beginX && a.beginY == b.beginY && a.endX == b.endX && a.endY == b.endY;
  }
};

/// Some pixels of a row, one beside the other.
struct RowSpan {
  int begin = 0;
  int end = 0;  ///< exclusive
};

/// The box grown by `margin` pixels on every side, as far as an image of `size` reaches. An empty
/// box stays empty.
[[nodiscard]] inline Box grown(const Box& box, int margin, Size size) {
  if (box.empty()) return {};
  return {std::max(box.beginX - margin, 0), std::max(box.beginY - margin, 0),
          std::min(box.endX + margin, size.width), std::min(box.endY + margin, size.height)};
}

/// A box within the part of an image that begins at `origin`, as a box of the image. An empty box
/// stays empty.
[[nodiscard]] inline Box moved(const Box& box, Pixel origin) {
  if (box.empty()) return {};
  return {box.beginX + origin.x, box.beginY + origin.y, box.endX + origin.x, box.endY + origin.y};
}

/// The box with its begin moved to even coordinates, by a pixel at most: blocks of 2x2 pixels then
/// lie within the box as they lie within the image.
[[nodiscard]] inline Box fromEvenPixel(const Box& box) {
  return {box.beginX - box.beginX % 2, box.beginY - box.beginY % 2, box.endX, box.endY};
}

/// The box with its ends moved outwards to multiples of `step`, as far as an image of `size`
/// reaches: blocks of step x step pixels then lie within the box as they lie within the image.
[[nodiscard]] inline Box alignedTo(const Box& box, int step, Size size) {
  const auto up = [step](int end) { return (end + step - 1) / step * step; };
  return {box.beginX - box.beginX % step, box.beginY - box.beginY % step,
          std::min(up(box.endX), size.width), std::min(up(box.endY), size.height)};
}

/// The smallest box that holds two others.
[[nodiscard]] inline Box joined(const Box& a, const Box& b) {
  if (a.empty()) return b;
  if (b.empty()) return a;
  return {std::min(a.beginX, b.beginX), std::min(a.beginY, b.beginY), std::max(a.endX, b.endX),
          std::max(a.endY, b.endY)};
}

/// The smallest box that holds all pixels of which `isInside(value)` holds.
template <typename T, typename IsInside>
[[nodiscard]] Box boundingBox(const Image<T>& image, const IsInside& isInside) {
  Box box{image.width(), image.height(), 0, 0};
  for (int y = 0; y < image.height(); ++y) {
    const T* row = image.row(y);
    const T* end = row + image.width();
    const T* first = std::find_if(row, end, isInside);
    if (first == end) continue;
    const T* last = end - 1;
    while (!isInside(*last)) --last;
    box.beginX = std::min(box.beginX, static_cast<int>(first - row));
    box.endX = std::max(box.endX, static_cast<int>(last - row) + 1);
    box.beginY = std::min(box.beginY, y);
    box.endY = y + 1;
  }
  return box.endY == 0 ? Box{} : box;
}

/// The smallest box that holds all of the mask.
[[nodiscard]] inline Box boundingBox(const Mask& mask) {
  return boundingBox(mask, [](std::uint8_t m) { return m != 0; });
}

/// The part of the image within the box.
template <typename T>
[[nodiscard]] Image<T> cropped(const Image<T>& image, const Box& box) {
  Image<T> part(box.size());
  for (int y = 0; y < part.height(); ++y) {
    std::copy_n(image.row(box.beginY + y) + box.beginX, part.width(), part.row(y));
  }
  return part;
}

/// What of an image that shows `from` lies in `to`; T{} where it shows nothing.
template <typename T>
[[nodiscard]] Image<T> recropped(const Image<T>& image, const Box& from, const Box& to) {
  Image<T> part(to.size());
  const int left = std::max(from.beginX, to.beginX);
  const int right = std::min(from.endX, to.endX);
  if (right <= left) return part;
  for (int y = std::max(from.beginY, to.beginY); y < std::min(from.endY, to.endY); ++y) {
    std::copy_n(image.row(y - from.beginY) + (left - from.beginX), right - left,
                part.row(y - to.beginY) + (left - to.beginX));
  }
  return part;
}

}  // namespace fluidymation
