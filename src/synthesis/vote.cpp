#include "fluidymation/synthesis/vote.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "fluidymation/core/parallel.h"
#include "synthesis/patch_kernels.h"
#include "synthesis/sample_order.h"

namespace fluidymation {
namespace {

/// Rows of a picture that are averaged at a time. The windows of kPatchRadius rows on either side
/// are read twice.
constexpr int kBandRows = 32;

/// The nearest place to `match` that is in the image: one that was only enlarged may lie outside.
Match inImage(const Match& match, Size size) {
  constexpr float kHalf = 0.5F;
  // Just below the place that is nearest to the pixel beyond
  const auto last = [](int length) {
    return std::nextafter(static_cast<float>(length) - kHalf, 0.0F);
  };
  return {std::clamp(match.x, -kHalf, last(size.width)),
          std::clamp(match.y, -kHalf, last(size.height)), match.frame, match.rotation};
}

/// The weights of a window's samples, in the order of kSampleOffsets: whole numbers, so that sums
/// are exact. With sigma 0 all are 1.
SampleWeights sampleWeights(float sigmaPx) {
  // Of the window's own pixel; 25 colours times as much fit 32 bits
  constexpr float kWhole = 256.0F;
  SampleWeights weights;
  for (std::size_t i = 0; i < kPatchArea; ++i) {
    std::int32_t& weight = weights.ofSample[i];
    weight = 1;
    if (sigmaPx > 0.0F) {
      const float tx = static_cast<float>(sampleOffsetX(i)) / sigmaPx;
      const float ty = static_cast<float>(sampleOffsetY(i)) / sigmaPx;
      weight = floorToInt(kWhole * std::exp(-0.5F * (tx * tx + ty * ty)) + 0.5F);
    }
    if (weight != 0) weights.blockCounts[i / kSampleBlock] = true;
  }
  return weights;
}

/// Sums of colours for the rows [top, bottom) of a picture, with room for what windows that cover
/// them add beyond.
class BandSums {
 public:
  BandSums(int width, int top, int bottom, const SampleWeights& weights)
      : weights_(weights),
        top_(top),
        bottom_(bottom),
        stride_(static_cast<std::size_t>(width) + 2 * std::size_t{kPatchRadius}),
        sums_(stride_ * (static_cast<std::size_t>(bottom - top) + 2 * std::size_t{kMargin})) {
    for (std::size_t i = 0; i < kPatchArea; ++i) {
      offsets_[i] = static_cast<std::ptrdiff_t>(sizeof(Sum) / sizeof(std::int32_t)) *
                    (sampleOffsetY(i) * static_cast<std::ptrdiff_t>(stride_) + sampleOffsetX(i));
    }
  }

  /// Adds all windows that reach into the band.
  void add(const ExemplarLevel& exemplar, const NearestNeighborField& nnf) {
    const int first = std::max(top_ - kPatchRadius, 0);
    const int end = std::min(bottom_ + kPatchRadius, nnf.height());
    for (int y = first; y < end; ++y) {
      for (int x = 0; x < nnf.width(); ++x) {
        if (!nnf(x, y).exists()) continue;
        const Match match = inImage(nnf(x, y), exemplar.size());
        exemplar.kernels().addColors(sourceWindow(exemplar, match),
                                     {at(x, y).data(), offsets_.data(), &weights_});
      }
    }
  }

  /// Writes the means of the wanted pixels.
  void average(const Image<Segment>& segment, Image<FixedLab>& picture) {
    for (int y = top_; y < bottom_; ++y) {
      for (int x = 0; x < picture.width(); ++x) {
        const Sum& sum = at(x, y);
        if (segment(x, y) == Segment::kOutside || sum[kWeight] == 0) continue;
        const float share = 1.0F / static_cast<float>(sum[kWeight]);
        const auto mean = [share](std::int32_t lane) {
          return static_cast<std::int16_t>(floorToInt(share * static_cast<float>(lane) + 0.5F));
        };
        picture(x, y) = {mean(sum[0]), mean(sum[1]), mean(sum[2]), 1};
      }
    }
  }

 private:
  static constexpr int kMargin = 2 * kPatchRadius;
  static constexpr std::size_t kWeight = 3;  ///< lane of FixedLab::weight
  struct alignas(16) Sum : std::array<std::int32_t, 4> {};

  [[nodiscard]] Sum& at(int x, int y) {
    return sums_[static_cast<std::size_t>(y - top_ + kMargin) * stride_ +
                 static_cast<std::size_t>(x + kPatchRadius)];
  }

  const SampleWeights& weights_;
  int top_;
  int bottom_;
  std::size_t stride_;
  std::vector<Sum> sums_;
  std::array<std::ptrdiff_t, kPatchArea> offsets_{};
};

}  // namespace

Image<FixedLab> vote(const ExemplarLevel& exemplar, const Image<Segment>& segment,
                     const NearestNeighborField& nnf, float sigmaPx) {
  Image<FixedLab> picture(nnf.size());
  const SampleWeights weights = sampleWeights(sigmaPx);
  const int bands = (nnf.height() + kBandRows - 1) / kBandRows;
  parallelFor(bands, 1, [&](int band) {
    BandSums sums(nnf.width(), band * kBandRows, std::min((band + 1) * kBandRows, nnf.height()),
                  weights);
    sums.add(exemplar, nnf);
    sums.average(segment, picture);
  });
  return picture;
}

}  // namespace fluidymation
