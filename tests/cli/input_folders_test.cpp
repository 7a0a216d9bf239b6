// Folders in the place of patterns.

#include "cli/input_folders.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "cli/command_line_arguments.h"
#include "fluidymation/io/frame_pattern.h"
#include "support/temporary_folder.h"

namespace fluidymation::cli {
namespace {

/// A film, its masks and an animation in folders.
class Folders {
 public:
  Folders() {
    fill("film", {10, 11, 12, 13}, "f%02d.png");
    fill("masks", {10, 11, 12, 13}, "%d.png");
    fill("animation", {101, 102, 104}, "a_%04d.png");
  }

  [[nodiscard]] std::string file(const std::string& name) const { return folder_.file(name); }
  [[nodiscard]] Options parsed(const Arguments& more, const std::string& out = "out") const {
    Arguments arguments = {"--src-path",    file("film"),      "--src-mask-path", file("masks"),
                           "--target-path", file("animation"), "--out-path",      file(out)};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return parse(arguments).options;
  }

 private:
  void fill(const std::string& name, const std::vector<int>& numbers, const std::string& pattern) {
    std::filesystem::create_directory(folder_.file(name));
    for (const int number : numbers) {
      const FramePattern frame(folder_.file(name) + "/" + pattern);
      test::writeBytes(frame.path(number), {});
    }
  }

  test::TemporaryFolder folder_;
};

TEST(InputFolders, BecomePatternsOfAllTheirFiles) {
  const Folders folders;
  const Options options = folders.parsed({});
  EXPECT_EQ(options.source.path, folders.file("film/f%d.png"));
  EXPECT_EQ(options.sourceMaskPath, folders.file("masks/%d.png"));
  EXPECT_EQ(options.source.start, 10);
  EXPECT_EQ(options.source.frames, 4);
  EXPECT_EQ(options.target.path, folders.file("animation/a_%04d.png"));
  EXPECT_EQ(options.target.start, 101);
  EXPECT_EQ(options.target.frames, 4);  // so that the hole is found
  EXPECT_EQ(options.outPath, folders.file("out/%05d.png"));
}

TEST(InputFolders, LeaveToTheUserWhatTheUserSays) {
  const Folders folders;
  const Options part = folders.parsed({"--src-start", "11", "--target-frames", "2"});
  EXPECT_EQ(part.source.start, 11);
  EXPECT_EQ(part.source.frames, 3);
  EXPECT_EQ(part.target.start, 101);
  EXPECT_EQ(part.target.frames, 2);
  const Options backwards = folders.parsed({"--src-speed", "-1", "--target-range", "102-101"});
  EXPECT_EQ(backwards.source.start, 13);
  EXPECT_EQ(backwards.source.frames, 4);
  EXPECT_EQ(backwards.target.start, 102);
  EXPECT_EQ(backwards.target.speed, -1);
}

TEST(InputFolders, MissingOnesAndSingleFilesAreTold) {
  const std::string wanted =
      "; wanted a folder of frames, or a path with one frame number, e.g. frames/%05d.png";
  EXPECT_EQ(complaint({"--src-path", "no/film"}), "--src-path no/film: no such folder" + wanted);
  EXPECT_EQ(complaint({"--target-path", "/proc/self/stat"}),
            "--target-path /proc/self/stat: is a single file" + wanted);
}

TEST(InputFolders, OutputMayBeAFolder) {
  const Folders folders;
  EXPECT_EQ(folders.parsed({}, "new/").outPath, folders.file("new/%05d.png"));
  EXPECT_EQ(folders.parsed({}, "film").outPath, folders.file("film/%05d.png"));
  for (const std::string version : {"shot.v1.2", "shot.v2", "v12", "1.0"}) {
    EXPECT_EQ(folders.parsed({}, version).outPath, folders.file(version + "/%05d.png"));
  }
  EXPECT_EQ(folders.parsed({}, "##.png").outPath, folders.file("##.png"));
  EXPECT_EQ(complaint({"--out-path", "x.png"}).find("--out-path: x.png: contains no frame number"),
            0U);
  for (const std::string file : {"shot.mp4", "shot.vob", "shot.v", "shot.v2.exr", "shot."}) {
    EXPECT_EQ(complaint({"--out-path", file}).find("--out-path: " + file + ": "), 0U) << file;
  }
}

}  // namespace
}  // namespace fluidymation::cli
