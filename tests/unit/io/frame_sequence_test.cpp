#include "fluidymation/io/frame_sequence.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

#include "fluidymation/core/error.h"
#include "fluidymation/io/png.h"
#include "support/temporary_folder.h"

namespace fluidymation {
namespace {

using test::messageOf;
using test::TemporaryFolder;
using Numbers = std::vector<int>;

/// A folder with (empty) files %03d.png of the given numbers.
class Frames {
 public:
  explicit Frames(const Numbers& numbers) : pattern_(folder_.file("%03d.png")) {
    for (const int number : numbers) test::writeBytes(pattern_.path(number), {});
    test::writeBytes(folder_.file("4.png"), {});  // not of this pattern
    test::writeBytes(folder_.file("readme.txt"), {});
  }

  [[nodiscard]] FrameFiles find(int start, int frames, int speed = 1) const {
    return findFrames(pattern_, {pattern_.text(), start, frames, speed, 1.0}, "--target-path");
  }
  [[nodiscard]] std::string complaint(int start, int frames, int speed = 1) const {
    return messageOf<Error>([&] { (void)find(start, frames, speed); });
  }
  [[nodiscard]] std::string path(int number) const { return pattern_.path(number); }
  [[nodiscard]] const std::string& text() const { return pattern_.text(); }

