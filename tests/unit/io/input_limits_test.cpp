// The limits on what is read: the last value that passes, and the first that does not.
#include "fluidymation/io/input_limits.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <limits>

#include "fluidymation/core/error.h"
#include "fluidymation/io/flow_file.h"
#include "fluidymation/io/frame_pattern.h"
#include "fluidymation/io/png.h"
#include "fluidymation/option_ranges.h"
#include "support/png_maker.h"

namespace fluidymation {
namespace {

using test::Bytes;
using test::messageOf;
using test::TemporaryFolder;

class InputLimits : public ::testing::Test {
 protected:
  /// A 1-bit gray PNG file of that size, with all its pixels.
  void writeGray(std::uint32_t width, std::uint32_t height) const {
    const std::size_t rowBytes = 1 + (width + 7) / 8;
    test::writeBytes(path_, test::joinPng({{"IHDR", test::pngHeader(width, height, 1, 0)},
                                           {"IDAT", test::deflatedZeros(rowBytes * height)},
                                           {"IEND", {}}}));
  }
  [[nodiscard]] std::string sizeComplaint() const {
    return messageOf<Error>([&] { (void)readPngSize(path_); });
  }

  TemporaryFolder folder_;
  std::string path_ = folder_.file("a.png");
};

TEST_F(InputLimits, ASideMayHave16384Pixels) {
  for (const bool wide : {true, false}) {
    const auto write = [&](std::uint32_t side) { wide ? writeGray(side, 1) : writeGray(1, side); };
    write(16384);
    EXPECT_EQ(readPng(path_).size(), (wide ? Size{16384, 1} : Size{1, 16384}));
    write(16385);
    EXPECT_NE(sizeComplaint().find("wanted at most 16384 a side"), std::string::npos);
    EXPECT_EQ(messageOf<Error>([&] { (void)readPng(path_); }), sizeComplaint());
  }
}

TEST_F(InputLimits, APictureMayHave120MillionPixels) {
  writeGray(10000, 12000);
  EXPECT_EQ(readPngSize(path_), (Size{10000, 12000}));
  writeGray(10001, 12000);
  EXPECT_NE(sizeComplaint().find("120 million in all"), std::string::npos);
}

TEST_F(InputLimits, AFileMayHaveAGibibyte) {
  writeGray(8, 8);
  std::filesystem::resize_file(path_, kMaxImageFileBytes);  // sparse: takes no room on the disk
  EXPECT_EQ(sizeComplaint(), "") << "what follows the picture is not read";
  std::filesystem::resize_file(path_, kMaxImageFileBytes + 1);
  EXPECT_EQ(sizeComplaint(),
            path_ + ": has 1073741825 bytes; wanted a PNG file of at most 1073741824");
  EXPECT_EQ(messageOf<Error>([&] { (void)readPng(path_); }), sizeComplaint());
  EXPECT_EQ(messageOf<Error>([&] { (void)hasTransparency(path_); }), sizeComplaint());
  EXPECT_NE(messageOf<Error>([&] { (void)readFlowSize(path_); }).find("has 1073741825 bytes"),
            std::string::npos);
}

TEST_F(InputLimits, TheLargestPictureAndTheLargestFlowFitTheirFile) {
  constexpr std::int64_t kWidestPixelBytes = 8;  // 16-bit RGBA, or a vector
  constexpr std::int64_t kFilterBytes = 7 * std::int64_t{kMaxImageSidePx};  // one a row and sweep
  // Stored without compression, deflate adds 5 bytes to each block of 65535; libpng cuts IDAT
  // chunks, 12 bytes each, at 8192 or more.
  constexpr std::int64_t kPixels = kWidestPixelBytes * kMaxImagePixels + kFilterBytes;
  constexpr std::int64_t kPacked = kPixels + kPixels / 65535 * 5 + kPixels / 8192 * 12;
  static_assert(kPacked < kMaxImageFileBytes);
}

TEST_F(InputLimits, SumsAndProductsOfSizesFit64Bits) {
  constexpr std::int64_t kMost = std::numeric_limits<std::int64_t>::max();
  constexpr std::int64_t kMostBytesAPixel = 1000;  // a run takes some 200
  static_assert(kMaxImagePixels < kMost / kMostBytesAPixel / kMaxFrames);
  static_assert(std::int64_t{kMaxImageSidePx} * kMaxImageSidePx < std::numeric_limits<int>::max());
  EXPECT_LT(ranges::kScales.high * kMaxImageSidePx, std::numeric_limits<int>::max());
}

TEST_F(InputLimits, APatternMayHave4000Bytes) {
  const std::string ending = "/%d.png";
  EXPECT_NO_THROW(FramePattern(std::string(4000 - ending.size(), 'a') + ending));
  EXPECT_THROW(FramePattern(std::string(4001 - ending.size(), 'a') + ending), UsageError);
}

TEST_F(InputLimits, ASequenceMayHaveAMillionFrames) {
  EXPECT_TRUE(ranges::kFrameCounts.contains(1'000'000));
  EXPECT_FALSE(ranges::kFrameCounts.contains(1'000'001));
}

TEST_F(InputLimits, ABombEndsAtTheDeclaredSize) {
  // 60 MB behind the last of 8x8 pixels, in the same stream
  test::writeBytes(path_, test::joinPng({{"IHDR", test::pngHeader(8, 8, 1, 0)},
                                         {"IDAT", test::deflatedZeros(60'000'000)},
                                         {"IEND", {}}}));
  EXPECT_EQ(messageOf<Error>([&] { (void)readPng(path_); }),
            path_ + ": damaged PNG file (there is more data than its pixels need)");
}

}  // namespace
}  // namespace fluidymation
