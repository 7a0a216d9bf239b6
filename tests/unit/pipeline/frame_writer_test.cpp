#include "pipeline/frame_writer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>

#include "fluidymation/core/error.h"
#include "pipeline/painted_pixels.h"
#include "support/half_covered.h"
#include "support/synthetic_scene.h"
#include "support/temporary_folder.h"

namespace fluidymation {
namespace {

using test::TemporaryFolder;

constexpr Size kSize{31, 23};
const FramePart kWhole = FramePart::whole(kSize);

GuideFrame halfCovered() { return test::halfCovered(kSize); }

/// From none to all, changing from pixel to pixel.
Image<float> anyCoverage() {
  const Image<Lab> texture = test::randomTexture(kSize, 5);
  Image<float> coverage(kSize);
  for (std::size_t i = 0; i < coverage.pixelCount(); ++i) {
    coverage.data()[i] = i % 3 == 0 ? 0.0F : std::clamp(0.02F * texture.data()[i].l, 0.0F, 1.0F);
  }
  return coverage;
}

TEST(FrameWriter, WritesWhatIsPaintedAsWritePngWould) {
  const TemporaryFolder folder;
  const Image<Lab> picture = test::randomTexture(kSize, 3);
  FrameWriter writer({BitDepth::k8, 5});
  writer.write(folder.file("a.png"), kWhole, picture, halfCovered());
  writePng(folder.file("b.png"),
           straightPixels8({kWhole, picture, halfCovered()}, SrgbByteEncoder()), 5);
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
      writer.write(path, kWhole, picture, halfCovered());
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
  FrameWriter writer{FrameForm{}, [this](const FrameWriter::Output& output) {
                       ++encoded;
                       return encodePng(std::get<Image<Rgba8>>(output.pixels), output.part);
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
    counting.writer.write(path(number++), kWhole, *picture, halfCovered());
  }
  EXPECT_EQ(counting.encoded, 3);
  for (const int same : {1, 2, 4}) EXPECT_EQ(test::readBytes(path(same)), test::readBytes(path(0)));
  EXPECT_NE(test::readBytes(path(3)), test::readBytes(path(0)));
}

/// Whether only the part with the paint is given, or all of the frame, is no matter.
TEST(FrameWriter, APartIsWrittenAsTheWholeFrame) {
  const TemporaryFolder folder;
  const Image<Lab> picture = test::randomTexture(kSize, 3);
  const Image<Lab> surface = test::randomTexture({kSize.height, kSize.width}, 4);
  for (const Box& box : {Box{9, 6, 20, 15}, Box{0, 0, 12, kSize.height}, Box{}}) {
    const FramePart part{kSize, box};
    GuideFrame ofPart;
    ofPart.mask = cropped(halfCovered().mask, box);
    ofPart.coverage = cropped(anyCoverage(), box);
    GuideFrame ofWhole;
    ofWhole.mask = wholeFrame(ofPart.mask, part);
    ofWhole.coverage = wholeFrame(ofPart.coverage, part);
    for (const BitDepth depth : {BitDepth::k8, BitDepth::k16}) {
      for (const bool opaque : {false, true}) {
        SCOPED_TRACE(::testing::Message()
                     << "box from " << box.beginX << "," << box.beginY << " to " << box.endX << ","
                     << box.endY << (depth == BitDepth::k8 ? ", 8 bits" : ", 16 bits")
                     << (opaque ? ", opaque" : ""));
        FrameForm form{depth};
        if (opaque) form.background = Image<Rgb>(kSize);
        for (std::size_t i = 0; i < form.background.pixelCount(); ++i) {
          form.background.data()[i] = toRgb(surface.data()[i]);
        }
        FrameWriter writer(std::move(form));
        writer.write(folder.file("part.png"), part, cropped(picture, box), ofPart);
        writer.write(folder.file("whole.png"), kWhole, picture, ofWhole);
        EXPECT_EQ(test::readBytes(folder.file("part.png")),
                  test::readBytes(folder.file("whole.png")));
      }
    }
  }
}

TEST(FrameWriter, TheSamePaintElsewhereIsAnotherFrame) {
  const TemporaryFolder folder;
  const Size size{6, 5};
  const Image<Lab> picture = test::randomTexture(size, 1);
  GuideFrame guides;
  guides.mask = Mask(size, 1);
  CountingWriter counting;
  counting.writer.write(folder.file("a.png"), {kSize, {8, 8, 14, 13}}, picture, guides);
  counting.writer.write(folder.file("b.png"), {kSize, {9, 8, 15, 13}}, picture, guides);
  EXPECT_EQ(counting.encoded, 2);
  EXPECT_NE(test::readBytes(folder.file("a.png")), test::readBytes(folder.file("b.png")));
}

TEST(FrameWriter, AnotherOutlineIsAnotherFrame) {
  const TemporaryFolder folder;
  const Image<Lab> picture = test::randomTexture(kSize, 1);
  GuideFrame fuller = halfCovered();
  for (float& c : fuller.coverage) {
    if (c == 0.25F) c = 0.5F;
  }
  CountingWriter counting;
  counting.writer.write(folder.file("a.png"), kWhole, picture, halfCovered());
  counting.writer.write(folder.file("b.png"), kWhole, picture, fuller);
  EXPECT_EQ(counting.encoded, 2);
  EXPECT_NE(test::readBytes(folder.file("a.png")), test::readBytes(folder.file("b.png")));
}

TEST(FrameWriter, NamesTheFileThatCannotBeWritten) {
  const TemporaryFolder folder;
  const std::string path = folder.file("none/a.png");
  FrameWriter writer(FrameForm{});
  EXPECT_EQ(test::messageOf<Error>(
                [&] { writer.write(path, kWhole, test::randomTexture(kSize, 1), halfCovered()); }),
            path + ": cannot be written (No such file or directory)");
}

}  // namespace
}  // namespace fluidymation
