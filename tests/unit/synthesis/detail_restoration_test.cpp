#include "fluidymation/synthesis/detail_restoration.h"

#include <gtest/gtest.h>
#include <omp.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "fluidymation/core/random.h"
#include "support/synthetic_scene.h"

namespace fluidymation {
namespace {

constexpr float kBorderPx = 8.0F;

/// A film of a disc, and a painting of the same shape.
class DetailRestoration : public ::testing::Test {
 protected:
  /// Noise of `amplitude(depth)` on a plain medium.
  template <typename Amplitude>
  [[nodiscard]] Image<Lab> noisy(int frame, int seed, const Amplitude& amplitude) const {
    const GuideFrame guides = disc_.guides(frame);
    Image<Lab> picture(disc_.size);
    for (int y = 0; y < picture.height(); ++y) {
      for (int x = 0; x < picture.width(); ++x) {
        Random random({5, seed, 0, 0, x, y});
        const float noise = static_cast<float>(random.uniform(-1000, 1000)) / 1000.0F;
        picture(x, y) = {50.0F + amplitude(guides.distance(x, y)) * noise, 4.0F, -6.0F};
      }
    }
    return picture;
  }

  template <typename Amplitude>
  [[nodiscard]] Exemplar filmOf(const Amplitude& amplitude) const {
    Exemplar film(disc_.size, disc_.frameCount, 0, kBorderPx);
    for (int k = 0; k < disc_.frameCount; ++k) {
      film.setColor(k, noisy(k, k, amplitude));
      film.setGuides(k, disc_.guides(k));
    }
    film.finish();
    return film;
  }

  /// Every pixel shows its own place of a frame of the film.
  [[nodiscard]] NearestNeighborField matches(int frame) const {
    const GuideFrame guides = disc_.guides(frame);
    NearestNeighborField nnf(disc_.size);
    for (int y = 0; y < nnf.height(); ++y) {
      for (int x = 0; x < nnf.width(); ++x) {
        if (guides.mask(x, y) == 0) continue;
        nnf(x, y) = {static_cast<float>(x), static_cast<float>(y), frame, {}};
      }
    }
    return nnf;
  }

  [[nodiscard]] DetailGains gains(const Exemplar& film, const Image<Lab>& picture,
                                  int frame = kFrame) const {
    const GuideFrame guides = disc_.guides(frame);
    FilmDetail detail;
    return detailGains(film, detail, matches(frame), guides.distance,
                       detailEnergy(detailBands(picture, guides.mask), guides.distance, kBorderPx));
  }

  [[nodiscard]] Image<Lab> restored(const Exemplar& film, const Image<Lab>& picture,
                                    float share) const {
    const GuideFrame guides = disc_.guides(kFrame);
    Image<Lab> result = picture.clone();
    FilmDetail detail;
    restoreDetail(film, detail, matches(kFrame), guides.mask, guides.distance, share, result);
    return result;
  }

