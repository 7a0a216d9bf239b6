// Flow that is given instead of derived.

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "fluidymation/core/resize.h"
#include "fluidymation/guides/mask.h"
#include "fluidymation/io/flow_file.h"
#include "support/png_maker.h"
#include "support/small_scene.h"

namespace fluidymation::test {
namespace {

namespace fs = std::filesystem;
using Painting = SmallScene::Painting;

constexpr Size kSource{24, 20};
constexpr Size kTarget{28, 22};

std::string flowFile(const std::string& folder, int number) {
  return folder + "/0000" + std::to_string(number) + ".flo";
}

/// The same flow for all four frames.
void writeFlows(const SmallScene& scene, const std::string& folder, Size size, Vec2 flow) {
  fs::create_directories(scene.file(folder));
  for (int number = 1; number <= 4; ++number) {
    writeFlow(scene.file(flowFile(folder, number)), Image<Vec2>(size, flow));
  }
}

const ToolOptions kGiven = {{"--src-flow-path", "sf/%05d.flo"},
                            {"--target-flow-path", "tf/%05d.flo"},
                            {"--dump-guides", "dump"}};

/// The tool has to refuse with exit code `code` and `message`, before anything is written.
void expectRefused(const SmallScene& scene, const ToolOptions& options, int code,
                   const std::string& message) {
  EXPECT_TRUE(failedWith(code, message, scene.paint(quietly(options))));
  EXPECT_TRUE(scene.names("out").empty()) << message;
  EXPECT_TRUE(scene.names("dump").empty()) << message;
}

class EndToEndFlow : public ::testing::Test {
 protected:
  EndToEndFlow() {
    writeFlows(scene_, "sf", kSource, {0.5F, -0.25F});
    writeFlows(scene_, "tf", kTarget, {1.5F, 0.75F});
  }

  /// KITTI's PNG files of the flow that `tf` has.
  void writeKitti() const {
    PngSpec spec;
    spec.size = kTarget;
    spec.color = PngColor::kRgb;
    spec.bitDepth = 16;
    for (int i = 0; i < kTarget.width * kTarget.height; ++i) {
      for (const int sample : {32768 + 96, 32768 + 48, 1}) {
        spec.samples.push_back(static_cast<std::uint16_t>(sample));
      }
    }
    for (int number = 1; number <= 4; ++number) {
      scene_.write(SmallScene::frame("kitti", number), makePng(spec));
    }
  }

  /// Whether the dumped flow is `flow` inside the mask of every frame and zero outside.
  void expectDumped(const std::string& sequence, Size size, Vec2 flow) const {
    for (int number = 1; number <= 4; ++number) {
      const std::string stem = scene_.file("dump/" + sequence + "/0000" + std::to_string(number));
      const Image<Vec2> dumped = readFlow(stem + ".flow.flo", size);
      const Image<float> mask = readCoverage(stem + ".mask.png", MaskChannel::kBrightness, size);
      for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
          const Vec2 wanted = mask(x, y) > 0.5F ? flow : Vec2{};
          ASSERT_NEAR(length(dumped(x, y) - wanted), 0.0F, 1e-6F) << sequence << number;
        }
      }
    }
  }

  SmallScene scene_{4};
};

TEST_F(EndToEndFlow, AConstantFlowIsTheOneThatIsUsed) {
  (void)scene_.painting(kGiven);
  expectDumped("source", kSource, {0.5F, -0.25F});
  expectDumped("target", kTarget, {1.5F, 0.75F});
}

TEST_F(EndToEndFlow, ItIsScaledWithTheFramesAndNegatedWithTime) {
  ToolOptions options = kGiven;
  options["--src-scale"] = "0.5";
  options["--target-scale"] = "1.5";
  options["--target-start"] = "4";
  options["--target-speed"] = "-1";
  (void)scene_.painting(options);
  expectDumped("source", scaledSize(kSource, 0.5), {0.25F, -0.125F});
  expectDumped("target", scaledSize(kTarget, 1.5), {-2.25F, -1.125F});
}

TEST_F(EndToEndFlow, EachIsGivenByItselfAndChangesThePainting) {
  const Painting derived = scene_.painting({{"--flow-weight", "100"}});
  for (const char* option : {"--src-flow-path", "--target-flow-path"}) {
    EXPECT_TRUE(scene_.painting({{"--flow-weight", "100"}, {option, kGiven.at(option)}}) != derived)
        << option;
  }
}

TEST_F(EndToEndFlow, WhatWasDumpedPaintsTheSameWhenItIsGiven) {
  const Painting derived = scene_.painting({{"--dump-guides", "dump"}});
  EXPECT_TRUE(scene_.painting({{"--src-flow-path", "dump/source/%05d.flow.flo"},
                               {"--target-flow-path", "dump/target/%05d.flow.flo"}}) == derived);
}

