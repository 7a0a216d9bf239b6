#include "compositing/plain_background.h"

#include <gtest/gtest.h>

namespace fluidymation {
namespace {

TEST(PlainBackground, ReadsColors) {
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

}  // namespace
}  // namespace fluidymation
