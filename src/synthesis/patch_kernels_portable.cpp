// The inner loops in plain C++, for processors without AVX2 and as the reference of the others.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "synthesis/patch_kernels.h"
#include "synthesis/sample_order.h"
#include "synthesis/subpixels.h"

namespace fluidymation {
namespace {

constexpr std::size_t kLanes = 8;
constexpr std::size_t kChannelPairs = kLanes / 2;
constexpr int kFractionMask = (1 << kSubpixelBits) - 1;

using Lanes = std::array<std::int16_t, kLanes>;

Lanes lanesOf(const Texel& texel) {
  Lanes lanes;
  std::memcpy(lanes.data(), &texel, sizeof lanes);
  return lanes;
}

/// from + share (to - from), to the nearest step.
std::int16_t mix(std::int16_t from, std::int16_t to, int share) {
  const int step = ((to - from) * share + (1 << (kShareBits - 1))) >> kShareBits;
  return static_cast<std::int16_t>(from + step);
}

Lanes mix(const Lanes& from, const Lanes& to, int share) {
  Lanes mixed;
  for (std::size_t c = 0; c < kLanes; ++c) mixed[c] = mix(from[c], to[c], share);
  return mixed;
}

/// Bilinear interpolation at the i-th sample of the window.
Lanes sample(const SourceWindow& source, std::size_t i) {
  const float dx = kSampleOffsets.x[i];
  const float dy = kSampleOffsets.y[i];
  const float c = source.rotation.cosine;
  const float s = source.rotation.sine;
  const auto x = static_cast<int>(((dx * c + dy * s) + source.x) * kSubpixels);
  const auto y = static_cast<int>(((dy * c - dx * s) + source.y) * kSubpixels);
  const Texel* top = source.origin +
                     static_cast<std::ptrdiff_t>(y >> kSubpixelBits) * source.stride +
                     (x >> kSubpixelBits);
  const Texel* bottom = top + source.stride;
  const int right = (x & kFractionMask) >> (kSubpixelBits - kShareBits);
  const int down = (y & kFractionMask) >> (kSubpixelBits - kShareBits);
  return mix(mix(lanesOf(top[0]), lanesOf(bottom[0]), down),
             mix(lanesOf(top[1]), lanesOf(bottom[1]), down), right);
}

/// In the order in which a vector of eight is folded.
float fold(const std::array<float, 2 * kChannelPairs>& sums) {
  std::array<float, kChannelPairs> half;
  for (std::size_t c = 0; c < kChannelPairs; ++c) half[c] = sums[c] + sums[c + kChannelPairs];
  return (half[0] + half[2]) + (half[1] + half[3]);
}

/// Weighted squares of even and of odd samples.
using Sums = std::array<float, 2 * kChannelPairs>;

/// Adds those of the difference between a sample and what the window has at `wanted`.
void addSquares(const TargetWindow& window, const Texel* values, const Lanes& there,
                std::size_t parity, std::size_t wanted, Sums& sums) {
  const Lanes here = lanesOf(values[wanted]);
  for (std::size_t p = 0; p < kChannelPairs; ++p) {
    const int first = there[2 * p] - here[2 * p];
    const int second = there[2 * p + 1] - here[2 * p + 1];
    sums[parity * kChannelPairs + p] +=
        static_cast<float>(first * first + second * second) * window.weight[wanted][p];
  }
}

float distance(const TargetWindow& window, const Texel* wanted, const SourceWindow& source,
               float stopAt, int& samples) {
  Sums sums{};
  float total = window.constant;
  for (std::size_t i = 0; i < kPatchArea;) {
    const std::size_t end = std::min<std::size_t>(i + kSampleBlock, kPatchArea);
    for (; i < end; ++i) addSquares(window, wanted, sample(source, i), i % 2, i, sums);
    total = window.constant + fold(sums);
    samples = static_cast<int>(i);
    if (total >= stopAt) break;
  }
  return total;
}

std::array<float, 2> bothDistances(const TargetWindow& window, const Texel* upright,
                                   const Texel* turned, const SourceWindow& source, float stopAt,
                                   int& samples) {
  Sums uprightSums{};
  Sums turnedSums{};
  std::array<float, 2> totals{};
  for (std::size_t i = 0; i < kPatchArea;) {
    const std::size_t end = std::min<std::size_t>(i + kSampleBlock, kPatchArea);
    for (; i < end; ++i) {
      const Lanes there = sample(source, i);
      const bool isCentre = i + 1 == kPatchArea;
      addSquares(window, upright, there, i % 2, i, uprightSums);
      addSquares(window, turned, there, isCentre ? 1 : i % 2, isCentre ? i : i ^ 1U, turnedSums);
    }
    totals = {window.constant + fold(uprightSums), window.constant + fold(turnedSums)};
    samples = static_cast<int>(i);
    if (totals[0] >= stopAt && totals[1] >= stopAt) break;
  }
  return totals;
}

void gather(const WindowSource& source, const WindowWeights& weights, TargetWindow& window) {
  int colored = 0;
  int remembered = 0;
  for (std::size_t i = 0; i < kPatchArea; ++i) {
    colored += source.picture[source.offsets[i]].weight;
    remembered += source.previous[source.offsets[i]].weight;
  }
  const float colorWeight = weights.ofColor(colored);
  const float previousWeight = weights.ofPrevious(remembered);
  const std::int16_t share = blendShare(colorWeight, previousWeight);

  std::array<float, kChannelPairs> apart{};  // of even and of odd samples
  for (std::size_t i = 0; i < kPatchArea; ++i) {
    const FixedLab t = source.picture[source.offsets[i]];
    const FixedLab p = source.previous[source.offsets[i]];
    const FixedGuides guides = source.guides[source.offsets[i]];
    FixedLab color = t;
    if (p.exists() && !t.exists()) color = p;
    if (p.exists() && t.exists()) {
      color = {mix(t.l, p.l, share), mix(t.a, p.a, share), mix(t.b, p.b, share), 1};
      const int l = p.l - t.l;
      const int a = p.a - t.a;
      const int b = p.b - t.b;
      apart[i % 2 * 2] += static_cast<float>(l * l + a * a);
      apart[i % 2 * 2 + 1] += static_cast<float>(b * b);
    }
    color.weight = 1;  // as the exemplar's, so that it makes no difference
    window.value[i] = {color, guides};
    window.swapped[i] = {color, {guides.edge, 0, guides.extBackward, guides.extForward}};
    const float both = (t.exists() ? colorWeight : 0.0F) + (p.exists() ? previousWeight : 0.0F);
    window.weight[i] = {both, both, weights.dist, weights.flow};
  }
  window.constant = colorWeight * (static_cast<float>(share) * kShareStep) *
                    ((apart[0] + apart[2]) + (apart[1] + apart[3]));
}

void addColors(const SourceWindow& source, const WindowSums& sums) {
  for (std::size_t i = 0; i < kPatchArea; ++i) {
    const std::int32_t weight = sums.weights->ofSample[i];
    if (weight == 0) continue;
    const Lanes color = sample(source, i);
    std::int32_t* sum = sums.centre + sums.offsets[i];
    for (std::size_t c = 0; c < 4; ++c) sum[c] += weight * color[c];
  }
}

std::array<float, 4> weightedGrid(const Texel* first, std::ptrdiff_t stride, std::size_t taps,
                                  const float* columnWeights, const float* rowWeights) {
  std::array<float, 4> sum{};
  for (std::size_t j = 0; j < taps; ++j, first += stride) {
    std::array<float, 4> along{};
    for (std::size_t i = 0; i < taps; ++i) {
      const Lanes texel = lanesOf(first[i]);
      for (std::size_t c = 0; c < 4; ++c) {
        along[c] += columnWeights[i] * static_cast<float>(texel[c]);
      }
    }
    for (std::size_t c = 0; c < 4; ++c) sum[c] += rowWeights[j] * along[c];
  }
  return sum;
}

}  // namespace

const PatchKernels& portableKernels() {
  static const PatchKernels kernels{"portable", distance,     bothDistances,
                                    gather,     weightedGrid, addColors};
  return kernels;
}

}  // namespace fluidymation
