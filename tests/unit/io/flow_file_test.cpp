#include "fluidymation/io/flow_file.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

#include "fluidymation/core/error.h"
#include "fluidymation/core/random.h"
#include "fluidymation/io/png.h"
#include "support/comparison.h"
#include "support/png_maker.h"
#include "support/temporary_folder.h"

namespace fluidymation {
namespace {

using test::Bytes;
using test::bytesOf;
using test::messageOf;

void append(Bytes& bytes, std::uint32_t value) {
  for (int shift = 0; shift < 32; shift += 8) {
    bytes.push_back(static_cast<std::uint8_t>((value >> shift) & 0xFFU));
  }
}

Bytes floBytes(std::uint32_t width, std::uint32_t height, const std::vector<float>& values) {
  Bytes bytes = bytesOf("PIEH");
  append(bytes, width);
  append(bytes, height);
  for (const float value : values) {
    std::uint32_t bits = 0;
    std::memcpy(&bits, &value, sizeof bits);
    append(bytes, bits);
  }
  return bytes;
}

/// A 16-bit RGB PNG file as KITTI encodes flow; invalid where a component is NaN.
test::PngSpec kitti(const Image<Vec2>& flow) {
  test::PngSpec spec;
  spec.size = flow.size();
  spec.color = test::PngColor::kRgb;
  spec.bitDepth = 16;
  for (const Vec2 v : flow) {
    const bool valid = !std::isnan(v.x);
    spec.samples.push_back(valid ? static_cast<std::uint16_t>(std::lround(v.x * 64.0F) + 32768)
                                 : std::uint16_t{7});
    spec.samples.push_back(valid ? static_cast<std::uint16_t>(std::lround(v.y * 64.0F) + 32768)
                                 : std::uint16_t{9});
    spec.samples.push_back(valid ? 1 : 0);
  }
  return spec;
}

class FlowFileTest : public ::testing::Test {
 protected:
  /// What reading a file of these bytes complains about, in its header or in its vectors.
  [[nodiscard]] std::string complaint(const Bytes& bytes) const {
    test::writeBytes(path_, bytes);
    return messageOf<Error>([&] { (void)readFlow(path_, readFlowSize(path_)); });
  }

