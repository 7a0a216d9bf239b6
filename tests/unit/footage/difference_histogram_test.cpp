#include "footage/difference_histogram.h"

#include <gtest/gtest.h>

#include <cmath>

#include "footage/film_difference.h"
#include "support/synthetic_film.h"

namespace fluidymation::test {
namespace {

[[nodiscard]] double shareAbove(const Image<float>& difference, float threshold) {
  std::size_t above = 0;
  for (const float d : difference) above += d >= threshold ? 1 : 0;
  return static_cast<double>(above) / static_cast<double>(difference.pixelCount());
}

TEST(FilmDifference, IsTheDistanceInLab) {
  const Image<Lab> bare(Size{5, 4}, Lab{50.0F, 10.0F, -10.0F});
  const Image<Lab> frame(Size{5, 4}, Lab{53.0F, 14.0F, -22.0F});
  for (const float sigma : {0.0F, 1.5F}) {
    for (const float d : filmDifference(frame, bare, sigma)) EXPECT_NEAR(d, 13.0F, 1e-3F);
  }
}

TEST(FilmDifference, AveragesGrainAndNotPaint) {
  const Image<Lab> bare = toLab(filmed(paper()));
  Shot grainy = paper();
  grainy.grain = 0.04F;
  const Image<Lab> frame = toLab(filmed(grainy));
  const double sharp = shareAbove(filmDifference(frame, bare, 0.0F), 5.0F);
  const double averaged = shareAbove(filmDifference(frame, bare, 1.5F), 5.0F);
  EXPECT_GT(sharp, 0.3);
  EXPECT_LT(averaged, 0.02);
  EXPECT_NEAR(filmDifference(toLab(filmed(Shot())), bare, 1.5F)(80, 60),
              filmDifference(toLab(filmed(Shot())), bare, 0.0F)(80, 60), 2.0F);
}

TEST(GrainLevel, IsTheRootMeanSquareOfDifferencesByGrain) {
  const Image<Lab> bare = toLab(filmed(paper()));
  for (const float sigma : {0.0F, 1.0F}) {
    Shot grainy = paper();
    grainy.grain = 0.03F;
    const Image<Lab> frame = toLab(filmed(grainy));
    double square = 0.0;
    for (const float d : filmDifference(frame, bare, sigma)) square += d * d;
    const double wanted = std::sqrt(square / static_cast<double>(bare.pixelCount()));
    EXPECT_NEAR(grainLevel(frame, bare, sigma), wanted, 0.08 * wanted);
    Shot painted;  // hardly changes it
    painted.grain = 0.03F;
    EXPECT_NEAR(grainLevel(toLab(filmed(painted)), bare, sigma), wanted, 0.15 * wanted);
  }
  EXPECT_EQ(grainLevel(bare, bare, 1.0F), 0.0F);
}

TEST(DifferenceHistogram, PartsBareFromPaintWhateverTheirShares) {
  for (const int painted : {10, 100, 900, 2900}) {
    Image<float> difference(Size{60, 50}, 1.0F);
    for (int i = 0; i < painted; ++i) difference.data()[i] = 30.0F + static_cast<float>(i % 7);
    DifferenceHistogram histogram;
    histogram.add(difference, 0.2F);
    EXPECT_GT(histogram.automaticThreshold(), 1.0F);
    EXPECT_LE(histogram.automaticThreshold(), 30.0F);
    EXPECT_GE(histogram.automaticThreshold(), 2.3F);
  }
}

TEST(DifferenceHistogram, GrainAloneIsNoPaint) {
  const Image<Lab> bare = toLab(filmed(paper()));
  for (const float grain : {0.0F, 0.01F, 0.05F, 0.1F}) {
    Shot shot = paper();
    shot.grain = grain;
    const Image<float> difference = filmDifference(toLab(filmed(shot)), bare, 1.0F);
    DifferenceHistogram histogram;
    histogram.add(difference, grainLevel(toLab(filmed(shot)), bare, 1.0F));
    EXPECT_LT(shareAbove(difference, histogram.automaticThreshold()), 0.0005) << grain;
  }
}

TEST(DifferenceHistogram, IsOneForAllFrames) {
  DifferenceHistogram once;
  DifferenceHistogram reversed;
  const Image<float> pale(Size{20, 20}, 3.0F);
  const Image<float> strong(Size{20, 20}, 40.0F);
  once.add(pale, 1.0F);
  once.add(strong, 1.0F);
  reversed.add(strong, 1.0F);
  reversed.add(pale, 1.0F);
  EXPECT_EQ(once.automaticThreshold(), reversed.automaticThreshold());
  DifferenceHistogram nothing;
  EXPECT_FLOAT_EQ(nothing.automaticThreshold(), 2.3F);
}

}  // namespace
}  // namespace fluidymation::test
