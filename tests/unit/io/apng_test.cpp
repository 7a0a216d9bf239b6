#include "fluidymation/io/apng.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <vector>

#include "support/png_maker.h"
#include "support/temporary_folder.h"

namespace fluidymation {
namespace {

constexpr Size kSize{9, 7};

/// A picture of its own for each frame.
Image<Rgba8> picture(int frame) {
  Image<Rgba8> image(kSize);
  std::uint8_t value = static_cast<std::uint8_t>(31 * frame);
  for (Rgba8& pixel : image) {
    pixel = {value, static_cast<std::uint8_t>(value + 50), 7, 255};
    value = static_cast<std::uint8_t>(value + 3);
  }
  return image;
}

std::uint32_t numberAt(const test::Bytes& bytes, std::size_t place) {
  return static_cast<std::uint32_t>(bytes.at(place)) << 24U |
         static_cast<std::uint32_t>(bytes.at(place + 1)) << 16U |
         static_cast<std::uint32_t>(bytes.at(place + 2)) << 8U | bytes.at(place + 3);
}

void expectEqual(const Image<Rgba>& read, const Image<Rgba8>& written) {
  ASSERT_EQ(read.size(), written.size());
  for (std::size_t i = 0; i < read.pixelCount(); ++i) {
    EXPECT_EQ(toByte(read.data()[i].r), written.data()[i].r);
    EXPECT_EQ(toByte(read.data()[i].g), written.data()[i].g);
  }
}

TEST(AnimatedPng, HoldsEveryPictureInChunksInOrder) {
  const test::TemporaryFolder folder;
  const std::string path = folder.file("film.apng");
  constexpr int kFrames = 4;
  writeAnimatedPng(path, kFrames, 12, picture);

  // Whoever knows no animations sees the first picture; libpng checks the sums of all chunks
  expectEqual(readPng(path), picture(0));

  const std::vector<test::PngChunk> chunks = test::splitPng(test::readBytes(path));
  ASSERT_EQ(chunks.size(), 2U + 2U * kFrames + 1U);
  EXPECT_EQ(chunks[0].name, "IHDR");
  EXPECT_EQ(chunks[1].name, "acTL");
  EXPECT_EQ(numberAt(chunks[1].data, 0), static_cast<std::uint32_t>(kFrames));
  EXPECT_EQ(numberAt(chunks[1].data, 4), 0U);
  EXPECT_EQ(chunks.back().name, "IEND");
  std::uint32_t sequence = 0;
  for (int i = 0; i < kFrames; ++i) {
    const test::PngChunk& control = chunks[2 + 2 * static_cast<std::size_t>(i)];
    const test::PngChunk& data = chunks[3 + 2 * static_cast<std::size_t>(i)];
    EXPECT_EQ(control.name, "fcTL");
    ASSERT_EQ(control.data.size(), 26U);
    EXPECT_EQ(numberAt(control.data, 0), sequence++);
    EXPECT_EQ(numberAt(control.data, 4), 9U);
    EXPECT_EQ(numberAt(control.data, 8), 7U);
    EXPECT_EQ(numberAt(control.data, 20), 1U << 16U | 12U);  // 1/12 s
    test::Bytes pixels = data.data;
    if (i > 0) {
      EXPECT_EQ(data.name, "fdAT");
      EXPECT_EQ(numberAt(pixels, 0), sequence++);
      pixels.erase(pixels.begin(), pixels.begin() + 4);
    } else {
      EXPECT_EQ(data.name, "IDAT");
    }
    const std::string still = folder.file(std::to_string(i) + ".png");
    test::writeBytes(still, test::joinPng({chunks[0], {"IDAT", pixels}, {"IEND", {}}}));
    expectEqual(readPng(still), picture(i));
  }
}

TEST(AnimatedPng, WhatFailsLeavesTheOldFile) {
  const test::TemporaryFolder folder;
  const std::string path = folder.file("film.apng");
  writeAnimatedPng(path, 1, 12, picture);
  const test::Bytes before = test::readBytes(path);
  const auto failing = [](int frame) {
    if (frame == 2) throw std::runtime_error("no such frame");
    return picture(frame);
  };
  EXPECT_THROW(writeAnimatedPng(path, 3, 12, failing), std::runtime_error);
  EXPECT_EQ(test::readBytes(path), before);
}

}  // namespace
}  // namespace fluidymation
