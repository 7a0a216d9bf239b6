#include "pipeline/frame_writer.h"

#include <gtest/gtest.h>

#include "fluidymation/core/error.h"
#include "support/synthetic_scene.h"
#include "support/temporary_folder.h"

namespace fluidymation {
namespace {

using test::TemporaryFolder;

constexpr Size kSize{31, 23};

/// The left half covered, and a column in the middle covered in part.
GuideFrame halfCovered() {
  GuideFrame guides;
  guides.mask = Mask(kSize);
  guides.coverage = Image<float>(kSize);
  for (int y = 0; y < kSize.height; ++y) {
    for (int x = 0; x <= kSize.width / 2; ++x) {
      const bool edge = x == kSize.width / 2;
      guides.mask(x, y) = edge ? 0 : 1;
      guides.coverage(x, y) = edge ? 0.25F : 1.0F;
    }
  }
  return guides;
}

TEST(ToOutput, PaintsWhatIsCoveredAndLeavesTheRestEmpty) {
  const Image<Lab> picture = test::randomTexture(kSize, 3);
  const Image<Rgba8> output = toOutput(picture, halfCovered(), SrgbByteEncoder());
  for (int y = 0; y < kSize.height; ++y) {
    for (int x = 0; x < kSize.width; ++x) {
      const Rgba8 p = output(x, y);
      const Rgb color = toRgb(picture(x, y));
      if (x > kSize.width / 2) {
        ASSERT_TRUE(p.r == 0 && p.g == 0 && p.b == 0 && p.a == 0);
        continue;
      }
      ASSERT_EQ(p.a, x == kSize.width / 2 ? 64 : 255);
      ASSERT_TRUE(p.r == toByte(color.r) && p.g == toByte(color.g) && p.b == toByte(color.b));
    }
  }
}

TEST(FrameWriter, WritesWhatIsPaintedAsWritePngWould) {
  const TemporaryFolder folder;
  const Image<Lab> picture = test::randomTexture(kSize, 3);
  FrameWriter writer(5);
  writer.write(folder.file("a.png"), picture, halfCovered());
  writePng(folder.file("b.png"), toOutput(picture, halfCovered(), SrgbByteEncoder()), 5);
  EXPECT_EQ(test::readBytes(folder.file("a.png")), test::readBytes(folder.file("b.png")));
}

/// A writer that counts the frames that it encodes.
struct CountingWriter {
  int encoded = 0;
  FrameWriter writer{[this](const Image<Rgba8>& pixels) {
    ++encoded;
    return encodePng(pixels);
  }};
};

TEST(FrameWriter, AFrameThatLooksAsTheOneBeforeIsNotEncodedAgain) {
  const TemporaryFolder folder;
  const Image<Lab> first = test::randomTexture(kSize, 1);
  const Image<Lab> second = test::randomTexture(kSize, 2);
  const auto path = [&](int number) { return folder.file(std::to_string(number) + ".png"); };
  CountingWriter counting;
  int number = 0;
  for (const Image<Lab>* picture : {&first, &first, &first, &second, &first}) {
    counting.writer.write(path(number++), *picture, halfCovered());
  }
  EXPECT_EQ(counting.encoded, 3);
  for (const int same : {1, 2, 4}) EXPECT_EQ(test::readBytes(path(same)), test::readBytes(path(0)));
  EXPECT_NE(test::readBytes(path(3)), test::readBytes(path(0)));
}

TEST(FrameWriter, AnotherOutlineIsAnotherFrame) {
  const TemporaryFolder folder;
  const Image<Lab> picture = test::randomTexture(kSize, 1);
  GuideFrame fuller = halfCovered();
  for (float& c : fuller.coverage) {
    if (c == 0.25F) c = 0.5F;
  }
  CountingWriter counting;
  counting.writer.write(folder.file("a.png"), picture, halfCovered());
  counting.writer.write(folder.file("b.png"), picture, fuller);
  EXPECT_EQ(counting.encoded, 2);
  EXPECT_NE(test::readBytes(folder.file("a.png")), test::readBytes(folder.file("b.png")));
}

TEST(FrameWriter, NamesTheFileThatCannotBeWritten) {
  const TemporaryFolder folder;
  const std::string path = folder.file("none/a.png");
  FrameWriter writer(kDefaultCompression);
  EXPECT_EQ(test::messageOf<Error>(
                [&] { writer.write(path, test::randomTexture(kSize, 1), halfCovered()); }),
            path + ": cannot be written (No such file or directory)");
}

}  // namespace
}  // namespace fluidymation
