// What --dump-guides writes, file by file.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <set>
#include <sstream>

#include "fluidymation/guides/mask.h"
#include "support/shapes.h"
#include "support/small_scene.h"

namespace fluidymation::test {
namespace {

constexpr float kPi = 3.1415927F;

/// A float file as the formats say: rows top to bottom here, channels interleaved.
struct FloatImage {
  Size size;
  int channels = 0;
  std::vector<float> values;

  [[nodiscard]] float at(int x, int y, int channel = 0) const {
    const int pixel = y * size.width + x;
    return values.at(static_cast<std::size_t>(pixel * channels + channel));
  }
};

float littleEndianFloat(const Bytes& bytes, std::size_t begin) {
  std::uint32_t bits = 0;
  for (std::size_t i = 4; i-- > 0;) bits = (bits << 8U) | bytes.at(begin + i);
  float value = 0.0F;
  std::memcpy(&value, &bits, sizeof value);
  return value;
}

/// Reads a PFM file that has to begin with exactly this kind, size and a scale of -1.
FloatImage readPfm(const std::string& path, const std::string& kind, Size size) {
  const Bytes bytes = readBytes(path);
  std::istringstream header(std::string(bytes.begin(), bytes.end()));
  std::string magic;
  int width = 0;
  int height = 0;
  double scale = 0.0;
  header >> magic >> width >> height >> scale;
  header.get();
  EXPECT_EQ(magic, kind) << path;
  EXPECT_EQ((Size{width, height}), size) << path;
  EXPECT_EQ(scale, -1.0) << path;
  FloatImage image{size, kind == "PF" ? 3 : 1, {}};
  const auto begin = static_cast<std::size_t>(header.tellg());
  const auto perRow = static_cast<std::size_t>(size.width * image.channels);
  const auto rows = static_cast<std::size_t>(size.height);
  EXPECT_EQ(bytes.size(), begin + 4 * perRow * rows) << path;
  for (std::size_t y = 0; y < rows; ++y) {
    for (std::size_t i = 0; i < perRow; ++i) {
      image.values.push_back(littleEndianFloat(bytes, begin + 4 * ((rows - 1 - y) * perRow + i)));
    }
  }
  return image;
}

FloatImage readFlow(const std::string& path, Size size) {
  const Bytes bytes = readBytes(path);
  const auto number = [&](std::size_t i) {
    return bytes.at(i) + 256 * (bytes.at(i + 1) + 256 * (bytes.at(i + 2) + 256 * bytes.at(i + 3)));
  };
  EXPECT_EQ(std::string(bytes.begin(), bytes.begin() + 4), "PIEH") << path;
  EXPECT_EQ((Size{number(4), number(8)}), size) << path;
  FloatImage image{size, 2, {}};
  const auto count = static_cast<std::size_t>(2 * size.width * size.height);
  EXPECT_EQ(bytes.size(), 12 + 4 * count) << path;
  for (std::size_t i = 0; i < count; ++i) {
    image.values.push_back(littleEndianFloat(bytes, 12 + 4 * i));
  }
  return image;
}

class EndToEndDump : public ::testing::Test {
 protected:
  static constexpr int kFrames = 4;
  static constexpr Size kSource{24, 20};
  static constexpr Size kTarget{28, 22};

  /// The exemplar backwards from frame 4 on, so that numbers and indices differ.
  void SetUp() override {
    (void)scene_.painting({{"--dump-guides", "dump"}, {"--src-start", "4"}, {"--src-speed", "-1"}});
  }

  [[nodiscard]] std::string path(const std::string& sequence, int number,
                                 const std::string& channel) const {
    return scene_.file("dump/" + sequence + "/0000" + std::to_string(number) + "." + channel);
  }
  [[nodiscard]] FloatImage plane(const std::string& sequence, int number,
                                 const std::string& channel) const {
    return readPfm(path(sequence, number, channel), "Pf", sequence == "source" ? kSource : kTarget);
  }
  [[nodiscard]] Mask mask(const std::string& sequence, int number) const {
    return smoothed(sequence == "source" ? scene_.sourceMask(number) : scene_.targetMask(number),
                    1.0F);
  }

