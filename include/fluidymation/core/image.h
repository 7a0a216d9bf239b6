#pragma once

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "fluidymation/core/geometry.h"

namespace fluidymation {

/// Width x height grid of T, owned, row-major, no padding. Integer coordinates are pixel centres;
/// x grows right, y down. Move-only: copying a frame is expensive, so it is `clone()`.
template <typename T>
class Image {
 public:
  Image() = default;
  explicit Image(Size size, const T& value = T{})
      : size_(size),
        pixels_(static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height),
                value) {}

  Image(Image&&) noexcept = default;
  Image& operator=(Image&&) noexcept = default;
  Image(const Image&) = delete;
  Image& operator=(const Image&) = delete;
  ~Image() = default;

  [[nodiscard]] Image clone() const {
    Image copy;
    copy.size_ = size_;
    copy.pixels_ = pixels_;
    return copy;
  }

  [[nodiscard]] Size size() const { return size_; }
  [[nodiscard]] int width() const { return size_.width; }
  [[nodiscard]] int height() const { return size_.height; }
  [[nodiscard]] bool empty() const { return pixels_.empty(); }
  [[nodiscard]] std::size_t pixelCount() const { return pixels_.size(); }

  [[nodiscard]] bool contains(int x, int y) const {
    return x >= 0 && y >= 0 && x < size_.width && y < size_.height;
  }

  [[nodiscard]] T& operator()(int x, int y) { return pixels_[index(x, y)]; }
  [[nodiscard]] const T& operator()(int x, int y) const { return pixels_[index(x, y)]; }

  /// The pixel nearest to (x, y) within the image: the edge repeats.
  [[nodiscard]] const T& clamped(int x, int y) const {
    return (*this)(std::clamp(x, 0, size_.width - 1), std::clamp(y, 0, size_.height - 1));
  }

  [[nodiscard]] T* row(int y) { return pixels_.data() + index(0, y); }
  [[nodiscard]] const T* row(int y) const { return pixels_.data() + index(0, y); }
  [[nodiscard]] T* data() { return pixels_.data(); }
  [[nodiscard]] const T* data() const { return pixels_.data(); }
  [[nodiscard]] auto begin() { return pixels_.begin(); }
  [[nodiscard]] auto end() { return pixels_.end(); }
  [[nodiscard]] auto begin() const { return pixels_.begin(); }
  [[nodiscard]] auto end() const { return pixels_.end(); }

 private:
  [[nodiscard]] std::size_t index(int x, int y) const {
    assert(contains(x, y));
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(size_.width) +
           static_cast<std::size_t>(x);
  }

  Size size_;
  std::vector<T> pixels_;
};

/// 1 where the material is, 0 elsewhere. Bytes, not bits: two threads may write neighbours.
using Mask = Image<std::uint8_t>;

/// Pixels inside.
[[nodiscard]] inline std::size_t countInside(const Mask& mask) {
  return static_cast<std::size_t>(
      std::count_if(mask.begin(), mask.end(), [](std::uint8_t m) { return m != 0; }));
}

}  // namespace fluidymation
