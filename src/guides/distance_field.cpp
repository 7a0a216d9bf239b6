#include "fluidymation/guides/distance_field.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "fluidymation/core/box.h"
#include "fluidymation/core/index.h"
#include "fluidymation/core/parallel.h"

namespace fluidymation {
namespace {

/// Steps along a column. 16 bits: twice as many at a time as in an int, and sides of 16384 px fit.
using Steps = std::int16_t;
constexpr Steps kNoSteps = INT16_MAX;  ///< the whole column is of one side

/// Steps along the column to the nearest pixel of the other side within `box`, for its pixels.
Image<Steps> columnDistance(const Mask& mask, const Box& box) {
  constexpr int kColumnsAtATime = 64;  // a strip of rows that long stays in the nearest cache
  Image<Steps> steps(box.size());
  const int height = steps.height();
  const int strips = (steps.width() + kColumnsAtATime - 1) / kColumnsAtATime;
  parallelFor(strips, 1, [&](int strip) {
    const int begin = strip * kColumnsAtATime;
    const int end = std::min(begin + kColumnsAtATime, steps.width());
    const auto maskRow = [&](int y) { return mask.row(box.beginY + y) + box.beginX; };
    const auto oneFurther = [](Steps s) {
      return static_cast<Steps>(std::min<Steps>(s, kNoSteps - 1) + 1);
    };
    std::fill(steps.row(0) + begin, steps.row(0) + end, kNoSteps);
    for (int y = 1; y < height; ++y) {
      const std::uint8_t* here = maskRow(y);
      const std::uint8_t* above = maskRow(y - 1);
      const Steps* last = steps.row(y - 1);
      Steps* out = steps.row(y);
      for (int x = begin; x < end; ++x) {
        const bool crossed = (here[x] != 0) != (above[x] != 0);
        out[x] = crossed ? Steps{1} : oneFurther(last[x]);
      }
    }
    for (int y = height - 2; y >= 0; --y) {
      const std::uint8_t* here = maskRow(y);
      const std::uint8_t* below = maskRow(y + 1);
      const Steps* last = steps.row(y + 1);
      Steps* out = steps.row(y);
      for (int x = begin; x < end; ++x) {
        const bool crossed = (here[x] != 0) != (below[x] != 0);
        out[x] = crossed ? Steps{1} : std::min(out[x], oneFurther(last[x]));
      }
    }
  });
  return steps;
}

/// The pixel of the other side that is nearest in its column.
struct Foot {
  int x = 0;
  int height = 0;  ///< steps along the column
};

/// Lower envelope of the parabolas (x - foot.x)^2 + foot.height^2 over a stretch of a row:
/// Meijster's second phase.
class Envelope {
 public:
  explicit Envelope(int width) : pieces_(at(width)) {}

  void start(int low, int high) {
    low_ = low;
    high_ = high;
    count_ = 0;
  }

  /// The next foot to the right.
  void add(const Foot& foot) {
    const int square = foot.height * foot.height;
    const auto height = [](int x, int centre, int squaredHeight) {
      return (x - centre) * (x - centre) + squaredHeight;
    };
    while (count_ > 0) {
      const Piece& last = pieces_[count_ - 1];
      if (height(last.begin, last.centre, last.square) <= height(last.begin, foot.x, square)) break;
      --count_;
    }
    int begin = low_;
    if (count_ > 0) {
      // From here on the new parabola is the lower one
      const Piece& last = pieces_[count_ - 1];
      assert(last.centre < foot.x);
      begin = 1 + (foot.x * foot.x - last.centre * last.centre + square - last.square) /
                      (2 * (foot.x - last.centre));
    }
    if (begin > high_) return;
    pieces_[count_++] = {foot.x, begin, square};
  }

  /// Squared distances over the stretch; there must have been a foot.
  void write(int* squares) const {
    assert(count_ > 0);
    for (std::size_t i = 0; i < count_; ++i) {
      const Piece& piece = pieces_[i];
      const int end = i + 1 < count_ ? pieces_[i + 1].begin : high_ + 1;
      for (int x = piece.begin; x < end; ++x) {
        squares[x] = (x - piece.centre) * (x - piece.centre) + piece.square;
      }
    }
  }

