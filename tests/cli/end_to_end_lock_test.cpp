// That two runs of the real program do not paint the same frames at a time.

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <optional>
#include <string>

#include "fluidymation/io/file_lock.h"
#include "support/small_scene.h"

namespace fluidymation::test {
namespace {

class Lock : public ::testing::Test {
 protected:
  Lock() { std::filesystem::create_directories(scene_.file("out/.fluidymation")); }

  [[nodiscard]] std::string lockFile() const { return scene_.file("out/.fluidymation/lock"); }

  SmallScene scene_;
};

TEST_F(Lock, ASecondRunIsRefusedNamingTheFirst) {
  std::optional<FileLock> other(std::in_place, lockFile(), "painting");
  EXPECT_TRUE(failedNaming(
      1, "out/.fluidymation/lock: process " + std::to_string(getpid()) + " on host ",
      {" is painting out/%05d.png; wanted one run at a time"}, scene_.paint(quietly({}))));
  EXPECT_EQ(scene_.names("out"), kNothing);
  EXPECT_EQ(scene_.paint(quietly({{"--out-path", "out/rim_%d.png"}})).exitCode, 0)
      << "another pattern";
  other.reset();
  EXPECT_EQ(scene_.paint(quietly({})).exitCode, 0);
}

TEST_F(Lock, WhatAKilledRunLeftIsTakenOverAndSaid) {
  const std::string letters = "abcdabcdabcdabcd";
  scene_.write("out/.fluidymation/lock", bytesOf("process 4711 on host render7\n"));
  for (const char* half : {"out/.00002.png.tmp.", "out/.fluidymation.json.tmp.",
                           "out/.fluidymation/.state-2.bin.tmp.", "out/.write-test.tmp."}) {
    scene_.write(half + letters, bytesOf("half"));
  }
  scene_.write("out/.other.png.tmp." + letters, bytesOf("of somebody else"));
  const ProcessResult result = scene_.paint({{"--src-frames", "4"}, {"--target-frames", "4"}});
  EXPECT_EQ(result.exitCode, 0);
  EXPECT_NE(result.err.find("fluidymation: note: out/.fluidymation/lock: taken over from process "
                            "4711 on host render7, which is gone\npainting 4 frames "),
            std::string::npos)
      << result.err;
  scene_.remove("out/.other.png.tmp." + letters);
  EXPECT_EQ(scene_.names("out"), kFourFrames);
  EXPECT_EQ(scene_.names("out/.fluidymation"), std::vector<std::string>{"times.json"});
}

}  // namespace
}  // namespace fluidymation::test
