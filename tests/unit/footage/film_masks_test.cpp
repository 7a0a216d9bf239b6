#include "fluidymation/film_masks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "fluidymation/core/error.h"
#include "fluidymation/io/png.h"
#include "support/comparison.h"
#include "support/shapes.h"
#include "support/synthetic_film.h"
#include "support/temporary_folder.h"

namespace fluidymation::test {
namespace {

constexpr int kFrames = 6;

[[nodiscard]] Image<Rgba8> bytesOfPicture(const Image<Rgb>& picture) {
  Image<Rgba8> bytes(picture.size());
  std::transform(picture.begin(), picture.end(), bytes.begin(), [](Rgb c) {
    return Rgba8{toByte(c.r), toByte(c.g), toByte(c.b), 255};
  });
  return bytes;
}

/// A stain that grows from frame 2 on, filmed with grain.
[[nodiscard]] Shot growing(int number) {
  Shot shot;
  shot.radiusPx = number == 1 ? 0.0F : 10.0F + 4.0F * static_cast<float>(number);
  shot.grain = 0.015F;
  shot.grainSeed = static_cast<std::uint64_t>(number);
  return shot;
}

class FilmMasksTest : public ::testing::Test {
 protected:
  FilmMasksTest() {
    std::filesystem::create_directories(folder_.file("rgb"));
    for (int number = 1; number <= kFrames; ++number) write(number, growing(number));
    options_.film.path = folder_.file("rgb/%05d.png");
    options_.maskPath = folder_.file("mask/%05d.png");
    options_.overwrite = true;
  }

  void write(int number, const Shot& shot) const {
    writePng(file("rgb", number), bytesOfPicture(filmed(shot)));
  }

  [[nodiscard]] std::string file(const std::string& sequence, int number) const {
    return folder_.file(sequence + "/0000" + std::to_string(number) + ".png");
  }

  [[nodiscard]] Mask maskOfFrame(int number) const {
    const Image<float> coverage = readCoverage(file("mask", number), MaskChannel::kBrightness);
    Mask mask(coverage.size());
    std::transform(coverage.begin(), coverage.end(), mask.begin(),
                   [](float c) { return static_cast<std::uint8_t>(c >= 0.5F ? 1 : 0); });
    return mask;
  }

  [[nodiscard]] FilmMasks made() const { return maskFilm(options_, {}); }

  [[nodiscard]] std::vector<Bytes> masks() const {
    (void)made();
    std::vector<Bytes> all;
    for (int number = 1; number <= kFrames; ++number)
      all.push_back(readBytes(file("mask", number)));
    return all;
  }

  /// Whether just one warning begins so.
  [[nodiscard]] static bool warns(const FilmMasks& masks, const std::string& beginning) {
    return std::count_if(masks.warnings.begin(), masks.warnings.end(), [&](const std::string& w) {
             return w.compare(0, beginning.size(), beginning) == 0;
           }) == 1;
  }

