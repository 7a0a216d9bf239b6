#include "fluidymation/guides/packed_mask.h"

#include <algorithm>
#include <array>
#include <bitset>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <utility>
#include <vector>

#include "fluidymation/core/index.h"

namespace fluidymation {

PackedMask::PackedMask(const Mask& mask)
    : size_(mask.size()), bits_((mask.pixelCount() + kBits - 1) / kBits) {
  static constexpr std::array<std::uint8_t, kBits> kOutside{};  // as most of a frame is
  const std::uint8_t* pixels = mask.data();
  for (std::size_t w = 0; w < bits_.size(); ++w) {
    const std::size_t first = w * kBits;
    const std::size_t count = std::min(kBits, mask.pixelCount() - first);
    if (count == kBits && std::memcmp(pixels + first, kOutside.data(), kBits) == 0) continue;
    std::uint64_t word = 0;
    for (std::size_t i = 0; i < count; ++i) {
      word |= static_cast<std::uint64_t>(pixels[first + i] != 0) << i;
    }
    bits_[w] = word;
  }
}

PackedMask::PackedMask(Size size, std::vector<std::uint64_t> words)
    : size_(size), bits_(std::move(words)) {
  assert(bits_.size() == (pixelCount() + kBits - 1) / kBits);
}

std::size_t PackedMask::count() const { return countShared(*this); }

std::size_t PackedMask::countShared(const PackedMask& other) const {
  assert(size_ == other.size_);
  std::size_t count = 0;
  for (std::size_t w = 0; w < bits_.size(); ++w) {
    count += std::bitset<kBits>(bits_[w] & other.bits_[w]).count();
  }
  return count;
}

Box PackedMask::box() const {
  Box box;
  const auto width = at(size_.width);
  forEachRun([&](std::size_t begin, std::size_t end) {
    const auto firstRow = static_cast<int>(begin / width);
    const auto lastRow = static_cast<int>((end - 1) / width);
    const bool wraps = firstRow != lastRow;
    box = joined(box, {wraps ? 0 : static_cast<int>(begin % width), firstRow,
                       wraps ? size_.width : static_cast<int>((end - 1) % width) + 1, lastRow + 1});
  });
  return box;
}

Mask PackedMask::unpack() const {
  Mask mask(size_);
  forEachRun([&](std::size_t begin, std::size_t end) {
    std::fill(mask.data() + begin, mask.data() + end, std::uint8_t{1});
  });
  return mask;
}

Mask PackedMask::unpack(const Box& box) const {
  Mask mask(box.size());
  for (int y = 0; y < mask.height(); ++y) {
    const std::size_t from = at(box.beginY + y) * at(size_.width) + at(box.beginX);
    forEachRun(from, from + at(mask.width()), [&](std::size_t begin, std::size_t end) {
      std::fill(mask.row(y) + (begin - from), mask.row(y) + (end - from), std::uint8_t{1});
    });
  }
  return mask;
}

std::size_t PackedMask::firstOf(bool inside, std::size_t from, std::size_t to) const {
  while (from < to) {
    const std::uint64_t word = inside ? bits_[from / kBits] : ~bits_[from / kBits];
    const std::uint64_t rest = word >> (from % kBits);
    if (rest != 0) return std::min(from + at(__builtin_ctzll(rest)), to);
    from = (from / kBits + 1) * kBits;
  }
  return to;
}

std::vector<Vec2> gather(const PackedMask& mask, const Image<Vec2>& image, const Box& box) {
  std::vector<Vec2> values;
  values.reserve(mask.count());
  for (int y = 0; y < image.height(); ++y) {
    const std::size_t from = at(box.beginY + y) * at(mask.size().width) + at(box.beginX);
    const Vec2* row = image.row(y);
    mask.forEachRun(from, from + at(image.width()), [&](std::size_t begin, std::size_t end) {
      values.insert(values.end(), row + (begin - from), row + (end - from));
    });
  }
  return values;
}

std::vector<Vec2> gather(const PackedMask& mask, const Image<Vec2>& image) {
  return gather(mask, image, {0, 0, image.width(), image.height()});
}

Image<Vec2> scatter(const PackedMask& mask, const std::vector<Vec2>& values, const Box& box) {
  Image<Vec2> image(box.size());
  const std::size_t width = at(mask.size().width);
  const std::size_t left = at(box.beginX);
  const Vec2* value = values.data();
  // Row by row of the whole frame, since values are counted from its begin
  for (int y = 0; y < mask.size().height; ++y) {
    const std::size_t from = at(y) * width;
    const bool isShown = y >= box.beginY && y < box.endY;
    mask.forEachRun(from, from + width, [&](std::size_t begin, std::size_t end) {
      const std::size_t first = std::max(begin, from + left);
      const std::size_t last = std::min(end, from + at(box.endX));
      if (isShown && first < last) {
        std::copy(value + (first - begin), value + (last - begin),
                  image.row(y - box.beginY) + (first - from - left));
      }
      value += end - begin;
    });
  }
  assert(value == values.data() + values.size());
  return image;
}

Image<Vec2> scatter(const PackedMask& mask, const std::vector<Vec2>& values) {
  return scatter(mask, values, {0, 0, mask.size().width, mask.size().height});
}

}  // namespace fluidymation
