#include "fluidymation/synthesis/detail_bands.h"

#include <gtest/gtest.h>
#include <omp.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "fluidymation/guides/distance_field.h"
#include "support/synthetic_scene.h"

namespace fluidymation {
namespace {

constexpr Size kSize{41, 33};
constexpr Lab kSurface{-300.0F, 200.0F, 500.0F};

/// A shape with a hole, a thin part and a cut by the image's edge.
Mask shape() {
  Mask mask(kSize);
  for (int y = 0; y < kSize.height; ++y) {
    for (int x = 0; x < kSize.width; ++x) {
      const bool body = (x - 18) * (x - 18) + (y - 16) * (y - 16) < 140;
      const bool hole = (x - 20) * (x - 20) + (y - 14) * (y - 14) < 8;
      const bool tail = y == 17 && x > 18;
      mask(x, y) = (body && !hole) || tail ? 1 : 0;
    }
  }
  return mask;
}

/// Random colours inside, a strong one outside.
Image<Lab> paintedOn(const Mask& mask, const Lab& outside) {
  Image<Lab> picture = test::randomTexture(mask.size(), 3);
  for (std::size_t i = 0; i < picture.pixelCount(); ++i) {
    if (mask.data()[i] == 0) picture.data()[i] = outside;
  }
  return picture;
}

/// The mean of the pixels inside by their Gaussian weights, pixel by pixel; past the image's edge
/// the edge is repeated.
Lab smoothAt(const Image<Lab>& picture, const Mask& mask, int x, int y, float sigmaPx) {
  const int reach = static_cast<int>(std::ceil(3.0F * sigmaPx));
  double weights = 0.0;
  double l = 0.0;
  double a = 0.0;
  double b = 0.0;
  for (int v = -reach; v <= reach; ++v) {
    for (int u = -reach; u <= reach; ++u) {
      if (mask.clamped(x + u, y + v) == 0) continue;
      const double weight = std::exp(-0.5 * (u * u + v * v) / (double{sigmaPx} * sigmaPx));
      const Lab& color = picture.clamped(x + u, y + v);
      weights += weight;
      l += weight * static_cast<double>(color.l);
      a += weight * static_cast<double>(color.a);
      b += weight * static_cast<double>(color.b);
    }
  }
  return {static_cast<float>(l / weights), static_cast<float>(a / weights),
          static_cast<float>(b / weights)};
}

void expectNear(const Lab& found, const Lab& wanted, int x, int y) {
  EXPECT_NEAR(found.l, wanted.l, 2e-4F) << x << ", " << y;
  EXPECT_NEAR(found.a, wanted.a, 2e-4F) << x << ", " << y;
  EXPECT_NEAR(found.b, wanted.b, 2e-4F) << x << ", " << y;
}

TEST(DetailBands, AreDifferencesOfGaussiansOfWhatIsInside) {
  const Mask mask = shape();
  const Image<Lab> picture = paintedOn(mask, kSurface);
  const DetailBands bands = detailBands(picture, mask);
  for (int y = 0; y < kSize.height; ++y) {
    for (int x = 0; x < kSize.width; ++x) {
      if (mask(x, y) == 0) {
        expectNear(bands[0](x, y), {}, x, y);
        expectNear(bands[1](x, y), {}, x, y);
        continue;
      }
      const Lab& color = picture(x, y);
      const Lab finer = smoothAt(picture, mask, x, y, kDetailSigmasPx[0]);
      const Lab coarser = smoothAt(picture, mask, x, y, kDetailSigmasPx[1]);
      expectNear(bands[0](x, y), {color.l - finer.l, color.a - finer.a, color.b - finer.b}, x, y);
      expectNear(bands[1](x, y), {finer.l - coarser.l, finer.a - coarser.a, finer.b - coarser.b}, x,
                 y);
    }
  }
}

TEST(DetailBands, AreEmptyWhereThereIsNoDetailWhateverSurroundsIt) {
  const Mask mask = shape();
  Image<Lab> picture(kSize);
  for (std::size_t i = 0; i < picture.pixelCount(); ++i) {
    picture.data()[i] = mask.data()[i] != 0 ? Lab{40.0F, -10.0F, 20.0F} : kSurface;
  }
  const DetailBands bands = detailBands(picture, mask);
  for (int y = 0; y < kSize.height; ++y) {
    for (int x = 0; x < kSize.width; ++x) {
      expectNear(bands[0](x, y), {}, x, y);
      expectNear(bands[1](x, y), {}, x, y);
    }
  }
}

TEST(DetailClasses, BeginBehindTheEdgeAndTellRimFromInside) {
  constexpr float kBorderPx = 10.0F;
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  for (const float depth : {-50.0F, -1.0F, 1.0F, 1.99F, kNan}) {
    EXPECT_FALSE(detailClass(depth, kBorderPx)) << depth;
  }
  EXPECT_EQ(detailClass(2.0F, kBorderPx), 0U);
  EXPECT_EQ(detailClass(3.9F, kBorderPx), 0U);
  EXPECT_EQ(detailClass(4.1F, kBorderPx), 1U);
  EXPECT_EQ(detailClass(9.9F, kBorderPx), kFirstInsideClass - 1);
  EXPECT_EQ(detailClass(10.0F, kBorderPx), kFirstInsideClass);
  EXPECT_EQ(detailClass(51.0F, kBorderPx), kDetailClasses - 1);
  EXPECT_EQ(detailClass(std::numeric_limits<float>::infinity(), kBorderPx), kDetailClasses - 1);
  EXPECT_EQ(detailClass(2.0F, 0.1F), kDetailClasses - 1) << "a border narrower than the edge";
}

TEST(DetailEnergies, AreSumsOverThePixelsOfADepth) {
  const Mask mask = shape();
  const Image<float> depth = signedDistance(mask);
  constexpr float kBorderPx = 6.0F;
  const DetailBands bands = detailBands(paintedOn(mask, kSurface), mask);
  const DetailEnergy energy = detailEnergy(bands, depth, kBorderPx);
  for (std::size_t c = 0; c < kDetailClasses; ++c) {
    std::int64_t pixels = 0;
    std::array<double, kDetailSigmasPx.size()> squares{};
    for (int y = 0; y < kSize.height; ++y) {
      for (int x = 0; x < kSize.width; ++x) {
        if (detailClass(depth(x, y), kBorderPx) != c) continue;
        ++pixels;
        for (std::size_t band = 0; band < squares.size(); ++band) {
          const Lab& d = bands[band](x, y);
          squares[band] += static_cast<double>(d.l * d.l + d.a * d.a + d.b * d.b);
        }
      }
    }
    EXPECT_EQ(energy.pixels(c), pixels) << c;
    for (std::size_t band = 0; band < squares.size(); ++band) {
      EXPECT_NEAR(energy.squares(c, band), squares[band], 1e-5 * squares[band]) << c;
    }
  }
  EXPECT_GT(energy.pixels(0), 0);
  EXPECT_GT(energy.pixels(kFirstInsideClass), 0);
}

TEST(DetailEnergies, AreTheSameForAnyNumberOfThreads) {
  const Mask mask = shape();
  const Image<float> depth = signedDistance(mask);
  const auto energyBy = [&](int threads) {
    const int before = omp_get_max_threads();
    omp_set_num_threads(threads);
    const DetailEnergy energy =
        detailEnergy(detailBands(paintedOn(mask, kSurface), mask), depth, 4.0F);
    omp_set_num_threads(before);
    return energy;
  };
  const DetailEnergy one = energyBy(1);
  for (const int threads : {2, 3, 7}) {
    const DetailEnergy more = energyBy(threads);
    for (std::size_t c = 0; c < kDetailClasses; ++c) {
      EXPECT_EQ(more.squares(c, 0), one.squares(c, 0)) << threads;
      EXPECT_EQ(more.squares(c, 1), one.squares(c, 1)) << threads;
    }
  }
}

}  // namespace
}  // namespace fluidymation
