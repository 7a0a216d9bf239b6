#include "fluidymation/guides/distance_field.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <vector>

#include "fluidymation/core/parallel.h"

namespace fluidymation {
namespace {

/// Larger than any distance within the image; its square and a squared width still fit an int for
/// sides up to 16384 px.
int farAway(const Mask& mask) { return mask.width() + mask.height(); }

/// Steps along the column to the nearest pixel of the other side, `farAway` where there is none.
Image<int> columnDistance(const Mask& mask) {
  constexpr int kColumnsAtATime = 64;  // a strip of rows that long stays in the nearest cache
  const int limit = farAway(mask);
  Image<int> steps(mask.size());
  const int strips = (mask.width() + kColumnsAtATime - 1) / kColumnsAtATime;
  parallelFor(strips, 1, [&](int strip) {
    const int begin = strip * kColumnsAtATime;
    const int end = std::min(begin + kColumnsAtATime, mask.width());
    for (int x = begin; x < end; ++x) steps(x, 0) = limit;
    for (int y = 1; y < mask.height(); ++y) {
      for (int x = begin; x < end; ++x) {
        const bool crossed = (mask(x, y) != 0) != (mask(x, y - 1) != 0);
        steps(x, y) = crossed ? 1 : std::min(steps(x, y - 1) + 1, limit);
      }
    }
    for (int y = mask.height() - 2; y >= 0; --y) {
      for (int x = begin; x < end; ++x) {
        const bool crossed = (mask(x, y) != 0) != (mask(x, y + 1) != 0);
        steps(x, y) = crossed ? 1 : std::min(steps(x, y), steps(x, y + 1) + 1);
      }
    }
  });
  return steps;
}

/// Lower envelope of the parabolas (x - i)^2 + height(i)^2, i in [low, high]: Meijster's second
/// phase. Owns the scratch memory of one row.
class Envelope {
 public:
  explicit Envelope(int width)
      : centre_(static_cast<std::size_t>(width)), begin_(static_cast<std::size_t>(width)) {}

  template <typename Height, typename Write>
  void trace(int low, int high, const Height& height, const Write& write) {
    const auto value = [&height](int x, int i) {
      return (x - i) * (x - i) + height(i) * height(i);
    };
    std::size_t count = 1;
    centre_[0] = low;
    begin_[0] = low;
    for (int i = low + 1; i <= high; ++i) {
      while (count > 0 &&
             value(begin_[count - 1], centre_[count - 1]) > value(begin_[count - 1], i)) {
        --count;
      }
      int begin = low;
      if (count > 0) {
        // From here on the new parabola is the lower one
        const int c = centre_[count - 1];
        assert(c < i);  // centres are listed in order
        begin = 1 + (i * i - c * c + height(i) * height(i) - height(c) * height(c)) / (2 * (i - c));
      }
      if (begin > high) continue;
      centre_[count] = i;
      begin_[count] = begin;
      ++count;
    }
    for (int x = high; x >= low; --x) {
      write(x, value(x, centre_[count - 1]));
      if (x == begin_[count - 1]) --count;
    }
  }

 private:
  std::vector<int> centre_;  ///< whose parabola is lowest ...
  std::vector<int> begin_;   ///< ... from this x on
};

}  // namespace

Image<float> signedDistance(const Mask& mask) {
  const std::size_t inside = countInside(mask);
  const auto standIn = static_cast<float>(farAway(mask));
  if (inside == 0) return Image<float>(mask.size(), -standIn);
  if (inside == mask.pixelCount()) return Image<float>(mask.size(), standIn);

  const Image<int> steps = columnDistance(mask);
  Image<float> distance(mask.size());
  const int width = mask.width();
  forEachRow(mask.height(), [&](int y) {
    Envelope envelope(width);
    // Both signs in one sweep: a run of pixels of one side cannot have its nearest pixel of the
    // other side beyond the run's two neighbours, for these are of the other side themselves
    int end = 0;
    for (int begin = 0; begin < width; begin = end) {
      const bool isInside = mask(begin, y) != 0;
      end = begin + 1;
      while (end < width && (mask(end, y) != 0) == isInside) ++end;
      envelope.trace(
          std::max(begin - 1, 0), std::min(end, width - 1),
          [&](int x) { return x >= begin && x < end ? steps(x, y) : 0; },
          [&](int x, int squared) {
            if (x < begin || x >= end) return;
            const auto length = static_cast<float>(std::sqrt(static_cast<double>(squared)));
            distance(x, y) = isInside ? length : -length;
          });
    }
  });
  return distance;
}

}  // namespace fluidymation
