#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "fluidymation/core/box.h"
#include "fluidymation/core/image.h"

namespace fluidymation {

/// A mask at one bit a pixel, for the frames of a long sequence that wait for their turn. Pixels
/// are numbered in row order, from 0.
class PackedMask {
 public:
  PackedMask() = default;
  explicit PackedMask(const Mask& mask);
  /// @param words  those of a mask of this size (asserted).
  PackedMask(Size size, std::vector<std::uint64_t> words);

  friend bool operator==(const PackedMask& a, const PackedMask& b) {
    return a.size_ == b.size_ && a.bits_ == b.bits_;
  }

  [[nodiscard]] Size size() const { return size_; }
  /// All bits, of each word from the lowest on.
  [[nodiscard]] const std::vector<std::uint64_t>& words() const { return bits_; }
  [[nodiscard]] std::size_t count() const;  ///< pixels inside
  /// Pixels inside both. @param other  of the same size (asserted).
  [[nodiscard]] std::size_t countShared(const PackedMask& other) const;
  [[nodiscard]] Box box() const;  ///< the smallest that holds all of it
  [[nodiscard]] Mask unpack() const;
  [[nodiscard]] Mask unpack(const Box& box) const;  ///< the part within the box

  /// body(begin, end) for each run of pixels begin..end-1 inside, among the pixels from..to-1. Runs
  /// go on from row to row.
  template <typename Body>
  void forEachRun(std::size_t from, std::size_t to, const Body& body) const {
    while (true) {
      const std::size_t begin = firstOf(true, from, to);
      if (begin == to) return;
      from = firstOf(false, begin, to);
      body(begin, from);
    }
  }
  template <typename Body>
  void forEachRun(const Body& body) const {
    forEachRun(0, pixelCount(), body);
  }

 private:
  static constexpr std::size_t kBits = 64;

  [[nodiscard]] std::size_t pixelCount() const {
    return static_cast<std::size_t>(size_.width) * static_cast<std::size_t>(size_.height);
  }

  /// The first pixel in from..to-1 that is inside, or outside; `to` where there is none.
  [[nodiscard]] std::size_t firstOf(bool inside, std::size_t from, std::size_t to) const;

  Size size_;
  std::vector<std::uint64_t> bits_;
};

/// The pixels of `mask` in row order, in stretches that lie wholly within `other` or wholly out of
/// it: body(begin, end, ownRank, isShared, otherRank), ranks of pixel `begin` among those of either
/// mask. `otherRank` means nothing where the stretch is not shared.
template <typename Body>
void forEachStretch(const PackedMask& mask, const PackedMask& other, const Body& body) {
  struct Run {
    std::size_t begin;
    std::size_t end;
  };
  std::vector<Run> others;
  other.forEachRun([&](std::size_t begin, std::size_t end) { others.push_back({begin, end}); });
  auto run = others.begin();
  std::size_t otherRank = 0;  // of the run's first pixel
  std::size_t ownRank = 0;
  mask.forEachRun([&](std::size_t begin, std::size_t end) {
    while (begin < end) {
      while (run != others.end() && run->end <= begin) {
        otherRank += run->end - run->begin;
        ++run;
      }
      const bool isShared = run != others.end() && run->begin <= begin;
      const std::size_t border = run == others.end() ? end : isShared ? run->end : run->begin;
      const std::size_t stretchEnd = std::min(end, border);
      body(begin, stretchEnd, ownRank, isShared, isShared ? otherRank + begin - run->begin : 0);
      ownRank += stretchEnd - begin;
      begin = stretchEnd;
    }
  });
}

/// The values of the pixels inside, in row order.
/// @param image  the part within `box`, which holds the mask.
[[nodiscard]] std::vector<Vec2> gather(const PackedMask& mask, const Image<Vec2>& image,
                                       const Box& box);
[[nodiscard]] std::vector<Vec2> gather(const PackedMask& mask, const Image<Vec2>& image);

/// The inverse of `gather`; zero outside.
/// @return  the part within `box`, which may cut the mask.
[[nodiscard]] Image<Vec2> scatter(const PackedMask& mask, const std::vector<Vec2>& values,
                                  const Box& box);
[[nodiscard]] Image<Vec2> scatter(const PackedMask& mask, const std::vector<Vec2>& values);

}  // namespace fluidymation
