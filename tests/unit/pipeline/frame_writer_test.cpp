#include "pipeline/frame_writer.h"

#include <gtest/gtest.h>

#include "fluidymation/core/error.h"
#include "pipeline/painted_pixels.h"
#include "support/half_covered.h"
#include "support/synthetic_scene.h"
#include "support/temporary_folder.h"

namespace fluidymation {
namespace {

using test::TemporaryFolder;

constexpr Size kSize{31, 23};

GuideFrame halfCovered() { return test::halfCovered(kSize); }

TEST(FrameWriter, WritesWhatIsPaintedAsWritePngWould) {
  const TemporaryFolder folder;
  const Image<Lab> picture = test::randomTexture(kSize, 3);
  FrameWriter writer({BitDepth::k8, 5});
  writer.write(folder.file("a.png"), picture, halfCovered());
  writePng(folder.file("b.png"), straightPixels8(picture, halfCovered(), SrgbByteEncoder()), 5);
  EXPECT_EQ(test::readBytes(folder.file("a.png")), test::readBytes(folder.file("b.png")));
}

TEST(FrameWriter, WritesAllFormsWithTheirColourChunks) {
  constexpr std::size_t kBitDepthByte = 24;
  constexpr std::size_t kColorTypeByte = 25;
  const TemporaryFolder folder;
  const Image<Lab> picture = test::randomTexture(kSize, 3);
  for (const BitDepth depth : {BitDepth::k8, BitDepth::k16}) {
    for (const bool opaque : {false, true}) {
      FrameForm form{depth};
      form.color.srgbIntent = 1;
      if (opaque) form.background = Image<Rgb>(kSize, Rgb{1.0F, 0.0F, 0.0F});
      FrameWriter writer(std::move(form));
      const std::string path = folder.file("a.png");
      writer.write(path, picture, halfCovered());
      const test::Bytes file = test::readBytes(path);
      EXPECT_EQ(file[kBitDepthByte], depth == BitDepth::k8 ? 8 : 16);
      EXPECT_EQ(file[kColorTypeByte], opaque ? 2 : 6);
      EXPECT_EQ(readColorChunks(path).chunks.srgbIntent, 1);
      const Rgba corner = readPng(path)(kSize.width - 1, 0);
      EXPECT_EQ(corner.a, opaque ? 1.0F : 0.0F);
      EXPECT_EQ(corner.r, opaque ? 1.0F : 0.0F);
    }
  }
}

/// A writer that counts the frames that it encodes.
struct CountingWriter {
  int encoded = 0;
  FrameWriter writer{FrameForm{}, [this](const FrameWriter::Pixels& pixels) {
                       ++encoded;
                       return encodePng(std::get<Image<Rgba8>>(pixels));
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
  FrameWriter writer(FrameForm{});
  EXPECT_EQ(test::messageOf<Error>(
                [&] { writer.write(path, test::randomTexture(kSize, 1), halfCovered()); }),
            path + ": cannot be written (No such file or directory)");
}

}  // namespace
}  // namespace fluidymation
