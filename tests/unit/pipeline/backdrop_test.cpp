#include "pipeline/backdrop.h"

#include <gtest/gtest.h>

#include "fluidymation/core/error.h"
#include "fluidymation/io/png.h"
#include "support/temporary_folder.h"

namespace fluidymation {
namespace {

TEST(Backdrop, APictureFillsTheFrameAndIsCutInTheMiddle) {
  const test::TemporaryFolder folder;
  Image<Rgba8> picture({40, 10}, Rgba8{255, 0, 0, 255});
  for (int y = 0; y < 10; ++y) {
    for (int x = 15; x < 25; ++x) picture(x, y) = {0, 255, 0, 255};
  }
  writePng(folder.file("bare.png"), picture);
  const Image<Rgb> result = backdrop("--background", folder.file("bare.png"), Inputs{}, {20, 20});
  EXPECT_EQ(result.size(), (Size{20, 20}));
  EXPECT_EQ(toByte(result(10, 10).g), 255);
  EXPECT_EQ(toByte(result(10, 10).r), 0);
}

TEST(Backdrop, HasOneTextForEachColour) {
  for (const char* white : {"white", "#fff", "#FFF", "#ffffff", "#FfFFff"}) {
    EXPECT_EQ(backgroundText(white), "#ffffff");
  }
  EXPECT_EQ(backgroundText("black"), "#000000");
  EXPECT_EQ(backgroundText("#Ab3"), "#aabb33");
  for (const char* text : {"gray", "exemplar", "exemplar:cat", "White.png", "#12", ""}) {
    EXPECT_EQ(backgroundText(text), text);
  }
}

TEST(Backdrop, WhatIsNeitherIsWrongUsage) {
  const std::string message = test::messageOf<UsageError>([] {
    (void)backdrop("--background", "blueish", Inputs{}, {4, 4});
  });
  EXPECT_EQ(message.find("--background blueish: no colour, and no file"), 0U) << message;
}

}  // namespace
}  // namespace fluidymation
