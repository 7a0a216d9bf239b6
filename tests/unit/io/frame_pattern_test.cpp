#include "fluidymation/io/frame_pattern.h"

#include <gtest/gtest.h>

#include <limits>

#include "fluidymation/core/error.h"
#include "support/temporary_folder.h"

namespace fluidymation {
namespace {

std::string complaintAbout(const std::string& pattern) {
  return test::messageOf<UsageError>([&] { (void)FramePattern(pattern); });
}

TEST(FramePattern, WritesNumbersAsPrintfDoes) {
  const struct {
    const char* pattern;
    int number;
    const char* path;
  } cases[] = {
      {"out/%05d.png", 12, "out/00012.png"},
      {"out/%d.png", 12, "out/12.png"},
      {"%i", 7, "7"},
      {"%3u.png", 7, "  7.png"},
      {"/%02d.png", 123, "/123.png"},
      {"a/b_%04d_c.png", -12, "a/b_-012_c.png"},
      {"%4d", -12, " -12"},
      {"%000005d", 3, "00003"},
      {"50%%/%d%%.png", 3, "50%/3%.png"},
      {"%020d", std::numeric_limits<int>::min(), "-0000000002147483648"},
      {"%d", std::numeric_limits<int>::max(), "2147483647"},
      {"%0d", 5, "5"},
      {"out/#####.png", 12, "out/00012.png"},
      {"#.png", 123, "123.png"},
      {"shot#1/a_###_b.png", -5, "shot#1/a_-05_b.png"},
      {"50%%_##", 3, "50%_03"},
      {"shot#1_%02d.png", 3, "shot#1_03.png"},
  };
  for (const auto& c : cases) {
    EXPECT_EQ(FramePattern(c.pattern).path(c.number), c.path) << c.pattern;
    EXPECT_EQ(FramePattern(c.pattern).text(), c.pattern);
  }
}

TEST(FramePattern, RefusesAllThatIsNotOneIntegerConversion) {
  const struct {
    std::string pattern;
    const char* reason;
  } cases[] = {
      {"", "the path is empty"},
      {"a.png", "contains no frame number"},
      {"%%", "contains no frame number"},
      {"100%%d.png", "contains no frame number"},
      {"out/", "contains no frame number"},
      {"%", "the % is followed by no conversion"},
      {"a%05", "the % is followed by no conversion"},
      {"%s.png", "\"%s\" is no frame number"},
      {"%n", "\"%n\" is no frame number"},
      {"%x.png", "\"%x\" is no frame number"},
      {"%5$d", "\"%5$\" is no frame number"},
      {"%*d", "\"%*\" is no frame number"},
      {"%ld", "\"%l\" is no frame number"},
      {"%-5d", "\"%-\" is no frame number"},
      {"%+d", "\"%+\" is no frame number"},
      {"% d", "\"% \" is no frame number"},
      {"%.3d", "\"%.\" is no frame number"},
      {"50% done/%d.png", "\"% \" is no frame number"},
      {"%99999999d", "the width of the frame number is above 20"},
      {"%021d", "the width of the frame number is above 20"},
      {"%99999999999999999999999d", "the width of the frame number is above 20"},
      {"%d%d", "contains more than one frame number"},
      {"%d/%d", "contains more than one frame number"},
      {"%d/%s", "\"%s\" is no frame number"},
      {"a%d/x.png", "the frame number is in a folder's name"},
      {"%d/", "the frame number is in a folder's name"},
      {"##_##.png", "contains more than one frame number"},
      {"a##/x.png", "contains no frame number"},
      {"#####################.png", "more than 20 # in a row"},
      {"a\n%d.png", "contains a line break"},
      {std::string("a\0%d.png", 8), "contains a line break or another control character"},
      {"\x1b[2J%d.png", "contains a line break or another control character"},
      {std::string(100000, 'x') + "%d", "longer than 4000 bytes"},
  };
  for (const auto& c : cases) {
    const std::string message = complaintAbout(c.pattern);
    EXPECT_NE(message.find(c.reason), std::string::npos) << c.pattern << " -> " << message;
    EXPECT_EQ(message.find_first_of("\n\x1b"), std::string::npos) << message;
    EXPECT_LT(message.size(), 400U);
  }
}

TEST(FramePattern, ComplainsInOneLineThatShowsThePattern) {
  EXPECT_EQ(complaintAbout("out/%s.png"),
            "out/%s.png: \"%s\" is no frame number (%d, %i, %u, also %5d and %05d; %% is a percent "
            "sign); wanted a path with exactly one frame number, e.g. frames/%05d.png");
}

TEST(FramePattern, NamesTheFolder) {
  EXPECT_EQ(FramePattern("%d.png").folder(), ".");
  EXPECT_EQ(FramePattern("/%d.png").folder(), "/");
  EXPECT_EQ(FramePattern("a/b/%d.png").folder(), "a/b");
  EXPECT_EQ(FramePattern("a%%/%d.png").folder(), "a%");
}

TEST(FramePattern, NumberOfUndoesPath) {
  for (const char* text :
       {"%d", "x/%05d.png", "x/frame %3d", "%020d.png", "a/7%d7.png", "%%%u%%"}) {
    const FramePattern pattern(text);
    for (const int number : {0, 1, -1, 9, 10, -99, 99999, 100000, std::numeric_limits<int>::max(),
                             std::numeric_limits<int>::min()}) {
      const std::string path = pattern.path(number);
      EXPECT_EQ(pattern.numberOf(path.substr(path.rfind('/') + 1)), number) << path;
    }
  }
}

TEST(FramePattern, NumberOfKnowsOnlyItsOwnSpelling) {
  const FramePattern pattern("in/f%05d.png");
  for (const char* name :
       {"", "f", "f.png", "f0012.png", "f000012.png", "f+0012.png", "f00012.PNG", "f00012.png~",
        "g00012.png", "f 0012.png", "f0x012.png", "f000 2.png", ".f00012.png.tmp.7",
        "f99999999999.png", "f-0000.png", "in/f00012.png"}) {
    EXPECT_FALSE(pattern.numberOf(name)) << name;
  }
  EXPECT_EQ(pattern.numberOf("f00012.png"), 12);
  EXPECT_FALSE(FramePattern("%d").numberOf("007"));
  EXPECT_FALSE(FramePattern("ab%dba").numberOf("aba"));
}

}  // namespace
}  // namespace fluidymation