  test::TemporaryFolder folder_;
  std::string path_ = folder_.file("a.flo");
};

TEST_F(FlowFileTest, ReadsWhatWasWritten) {
  Image<Vec2> flow(Size{3, 2});
  float value = -2.5F;
  for (Vec2& v : flow) v = {value++, 0.1F * value};
  flow(2, 1) = {kMaxFlowPx, -kMaxFlowPx};
  writeFlow(path_, flow);
  EXPECT_EQ(readFlowSize(path_), flow.size());
  EXPECT_TRUE(test::nearEverywhere(flow, readFlow(path_, flow.size()), 0.0F));
}

TEST_F(FlowFileTest, WhatMiddleburyCallsUnknownIsZero) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  for (const float unknown : {kNan, kInfinity, -kInfinity, 1e9F, 1.666e9F, -1e10F}) {
    test::writeBytes(path_, floBytes(3, 1, {unknown, 1.0F, 2.0F, unknown, 3.0F, 4.0F}));
    const Image<Vec2> flow = readFlow(path_, Size{3, 1});
    EXPECT_EQ(length(flow(0, 0)), 0.0F);
    EXPECT_EQ(length(flow(1, 0)), 0.0F);
    EXPECT_EQ(flow(2, 0).x, 3.0F);
    EXPECT_EQ(flow(2, 0).y, 4.0F);
  }
}

TEST_F(FlowFileTest, ReadsKittisPngWhateverItsNameGammaAndOrderOfRows) {
  Image<Vec2> flow(Size{17, 9});
  for (int y = 0; y < 9; ++y) {
    for (int x = 0; x < 17; ++x) {
      flow(x, y) = {static_cast<float>(x - 8) * 3.125F, static_cast<float>(y) / 64.0F};
    }
  }
  flow(0, 0) = {-512.0F, 511.984375F};  // the ends of what it can say
  test::PngSpec spec = kitti(flow);
  for (const bool interlaced : {false, true}) {
    for (const bool gamma : {false, true}) {
      spec.interlaced = interlaced;
      spec.gamma.reset();
      if (gamma) spec.gamma = 1.0;
      test::writeBytes(path_, test::makePng(spec));
      EXPECT_EQ(readFlowSize(path_), flow.size());
      EXPECT_TRUE(test::nearEverywhere(flow, readFlow(path_, flow.size()), 0.0F));
    }
  }
}

TEST_F(FlowFileTest, WhatKittiCallsInvalidIsZero) {
  Image<Vec2> flow(Size{2, 1}, Vec2{5.0F, -3.0F});
  flow(0, 0) = {std::nanf(""), 0.0F};
  test::writeBytes(path_, test::makePng(kitti(flow)));
  const Image<Vec2> read = readFlow(path_, flow.size());
  EXPECT_EQ(length(read(0, 0)), 0.0F);
  EXPECT_EQ(read(1, 0).x, 5.0F);
}

TEST_F(FlowFileTest, OtherFilesAreNamedWithWhatTheyBeginWith) {
  const std::string wanted = "; wanted a Middlebury .flo file or a 16-bit RGB PNG file";
  EXPECT_EQ(complaint({}), path_ + ": is empty" + wanted);
  EXPECT_EQ(complaint(bytesOf("P")),
            path_ + ": is no flow file (it begins with the bytes 50)" + wanted);
  EXPECT_EQ(complaint(bytesOf("HEIP and more bytes than a header has")),
            path_ + ": is no flow file (it begins with the bytes 48 45 49 50)" + wanted);
  EXPECT_EQ(messageOf<Error>([&] { (void)readFlowSize(folder_.path()); }),
            folder_.path() + ": is a folder" + wanted);
  EXPECT_EQ(messageOf<Error>([&] { (void)readFlowSize(folder_.file("none")); }),
            folder_.file("none") + ": cannot be opened (No such file or directory)");
}

TEST_F(FlowFileTest, TheLengthHasToBeThatOfTheSize) {
  const Bytes whole = floBytes(2, 2, {1, 2, 3, 4, 5, 6, 7, 8});
  for (const std::size_t length : {4U, 5U, 11U}) {
    EXPECT_EQ(complaint(Bytes(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(length))),
              path_ + ": damaged .flo file (it ends within the header)");
  }
  for (const std::size_t length : {12U, 13U, 43U}) {
    EXPECT_EQ(complaint(Bytes(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(length))),
              path_ + ": damaged .flo file (" + std::to_string(length) +
                  " bytes; its 2x2 pixels take 44)");
  }
  Bytes longer = whole;
  longer.push_back(0);
  EXPECT_EQ(complaint(longer), path_ + ": damaged .flo file (45 bytes; its 2x2 pixels take 44)");
}

TEST_F(FlowFileTest, AbsurdSizesAreRefusedFromTheHeader) {
  const std::string wanted = " pixels; wanted 1 to 16384 a side and at most 120 million in all";
  EXPECT_EQ(complaint(floBytes(0, 5, {})), path_ + ": claims 0x5" + wanted);
  EXPECT_EQ(complaint(floBytes(5, 0, {})), path_ + ": claims 5x0" + wanted);
  EXPECT_EQ(complaint(floBytes(16385, 1, {})), path_ + ": claims 16385x1" + wanted);
  EXPECT_EQ(complaint(floBytes(16384, 16384, {})), path_ + ": claims 16384x16384" + wanted);
  EXPECT_EQ(complaint(floBytes(0xFFFFFFFFU, 0xFFFFFFFFU, {})),  // -1 x -1
            path_ + ": claims -1x-1" + wanted);
}

TEST_F(FlowFileTest, KnownVectorsBeyondAnyPictureAreASlip) {
  EXPECT_EQ(complaint(floBytes(2, 1, {1.0F, 2.0F, 3.0F, -2e5F})),
            path_ +
                ": pixel 1, 0 moves by 3, -200000 px; wanted at most 100000, or 1e9 and more "
                "where unknown");
}

TEST_F(FlowFileTest, PngFilesOfOtherKindsAndDamagedOnesAreRefused) {
  const Image<Vec2> flow(Size{4, 3}, Vec2{1.0F, 2.0F});
  test::PngSpec eight;
  eight.size = {2, 2};
  eight.samples = {1, 2, 3, 4};
  EXPECT_EQ(complaint(test::makePng(eight)),
            path_ + ": is a PNG file of 8 bits and colour type 0; wanted 16 bits and type 2 (RGB)");
  test::PngSpec alpha = kitti(flow);
  alpha.color = test::PngColor::kRgba;
  alpha.samples.resize(4 * 12);
  EXPECT_EQ(
      complaint(test::makePng(alpha)),
      path_ + ": is a PNG file of 16 bits and colour type 6; wanted 16 bits and type 2 (RGB)");
  Bytes cut = test::makePng(kitti(flow));
  cut.resize(cut.size() - 20);
  EXPECT_EQ(complaint(cut).find(path_ + ": damaged PNG file ("), 0U);
}

TEST_F(FlowFileTest, AnyDamageGivesAFlowOrOneLineThatNamesTheFile) {
  writeFlow(path_, Image<Vec2>(Size{5, 4}, Vec2{1.0F, -2.0F}));
  const Bytes flo = test::readBytes(path_);
  const Bytes png = test::makePng(kitti(Image<Vec2>(Size{5, 4}, Vec2{1.0F, -2.0F})));
  Random random({5, 0, 0, 0, 0, 0});
  for (int i = 0; i < 2000; ++i) {
    Bytes damaged = i % 2 == 0 ? flo : png;
    for (int change = random.uniform(1, 3); change > 0; --change) {
      const auto at =
          static_cast<std::size_t>(random.uniform(0, static_cast<int>(damaged.size()) - 1));
      damaged[at] = static_cast<std::uint8_t>(random.uniform(0, 255));
    }
    const std::string message = complaint(damaged);
    if (message.empty()) continue;
    EXPECT_EQ(message.find(path_ + ": "), 0U) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  }
}

TEST_F(FlowFileTest, AFileThatChangesMeanwhileIsNotRead) {
  const auto read = [&] { return messageOf<Error>([&] { (void)readFlow(path_, Size{5, 4}); }); };
  writeFlow(path_, Image<Vec2>(Size{4, 3}));
  EXPECT_EQ(read(), path_ + ": changed while being read (5x4 pixels at first, then 4x3)");
  test::writeBytes(path_, test::makePng(kitti(Image<Vec2>(Size{4, 3}))));
  EXPECT_EQ(read(), path_ + ": changed while being read (5x4 pixels at first, then 4x3)");
}

}  // namespace
}  // namespace fluidymation