 private:
  struct Piece {
    int centre = 0;  ///< whose parabola is lowest ...
    int begin = 0;   ///< ... from this x on
    int square = 0;  ///< of its height
  };
  int low_ = 0;
  int high_ = 0;
  std::size_t count_ = 0;
  std::vector<Piece> pieces_;
};

/// Drops the feet that are nearest nowhere along their row. Further away from them they are not
/// either: what is nearest to a point is nearest to all points on the way there.
void dropHidden(std::vector<Foot>& feet) {
  // Twice the difference of two feet's parabolas at 0, which is where they cross times their
  // distance
  const auto rise = [](const Foot& a, const Foot& b) {
    const auto square = [](std::int64_t v) { return v * v; };
    return square(b.x) - square(a.x) + square(b.height) - square(a.height);
  };
  std::size_t kept = 0;
  for (const Foot& foot : feet) {
    while (kept >= 2) {
      const Foot& a = feet[kept - 2];
      const Foot& b = feet[kept - 1];
      // b begins where it crosses a and ends where `foot` crosses it
      if (rise(a, b) * (foot.x - b.x) < rise(b, foot) * (b.x - a.x)) break;
      --kept;
    }
    feet[kept++] = foot;
  }
  feet.resize(kept);
}

/// Distances of a row, positive where the mask is. A float's root of a number that a float holds
/// exactly is the same as the rounded root of a double.
void writeRoots(const std::vector<int>& squares, const std::uint8_t* mask, bool areExact,
                float* distance) {
  const int width = static_cast<int>(squares.size());
  const int* square = squares.data();
  if (areExact) {
    for (int x = 0; x < width; ++x) {
      const float length = std::sqrt(static_cast<float>(square[x]));
      distance[x] = mask[x] != 0 ? length : -length;
    }
  } else {
    for (int x = 0; x < width; ++x) {
      const auto length = static_cast<float>(std::sqrt(static_cast<double>(square[x])));
      distance[x] = mask[x] != 0 ? length : -length;
    }
  }
}

/// The distance field of one mask that has both sides.
class DistanceField {
 public:
  /// @param box  of the mask.
  DistanceField(const Mask& mask, const Box& box)
      : mask_(mask),
        box_(box),
        around_(grown(box, 1, mask.size())),
        steps_(columnDistance(mask, around_)),
        distance_(mask.size()) {
    constexpr std::int64_t kExactInFloat = std::int64_t{1} << 24;
    const auto square = [](std::int64_t v) { return v * v; };
    rootsAreExact_ = square(mask.width()) + square(mask.height()) <= kExactInFloat;
  }

  Image<float> make() {
    parallelFor((mask_.height() + kRowsAtATime - 1) / kRowsAtATime, 1, [&](int strip) {
      const int begin = strip * kRowsAtATime;
      const int end = std::min(begin + kRowsAtATime, mask_.height());
      Scratch scratch{Envelope(mask_.width()), std::vector<int>(at(mask_.width())), {}};
      rowsBeyond(begin, std::min(end, around_.beginY), scratch);
      for (int y = std::max(begin, around_.beginY); y < std::min(end, around_.endY); ++y) {
        rowWithin(y, scratch);
      }
      rowsBeyond(std::max(begin, around_.endY), end, scratch);
    });
    return std::move(distance_);
  }

 private:
  static constexpr int kRowsAtATime = 32;  // whose feet are looked for once where there is no mask

  struct Scratch {
    Envelope envelope;
    std::vector<int> squares;
    std::vector<Foot> feet;
  };

  /// Both signs in one sweep: a run of pixels of one side cannot have its nearest pixel of the
  /// other side beyond the run's two neighbours, for these are of the other side themselves.
  void rowWithin(int y, Scratch& scratch) {
    const int width = mask_.width();
    const std::uint8_t* inside = mask_.row(y);
    const Steps* steps = steps_.row(y - around_.beginY);  // from around_.beginX on
    int end = 0;
    for (int begin = 0; begin < width; begin = end) {
      const bool isInside = inside[begin] != 0;
      end = begin + 1;
      while (end < width && (inside[end] != 0) == isInside) ++end;
      Envelope& envelope = scratch.envelope;
      envelope.start(begin, end - 1);
      if (begin > 0) envelope.add({begin - 1, 0});
      for (int x = std::max(begin, around_.beginX); x < std::min(end, around_.endX); ++x) {
        const Steps there = steps[x - around_.beginX];
        if (there != kNoSteps) envelope.add({x, there});
      }
      if (end < width) envelope.add({end, 0});
      envelope.write(scratch.squares.data());
    }
    writeRoots(scratch.squares, inside, rootsAreExact_, distance_.row(y));
  }