 private:
  TemporaryFolder folder_;
  FramePattern pattern_;
};

TEST(FrameSequence, FindsWhatWasAskedForWithoutANote) {
  const Frames frames({1, 2, 3});
  const FrameFiles found = frames.find(1, 3);
  EXPECT_EQ(found.numbers, (Numbers{1, 2, 3}));
  EXPECT_EQ(found.paths,
            (std::vector<std::string>{frames.path(1), frames.path(2), frames.path(3)}));
  EXPECT_EQ(found.note, "");
  EXPECT_EQ(found.count(), 3);
}

TEST(FrameSequence, EndsWhereTheFilesEndAndSaysSo) {
  const Frames frames({1, 2, 3});
  const FrameFiles found = frames.find(2, 50);
  EXPECT_EQ(found.numbers, (Numbers{2, 3}));
  EXPECT_EQ(found.note, "--target-path " + frames.text() +
                            ": the sequence ends with frame 3, after 2 of at most 50 frames "
                            "(--target-frames)");
}

TEST(FrameSequence, NotesThatMoreFilesFollow) {
  const Frames frames({1, 2, 3, 4, 5, 6});
  const FrameFiles found = frames.find(1, 2, 2);
  EXPECT_EQ(found.numbers, (Numbers{1, 3}));
  EXPECT_EQ(found.note, "--target-path " + frames.text() +
                            ": frames 1 to 3 are used; 1 more follows (--target-frames)");
  EXPECT_EQ(frames.find(2, 1).note, "--target-path " + frames.text() +
                                        ": frame 2 is used; 4 more follow (--target-frames)");
}

TEST(FrameSequence, PlaysBackwards) {
  const Frames frames({-1, 0, 1, 2, 3});
  EXPECT_EQ(frames.find(3, 5, -1).numbers, (Numbers{3, 2, 1, 0, -1}));
  EXPECT_EQ(frames.find(3, 5, -1).note, "");
  EXPECT_EQ(frames.find(3, 9, -2).numbers, (Numbers{3, 1, -1}));
}

TEST(FrameSequence, ListsAllHoles) {
  const Frames frames({3, 4, 10, 12});
  EXPECT_EQ(frames.complaint(1, 50),
            "--target-path " + frames.text() +
                ": 8 frames are missing although later ones exist: 1-2, 5-9, 11; frames 1 to 50 in "
                "steps of 1 were asked for");
  EXPECT_EQ(frames.complaint(12, 9, -1),
            "--target-path " + frames.text() +
                ": 6 frames are missing although later ones exist: 11, 9-5; frames 12 to 4 in "
                "steps of -1 were asked for");
}

TEST(FrameSequence, AFrameMissingAtTheEndIsAHoleWhenFilesFollow) {
  const Frames frames({1, 2, 4});
  EXPECT_NE(frames.complaint(1, 3).find("1 frame is missing although later ones exist: 3;"),
            std::string::npos);
}

TEST(FrameSequence, CutsAVeryLongListOfHoles) {
  Numbers odd;
  for (int i = 1; i < 800; i += 2) odd.push_back(i);
  const std::string message = Frames(odd).complaint(1, 800);
  EXPECT_LT(message.size(), 500U);
  EXPECT_NE(message.find("399 frames are missing"), std::string::npos) << message;
  EXPECT_NE(message.find(" more; frames 1 to 800"), std::string::npos) << message;
}

TEST(FrameSequence, NamesTheFirstFrameWhenThereIsNone) {
  EXPECT_EQ(
      messageOf<Error>([] {
        (void)findFrames(FramePattern("/nowhere/%05d.png"), {"", 1, 50, 1, 1.0}, "--src-path");
      }),
      "/nowhere/00001.png: cannot be opened (No such file or directory); frames 1 to 50 in "
      "steps of 1 were asked for");
  const Frames frames({100, 101});
  EXPECT_EQ(frames.complaint(1, 50),
            frames.path(1) +
                ": cannot be opened (No such file or directory); frames 1 to 50 in steps of 1 were "
                "asked for; files of this pattern are numbered 100 to 101 (--target-start)");
  EXPECT_EQ(frames.complaint(7, 1), frames.path(7) +
                                        ": cannot be opened (No such file or directory); frame 7 "
                                        "was asked for; files of this pattern are numbered 100 to "
                                        "101 (--target-start)");
}

TEST(FrameSequence, NumbersBeyondIntNameTheOptions) {
  const FramePattern pattern("%d.png");
  constexpr int kMax = std::numeric_limits<int>::max();
  EXPECT_EQ(messageOf<UsageError>([&] {
              (void)findFrames(pattern, {"", kMax - 1, 50, 1, 1.0}, "--src-mask-path");
            }),
            "--src-start 2147483646, --src-frames 50, --src-speed 1: the last frame would have "
            "number 2147483695; wanted numbers from -2147483648 to 2147483647");
  EXPECT_NE(messageOf<UsageError>([&] {
              (void)findFrames(pattern, {"", kMax, kMax, std::numeric_limits<int>::min(), 1.0},
                               "--target-path");
            }),
            "");
}

std::vector<std::string> faultsOf(const FrameFiles& files) {
  try {
    (void)commonSize(files);
  } catch (const Faults& faults) {
    return faults.lines();
  }
  return {};
}

TEST(FrameSequence, CommonSizeNamesAllFramesThatDifferOrCannotBeRead) {
  const TemporaryFolder folder;
  FrameFiles files;
  for (const int width : {5, 5, 4, 3}) {
    files.paths.push_back(folder.file(std::to_string(files.paths.size()) + ".png"));
    writeGrayPng(files.paths.back(), Image<std::uint8_t>(Size{width, 3}));
  }
  files.paths.push_back(folder.file("none.png"));
  const std::string wanted =
      ", but " + files.paths[0] + " is 5x3; all frames of a sequence must have one size";
  EXPECT_EQ(faultsOf(files),
            (std::vector<std::string>{
                files.paths[2] + ": size 4x3" + wanted, files.paths[3] + ": size 3x3" + wanted,
                files.paths[4] + ": cannot be opened (No such file or directory)"}));
  for (int i = 0; i < 9; ++i) files.paths.push_back(files.paths[2]);
  const std::vector<std::string> many = faultsOf(files);
  ASSERT_EQ(many.size(), 10U);
  EXPECT_EQ(many.back(), files.paths[2] + ": size 4x3" + wanted + "; 2 more files have faults");
  files.paths.resize(2);
  EXPECT_EQ(commonSize(files), (Size{5, 3}));
}

TEST(FrameSequence, ThatIsWantedCompletelyMustNotEndEarly) {
  const Frames frames({1, 2, 3});
  const SequenceOptions range{frames.text(), 1, 5, 1, 1.0, true};
  EXPECT_EQ(messageOf<Error>(
                [&] { (void)findFrames(FramePattern(frames.text()), range, "--target-path"); }),
            "--target-path " + frames.text() +
                ": 2 frames are missing: 4-5; frames 1 to 5 in steps of 1 were asked for");
  const SequenceOptions all{frames.text(), 3, 2, -2, 1.0, true};
  EXPECT_EQ(findFrames(FramePattern(frames.text()), all, "--target-path").numbers, (Numbers{3, 1}));
}

TEST(FrameSequence, CompanionsThatAreNotThereAtAllAreSaidToBeMissing) {
  const TemporaryFolder folder;
  FrameFiles frames;
  frames.numbers = {1};
  frames.paths = {"1.png"};
  const auto complaint = [&](const std::string& pattern) {
    return messageOf<Error>(
        [&] { (void)findCompanions(FramePattern(pattern), frames, {}, "--src-flow-path", -1); });
  };
  EXPECT_EQ(complaint(folder.file("%d.flo")),
            "--src-flow-path " + folder.file("%d.flo") +
                ": there is no file of this pattern; wanted one for every frame of --src-path");
  EXPECT_EQ(complaint(folder.file("none/%d.flo")),
            "--src-flow-path " + folder.file("none/%d.flo") +
                ": there is no file of this pattern (" + folder.file("none") +
                ": No such file or directory); wanted one for every frame of --src-path");
}

TEST(FrameSequence, AnExemplarAndItsMasksMustAgree) {
  const TemporaryFolder folder;
  FrameFiles exemplar;
  FrameFiles masks;
  exemplar.paths = {folder.file("a.png")};
  masks.paths = {folder.file("b.png")};
  writeGrayPng(exemplar.paths[0], Image<std::uint8_t>(Size{4, 3}));
  writeGrayPng(masks.paths[0], Image<std::uint8_t>(Size{3, 4}));
  EXPECT_EQ(messageOf<Error>([&] { requireMasksOfSameSize(exemplar, masks); }),
            masks.paths[0] + ": size 3x4, but " + exemplar.paths[0] +
                " is 4x3; an exemplar and its masks must agree");
  EXPECT_NO_THROW(requireMasksOfSameSize(exemplar, exemplar));
}

}  // namespace
}  // namespace fluidymation
