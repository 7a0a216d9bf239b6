#include "fluidymation/synthesis/detail_bands.h"

#include <algorithm>
#include <cassert>
#include <vector>

#include "fluidymation/core/parallel.h"
#include "fluidymation/guides/gaussian.h"

namespace fluidymation {
namespace {

constexpr std::array<float Lab::*, 3> kChannels{&Lab::l, &Lab::a, &Lab::b};

Image<float> ofMask(const Mask& mask) {
  Image<float> weights(mask.size());
  std::transform(mask.begin(), mask.end(), weights.begin(),
                 [](std::uint8_t m) { return m != 0 ? 1.0F : 0.0F; });
  return weights;
}

}  // namespace

DetailBands detailBands(const Image<Lab>& picture, const Mask& mask) {
  static_assert(kDetailSigmasPx.size() == 2);
  assert(picture.size() == mask.size());
  DetailBands bands;
  for (Image<Lab>& band : bands) band = Image<Lab>(picture.size());
  const Image<float> inside = ofMask(mask);
  const Image<float> ofFiner = gaussianBlur(inside, kDetailSigmasPx[0]);
  const Image<float> ofCoarser = gaussianBlur(inside, kDetailSigmasPx[1]);
  for (float Lab::*channel : kChannels) {
    Image<float> values(picture.size());
    forEachRow(picture.height(), [&](int y) {
      for (int x = 0; x < picture.width(); ++x) {
        if (mask(x, y) != 0) values(x, y) = picture(x, y).*channel;
      }
    });
    const Image<float> finer = gaussianBlur(values, kDetailSigmasPx[0]);
    const Image<float> coarser = gaussianBlur(values, kDetailSigmasPx[1]);
    forEachRow(picture.height(), [&](int y) {
      for (int x = 0; x < picture.width(); ++x) {
        if (mask(x, y) == 0) continue;
        const float smooth = finer(x, y) / ofFiner(x, y);
        bands[0](x, y).*channel = values(x, y) - smooth;
        bands[1](x, y).*channel = smooth - coarser(x, y) / ofCoarser(x, y);
      }
    });
  }
  return bands;
}

std::optional<std::size_t> detailClass(float depthPx, float borderWidthPx) {
  if (!(depthPx >= kEdgeDepthPx)) return std::nullopt;
  const auto* above =
      std::upper_bound(kDetailDepths.begin(), kDetailDepths.end(), depthPx / borderWidthPx);
  return static_cast<std::size_t>(above - kDetailDepths.begin());
}

void DetailEnergy::add(std::size_t depthClass,
                       const std::array<Lab, kDetailSigmasPx.size()>& detail) {
  Sum& sum = sums_[depthClass];
  ++sum.pixels;
  for (std::size_t band = 0; band < detail.size(); ++band) {
    for (const float Lab::*channel : kChannels) {
      const auto value = static_cast<double>(detail[band].*channel);
      sum.squares[band] += value * value;
    }
  }
}

void DetailEnergy::add(const DetailEnergy& other) {
  for (std::size_t c = 0; c < sums_.size(); ++c) {
    sums_[c].pixels += other.sums_[c].pixels;
    for (std::size_t band = 0; band < sums_[c].squares.size(); ++band) {
      sums_[c].squares[band] += other.sums_[c].squares[band];
    }
  }
}

DetailEnergy detailEnergy(const DetailBands& bands, const Image<float>& depthPx,
                          float borderWidthPx) {
  assert(depthPx.size() == bands[0].size());
  std::vector<DetailEnergy> ofRows(static_cast<std::size_t>(depthPx.height()));
  forEachRow(depthPx.height(), [&](int y) {
    for (int x = 0; x < depthPx.width(); ++x) {
      const auto depthClass = detailClass(depthPx(x, y), borderWidthPx);
      if (!depthClass) continue;
      ofRows[static_cast<std::size_t>(y)].add(*depthClass, {bands[0](x, y), bands[1](x, y)});
    }
  });
  // Always in the order of the rows: sums of floating point depend on it
  DetailEnergy all;
  for (const DetailEnergy& row : ofRows) all.add(row);
  return all;
}

}  // namespace fluidymation