  TemporaryFolder folder_;
  FilmMaskOptions options_;
};

[[nodiscard]] double intersectionOverUnion(const Mask& a, const Mask& b) {
  std::size_t both = 0;
  std::size_t any = 0;
  for (std::size_t i = 0; i < a.pixelCount(); ++i) {
    both += a.data()[i] != 0 && b.data()[i] != 0 ? 1 : 0;
    any += a.data()[i] != 0 || b.data()[i] != 0 ? 1 : 0;
  }
  return any == 0 ? 1.0 : static_cast<double>(both) / static_cast<double>(any);
}

TEST_F(FilmMasksTest, FindsThePaintInGrainAndKeepsTheNumbers) {
  const FilmMasks masks = made();
  EXPECT_EQ(masks.frames, kFrames);
  EXPECT_EQ(masks.warnings, std::vector<std::string>{});
  EXPECT_EQ(countInside(maskOfFrame(1)), 0U);
  for (int number = 2; number <= kFrames; ++number) {
    const Shot shot = growing(number);
    EXPECT_GT(
        intersectionOverUnion(maskOfFrame(number), disc(shot.size, shot.centre, shot.radiusPx)),
        0.94)
        << number;
  }
  EXPECT_FALSE(std::filesystem::exists(file("mask", kFrames + 1)));
  EXPECT_EQ(masks.report.back(), "paint begins in frame 2: paint with --src-start 2");
}

TEST_F(FilmMasksTest, AreTheSameWithAnyNumberOfThreadsAndBlackAndWhite) {
  const std::vector<Bytes> one = masks();
  options_.threads = 3;
  EXPECT_EQ(masks(), one);
  for (const float c : readCoverage(file("mask", 3), MaskChannel::kBrightness)) {
    ASSERT_TRUE(c == 0.0F || c == 1.0F);
  }
}

TEST_F(FilmMasksTest, SoftOnesAreTheSameInside) {
  (void)made();
  const Mask hard = maskOfFrame(4);
  options_.soft = true;
  (void)made();
  EXPECT_TRUE(equalEverywhere(hard, maskOfFrame(4)));
  const Image<float> soft = readCoverage(file("mask", 4), MaskChannel::kBrightness);
  EXPECT_GT(std::count_if(soft.begin(), soft.end(), [](float c) { return c > 0.0F && c < 1.0F; }),
            50);
}

TEST_F(FilmMasksTest, AThresholdIsTakenAsGiven) {
  options_.threshold = 90.0F;
  const FilmMasks masks = made();
  EXPECT_EQ(masks.threshold, 90.0F);
  EXPECT_TRUE(warns(masks, "nothing found: "));
}

TEST_F(FilmMasksTest, PaintOfTheFirstFrameIsTakenOutWhereItIsNamed) {
  options_.film.start = 2;
  EXPECT_TRUE(warns(made(), "bare surface: "));
  writeGrayPng(folder_.file("stain.png"), [] {
    Mask stain = disc({160, 120}, {80.0F, 60.0F}, 19.0F);
    for (std::uint8_t& pixel : stain) pixel = pixel != 0 ? 255 : 0;
    return stain;
  }());
  options_.barePaintPath = folder_.file("stain.png");
  EXPECT_EQ(made().warnings, std::vector<std::string>{});
  EXPECT_GT(intersectionOverUnion(maskOfFrame(5), disc({160, 120}, {80.0F, 60.0F}, 30.0F)), 0.95);
}

TEST_F(FilmMasksTest, AStillOrSeveralFramesMayBeTheSurface) {
  writePng(folder_.file("still.png"), bytesOfPicture(filmed(paper())));
  options_.film.start = 2;
  options_.barePath = folder_.file("still.png");
  EXPECT_EQ(made().warnings, std::vector<std::string>{});
  EXPECT_GT(intersectionOverUnion(maskOfFrame(5), disc({160, 120}, {80.0F, 60.0F}, 30.0F)), 0.94);
  options_.bareFrames = 2;
  EXPECT_THROW((void)made(), UsageError);
  options_.barePath.reset();
  options_.film.start = 1;
  for (int number = 1; number <= 3; ++number) {
    Shot bare = growing(number);
    bare.radiusPx = 0.0F;
    write(number, bare);
  }
  options_.bareFrames = 3;
  const FilmMasks masks = made();
  EXPECT_EQ(masks.report[1], "bare surface: median of frames 1 to 3");
  EXPECT_EQ(countInside(maskOfFrame(3)), 0U);
}

TEST_F(FilmMasksTest, WarnsOfShakeAndLight) {
  Shot shaken = growing(4);
  shaken.cameraPx = {2.0F, 1.0F};
  write(4, shaken);
  EXPECT_TRUE(warns(made(), "camera: moved by more than 1 px in frame 4, "));
  Shot darker = growing(4);
  darker.light = 0.96F;
  write(4, darker);
  const FilmMasks masks = made();
  EXPECT_TRUE(warns(masks, "light: in frame 4 the unpainted surface has another colour"));
  EXPECT_FALSE(warns(masks, "camera: "));
}

TEST_F(FilmMasksTest, ReplacesNoInputAndNoOtherOutput) {
  const auto refused = [&] { return messageOf<UsageError>([&] { (void)made(); }); };
  options_.maskPath = folder_.file("rgb/%05d.png");
  EXPECT_EQ(refused(), "--out-path " + options_.maskPath + ": " + file("rgb", 1) +
                           " is an input and would be overwritten; choose another name");
  options_.maskPath = folder_.file("mask/%05d.png");
  options_.mattePath = folder_.file("rgb/../mask/%05d.png");
  EXPECT_NE(refused().find(" is written already; choose another name"), std::string::npos);
  options_.mattePath.reset();
  options_.sheetPath = file("rgb", 9);
  EXPECT_NE(refused().find(" is an input and would be overwritten"), std::string::npos);
  options_.sheetPath = folder_.file("sheet.jpg");
  EXPECT_NE(refused().find("wanted a name that ends in .png"), std::string::npos);
  options_.sheetPath.reset();
  options_.barePath = folder_.file("mask/00003.png");
  std::filesystem::create_directories(folder_.file("mask"));
  std::filesystem::copy_file(file("rgb", 1), *options_.barePath);
  EXPECT_NE(refused().find(" is an input and would be overwritten"), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(file("mask", 1)));
}

TEST_F(FilmMasksTest, ReplacesNoMaskUnasked) {
  options_.overwrite = false;
  std::filesystem::create_directories(folder_.file("mask"));
  const Bytes retouched = bytesOf("a mask");
  for (const int number : {2, 5}) writeBytes(file("mask", number), retouched);
  EXPECT_EQ(messageOf<Error>([&] { (void)made(); }),
            file("mask", 2) +
                ": is there already; so is 1 more; wanted --overwrite to replace, or "
                "another --out-path");
  EXPECT_EQ(readBytes(file("mask", 5)), retouched);
  EXPECT_FALSE(std::filesystem::exists(file("mask", 1)));
  options_.overwrite = true;
  EXPECT_EQ(made().frames, kFrames);
}

TEST_F(FilmMasksTest, ASurfaceOfAnotherSizeIsRefused) {
  writePng(folder_.file("still.png"), Image<Rgba8>({160, 119}));
  options_.barePath = folder_.file("still.png");
  EXPECT_EQ(messageOf<Error>([&] { (void)made(); }),
            *options_.barePath + ": 160x119, but " + file("rgb", 1) +
                " is 160x120; wanted a picture from the same place, of the same size");
}

TEST_F(FilmMasksTest, StopsBetweenFrames) {
  int asked = 0;
  EXPECT_THROW((void)maskFilm(options_, [&] { return ++asked > 1 + kFrames + 2; }), Interrupted);
  EXPECT_TRUE(std::filesystem::exists(file("mask", 2)));
  EXPECT_FALSE(std::filesystem::exists(file("mask", 3)));
}

TEST_F(FilmMasksTest, WritesSheetAndMattes) {
  options_.sheetPath = folder_.file("look/sheet.png");
  options_.mattePath = folder_.file("matte/%05d.png");
  (void)made();
  EXPECT_EQ(readPngSize(*options_.sheetPath), (Size{4 * 164 - 4, 2 * 124 - 4}));
  const Image<Rgba> matte = readPng(file("matte", 5));
  const Mask mask = maskOfFrame(5);
  for (std::size_t i = 0; i < mask.pixelCount(); ++i) {
    ASSERT_EQ(matte.data()[i].a, mask.data()[i] != 0 ? 1.0F : 0.0F);
  }
}

/// The samples were made together with their masks.
TEST(FilmMasks, AgreeWithTheMasksOfASample) {
  const TemporaryFolder folder;
  const std::string sample = std::string(FLUIDYMATION_SAMPLES) + "/rust";
  FilmMaskOptions options;
  options.film.path = sample + "/rgb/%05d.png";
  options.film.frames = 12;
  options.barePaintPath = sample + "/mask/00001.png";
  options.maskPath = folder.file("%05d.png");
  EXPECT_EQ(maskFilm(options, {}).frames, 12);
  for (const char* number : {"00002", "00006", "00012"}) {
    const auto read = [&](const std::string& path) {
      const Image<float> coverage = readCoverage(path, MaskChannel::kBrightness);
      return maskOf(coverage.size(), [&](int x, int y) { return coverage(x, y) >= 0.5F; });
    };
    EXPECT_GT(intersectionOverUnion(read(folder.file(std::string(number) + ".png")),
                                    read(sample + "/mask/" + number + ".png")),
              0.96)
        << number;
  }
}

}  // namespace
}  // namespace fluidymation::test
