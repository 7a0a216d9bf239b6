#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "fluidymation/core/geometry.h"
#include "fluidymation/core/index.h"
#include "fluidymation/core/parallel.h"
#include "pixel_level.h"
#include "region_graph.h"

namespace fluidymation {

using Field = std::vector<Vec2>;

/// The outer iteration is in double precision: on long thin regions that are given at their ends
/// only, single precision loses the slope (a path of n pixels multiplies rounding by n^2 / 8). Its
/// V-cycles, which only have to point in the right direction, are in single precision.
///
/// Also the scalars of the two components, which are solved side by side.
struct Vec2d {
  double x = 0.0;
  double y = 0.0;

  friend Vec2d operator+(Vec2d a, Vec2d b) { return {a.x + b.x, a.y + b.y}; }
  friend Vec2d operator-(Vec2d a, Vec2d b) { return {a.x - b.x, a.y - b.y}; }
  friend Vec2d operator*(Vec2d a, Vec2d b) { return {a.x * b.x, a.y * b.y}; }
  Vec2d& operator+=(Vec2d b) { return *this = *this + b; }
};

using PreciseField = std::vector<Vec2d>;

inline double squaredLength(Vec2d v) { return v.x * v.x + v.y * v.y; }
inline Vec2d toDouble(Vec2 v) { return {static_cast<double>(v.x), static_cast<double>(v.y)}; }
inline Vec2 toFloat(Vec2d v) { return {static_cast<float>(v.x), static_cast<float>(v.y)}; }

inline int pieceCount(int unknowns) { return (unknowns + kUnknownsAtATime - 1) / kUnknownsAtATime; }

/// body(piece) for each piece of work; a single one does not bother the other threads.
template <typename Body>
void forEachPiece(int begin, int end, const Body& body) {
  if (end - begin == 1) {
    body(begin);
  } else {
    parallelFor(end - begin, 1, [&](int i) { body(begin + i); });
  }
}

/// body(i) for i in [begin, end), in pieces.
template <typename Body>
void forEachUnknown(int begin, int end, const Body& body) {
  forEachPiece(0, pieceCount(end - begin), [&](int piece) {
    const int from = begin + piece * kUnknownsAtATime;
    const int to = std::min(from + kUnknownsAtATime, end);
    for (int i = from; i < to; ++i) body(at(i));
  });
}

/// The values of the four neighbours of the pixels of a span: one array each, of zeros where there
/// is no such neighbour.
template <typename Value>
struct Beside {
  Beside(const PixelSpan& span, const std::vector<Value>& field, const std::vector<Value>& zeros)
      : left(valuesFrom(span.left, field, zeros)),
        right(valuesFrom(span.right, field, zeros)),
        up(valuesFrom(span.up, field, zeros)),
        down(valuesFrom(span.down, field, zeros)) {}

  static const Value* valuesFrom(int unknown, const std::vector<Value>& field,
                                 const std::vector<Value>& zeros) {
    return unknown == kNoUnknown ? zeros.data() : field.data() + unknown;
  }

  /// Of the k-th pixel. Begins at zero, as a sum over a list of neighbours does.
  [[nodiscard]] Value sum(int k) const { return Value{} + left[k] + right[k] + up[k] + down[k]; }

  const Value* left;
  const Value* right;
  const Value* up;
  const Value* down;
};

/// The hierarchy of levels over the pixels that are to be solved for.
class Multigrid {
 public:
  /// @param finest  see `pixelLevel`; its parents are filled in.
  /// @param size, origin  see `coarserLevel`.
  Multigrid(PixelLevel finest, Size size, Pixel origin);

  [[nodiscard]] const PixelLevel& finest() const { return finest_; }

  /// Takes what is left over of one piece of work, before `cycle`.
  void setResidual(int piece, const PreciseField& residual);

  /// One V-cycle from zero, without pre-smoothing: an approximate solution of
  /// (operator) x = residual.
  const Field& cycle();

 private:
  template <typename Body>
  void forEachSpan(int piece, const Body& body) const {
    for (int s = finest_.firstSpan[at(piece)]; s < finest_.firstSpan[at(piece) + 1]; ++s) {
      body(finest_.spans[at(s)]);
    }
  }

  /// Transpose of `prolongate`. What is left over right next to the border has to count little on
  /// coarse levels: there the border is many pixels away from the block's centre. Plain sums would
  /// make the first correction too large by the number of those pixels.
  void restrict(std::size_t l);
  void restrictFinest();

  /// Every unknown takes its parent's value, then the mean of its neighbours' (one Jacobi step).
  /// On a regular grid that is linear interpolation between the parents. The smoothing that follows
  /// begins with the red unknowns and asks for the black ones only, whose neighbours are all red.
  void prolongate(std::size_t l);
  void prolongateFinest();

  /// Gauss-Seidel, first the red unknowns, then the black ones.
  void smooth(std::size_t l);
  void smoothFinest();

  /// body(span) for spans begin..end-1, in the pieces of work that they lie in.
  template <typename Body>
  void forEachColorSpan(int begin, int end, const Body& body) const {
    if (begin == end) return;
    const int firstPiece = finest_.spans[at(begin)].begin / kUnknownsAtATime;
    const int lastPiece = finest_.spans[at(end - 1)].begin / kUnknownsAtATime;
    forEachPiece(firstPiece, lastPiece + 1, [&](int piece) {
      const int from = std::max(begin, finest_.firstSpan[at(piece)]);
      const int to = std::min(end, finest_.firstSpan[at(piece) + 1]);
      for (int s = from; s < to; ++s) body(finest_.spans[at(s)]);
    });
  }

  PixelLevel finest_;
  Field finestRight_;                       ///< right-hand side
  Field finestValue_;                       ///< correction; sums of neighbours while restricting
  std::vector<GraphLevel> levels_;          ///< the coarser ones, finest first
  std::vector<Field> right_;                ///< as finestRight_, of each of these
  std::vector<Field> value_;                ///< likewise
  std::vector<std::vector<float>> shares_;  ///< one over each level's diagonal
  Field plain_;                             ///< scratch of restrict and prolongate
  Field zeros_;                             ///< stands for the neighbours that are no unknowns
};

}  // namespace fluidymation