  static constexpr int kFrame = 4;  // one that is looked at itself
  test::GrowingDisc disc_{Size{96, 88}, {48.0F, 44.0F}, 24.0F, 2.0F, 8};
};

const auto kTen = [](float) { return 10.0F; };

TEST_F(DetailRestoration, LeavesTheFilmItselfAsItIs) {
  const Exemplar film = filmOf(kTen);
  const DetailGains found = gains(film, noisy(kFrame, kFrame, kTen));
  for (std::size_t band = 0; band < kDetailSigmasPx.size(); ++band) {
    EXPECT_NEAR(found.rim[band], 1.0F, 0.01F);
    EXPECT_NEAR(found.inside[band], 1.0F, 0.01F);
  }
}

TEST_F(DetailRestoration, BringsEachBandToTheFilmsEnergy) {
  const Exemplar film = filmOf(kTen);
  for (const float amplitude : {8.5F, 12.0F}) {
    const Image<Lab> painted = noisy(kFrame, kFrame, [=](float) { return amplitude; });
    const DetailGains before = gains(film, painted);
    const DetailGains after = gains(film, restored(film, painted, 1.0F));
    for (std::size_t band = 0; band < kDetailSigmasPx.size(); ++band) {
      EXPECT_NEAR(before.rim[band], 10.0F / amplitude, 0.02F) << amplitude;
      EXPECT_NEAR(before.inside[band], 10.0F / amplitude, 0.02F) << amplitude;
      // What is left over: the bands overlap, so that a change of one is a little of the other's
      EXPECT_NEAR(after.rim[band], 1.0F, 0.04F) << amplitude;
      EXPECT_NEAR(after.inside[band], 1.0F, 0.04F) << amplitude;
    }
  }
}

TEST_F(DetailRestoration, TellsTheRimFromTheInside) {
  const Exemplar film = filmOf(kTen);
  const auto uneven = [](float depth) { return depth < kBorderPx ? 8.5F : 12.0F; };
  const Image<Lab> painted = noisy(kFrame, kFrame, uneven);
  const DetailGains before = gains(film, painted);
  const DetailGains after = gains(film, restored(film, painted, 1.0F));
  for (std::size_t band = 0; band < kDetailSigmasPx.size(); ++band) {
    // The inside reaches a little into the rim's Gaussians
    EXPECT_GT(before.rim[band], 1.05F);
    EXPECT_LT(before.inside[band], 0.9F);
    EXPECT_NEAR(after.rim[band], 1.0F, 0.05F);
    EXPECT_NEAR(after.inside[band], 1.0F, 0.05F);
  }
}

/// As deep as the target is, not as deep as the film is on average.
TEST_F(DetailRestoration, AsksForTheFilmsEnergyAtTheDepthsOfThePainting) {
  const Exemplar film = filmOf([](float depth) { return depth < 14.0F ? 10.0F : 1.0F; });
  const test::GrowingDisc thin{disc_.size, disc_.centre, 13.0F, 0.0F, 1};
  const GuideFrame guides = thin.guides(0);
  NearestNeighborField nnf = matches(kFrame);
  const Image<Lab> picture = noisy(kFrame, 77, kTen);
  FilmDetail detail;
  const DetailGains found =
      detailGains(film, detail, nnf, guides.distance,
                  detailEnergy(detailBands(picture, guides.mask), guides.distance, kBorderPx));
  EXPECT_NEAR(found.inside[0], 1.0F, 0.08F);
}

TEST_F(DetailRestoration, GoesNoFurtherThanItsBounds) {
  const Exemplar film = filmOf(kTen);
  const DetailGains more = gains(film, noisy(kFrame, 77, [](float) { return 1.0F; }));
  const DetailGains less = gains(film, noisy(kFrame, 77, [](float) { return 40.0F; }));
  for (std::size_t band = 0; band < kDetailSigmasPx.size(); ++band) {
    EXPECT_NEAR(more.rim[band], kMostDetailGain, 0.02F);
    EXPECT_NEAR(more.inside[band], kMostDetailGain, 0.02F);
    EXPECT_NEAR(less.rim[band], kLeastDetailGain, 0.02F);
    EXPECT_NEAR(less.inside[band], kLeastDetailGain, 0.02F);
  }
}

TEST_F(DetailRestoration, TrustsFewPixelsLittle) {
  const Exemplar film = filmOf(kTen);
  const test::GrowingDisc speck{disc_.size, disc_.centre, 3.6F, 0.0F, 1};
  const GuideFrame guides = speck.guides(0);
  NearestNeighborField nnf = matches(kFrame);
  for (std::size_t i = 0; i < nnf.pixelCount(); ++i) {
    if (guides.mask.data()[i] == 0) nnf.data()[i] = {};
  }
  const Image<Lab> picture = noisy(kFrame, 77, [](float) { return 1.0F; });
  FilmDetail detail;
  const DetailEnergy energy =
      detailEnergy(detailBands(picture, guides.mask), guides.distance, kBorderPx);
  const auto pixels = static_cast<float>(energy.pixels(0) + energy.pixels(1));
  ASSERT_GT(pixels, 0.0F);
  ASSERT_LT(pixels, 12.0F);
  const DetailGains found = detailGains(film, detail, nnf, guides.distance, energy);
  EXPECT_NEAR(found.rim[0], 1.0F + (kMostDetailGain - 1.0F) * pixels / (pixels + 50.0F), 1e-5F);
  EXPECT_EQ(found.inside[0], 1.0F) << "there is none";
}

/// A speck at the film's beginning says nothing, and pixels that show it are not compared.
TEST_F(DetailRestoration, ComparesNoPixelsOfFramesThatAreTooSmall) {
  const test::GrowingDisc sudden{disc_.size, disc_.centre, 0.5F, 20.0F, 3};
  Exemplar film(sudden.size, sudden.frameCount, 0, kBorderPx);
  for (int k = 0; k < sudden.frameCount; ++k) {
    film.setColor(k, noisy(kFrame, k, kTen));
    film.setGuides(k, sudden.guides(k));
  }
  film.finish();
  const GuideFrame guides = sudden.guides(2);
  NearestNeighborField nnf(sudden.size);
  for (std::size_t i = 0; i < nnf.pixelCount(); ++i) {
    if (guides.mask.data()[i] == 0) continue;
    nnf.data()[i] = {0.0F, 0.0F, i % 3 == 0 ? 0 : 2, {}};
  }
  const Image<Lab> picture = noisy(kFrame, 77, [](float) { return 9.0F; });
  FilmDetail detail;
  const DetailGains found =
      detailGains(film, detail, nnf, guides.distance,
                  detailEnergy(detailBands(picture, guides.mask), guides.distance, kBorderPx));
  for (std::size_t band = 0; band < kDetailSigmasPx.size(); ++band) {
    EXPECT_NEAR(found.rim[band], 10.0F / 9.0F, 0.06F);  // two noises of a thousand pixels each
    EXPECT_NEAR(found.inside[band], 10.0F / 9.0F, 0.06F);
  }
}

/// Every painting stays finite, whatever there is to compare.
TEST(RestoredDetail, IsFiniteForAnyShapeAndBorder) {
  for (const float borderPx : {0.1F, 8.0F, 10000.0F}) {
    for (const int side : {1, 3, 40}) {
      for (const float radiusPx : {0.0F, 1.2F, 200.0F}) {
        const auto middle = static_cast<float>(side / 2);
        const test::GrowingDisc disc{Size{side, side}, {middle, middle}, radiusPx, 0.0F, 2};
        Exemplar film(disc.size, disc.frameCount, 0, borderPx);
        Image<Lab> plain(disc.size);
        for (Lab& color : plain) color = {40.0F, 5.0F, -5.0F};
        for (int k = 0; k < disc.frameCount; ++k) {
          film.setColor(k, plain);
          film.setGuides(k, disc.guides(k));
        }
        film.finish();
        const GuideFrame guides = disc.guides(0);
        NearestNeighborField nnf(disc.size);
        for (std::size_t i = 0; i < nnf.pixelCount(); ++i) {
          if (guides.mask.data()[i] != 0) nnf.data()[i] = {0.0F, 0.0F, 1, {}};
        }
        for (const bool isPlain : {true, false}) {
          Image<Lab> picture = isPlain ? plain.clone() : test::randomTexture(disc.size, 3);
          FilmDetail detail;
          restoreDetail(film, detail, nnf, guides.mask, guides.distance, 1.0F, picture);
          for (const Lab& color : picture) {
            ASSERT_TRUE(std::isfinite(color.l + color.a + color.b))
                << borderPx << ", " << side << ", " << radiusPx;
          }
        }
      }
    }
  }
}

TEST_F(DetailRestoration, KeepsMeanColoursAndWhatIsOutside) {
  const Exemplar film = filmOf(kTen);
  const Image<Lab> painted = noisy(kFrame, 77, [](float) { return 8.0F; });
  const Image<Lab> result = restored(film, painted, 1.0F);
  const GuideFrame guides = disc_.guides(kFrame);
  double change = 0.0;
  double moved = 0.0;
  for (int y = 0; y < disc_.size.height; ++y) {
    for (int x = 0; x < disc_.size.width; ++x) {
      const float difference = result(x, y).l - painted(x, y).l;
      if (guides.mask(x, y) == 0) {
        EXPECT_EQ(difference, 0.0F);
        continue;
      }
      change += static_cast<double>(difference);
      moved += static_cast<double>(std::abs(difference));
      EXPECT_NEAR(result(x, y).a, 4.0F, 1e-3F) << "a channel without detail";
    }
  }
  const auto pixels = static_cast<double>(countInside(guides.mask));
  EXPECT_GT(moved / pixels, 0.3);
  EXPECT_LT(std::abs(change) / pixels, 0.02);
}

TEST_F(DetailRestoration, MakesTheShareOfTheChangeThatIsWanted) {
  const Exemplar film = filmOf(kTen);
  const Image<Lab> painted = noisy(kFrame, 77, [](float) { return 8.0F; });
  const Image<Lab> none = restored(film, painted, 0.0F);
  const Image<Lab> some = restored(film, painted, 0.25F);
  const Image<Lab> all = restored(film, painted, 1.0F);
  for (std::size_t i = 0; i < painted.pixelCount(); ++i) {
    const float before = painted.data()[i].l;
    EXPECT_EQ(none.data()[i].l, before);
    EXPECT_NEAR(some.data()[i].l, before + 0.25F * (all.data()[i].l - before), 1e-4F);
  }
}

TEST_F(DetailRestoration, IsTheSameForAnyNumberOfThreads) {
  const Exemplar film = filmOf(kTen);
  const Image<Lab> painted = noisy(kFrame, 77, [](float) { return 8.0F; });
  const int before = omp_get_max_threads();
  omp_set_num_threads(1);
  const Image<Lab> one = restored(film, painted, 1.0F);
  for (const int threads : {2, 3, 7}) {
    omp_set_num_threads(threads);
    const Image<Lab> more = restored(film, painted, 1.0F);
    const auto alike = [](const Lab& a, const Lab& b) {
      return a.l == b.l && a.a == b.a && a.b == b.b;
    };
    EXPECT_TRUE(std::equal(one.begin(), one.end(), more.begin(), alike)) << threads;
  }
  omp_set_num_threads(before);
}

/// What a frame has is the same whatever was asked for before, and from where on a film is held:
/// else a run that is gone on with would paint something else.
TEST(FilmDetails, DependOnTheFrameAlone) {
  const test::GrowingDisc disc{Size{64, 64}, {32.0F, 32.0F}, 10.0F, 1.0F, 16};
  const Exemplar whole = test::discExemplar(disc, 0, kBorderPx, 3);
  const Exemplar part = test::heldDiscExemplar(disc, 6, 8, 0, kBorderPx, 3);
  FilmDetail known;
  for (int k = 0; k < 16; ++k) (void)known.of(whole, k);
  const auto same = [](const DetailEnergy& a, const DetailEnergy& b) {
    for (std::size_t c = 0; c < kDetailClasses; ++c) {
      if (a.pixels(c) != b.pixels(c) || a.squares(c, 0) != b.squares(c, 0)) return false;
    }
    return true;
  };
  for (int k = 6; k < 14; ++k) {
    FilmDetail fresh;
    EXPECT_TRUE(same(fresh.of(whole, k), known.of(whole, k))) << k;
    FilmDetail ofPart;
    EXPECT_TRUE(same(ofPart.of(part, k - 6), known.of(whole, k))) << k;
    EXPECT_TRUE(same(known.of(part, k - 6), known.of(whole, k))) << k;
  }
  EXPECT_FALSE(same(known.of(whole, 6), known.of(whole, 7)));
}

}  // namespace
}  // namespace fluidymation
