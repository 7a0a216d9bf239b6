#include "footage/matte.h"

#include <algorithm>
#include <cassert>

namespace fluidymation {
namespace {

constexpr float kByteStep = 1.0F / 255.0F;

/// What alpha times it, and the rest of white, turn `bare` into `frame` with.
[[nodiscard]] float factorOf(float frame, float bare, float alpha) {
  const float transmitted = frame / std::max(bare, kByteStep);
  return 1.0F - (1.0F - transmitted) / alpha;
}

[[nodiscard]] bool isLighter(float frame, float bare) { return frame > bare + kByteStep; }

}  // namespace

Matte multiplyMatte(const Image<Rgb>& frame, const Image<Rgb>& bare, const Image<float>& coverage) {
  assert(frame.size() == bare.size() && frame.size() == coverage.size());
  Matte matte{Image<Rgba8>(frame.size()), 0};
  for (std::size_t i = 0; i < coverage.pixelCount(); ++i) {
    const std::uint8_t alphaByte = toByte(coverage.data()[i]);
    if (alphaByte == 0) continue;
    const float alpha = kByteStep * static_cast<float>(alphaByte);
    const Rgb over = frame.data()[i];
    const Rgb under = bare.data()[i];
    matte.picture.data()[i] = {toByte(factorOf(over.r, under.r, alpha)),
                               toByte(factorOf(over.g, under.g, alpha)),
                               toByte(factorOf(over.b, under.b, alpha)), alphaByte};
    if (isLighter(over.r, under.r) || isLighter(over.g, under.g) || isLighter(over.b, under.b)) {
      ++matte.lighter;
    }
  }
  return matte;
}

}  // namespace fluidymation