TEST_F(EndToEndFlow, ConventionsDifferByTheFileThatIsMeant) {
  // Only the file of frame 2 moves: it leads to frame 2, or away from it.
  for (const int number : {1, 3, 4}) {
    writeFlow(scene_.file(flowFile("tf", number)), Image<Vec2>(kTarget));
  }
  const auto fastest = [&](int number) {
    float largest = 0.0F;
    const std::string path = "dump/target/0000" + std::to_string(number) + ".flow.flo";
    for (const Vec2 v : readFlow(scene_.file(path), kTarget)) {
      largest = std::max(largest, length(v));
    }
    return largest;
  };
  ToolOptions options = kGiven;
  (void)scene_.painting(options);
  EXPECT_EQ(fastest(1), 0.0F);
  EXPECT_GT(fastest(2), 1.0F);
  EXPECT_EQ(fastest(3), 0.0F);
  options["--flow-convention"] = "forward";
  scene_.remove(flowFile("tf", 4));  // nothing comes after the last frame
  (void)scene_.painting(options);
  EXPECT_GT(fastest(3), 1.0F);
  EXPECT_EQ(fastest(4), 0.0F);
}

TEST_F(EndToEndFlow, KittisPngIsTakenToo) {
  writeKitti();
  ToolOptions options = kGiven;
  options["--target-flow-path"] = "kitti/%05d.png";
  (void)scene_.painting(options);
  expectDumped("target", kTarget, {1.5F, 0.75F});
}

TEST_F(EndToEndFlow, FaultyFilesAreNamedBeforeAnythingIsWritten) {
  const Bytes good = scene_.read(flowFile("tf", 3));
  Bytes cut = good;
  cut.pop_back();
  scene_.write(flowFile("tf", 3), cut);
  const std::string length = std::to_string(good.size());
  expectRefused(scene_, kGiven, 1,
                "tf/00003.flo: damaged .flo file (" + std::to_string(cut.size()) +
                    " bytes; its 28x22 pixels take " + length + ")");
  scene_.write(flowFile("tf", 3), bytesOf("no flow"));
  expectRefused(scene_, kGiven, 1,
                "tf/00003.flo: is no flow file (it begins with the bytes 6E 6F 20 66); wanted a "
                "Middlebury .flo file or a 16-bit RGB PNG file");
  writeFlow(scene_.file(flowFile("tf", 3)), Image<Vec2>(kSource));
  expectRefused(scene_, kGiven, 1,
                "tf/00003.flo: size 24x20, but target/00003.png is 28x22; a flow and its masks "
                "must agree");
  writeFlow(scene_.file(flowFile("tf", 3)), Image<Vec2>(kTarget, Vec2{1e8F, 0.0F}));
  expectRefused(scene_, kGiven, 1,
                "tf/00003.flo: pixel 0, 0 moves by 100000000, 0 px; wanted at most 100000, or 1e9 "
                "and more where unknown");
  scene_.remove(flowFile("tf", 3));
  expectRefused(scene_, kGiven, 1,
                "--target-flow-path tf/%05d.flo: 1 frame is missing: 3; wanted one file for every "
                "frame of --target-path but the first");
  scene_.remove("tf");
  expectRefused(
      scene_, kGiven, 1,
      "--target-flow-path tf/%05d.flo: there is no file of this pattern (tf: No such file "
      "or directory); wanted one for every frame of --target-path");
}

TEST_F(EndToEndFlow, OtherSpeedsAreWrongUsage) {
  ToolOptions options = kGiven;
  options["--src-speed"] = "2";
  expectRefused(scene_, options, 2,
                "--src-speed 2: wanted 1 or -1 with --src-flow-path, whose files lead from one "
                "frame to the next");
}

TEST_F(EndToEndFlow, IsNeverOverwritten) {
  writeKitti();
  const std::string frame = SmallScene::frame("kitti", 2);
  const Bytes before = scene_.read(frame);
  ToolOptions options = kGiven;
  options.erase("--dump-guides");
  options["--target-flow-path"] = "kitti/%05d.png";
  options["--out-path"] = "./kitti/%05d.png";
  expectRefused(scene_, options, 2,
                "--out-path ./kitti/%05d.png: ./kitti/00001.png is an input and would be "
                "overwritten; choose another --out-path");
  (void)scene_.painting({{"--dump-guides", "d"}});
  scene_.remove("out");
  expectRefused(scene_,
                {{"--target-flow-path", "d/target/%05d.flow.flo"},
                 {"--dump-guides", "d"},
                 {"--out-path", "fresh/%d.png"}},
                2,
                "--dump-guides d: d/target/00001.flow.flo is an input and would be overwritten; "
                "choose another folder");
  EXPECT_TRUE(scene_.read(frame) == before);
}

}  // namespace
}  // namespace fluidymation::test
