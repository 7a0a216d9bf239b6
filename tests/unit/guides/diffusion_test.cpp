#include "fluidymation/guides/diffusion.h"

#include <omp.h>

#include <array>
#include <cmath>
#include <cstring>
#include <utility>
#include <vector>

#include "fluidymation/core/box.h"
#include "fluidymation/core/random.h"
#include "fluidymation/guides/motion.h"
#include "support/comparison.h"
#include "support/shapes.h"

namespace fluidymation {
namespace {

constexpr std::array<std::pair<int, int>, 4> kNeighbours = {{{-1, 0}, {1, 0}, {0, -1}, {0, 1}}};

/// Values f(x, y) at the border, nonsense elsewhere: the solver must not read it.
template <typename Function>
Image<Vec2> given(const Mask& isBorder, const Function& f) {
  Image<Vec2> field(isBorder.size(), Vec2{1000.0F, -1000.0F});
  for (int y = 0; y < field.height(); ++y) {
    for (int x = 0; x < field.width(); ++x) {
      if (isBorder(x, y) != 0) field(x, y) = f(x, y);
    }
  }
  return field;
}

Vec2 noise(std::uint64_t seed, int x, int y) {
  RandomKey key;
  key.seed = seed;
  key.x = x;
  key.y = y;
  Random random(key);
  const float u = static_cast<float>(random.uniform(-1000, 1000)) / 1000.0F;
  return {u, static_cast<float>(random.uniform(-1000, 1000)) / 1000.0F};
}

template <typename Function>
Image<Vec2> everywhere(const Mask& region, const Function& f) {
  Image<Vec2> field(region.size());
  for (int y = 0; y < field.height(); ++y) {
    for (int x = 0; x < field.width(); ++x) {
      if (region(x, y) != 0) field(x, y) = f(x, y);
    }
  }
  return field;
}

float largestLength(const Image<Vec2>& field) {
  float largest = 0.0F;
  for (const Vec2 v : field) largest = std::max(largest, length(v));
  return largest;
}

/// Gaussian elimination in double precision on all pixels of the region. A part without border is
/// singular: its unknowns come out as zero, as the contract wants.
Image<Vec2> solvedDirectly(const Mask& region, const Mask& isBorder, const Image<Vec2>& field) {
  Image<int> number(region.size(), -1);
  std::vector<std::pair<int, int>> unknowns;
  for (int y = 0; y < region.height(); ++y) {
    for (int x = 0; x < region.width(); ++x) {
      if (region(x, y) == 0 || isBorder(x, y) != 0) continue;
      number(x, y) = static_cast<int>(unknowns.size());
      unknowns.emplace_back(x, y);
    }
  }
  const std::size_t n = unknowns.size();
  std::vector<std::vector<double>> row(n, std::vector<double>(n + 2));
  for (std::size_t i = 0; i < n; ++i) {
    for (const auto& [dx, dy] : kNeighbours) {
      const int x = unknowns[i].first + dx;
      const int y = unknowns[i].second + dy;
      if (!region.contains(x, y) || region(x, y) == 0) continue;
      row[i][i] += 1.0;
      if (isBorder(x, y) != 0) {
        row[i][n] += static_cast<double>(field(x, y).x);
        row[i][n + 1] += static_cast<double>(field(x, y).y);
      } else {
        row[i][static_cast<std::size_t>(number(x, y))] -= 1.0;
      }
    }
  }
  // The matrix is symmetric and positive semidefinite: no exchange of rows is needed
  for (std::size_t k = 0; k < n; ++k) {
    if (row[k][k] < 1e-9) continue;
    for (std::size_t i = k + 1; i < n; ++i) {
      const double factor = row[i][k] / row[k][k];
      if (factor == 0.0) continue;
      for (std::size_t j = k; j < n + 2; ++j) row[i][j] -= factor * row[k][j];
    }
  }
  for (std::size_t k = n; k-- > 0;) {
    for (std::size_t c = n; c < n + 2; ++c) {
      double sum = row[k][c];
      for (std::size_t j = k + 1; j < n; ++j) sum -= row[k][j] * row[j][c];
      row[k][c] = row[k][k] < 1e-9 ? 0.0 : sum / row[k][k];
    }
  }
  Image<Vec2> result(region.size());
  for (int y = 0; y < region.height(); ++y) {
    for (int x = 0; x < region.width(); ++x) {
      if (isBorder(x, y) != 0) result(x, y) = field(x, y);
      if (number(x, y) < 0) continue;
      const std::vector<double>& solved = row[static_cast<std::size_t>(number(x, y))];
      result(x, y) = {static_cast<float>(solved[n]), static_cast<float>(solved[n + 1])};
    }
  }
  return result;
}

/// Mean of the neighbours within the region minus the value: what is left to relax.
float largestDefect(const Mask& region, const Mask& isBorder, const Image<Vec2>& field) {
  float largest = 0.0F;
  for (int y = 0; y < region.height(); ++y) {
    for (int x = 0; x < region.width(); ++x) {
      if (region(x, y) == 0 || isBorder(x, y) != 0) continue;
      Vec2 sum;
      float count = 0.0F;
      for (const auto& [dx, dy] : kNeighbours) {
        if (!region.contains(x + dx, y + dy) || region(x + dx, y + dy) == 0) continue;
        sum += field(x + dx, y + dy);
        count += 1.0F;
      }
      if (count > 0.0F) largest = std::max(largest, length((1.0F / count) * sum - field(x, y)));
    }
  }
  return largest;
}

TEST(Diffusion, ConstantAndLinearFieldsAreReproduced) {
  const Mask region = test::disc({70, 60}, {33.0F, 30.0F}, 26.5F);
  const Mask border = borderPixels(region);
  const auto constant = [](int, int) { return Vec2{2.0F, -3.0F}; };
  const auto linear = [](int x, int y) {
    return Vec2{0.02F * static_cast<float>(x) - 0.4F, 0.01F * static_cast<float>(x - 2 * y)};
  };
  Image<Vec2> field = given(border, constant);
  EXPECT_TRUE(diffuse(region, border, field).converged);
  EXPECT_TRUE(test::nearEverywhere(everywhere(region, constant), field, 3.6F * 2e-3F));
  field = given(border, linear);
  EXPECT_TRUE(diffuse(region, border, field).converged);
  const Image<Vec2> expected = everywhere(region, linear);
  EXPECT_TRUE(test::nearEverywhere(expected, field, 2e-3F * largestLength(expected)));
}

TEST(Diffusion, AgreesWithADirectSolveWhereverTheBorderIs) {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    // Even seeds: the border of the shape. Odd seeds: few scattered pixels, so that holes and the
    // image edge stand for most of the outline.
    const Mask region =
        seed % 3 == 0 ? test::randomMask({19, 17}, seed, 75) : test::randomBlobs({21, 18}, seed);
    const Mask scattered = test::randomMask(region.size(), 100 + seed, 3);
    const Mask border =
        seed % 2 == 0 ? borderPixels(region) : test::maskOf(region.size(), [&](int x, int y) {
          return region(x, y) != 0 && scattered(x, y) != 0;
        });
    Image<Vec2> field = given(border, [&](int x, int y) { return noise(seed, x, y); });
    const Image<Vec2> expected = solvedDirectly(region, border, field);
    const SolveReport report = diffuse(region, border, field);
    EXPECT_TRUE(report.converged);
    EXPECT_TRUE(test::nearEverywhere(expected, field, 1e-2F * largestLength(expected))) << seed;
  }
}

TEST(Diffusion, StaysBetweenTheExtremesOfTheBorder) {
  const Mask region = test::randomBlobs({80, 64}, 4);
  const Mask border = borderPixels(region);
  // x in [0, 1], y in [2, 3]
  Image<Vec2> field = given(border, [&](int x, int y) {
    const Vec2 v = noise(8, x, y);
    return Vec2{0.5F + 0.5F * v.x, 2.5F + 0.5F * v.y};
  });
  diffuse(region, border, field);
  constexpr float kSlack = 1e-2F * 3.2F;  // the solver's error, of the largest value
  for (int y = 0; y < region.height(); ++y) {
    for (int x = 0; x < region.width(); ++x) {
      if (region(x, y) == 0) continue;
      ASSERT_GE(field(x, y).x, -kSlack);
      ASSERT_LE(field(x, y).x, 1.0F + kSlack);
      ASSERT_GE(field(x, y).y, 2.0F - kSlack);
      ASSERT_LE(field(x, y).y, 3.0F + kSlack);
    }
  }
}

TEST(Diffusion, SeparateRegionsDoNotMixEvenInOneBlockOfACoarseLevel) {
  // Diagonal stripes, 4 px wide, one pixel apart: 4-connected each, and interleaved at all levels
  const Mask region = test::maskOf({64, 64}, [](int x, int y) { return (x + y) % 5 != 0; });
  const auto ofStripe = [](int x, int y) {
    return (x + y) / 5 % 2 == 0 ? Vec2{1.0F, 0.0F} : Vec2{0.0F, -2.0F};
  };
  // Given at the image edge only: the stripes' flanks are free
  const Mask border = test::maskOf({64, 64}, [&](int x, int y) {
    return region(x, y) != 0 && (x == 0 || y == 0 || x == 63 || y == 63);
  });
  Image<Vec2> field = given(border, ofStripe);
  EXPECT_TRUE(diffuse(region, border, field).converged);
  EXPECT_TRUE(test::nearEverywhere(everywhere(region, ofStripe), field, 2e-2F));
}

TEST(Diffusion, APartWithoutBorderGetsZero) {
  const Mask region = test::maskOf({40, 20}, [](int x, int) { return x != 20; });
  const Mask border = test::maskOf({40, 20}, [](int x, int) { return x == 0; });
  Image<Vec2> field = given(border, [](int, int) { return Vec2{1.0F, 1.0F}; });
  diffuse(region, border, field);
  const Image<Vec2> expected = everywhere(region, [](int x, int) {
    return x < 20 ? Vec2{1.0F, 1.0F} : Vec2{};
  });
  EXPECT_TRUE(test::nearEverywhere(expected, field, 1e-2F));
}

TEST(Diffusion, NothingFlowsAcrossTheImageEdge) {
  // Given at the left and right end of the image only: the profile is linear along x, and the
  // same in every row, up to the edge
  const Mask region(Size{51, 13}, 1);
  const Mask border = test::maskOf(region.size(), [](int x, int) { return x == 0 || x == 50; });
  const auto ramp = [](int x, int) {
    return Vec2{static_cast<float>(x) / 50.0F, 1.0F - static_cast<float>(x) / 50.0F};
  };
  Image<Vec2> field = given(border, ramp);
  diffuse(region, border, field);
  EXPECT_TRUE(test::nearEverywhere(everywhere(region, ramp), field, 1e-2F));
}

TEST(Diffusion, FewCyclesAreEnoughOnALargeDisc) {
  const Mask region = test::disc({400, 400}, {200.0F, 200.0F}, 187.5F);  // 110 000 px
  const Mask border = borderPixels(region);
  Image<Vec2> field = given(border, [](int x, int y) {
    return Vec2{static_cast<float>(x - 200) / 187.0F, static_cast<float>(y - 200) / 187.0F};
  });
  const SolveReport report = diffuse(region, border, field);
  EXPECT_TRUE(report.converged);
  EXPECT_LE(report.cycles, 8);  // 6 measured
  EXPECT_LE(largestDefect(region, border, field), 1e-3F);
}

TEST(Diffusion, FewCyclesAreEnoughOnCombs) {
  // Teeth one pixel wide, of which only the far end of the spine is given, and teeth of a shape
  const Mask thin = test::maskOf({200, 160}, [](int x, int y) { return y < 9 || x % 2 == 0; });
  const Mask spine = test::maskOf(thin.size(), [](int, int y) { return y == 0; });
  Image<Vec2> field = given(spine, [](int x, int y) { return noise(5, x, y); });
  SolveReport report = diffuse(thin, spine, field);
  EXPECT_TRUE(report.converged);
  EXPECT_LE(report.cycles, 12);
  EXPECT_LE(largestDefect(thin, spine, field), 1e-3F);

  const Mask wide =
      test::maskOf({200, 160}, [](int x, int y) { return y > 4 && (y < 20 || x % 9 < 5); });
  const Mask border = borderPixels(wide);
  field = given(border, [](int x, int y) { return noise(6, x, y); });
  report = diffuse(wide, border, field);
  EXPECT_TRUE(report.converged);
  EXPECT_LE(report.cycles, 10);
}

TEST(Diffusion, AFoldedPathIsSolvedToItsEnd) {
  // One pixel wide, 577 long, folded into a square, given at both ends: linear along its length
  constexpr int kSide = 33;
  const auto position = [](int x, int y) {
    const int row = y / 2;
    const int along = y % 2 == 1 ? kSide : (row % 2 == 0 ? x : kSide - 1 - x);
    return static_cast<float>(row * (kSide + 1) + along);
  };
  const Mask region = test::maskOf(
      {kSide, kSide}, [](int x, int y) { return y % 2 == 0 || x == (y % 4 == 1 ? kSide - 1 : 0); });
  const Mask ends = test::maskOf({kSide, kSide}, [](int x, int y) {
    return (x == 0 && y == 0) || (x == kSide - 1 && y == kSide - 1);
  });
  const float total = position(kSide - 1, kSide - 1);
  const auto ramp = [&](int x, int y) { return Vec2{position(x, y) / total, 0.0F}; };
  Image<Vec2> field = given(ends, ramp);
  diffuse(region, ends, field);
  EXPECT_TRUE(test::nearEverywhere(everywhere(region, ramp), field, 1e-2F));
}

TEST(Diffusion, RegionsWithNothingToSolveAreLeftAlone) {
  Image<Vec2> field(Size{4, 3}, Vec2{7.0F, 7.0F});
  SolveReport report = diffuse(Mask(Size{4, 3}), Mask(Size{4, 3}), field);
  EXPECT_TRUE(report.converged);
  EXPECT_TRUE(test::nearEverywhere(Image<Vec2>(Size{4, 3}), field, 0.0F));

  field = Image<Vec2>(Size{1, 1}, Vec2{7.0F, 7.0F});
  report = diffuse(Mask(Size{1, 1}, 1), Mask(Size{1, 1}, 1), field);
  EXPECT_TRUE(report.converged);
  EXPECT_TRUE(test::nearEverywhere(Image<Vec2>(Size{1, 1}, Vec2{7.0F, 7.0F}), field, 0.0F));
}

TEST(Diffusion, TheNumberOfThreadsDoesNotShow) {
  const Mask region = test::disc({300, 300}, {150.0F, 150.0F}, 130.0F);
  const Mask border = borderPixels(region);
  const int before = omp_get_max_threads();
  std::vector<Image<Vec2>> results;
  for (const int threads : {1, 2, 5}) {
    omp_set_num_threads(threads);
    results.push_back(given(border, [](int x, int y) { return noise(9, x, y); }));
    diffuse(region, border, results.back());
  }
  omp_set_num_threads(before);
  const std::size_t bytes = results[0].pixelCount() * sizeof(Vec2);
  EXPECT_EQ(std::memcmp(results[0].data(), results[1].data(), bytes), 0);
  EXPECT_EQ(std::memcmp(results[0].data(), results[2].data(), bytes), 0);
}

TEST(SolveReports, OfTwoTheOneThatDidNotSettleIsTold) {
  const SolveReport settled{40, 1e-4F, true};
  const SolveReport quick{3, 1e-5F, true};
  const SolveReport unsettled{100, 0.5F, false};
  EXPECT_EQ(worse(settled, unsettled).cycles, 100);
  EXPECT_EQ(worse(unsettled, settled).cycles, 100);
  EXPECT_FALSE(worse(settled, unsettled).converged);
  EXPECT_EQ(worse(quick, settled).cycles, 40);
  EXPECT_EQ(worse(settled, quick).cycles, 40);
}

TEST(Diffusion, APartOfAnImageGivesWhatTheImageGives) {
  const Size size{150, 130};
  const Box box{38, 26, 142, 119};
  for (const std::uint64_t seed : {1U, 2U}) {
    const Mask blobs = test::randomBlobs(box.size(), seed);
    const Mask region = test::maskOf(size, [&](int x, int y) {
      const bool within = blobs.contains(x - box.beginX, y - box.beginY);
      return within && blobs(x - box.beginX, y - box.beginY) != 0;
    });
    const Mask border = borderPixels(blobs);
    const Mask wholeBorder = test::maskOf(size, [&](int x, int y) {
      const bool within = border.contains(x - box.beginX, y - box.beginY);
      return within && border(x - box.beginX, y - box.beginY) != 0;
    });
    Image<Vec2> whole(size);
    for (int y = 0; y < size.height; ++y) {
      for (int x = 0; x < size.width; ++x) {
        whole(x, y) = {static_cast<float>(x % 7), static_cast<float>(y * x % 5)};
      }
    }
    Image<Vec2> part = cropped(whole, box);
    const SolveReport wholeReport = diffuse(region, wholeBorder, whole);
    const SolveReport report = diffuse(blobs, border, part, box.begin());
    EXPECT_EQ(report.cycles, wholeReport.cycles);
    EXPECT_EQ(report.lastChange, wholeReport.lastChange);
    EXPECT_TRUE(test::nearEverywhere(cropped(whole, box), part, 0.0F));
  }
}

}  // namespace
}  // namespace fluidymation
