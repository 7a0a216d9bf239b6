// The inner loops with AVX2: two samples of eight 16-bit channels at a time.

#include <array>
#include <cstddef>
#include <cstdint>

#include "synthesis/patch_kernels.h"
#include "synthesis/sample_order.h"
#include "synthesis/subpixels.h"

#if defined(__x86_64__) && defined(__GNUC__)

#include <immintrin.h>

#define FLUIDYMATION_AVX2 __attribute__((target("avx2")))

namespace fluidymation {
namespace {

/// Where eight samples are read: texels from the window's origin, and the weights of the right and
/// lower neighbour, 15 bits, twice in each 32-bit lane.
struct alignas(32) Addresses {
  std::array<std::int32_t, kSampleBlock> texel;
  std::array<std::int32_t, kSampleBlock> right;
  std::array<std::int32_t, kSampleBlock> down;
};

/// The fraction of a position as a weight, in both halves of the lane.
FLUIDYMATION_AVX2 inline __m256i weights(__m256i position) {
  constexpr int kWholeBits = 32 - kSubpixelBits;
  const __m256i fraction =
      _mm256_srli_epi32(_mm256_slli_epi32(position, kWholeBits), 32 - kShareBits);
  return _mm256_or_si256(fraction, _mm256_slli_epi32(fraction, 16));
}

/// What is the same for all samples of a window.
struct Turn {
  __m256 cosine;
  __m256 sine;
  __m256 x;
  __m256 y;
  __m256i stride;
};

FLUIDYMATION_AVX2 inline Turn turnOf(const SourceWindow& source) {
  return {_mm256_set1_ps(source.rotation.cosine), _mm256_set1_ps(source.rotation.sine),
          _mm256_set1_ps(source.x), _mm256_set1_ps(source.y), _mm256_set1_epi32(source.stride)};
}

/// Of the eight samples from the first on.
FLUIDYMATION_AVX2 inline void locate(const Turn& turn, std::size_t first, Addresses& addresses) {
  const __m256 subpixels = _mm256_set1_ps(kSubpixels);
  const __m256 dx = _mm256_load_ps(kSampleOffsets.x.data() + first);
  const __m256 dy = _mm256_load_ps(kSampleOffsets.y.data() + first);
  const __m256 x = _mm256_add_ps(
      _mm256_add_ps(_mm256_mul_ps(dx, turn.cosine), _mm256_mul_ps(dy, turn.sine)), turn.x);
  const __m256 y = _mm256_add_ps(
      _mm256_sub_ps(_mm256_mul_ps(dy, turn.cosine), _mm256_mul_ps(dx, turn.sine)), turn.y);
  const __m256i px = _mm256_cvttps_epi32(_mm256_mul_ps(x, subpixels));
  const __m256i py = _mm256_cvttps_epi32(_mm256_mul_ps(y, subpixels));
  const __m256i texel =
      _mm256_add_epi32(_mm256_srli_epi32(px, kSubpixelBits),
                       _mm256_mullo_epi32(_mm256_srli_epi32(py, kSubpixelBits), turn.stride));
  _mm256_store_si256(reinterpret_cast<__m256i*>(addresses.texel.data()), texel);
  _mm256_store_si256(reinterpret_cast<__m256i*>(addresses.right.data()), weights(px));
  _mm256_store_si256(reinterpret_cast<__m256i*>(addresses.down.data()), weights(py));
}

/// from + share (to - from), to the nearest step.
FLUIDYMATION_AVX2 inline __m256i mix(__m256i from, __m256i to, __m256i share) {
  return _mm256_add_epi16(from, _mm256_mulhrs_epi16(_mm256_sub_epi16(to, from), share));
}

/// The left and the right pixel of a sample, each interpolated downwards.
FLUIDYMATION_AVX2 inline __m256i columnPair(const SourceWindow& source, const Addresses& addresses,
                                            std::size_t i) {
  const Texel* top = source.origin + addresses.texel[i];
  return mix(_mm256_loadu_si256(reinterpret_cast<const __m256i*>(top)),
             _mm256_loadu_si256(reinterpret_cast<const __m256i*>(top + source.stride)),
             _mm256_set1_epi32(addresses.down[i]));
}

/// Samples i and i + 1 of the block, one in each half.
FLUIDYMATION_AVX2 inline __m256i samplePair(const SourceWindow& source, const Addresses& addresses,
                                            std::size_t i) {
  const __m256i even = columnPair(source, addresses, i);
  const __m256i odd = columnPair(source, addresses, i + 1);
  const __m256i right =
      _mm256_inserti128_si256(_mm256_castsi128_si256(_mm_set1_epi32(addresses.right[i])),
                              _mm_set1_epi32(addresses.right[i + 1]), 1);
  return mix(_mm256_permute2x128_si256(even, odd, 0x20), _mm256_permute2x128_si256(even, odd, 0x31),
             right);
}

FLUIDYMATION_AVX2 inline float fold(__m256 sums) {
  const __m128 half = _mm_add_ps(_mm256_castps256_ps128(sums), _mm256_extractf128_ps(sums, 1));
  const __m128 pair = _mm_add_ps(half, _mm_movehl_ps(half, half));
  return _mm_cvtss_f32(_mm_add_ss(pair, _mm_movehdup_ps(pair)));
}

/// The weighted squares of what differs between two samples and two texels.
FLUIDYMATION_AVX2 inline __m256 squares(__m256i there, __m256i here, __m256 weight) {
  const __m256i difference = _mm256_sub_epi16(there, here);
  return _mm256_mul_ps(_mm256_cvtepi32_ps(_mm256_madd_epi16(difference, difference)), weight);
}

FLUIDYMATION_AVX2 inline __m256i texelPair(const Texel* texels) {
  return _mm256_load_si256(reinterpret_cast<const __m256i*>(texels));
}

FLUIDYMATION_AVX2 inline __m256 weightPair(const TargetWindow& window, std::size_t i) {
  return _mm256_load_ps(window.weight[i].data());
}

FLUIDYMATION_AVX2 inline __m256i exchanged(__m256i pair) {
  return _mm256_permute4x64_epi64(pair, _MM_SHUFFLE(1, 0, 3, 2));
}

FLUIDYMATION_AVX2 inline __m256 exchanged(__m256 pair) {
  return _mm256_permute2f128_ps(pair, pair, 0x01);
}

static_assert(kPatchArea % kSampleBlock == 1, "the last block is one sample");
constexpr std::size_t kLastSample = kPatchArea - 1;

FLUIDYMATION_AVX2 float distance(const TargetWindow& window, const Texel* wanted,
                                 const SourceWindow& source, float stopAt, int& samples) {
  const Turn turn = turnOf(source);
  Addresses addresses;
  __m256 sums = _mm256_setzero_ps();
  for (std::size_t first = 0; first < kLastSample; first += kSampleBlock) {
    locate(turn, first, addresses);
    for (std::size_t i = 0; i < kSampleBlock; i += 2) {
      sums = _mm256_add_ps(sums,
                           squares(samplePair(source, addresses, i), texelPair(wanted + first + i),
                                   weightPair(window, first + i)));
    }
    const float total = window.constant + fold(sums);
    if (total >= stopAt) {
      samples = static_cast<int>(first) + kSampleBlock;
      return total;
    }
  }
  locate(turn, kLastSample, addresses);
  sums =
      _mm256_add_ps(sums, squares(samplePair(source, addresses, 0), texelPair(wanted + kLastSample),
                                  weightPair(window, kLastSample)));
  samples = kPatchArea;
  return window.constant + fold(sums);
}

FLUIDYMATION_AVX2 std::array<float, 2> bothDistances(const TargetWindow& window,
                                                     const Texel* upright, const Texel* turned,
                                                     const SourceWindow& source, float stopAt,
                                                     int& samples) {
  const Turn turn = turnOf(source);
  Addresses addresses;
  __m256 uprightSums = _mm256_setzero_ps();
  __m256 turnedSums = _mm256_setzero_ps();
  for (std::size_t first = 0; first < kLastSample; first += kSampleBlock) {
    locate(turn, first, addresses);
    for (std::size_t i = 0; i < kSampleBlock; i += 2) {
      const __m256i there = samplePair(source, addresses, i);
      const __m256 weight = weightPair(window, first + i);
      uprightSums =
          _mm256_add_ps(uprightSums, squares(there, texelPair(upright + first + i), weight));
      turnedSums = _mm256_add_ps(
          turnedSums, squares(there, exchanged(texelPair(turned + first + i)), exchanged(weight)));
    }
    const std::array<float, 2> totals{window.constant + fold(uprightSums),
                                      window.constant + fold(turnedSums)};
    if (totals[0] >= stopAt && totals[1] >= stopAt) {
      samples = static_cast<int>(first) + kSampleBlock;
      return totals;
    }
  }
  locate(turn, kLastSample, addresses);
  const __m256i there = samplePair(source, addresses, 0);
  const __m256 weight = weightPair(window, kLastSample);
  uprightSums =
      _mm256_add_ps(uprightSums, squares(there, texelPair(upright + kLastSample), weight));
  turnedSums = _mm256_add_ps(
      turnedSums, squares(there, exchanged(texelPair(turned + kLastSample)), exchanged(weight)));
  samples = kPatchArea;
  return {window.constant + fold(uprightSums), window.constant + fold(turnedSums)};
}

FLUIDYMATION_AVX2 inline __m128i load64(const void* at) {
  return _mm_loadl_epi64(static_cast<const __m128i*>(at));
}

/// Colours or guides of the samples i and i + 1, one in each half.
template <typename T>
FLUIDYMATION_AVX2 inline __m128i twoOf(const T* centre, const std::int32_t* offsets,
                                       std::size_t i) {
  return _mm_unpacklo_epi64(load64(centre + offsets[i]), load64(centre + offsets[i + 1]));
}

/// All bits set in the half of each colour that exists.
FLUIDYMATION_AVX2 inline __m128i existing(__m128i colors) {
  const __m128i weights = _mm_shufflehi_epi16(_mm_shufflelo_epi16(colors, 0xFF), 0xFF);
  return _mm_cmpgt_epi16(weights, _mm_setzero_si128());
}

FLUIDYMATION_AVX2 inline __m128i mix(__m128i from, __m128i to, __m128i share) {
  return _mm_add_epi16(from, _mm_mulhrs_epi16(_mm_sub_epi16(to, from), share));
}

FLUIDYMATION_AVX2 void gather(const WindowSource& source, const WindowWeights& weights,
                              TargetWindow& window) {
  __m128i counts = _mm_setzero_si128();  // of the picture and of the previous one
  for (std::size_t i = 0; i < kPatchArea; ++i) {
    const __m128i both = _mm_unpacklo_epi64(load64(source.picture + source.offsets[i]),
                                            load64(source.previous + source.offsets[i]));
    counts = _mm_add_epi16(counts, _mm_srli_epi64(both, 48));
  }
  const float colorWeight = weights.ofColor(_mm_extract_epi16(counts, 0));
  const float previousWeight = weights.ofPrevious(_mm_extract_epi16(counts, 4));
  const std::int16_t share = blendShare(colorWeight, previousWeight);

  const __m128i shares = _mm_set1_epi16(share);
  const __m128 ofColor = _mm_set1_ps(colorWeight);
  const __m128 ofPrevious = _mm_set1_ps(previousWeight);
  const __m128 ofGuides = _mm_setr_ps(weights.dist, weights.flow, 0.0F, 0.0F);
  __m128 apart = _mm_setzero_ps();
  for (std::size_t i = 0; i < TargetWindow::kSamples; i += 2) {
    const __m128i t = twoOf(source.picture, source.offsets, i);
    const __m128i p = twoOf(source.previous, source.offsets, i);
    const __m128i guides = twoOf(source.guides, source.offsets, i);
    const __m128i isColored = existing(t);
    __m128i isRemembered = existing(p);
    if (i + 1 == kPatchArea) {  // the second one is none of the window's
      isRemembered = _mm_move_epi64(isRemembered);
    }
    const __m128i isBoth = _mm_and_si128(isColored, isRemembered);
    const __m128i mixed = mix(t, p, _mm_and_si128(shares, isBoth));
    const __m128i onlyPrevious = _mm_andnot_si128(isColored, isRemembered);
    const __m128i color =
        _mm_blend_epi16(_mm_blendv_epi8(mixed, p, onlyPrevious), _mm_set1_epi16(1), 0x88);
    const __m128i difference = _mm_and_si128(_mm_sub_epi16(p, t), isBoth);
    apart = _mm_add_ps(apart, _mm_cvtepi32_ps(_mm_madd_epi16(difference, difference)));

    const __m128i first = _mm_unpacklo_epi64(color, guides);
    const __m128i second = _mm_unpackhi_epi64(color, guides);
    auto* const value = reinterpret_cast<__m128i*>(window.value.data() + i);
    auto* const swapped = reinterpret_cast<__m128i*>(window.swapped.data() + i);
    constexpr int kSwap = _MM_SHUFFLE(2, 3, 1, 0);
    _mm_store_si128(value, first);
    _mm_store_si128(value + 1, second);
    _mm_store_si128(swapped, _mm_shufflehi_epi16(first, kSwap));
    _mm_store_si128(swapped + 1, _mm_shufflehi_epi16(second, kSwap));

    const __m128 both = _mm_add_ps(_mm_and_ps(_mm_castsi128_ps(isColored), ofColor),
                                   _mm_and_ps(_mm_castsi128_ps(isRemembered), ofPrevious));
    _mm_store_ps(window.weight[i].data(), _mm_movelh_ps(both, ofGuides));
    _mm_store_ps(window.weight[i + 1].data(),
                 _mm_shuffle_ps(both, ofGuides, _MM_SHUFFLE(1, 0, 3, 2)));
  }
  window.weight[kPatchArea] = {};
  const __m128 pair = _mm_add_ps(apart, _mm_movehl_ps(apart, apart));
  const float sum = _mm_cvtss_f32(_mm_add_ss(pair, _mm_movehdup_ps(pair)));
  window.constant = colorWeight * (static_cast<float>(share) * kShareStep) * sum;
}

FLUIDYMATION_AVX2 inline void add(std::int32_t* sum, std::int32_t weight, __m128i color) {
  auto* const at = reinterpret_cast<__m128i*>(sum);
  const __m128i weighted = _mm_mullo_epi32(_mm_set1_epi32(weight), _mm_cvtepi16_epi32(color));
  _mm_store_si128(at, _mm_add_epi32(_mm_load_si128(at), weighted));
}

FLUIDYMATION_AVX2 void addColors(const SourceWindow& source, const WindowSums& sums) {
  const Turn turn = turnOf(source);
  const auto& weights = sums.weights->ofSample;
  Addresses addresses;
  std::size_t first = 0;
  for (; first + kSampleBlock <= kPatchArea; first += kSampleBlock) {
    if (!sums.weights->blockCounts[first / kSampleBlock]) continue;
    locate(turn, first, addresses);
    for (std::size_t i = 0; i < kSampleBlock; i += 2) {
      const __m256i pair = samplePair(source, addresses, i);
      add(sums.centre + sums.offsets[first + i], weights[first + i], _mm256_castsi256_si128(pair));
      add(sums.centre + sums.offsets[first + i + 1], weights[first + i + 1],
          _mm256_extracti128_si256(pair, 1));
    }
  }
  locate(turn, first, addresses);
  add(sums.centre + sums.offsets[first], weights[first],
      _mm256_castsi256_si128(samplePair(source, addresses, 0)));
}

FLUIDYMATION_AVX2 std::array<float, 4> weightedGrid(const Texel* first, std::ptrdiff_t stride,
                                                    std::size_t taps, const float* columnWeights,
                                                    const float* rowWeights) {
  __m128 sum = _mm_setzero_ps();
  for (std::size_t j = 0; j < taps; ++j, first += stride) {
    __m128 along = _mm_setzero_ps();
    for (std::size_t i = 0; i < taps; ++i) {
      const __m128 color = _mm_cvtepi32_ps(_mm_cvtepi16_epi32(load64(first + i)));
      along = _mm_add_ps(along, _mm_mul_ps(_mm_set1_ps(columnWeights[i]), color));
    }
    sum = _mm_add_ps(sum, _mm_mul_ps(_mm_set1_ps(rowWeights[j]), along));
  }
  std::array<float, 4> result;
  _mm_storeu_ps(result.data(), sum);
  return result;
}

}  // namespace

const PatchKernels* avx2Kernels() {
  static const PatchKernels kernels{"AVX2", distance,     bothDistances,
                                    gather, weightedGrid, addColors};
  return __builtin_cpu_supports("avx2") ? &kernels : nullptr;
}

}  // namespace fluidymation

#else

namespace fluidymation {
const PatchKernels* avx2Kernels() { return nullptr; }
}  // namespace fluidymation

#endif