  SmallScene scene_{kFrames};
};

/// Calls `check(sequence, number)` for every dumped frame.
template <typename Check>
void forEachFrame(const Check& check) {
  for (const std::string sequence : {"source", "target"}) {
    for (int number = 1; number <= 4; ++number) check(sequence, number);
  }
}

TEST_F(EndToEndDump, HasExactlyTheFilesOfTheList) {
  const std::vector<std::string> guides = {"dist.pfm",    "ext_bwd.pfm", "ext_bwd.png",
                                           "ext_fwd.pfm", "ext_fwd.png", "flow.flo",
                                           "flow.png",    "mask.png"};
  const std::vector<std::string> matches = {"nnf.pfm", "nnf.png", "theta.pfm"};
  std::vector<std::string> source;
  std::vector<std::string> target;
  for (int number = 1; number <= kFrames; ++number) {
    const std::string stem = "0000" + std::to_string(number) + ".";
    for (const std::string& channel : guides) {
      source.push_back(stem + channel);
      target.push_back(stem + channel);
    }
    for (const std::string& channel : matches) target.push_back(stem + channel);
  }
  std::sort(source.begin(), source.end());
  std::sort(target.begin(), target.end());
  EXPECT_EQ(scene_.names("dump"), (std::vector<std::string>{"source", "target"}));
  EXPECT_EQ(scene_.names("dump/source"), source);
  EXPECT_EQ(scene_.names("dump/target"), target);
}

TEST_F(EndToEndDump, TheBlurredMaskIsDumpedWhereItGuides) {
  (void)scene_.painting({{"--dump-guides", "dump"}, {"--shape-guide", "blurred"}});
  forEachFrame([&](const std::string& sequence, int number) {
    const Image<float> expected = blurredMask(mask(sequence, number), 3.0F);  // the border width
    const FloatImage shape = plane(sequence, number, "shape.pfm");
    for (int y = 0; y < expected.height(); ++y) {
      for (int x = 0; x < expected.width(); ++x) {
        ASSERT_NEAR(shape.at(x, y), expected(x, y), 1e-6F) << sequence << number;
      }
    }
  });
}

TEST_F(EndToEndDump, ChangesNoPaintedByte) {
  const SmallScene::Painting withDump = filesOf(scene_.file("out"));
  EXPECT_TRUE(scene_.painting({{"--src-start", "4"}, {"--src-speed", "-1"}}) == withDump);
}

TEST_F(EndToEndDump, MasksAreTheSmoothedOnes) {
  forEachFrame([&](const std::string& sequence, int number) {
    const Mask expected = mask(sequence, number);
    const Image<Rgba> picture = readPng(path(sequence, number, "mask.png"));
    ASSERT_EQ(picture.size(), expected.size());
    for (std::size_t i = 0; i < expected.pixelCount(); ++i) {
      ASSERT_EQ(picture.data()[i].r, expected.data()[i] != 0 ? 1.0F : 0.0F) << sequence << number;
    }
  });
}

TEST_F(EndToEndDump, DistancesAreThoseToTheNearestPixelOfTheOtherSide) {
  forEachFrame([&](const std::string& sequence, int number) {
    const Mask shape = mask(sequence, number);
    const FloatImage distance = plane(sequence, number, "dist.pfm");
    for (int y = 0; y < shape.height(); ++y) {
      for (int x = 0; x < shape.width(); ++x) {
        float nearest = 1e9F;
        for (int oy = 0; oy < shape.height(); ++oy) {
          for (int ox = 0; ox < shape.width(); ++ox) {
            if (shape(ox, oy) == shape(x, y)) continue;
            nearest = std::min(
                nearest, length(Vec2{static_cast<float>(ox - x), static_cast<float>(oy - y)}));
          }
        }
        ASSERT_NEAR(distance.at(x, y), shape(x, y) != 0 ? nearest : -nearest, 1e-4)
            << sequence << number << " (" << x << ", " << y << ")";
      }
    }
  });
}

TEST_F(EndToEndDump, MotionIsFiniteAndWithinTheMask) {
  forEachFrame([&](const std::string& sequence, int number) {
    const Mask shape = mask(sequence, number);
    const FloatImage flow = readFlow(path(sequence, number, "flow.flo"), shape.size());
    for (const std::string channel : {"ext_fwd.pfm", "ext_bwd.pfm"}) {
      const FloatImage extent = plane(sequence, number, channel);
      for (int y = 0; y < shape.height(); ++y) {
        for (int x = 0; x < shape.width(); ++x) {
          const float speed = length(Vec2{flow.at(x, y, 0), flow.at(x, y, 1)});
          ASSERT_TRUE(speed < 5.0F) << speed;
          ASSERT_TRUE(extent.at(x, y) >= 0.0F && extent.at(x, y) < 20.0F) << extent.at(x, y);
          if (shape(x, y) != 0) continue;
          ASSERT_EQ(speed, 0.0F);
          ASSERT_EQ(extent.at(x, y), 0.0F);
        }
      }
    }
  });
}

TEST_F(EndToEndDump, ExtentsBeginAndEndAtZero) {
  const auto largest = [&](const std::string& sequence, int number, const std::string& channel) {
    const FloatImage extent = plane(sequence, number, channel);
    return *std::max_element(extent.values.begin(), extent.values.end());
  };
  // The exemplar is played backwards: its first frame is number 4.
  EXPECT_EQ(largest("source", 4, "ext_fwd.pfm"), 0.0F);
  EXPECT_EQ(largest("source", 1, "ext_bwd.pfm"), 0.0F);
  EXPECT_GT(largest("source", 1, "ext_fwd.pfm"), 1.0F);
  EXPECT_GT(largest("source", 4, "ext_bwd.pfm"), 1.0F);
  EXPECT_EQ(largest("target", 1, "ext_fwd.pfm"), 0.0F);
  EXPECT_EQ(largest("target", 4, "ext_bwd.pfm"), 0.0F);
  EXPECT_GT(largest("target", 4, "ext_fwd.pfm"), 0.5F);
  EXPECT_GT(largest("target", 1, "ext_bwd.pfm"), 0.5F);
}

TEST_F(EndToEndDump, TheSecondFramesExtentIsItsFlow) {
  for (const auto& [sequence, number] : {std::pair{std::string("source"), 3}, {"target", 2}}) {
    const Size size = sequence == "source" ? kSource : kTarget;
    const FloatImage flow = readFlow(path(sequence, number, "flow.flo"), size);
    const FloatImage extent = plane(sequence, number, "ext_fwd.pfm");
    for (int y = 0; y < size.height; ++y) {
      for (int x = 0; x < size.width; ++x) {
        const float speed = length(Vec2{flow.at(x, y, 0), flow.at(x, y, 1)});
        ASSERT_NEAR(extent.at(x, y), speed, 1e-5) << sequence << " (" << x << ", " << y << ")";
      }
    }
  }
}

TEST_F(EndToEndDump, ThetaTurnsTheExemplarsFlowOntoTheTargets) {
  // The exemplar moves to the right, the target to the right and down.
  for (int number = 1; number <= kFrames; ++number) {
    scene_.write(SmallScene::frame("mask", number),
                 maskPng(maskOf(kSource, [=](int x, int) { return x < 12 + 2 * number; })));
    scene_.write(SmallScene::frame("target", number),
                 maskPng(maskOf(kTarget, [=](int x, int y) { return x + y < 18 + 3 * number; })));
  }
  (void)scene_.painting({{"--dump-guides", "turned"}});
  for (int number = 1; number <= kFrames; ++number) {
    const std::string stem = scene_.file("turned/target/0000" + std::to_string(number) + ".");
    const FloatImage theta = readPfm(stem + "theta.pfm", "Pf", kTarget);
    const FloatImage nnf = readPfm(stem + "nnf.pfm", "PF", kTarget);
    int painted = 0;
    int right = 0;
    for (int y = 0; y < kTarget.height; ++y) {
      for (int x = 0; x < kTarget.width; ++x) {
        if (std::isnan(nnf.at(x, y, 2))) continue;
        ++painted;
        // An eighth of a turn clockwise, y being down, or the opposite of that.
        const float turned = theta.at(x, y) < 0.0F ? theta.at(x, y) + kPi : theta.at(x, y);
        right += std::abs(turned - kPi / 4.0F) < kPi / 8.0F ? 1 : 0;
      }
    }
    EXPECT_GT(painted, 100);
    EXPECT_GT(right, 0.95 * painted) << number;
  }
}

TEST_F(EndToEndDump, AShrinkingExemplarFlowsInwards) {
  for (int number = 1; number <= kFrames; ++number) {  // played backwards
    const Mask shape = mask("source", number);
    const FloatImage flow = readFlow(path("source", number, "flow.flo"), kSource);
    double outward = 0.0;
    for (int y = 0; y < kSource.height; ++y) {
      for (int x = 0; x < kSource.width; ++x) {
        const Vec2 away{static_cast<float>(x) - 11.5F, static_cast<float>(y) - 9.5F};
        if (shape(x, y) == 0 || length(away) < 2.0F) continue;
        outward += static_cast<double>(dot(Vec2{flow.at(x, y, 0), flow.at(x, y, 1)}, away));
      }
    }
    EXPECT_LT(outward, 0.0) << number;
  }
}

TEST_F(EndToEndDump, MatchesLieInTheExemplarAndNameItsFrames) {
  // The finest matches continue those of half the size, by up to a pixel past the last one.
  constexpr float kBeyondPx = 1.25F;
  std::set<float> frames;
  for (int number = 1; number <= kFrames; ++number) {
    const Mask shape = mask("target", number);
    const FloatImage nnf = readPfm(path("target", number, "nnf.pfm"), "PF", kTarget);
    const FloatImage theta = plane("target", number, "theta.pfm");
    for (int y = 0; y < kTarget.height; ++y) {
      for (int x = 0; x < kTarget.width; ++x) {
        if (shape(x, y) == 0) {
          for (int c = 0; c < 3; ++c) ASSERT_TRUE(std::isnan(nnf.at(x, y, c)));
          ASSERT_EQ(theta.at(x, y), 0.0F);
          continue;
        }
        ASSERT_TRUE(nnf.at(x, y, 0) > -kBeyondPx && nnf.at(x, y, 0) < 23.0F + kBeyondPx);
        ASSERT_TRUE(nnf.at(x, y, 1) > -kBeyondPx && nnf.at(x, y, 1) < 19.0F + kBeyondPx);
        ASSERT_TRUE(std::abs(theta.at(x, y)) <= kPi);
        const float frame = nnf.at(x, y, 2);
        ASSERT_TRUE(frame == 1.0F || frame == 2.0F || frame == 3.0F || frame == 4.0F) << frame;
        frames.insert(frame);
      }
    }
  }
  EXPECT_GE(frames.size(), 2U) << "several frames of the exemplar are used";
}

TEST_F(EndToEndDump, ASingleSourceFrameIsNamedEverywhere) {
  const SmallScene::Painting painting =
      scene_.painting({{"--dump-guides", "single"}, {"--src-start", "3"}, {"--src-frames", "1"}});
  ASSERT_EQ(painting.size(), 4U);
  for (int number = 1; number <= kFrames; ++number) {
    const FloatImage nnf = readPfm(
        scene_.file("single/target/0000" + std::to_string(number) + ".nnf.pfm"), "PF", kTarget);
    const Mask shape = mask("target", number);
    for (int y = 0; y < kTarget.height; ++y) {
      for (int x = 0; x < kTarget.width; ++x) {
        const float frame = nnf.at(x, y, 2);
        ASSERT_TRUE(shape(x, y) != 0 ? frame == 3.0F : std::isnan(frame)) << frame;
      }
    }
  }
  EXPECT_EQ(scene_.names("single/source").size(), 8U);
  EXPECT_EQ(scene_.names("single/source").front(), "00003.dist.pfm");
}

TEST_F(EndToEndDump, AFrameOfAnyNumberIsToldFromNoMatch) {
  scene_.write("src/-0001.png", scene_.read("src/00001.png"));
  scene_.write("mask/-0001.png", scene_.read("mask/00001.png"));
  (void)scene_.painting({{"--dump-guides", "minus"},
                         {"--src-start", "-1"},
                         {"--src-frames", "1"},
                         {"--target-frames", "4"}});
  const FloatImage nnf = readPfm(scene_.file("minus/target/00001.nnf.pfm"), "PF", kTarget);
  const Mask shape = mask("target", 1);
  for (int y = 0; y < kTarget.height; ++y) {
    for (int x = 0; x < kTarget.width; ++x) {
      const float frame = nnf.at(x, y, 2);
      ASSERT_TRUE(shape(x, y) != 0 ? frame == -1.0F : std::isnan(frame)) << frame;
    }
  }
}

TEST_F(EndToEndDump, PicturesForPeopleHaveTheFramesSize) {
  forEachFrame([&](const std::string& sequence, int number) {
    for (const std::string channel : {"flow.png", "ext_fwd.png", "ext_bwd.png"}) {
      EXPECT_EQ(readPngSize(path(sequence, number, channel)),
                sequence == "source" ? kSource : kTarget);
    }
  });
  for (int number = 1; number <= kFrames; ++number) {
    const Image<Rgba> picture = readPng(path("target", number, "nnf.png"));
    ASSERT_EQ(picture.size(), kTarget);
    const Mask shape = mask("target", number);
    for (std::size_t i = 0; i < shape.pixelCount(); ++i) {
      ASSERT_EQ(picture.data()[i].a, shape.data()[i] != 0 ? 1.0F : 0.0F);
    }
  }
}

TEST_F(EndToEndDump, FollowsTheScales) {
  (void)scene_.painting(
      {{"--dump-guides", "scaled"}, {"--src-scale", "2"}, {"--target-scale", "0.5"}});
  EXPECT_EQ(readPngSize(scene_.file("scaled/source/00001.mask.png")), (Size{48, 40}));
  EXPECT_EQ(readPngSize(scene_.file("scaled/target/00001.mask.png")), (Size{14, 11}));
}

TEST_F(EndToEndDump, EmptyFramesAreDumpedToo) {
  scene_.write("target/00002.png", maskPng(Mask(kTarget)));
  (void)scene_.painting({{"--dump-guides", "gap"}});
  const FloatImage nnf = readPfm(scene_.file("gap/target/00002.nnf.pfm"), "PF", kTarget);
  EXPECT_TRUE(std::all_of(nnf.values.begin(), nnf.values.end(),
                          [](float value) { return std::isnan(value); }));
  const FloatImage distance = readPfm(scene_.file("gap/target/00002.dist.pfm"), "Pf", kTarget);
  EXPECT_TRUE(std::all_of(distance.values.begin(), distance.values.end(),
                          [](float value) { return value < 0.0F && std::isfinite(value); }));
}

}  // namespace
}  // namespace fluidymation::test
