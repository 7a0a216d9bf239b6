#include "footage/film_difference.h"

#include <cassert>
#include <cmath>

#include "fluidymation/core/parallel.h"
#include "fluidymation/guides/gaussian.h"

namespace fluidymation {
namespace {

/// One channel of what differs, averaged.
[[nodiscard]] Image<float> averagedChannel(const Image<Lab>& frame, const Image<Lab>& bare,
                                           float Lab::*channel, float grainSigmaPx) {
  Image<float> difference(frame.size());
  for (std::size_t i = 0; i < difference.pixelCount(); ++i) {
    difference.data()[i] = frame.data()[i].*channel - bare.data()[i].*channel;
  }
  return gaussianBlur(difference, grainSigmaPx);
}

}  // namespace

Image<float> filmDifference(const Image<Lab>& frame, const Image<Lab>& bare, float grainSigmaPx) {
  assert(frame.size() == bare.size());
  Image<float> squares(frame.size(), 0.0F);
  for (float Lab::*const channel : {&Lab::l, &Lab::a, &Lab::b}) {
    const Image<float> averaged = averagedChannel(frame, bare, channel, grainSigmaPx);
    for (std::size_t i = 0; i < squares.pixelCount(); ++i) {
      squares.data()[i] += averaged.data()[i] * averaged.data()[i];
    }
  }
  forEachRow(squares.height(), [&](int y) {
    for (int x = 0; x < squares.width(); ++x) squares(x, y) = std::sqrt(squares(x, y));
  });
  return squares;
}

}  // namespace fluidymation
