// Small paintings compared with the committed ones, tests/golden/<name>/NNNNN.png.
//
// These tests say that the painting has changed, not that it is wrong. An update is right when the
// change is meant, its cause is known, and it has been looked at on real samples; it is then a
// commit of its own that shows both pictures. scripts/update_golden.sh makes it. It is not right
// for getting rid of a failure.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>

#include "fluidymation/core/random.h"
#include "support/golden.h"
#include "support/shapes.h"
#include "support/small_scene.h"

namespace fluidymation::test {
namespace {

namespace fs = std::filesystem;

constexpr int kFrames = 4;
constexpr Size kSize{64, 64};

// All inputs are made by additions, multiplications and square roots, which every machine rounds
// alike.

float smooth(float v) {
  const float t = std::clamp(v, 0.0F, 1.0F);
  return t * t * (3.0F - 2.0F * t);
}

/// Smooth random values in [0, 1], `cellPx` apart.
float noise(int x, int y, int cellPx, std::uint64_t seed) {
  const auto corner = [&](int cx, int cy) {
    Random random({seed, 0, 0, 0, cx, cy});
    return static_cast<float>(random.uniform(0, 1024)) / 1024.0F;
  };
  const int cx = x / cellPx;
  const int cy = y / cellPx;
  const float fx = smooth(static_cast<float>(x % cellPx) / static_cast<float>(cellPx));
  const float fy = smooth(static_cast<float>(y % cellPx) / static_cast<float>(cellPx));
  return (1.0F - fy) * ((1.0F - fx) * corner(cx, cy) + fx * corner(cx + 1, cy)) +
         fy * ((1.0F - fx) * corner(cx, cy + 1) + fx * corner(cx + 1, cy + 1));
}

/// Depth below the wavy edge of a growing blot, px; negative outside.
float blotDepth(int x, int y, int frame) {
  const Vec2 away{static_cast<float>(x) - 31.0F, static_cast<float>(y) - 33.0F};
  return 13.0F + 2.5F * static_cast<float>(frame) + 6.0F * (noise(x, y, 9, 1) - 0.5F) -
         length(away);
}

Mask blotMask(int frame) {
  return maskOf(kSize, [frame](int x, int y) { return blotDepth(x, y, frame) > 0.0F; });
}

/// A wash of watercolour: pigment gathered at the edge, granulation within, paper outside.
Image<Rgba8> blot(int frame) {
  Image<Rgba8> picture(kSize);
  for (int y = 0; y < kSize.height; ++y) {
    for (int x = 0; x < kSize.width; ++x) {
      const float depth = blotDepth(x, y, frame);
      const float paper = 0.94F + 0.04F * noise(x, y, 2, 2);
      float pigment = 0.0F;
      if (depth > 0.0F) {
        const float edge = 1.0F - smooth(depth / 5.0F);
        pigment = 0.35F + 0.45F * edge + 0.25F * (noise(x, y, 3, 3) - 0.5F) +
                  0.2F * (noise(x, y, 13, 4) - 0.5F);
      }
      const auto channel = [&](float absorption) {
        const float value = paper * (1.0F - absorption * std::clamp(pigment, 0.0F, 1.0F));
        return static_cast<std::uint8_t>(255.0F * value + 0.5F);
      };
      picture(x, y) = {channel(0.95F), channel(0.7F), channel(0.3F), 255};
    }
  }
  return picture;
}

/// A bean that travels to the right and up.
Mask bean(int frame) {
  const Vec2 centre{24.0F + 4.0F * static_cast<float>(frame),
                    38.0F - 2.0F * static_cast<float>(frame)};
  const Mask large = disc(kSize, centre, 16.0F);
  const Mask small = disc(kSize, centre + Vec2{10.0F, 10.0F}, 11.0F);
  const Mask dent = disc(kSize, centre + Vec2{12.0F, -12.0F}, 9.0F);
  return maskOf(kSize, [&](int x, int y) {
    return (large(x, y) != 0 || small(x, y) != 0) && dent(x, y) == 0;
  });
}

/// A wheel that turns: a ring with a hole, four spokes of 3 px and a hub.
Mask wheel(int frame) {
  // Cosine and sine of 0, 8, 16 and 24 degrees.
  constexpr std::array<Vec2, kFrames> kTurns = {Vec2{1.0F, 0.0F}, Vec2{0.990268F, 0.139173F},
                                                Vec2{0.961262F, 0.275637F},
                                                Vec2{0.913545F, 0.406737F}};
  const Vec2 turn = kTurns.at(static_cast<std::size_t>(frame));
  return maskOf(kSize, [&](int x, int y) {
    const Vec2 away{static_cast<float>(x) - 31.5F, static_cast<float>(y) - 31.5F};
    const float radius = length(away);
    const float along = std::abs(dot(away, turn));
    const float across = std::abs(dot(away, Vec2{-turn.y, turn.x}));
    const bool spoke = std::min(along, across) < 1.5F && radius < 24.0F;
    return (radius > 20.0F && radius < 28.0F) || radius < 6.0F || spoke;
  });
}

struct Sample {
  const char* name;
  Mask (*targetMask)(int frame);
  ToolOptions options;
};

void checkSample(const Sample& sample) {
  const SmallScene scene(0);
  for (int frame = 0; frame < kFrames; ++frame) {
    scene.write(SmallScene::frame("src", frame + 1), colorPng(blot(frame)));
    scene.write(SmallScene::frame("mask", frame + 1), maskPng(blotMask(frame)));
    scene.write(SmallScene::frame("target", frame + 1), maskPng(sample.targetMask(frame)));
  }
  const SmallScene::Painting painting = scene.painting(sample.options);
  const std::string golden = std::string(FLUIDYMATION_GOLDEN_FOLDER) + "/" + sample.name;
  if (std::getenv("FLUIDYMATION_UPDATE_GOLDEN") != nullptr) {  // scripts/update_golden.sh
    fs::create_directories(golden);
    for (const auto& [name, bytes] : painting) writeBytes(golden + "/" + name, bytes);
    // Compared with what has just been written it would pass whatever it shows; that it is skipped
    // tells that nothing was checked.
    GTEST_SKIP() << golden << " has been painted anew and is not compared";
  }
  ASSERT_EQ(painting.size(), static_cast<std::size_t>(kFrames));
  // In a folder that stays when the comparison fails.
  std::string kept = (fs::temp_directory_path() / "fluidymation-golden-XXXXXX").string();
  ASSERT_NE(mkdtemp(kept.data()), nullptr);
  bool good = true;
  for (const auto& [name, bytes] : painting) {
    const std::string actual = kept + "/" + name;
    writeBytes(actual, bytes);
    const ::testing::AssertionResult result =
        isGolden(golden + "/" + name, actual, GoldenTolerance{});
    EXPECT_TRUE(result);
    good = good && result;
  }
  if (good) fs::remove_all(kept);
}

TEST(EndToEndGolden, ABlotPaintsAMovingBeanAsInTheThesis) {
  checkSample({"bean", bean, {{"--preset", "thesis"}, {"--border-width", "6"}}});
}

TEST(EndToEndGolden, ABlotPaintsAMovingBean) {
  checkSample({"bean-standard", bean, {{"--border-width", "6"}}});
}

TEST(EndToEndGolden, ABlotPaintsATurningWheelWithHolesAndThinPartsAsInTheThesis) {
  checkSample({"wheel",
               wheel,
               {{"--preset", "thesis"}, {"--border-width", "6"}, {"--target-blur-sigma", "0.6"}}});
}

TEST(EndToEndGolden, TheComparisonTellsPaintingsApart) {
  const TemporaryFolder folder;
  const auto painted = [&](const char* name, const auto& change) {
    Image<Rgba8> picture(Size{20, 20});
    for (int y = 0; y < 20; ++y) {
      for (int x = 2; x < 20; ++x) picture(x, y) = {100, 120, 140, 255};
    }
    change(picture);
    writePng(folder.file(name), picture);
    return folder.file(name);
  };
  const std::string golden = painted("golden.png", [](Image<Rgba8>&) {});
  const auto verdict = [&](const auto& change) {
    return isGolden(golden, painted("actual.png", change), GoldenTolerance{});
  };
  EXPECT_TRUE(verdict([](Image<Rgba8>&) {}));
  EXPECT_TRUE(verdict([](Image<Rgba8>& p) { p(9, 5).r += 30; }));
  EXPECT_TRUE(verdict([](Image<Rgba8>& p) {
    for (int x = 2; x < 20; x += 2) p(x, 3).g += 3;
  }));
  const ::testing::AssertionResult far = verdict([](Image<Rgba8>& p) { p(9, 5).b += 60; });
  EXPECT_FALSE(far);
  EXPECT_NE(std::string(far.message()).find("largest error 60"), std::string::npos);
  EXPECT_NE(std::string(far.message()).find("(9, 5) is (100, 120, 200, 255), not (100, 120, 140"),
            std::string::npos)
      << far.message();
  EXPECT_FALSE(verdict([](Image<Rgba8>& p) {
    for (int x = 2; x < 8; ++x) p(x, 3).g += 9;
  })) << "too many";
  EXPECT_FALSE(verdict([](Image<Rgba8>& p) {
    for (Rgba8& pixel : p) pixel.r += pixel.a == 0 ? 0 : 1;
  })) << "another colour on the whole";
  EXPECT_FALSE(verdict([](Image<Rgba8>& p) { p(3, 3) = {}; })) << "another shape";
  EXPECT_FALSE(isGolden(golden,
                        painted("actual.png",
                                [](Image<Rgba8>& p) {
                                  p = Image<Rgba8>(Size{20, 19});
                                }),
                        GoldenTolerance{}));
}

}  // namespace
}  // namespace fluidymation::test