  /// Rows above or below the mask. Their nearest pixels are among those of the row that is nearest
  /// to the mask.
  void rowsBeyond(int begin, int end, Scratch& scratch) {
    if (begin >= end) return;
    const bool isAbove = end <= around_.beginY;
    const int edge = isAbove ? around_.beginY : around_.endY - 1;
    const int nearest = isAbove ? end - 1 : begin;
    const Steps* steps = steps_.row(edge - around_.beginY);
    std::vector<Foot>& feet = scratch.feet;
    feet.clear();
    for (int x = box_.beginX; x < box_.endX; ++x) {
      const Steps there = steps[x - around_.beginX];
      if (there != kNoSteps) feet.push_back({x, there + std::abs(nearest - edge)});
    }
    dropHidden(feet);
    for (int y = begin; y < end; ++y) {
      scratch.envelope.start(0, mask_.width() - 1);
      for (const Foot& foot : feet) {
        scratch.envelope.add({foot.x, foot.height + std::abs(y - nearest)});
      }
      scratch.envelope.write(scratch.squares.data());
      writeRoots(scratch.squares, mask_.row(y), rootsAreExact_, distance_.row(y));
    }
  }

  const Mask& mask_;
  Box box_;
  Box around_;  ///< the mask and its outline: all feet lie there
  Image<Steps> steps_;
  Image<float> distance_;
  bool rootsAreExact_ = false;
};

/// Longest reach for which all pixels within it are tried. Their squares fit 16 bits.
constexpr int kLongestTriedPx = 48;

/// Steps along the column to the nearest pixel of the mask, at most `limit`, squared.
Image<std::int16_t> squaredColumnSteps(const Mask& mask, int limit) {
  Image<std::int16_t> steps(mask.size());
  const auto none = static_cast<std::int16_t>(limit);
  const auto follow = [&](const std::uint8_t* inside, const std::int16_t* last, std::int16_t* out) {
    for (int x = 0; x < mask.width(); ++x) {
      const auto further = static_cast<std::int16_t>(last[x] + 1);
      out[x] = inside[x] != 0 ? std::int16_t{0} : std::min(out[x], further);
    }
  };
  std::fill(steps.begin(), steps.end(), none);
  const std::vector<std::int16_t> beyond(at(mask.width()), none);
  for (int y = 0; y < mask.height(); ++y) {
    follow(mask.row(y), y > 0 ? steps.row(y - 1) : beyond.data(), steps.row(y));
  }
  for (int y = mask.height() - 2; y >= 0; --y) {
    follow(mask.row(y), steps.row(y + 1), steps.row(y));
  }
  for (std::int16_t& s : steps) s = static_cast<std::int16_t>(s * s);
  return steps;
}

}  // namespace

Image<float> signedDistance(const Mask& mask) {
  const std::size_t inside = countInside(mask);
  const auto standIn = static_cast<float>(mask.width() + mask.height());
  if (inside == 0) return Image<float>(mask.size(), -standIn);
  if (inside == mask.pixelCount()) return Image<float>(mask.size(), standIn);
  return DistanceField(mask, boundingBox(mask)).make();
}

Image<float> distanceWithin(const Mask& mask, int reachPx) {
  if (countInside(mask) == 0) return Image<float>(mask.size(), static_cast<float>(reachPx + 1));
  Image<float> distance(mask.size());
  if (reachPx > kLongestTriedPx) {
    const Image<float> field = signedDistance(mask);
    std::transform(field.begin(), field.end(), distance.begin(),
                   [](float d) { return std::max(-d, 0.0F); });
    return distance;
  }
  const int beyond = reachPx + 1;
  const Image<std::int16_t> steps = squaredColumnSteps(mask, beyond);
  const int width = mask.width();
  forEachRow(mask.height(), [&](int y) {
    std::vector<std::int16_t> padded(at(width + 2 * reachPx),
                                     static_cast<std::int16_t>(beyond * beyond));
    std::copy_n(steps.row(y), width, padded.begin() + reachPx);
    std::vector<std::int16_t> nearest(padded.begin() + reachPx, padded.end() - reachPx);
    const std::int16_t* here = padded.data() + reachPx;
    std::int16_t* best = nearest.data();
    for (int dx = 1; dx <= reachPx; ++dx) {
      const auto square = static_cast<std::int16_t>(dx * dx);
      for (int x = 0; x < width; ++x) {
        const std::int16_t beside = std::min(here[x - dx], here[x + dx]);
        best[x] = std::min(best[x], static_cast<std::int16_t>(beside + square));
      }
    }
    float* out = distance.row(y);
    for (int x = 0; x < width; ++x) out[x] = std::sqrt(static_cast<float>(best[x]));
  });
  return distance;
}

}  // namespace fluidymation
