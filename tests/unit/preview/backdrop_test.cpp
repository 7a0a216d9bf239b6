#include "preview/backdrop.h"

#include <gtest/gtest.h>

#include "fluidymation/core/error.h"
#include "fluidymation/io/png.h"
#include "support/temporary_folder.h"

namespace fluidymation {
namespace {

TEST(Backdrop, ReadsColors) {
  const std::optional<Rgb> paper = colorOf("#F4f100");
  ASSERT_TRUE(paper);
  EXPECT_EQ(toByte(paper->r), 0xF4);
  EXPECT_EQ(toByte(paper->g), 0xF1);
  EXPECT_EQ(toByte(paper->b), 0);
  const std::optional<Rgb> brief = colorOf("#08f");
  ASSERT_TRUE(brief);
  EXPECT_EQ(toByte(brief->r), 0);
  EXPECT_EQ(toByte(brief->g), 0x88);
  EXPECT_EQ(toByte(brief->b), 0xFF);
  EXPECT_TRUE(colorOf("white"));
  for (const char* text : {"", "#", "#12", "#12345", "#1234567", "#12345g", "F4F1E8", "redd"}) {
    EXPECT_FALSE(colorOf(text)) << text;
  }
}

TEST(Backdrop, APictureFillsTheFrameAndIsCutInTheMiddle) {
  const test::TemporaryFolder folder;
  Image<Rgba8> picture({40, 10}, Rgba8{255, 0, 0, 255});
  for (int y = 0; y < 10; ++y) {
    for (int x = 15; x < 25; ++x) picture(x, y) = {0, 255, 0, 255};
  }
  writePng(folder.file("bare.png"), picture);
  const Image<Rgb> result = backdrop(folder.file("bare.png"), Inputs{}, {20, 20});
  EXPECT_EQ(result.size(), (Size{20, 20}));
  EXPECT_EQ(toByte(result(10, 10).g), 255);
  EXPECT_EQ(toByte(result(10, 10).r), 0);
}

TEST(Backdrop, WhatIsNeitherIsWrongUsage) {
  const std::string message = test::messageOf<UsageError>([] {
    (void)backdrop("blueish", Inputs{}, {4, 4});
  });
  EXPECT_EQ(message.find("--preview-background blueish: no colour, and no file"), 0U) << message;
}

}  // namespace
}  // namespace fluidymation
