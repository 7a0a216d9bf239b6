#include "fluidymation/io/frame_folder.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "fluidymation/core/error.h"
#include "fluidymation/io/frame_pattern.h"
#include "support/temporary_folder.h"

namespace fluidymation {
namespace {

using test::messageOf;
using Names = std::vector<std::string>;

/// A folder with (empty) files of these names.
class Files {
 public:
  explicit Files(const Names& names, const std::string& subfolder = "") {
    path_ = subfolder.empty() ? folder_.path() : folder_.file(subfolder);
    std::filesystem::create_directory(path_);
    for (const std::string& name : names) test::writeBytes(path_ + "/" + name, {});
  }

  [[nodiscard]] const std::string& path() const { return path_; }
  [[nodiscard]] FolderSequence found() const {
    return sequenceIn(path_, "--target-path", {".png"});
  }
  [[nodiscard]] std::string complaint() const {
    return messageOf<Error>([&] { (void)found(); });
  }

 private:
  test::TemporaryFolder folder_;
  std::string path_;
};

TEST(FrameFolder, FindsTheNumberThatDiffers) {
  const struct {
    Names names;
    const char* pattern;
    int lowest;
    int highest;
  } cases[] = {
      {{"00007.png", "00008.png", "00010.png"}, "%05d.png", 7, 10},
      {{"8.png", "9.png", "10.png"}, "%d.png", 8, 10},
      {{"098.png", "100.png"}, "%03d.png", 98, 100},
      {{"099.png", "1000.png"}, "%03d.png", 99, 1000},
      {{"shot2_v3_01.png", "shot2_v3_02.png"}, "shot2_v3_%02d.png", 1, 2},
      {{"f01_1080p.PNG", "f02_1080p.PNG"}, "f%02d_1080p.PNG", 1, 2},
      {{"shot2_v3.png"}, "shot2_v%d.png", 3, 3},
      {{"0.png", "1.png"}, "%d.png", 0, 1},
      {{"50%_1.png", "50%_2.png"}, "50%%_%d.png", 1, 2},
      {{"1.png", "2.png", ".3.png", "4.jpg", "bare.png", "5.png.tmp"}, "%d.png", 1, 2},
  };
  for (const auto& c : cases) {
    const Files files(c.names);
    const FolderSequence found = files.found();
    EXPECT_EQ(found.pattern, files.path() + "/" + c.pattern);
    EXPECT_EQ(found.lowest, c.lowest);
    EXPECT_EQ(found.highest, c.highest);
    EXPECT_TRUE(std::filesystem::exists(FramePattern(found.pattern).path(c.lowest)));
  }
}

TEST(FrameFolder, NamesOfTheFolderArePlainText) {
  for (const char* name : {"50%", "%05d", "shot#1", "##"}) {
    const Files files({"01.png", "02.png"}, name);
    EXPECT_TRUE(std::filesystem::exists(FramePattern(files.found().pattern).path(2))) << name;
    EXPECT_EQ(FramePattern(patternIn(files.path())).path(3), files.path() + "/00003.png");
  }
}

TEST(FrameFolder, NamesAllShapesOfAnAmbiguousFolder) {
  const Files masks({"rgb_01.png", "rgb_02.png", "mask_01.png"});
  EXPECT_EQ(masks.complaint(), "--target-path " + masks.path() +
                                   ": holds files of 2 shapes of name: mask_%02d.png (1 file), "
                                   "rgb_%02d.png (2 files); wanted one of them as a pattern");
  const Files takes({"take1_01.png", "take1_02.png", "take2_01.png"});
  EXPECT_NE(takes.complaint().find("take1_%02d.png (2 files), take2_%02d.png (1 file)"),
            std::string::npos);
  const Files many({"a1.png", "b1.png", "c1.png", "d1.png", "e1.png", "f1.png"});
  EXPECT_NE(many.complaint().find("d%d.png (1 file) and 2 more; wanted"), std::string::npos);
}

TEST(FrameFolder, SaysWhatIsMissing) {
  const Files none({"bare.png", "01.jpg"});
  EXPECT_EQ(none.complaint(), "--target-path " + none.path() +
                                  ": the folder holds no numbered file; wanted names such as "
                                  "00001.png");
  const Files widths({"98.png", "099.png", "100.png"});
  EXPECT_NE(widths.complaint().find("filled up with zeros to different widths, such as 099"),
            std::string::npos);
  const Files large({"99999999999.png"});
  EXPECT_NE(large.complaint().find("the number 99999999999 is too large"), std::string::npos);
  EXPECT_NE(messageOf<Error>([] {
              (void)sequenceIn("/no/such/folder", "--src-path", {".png"});
            }).find("/no/such/folder: the folder cannot be read (No such file"),
            std::string::npos);
}

}  // namespace
}  // namespace fluidymation
