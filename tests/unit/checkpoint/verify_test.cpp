#include "fluidymation/verify.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "checkpoint/manifest.h"
#include "fluidymation/core/error.h"
#include "support/temporary_folder.h"

namespace fluidymation {
namespace {

using test::bytesOf;
using test::TemporaryFolder;
using Lines = std::vector<std::string>;

/// Three frames and their manifest.
class VerifyTest : public ::testing::Test {
 protected:
  VerifyTest() {
    manifest_.fingerprint.version = "0.1.0";
    manifest_.paths = {{"--out-path", "elsewhere/f%d.png"}};
    manifest_.complete = true;
    for (int number = 1; number <= 3; ++number) {
      const std::string content = "frame " + std::to_string(number);
      test::writeBytes(frame(number), bytesOf(content));
      manifest_.frames.push_back({number, "f" + std::to_string(number) + ".png",
                                  digestOf(content.data(), content.size())});
    }
  }

  [[nodiscard]] std::string frame(int number) const {
    return folder_.file("f" + std::to_string(number) + ".png");
  }
  [[nodiscard]] Lines faults() const {
    test::writeBytes(folder_.file("m.json"), encode(manifest_));
    return verify(folder_.file("m.json")).faults;
  }

  TemporaryFolder folder_;
  Manifest manifest_;
};

TEST_F(VerifyTest, WhatIsAsItWasPaintedHasNoFault) {
  EXPECT_EQ(faults(), Lines{});
  EXPECT_EQ(verify(folder_.file("m.json")).frames, 3);
}

TEST_F(VerifyTest, EachKindOfDamageIsNamed) {
  std::filesystem::remove(frame(1));
  test::writeBytes(frame(2), bytesOf("frame x"));
  test::writeBytes(frame(7), bytesOf("frame 7"));
  test::writeBytes(folder_.file("note.txt"), bytesOf("not a frame"));
  manifest_.complete = false;
  EXPECT_EQ(faults(), (Lines{frame(1) + ": missing", frame(2) + ": changed",
                             frame(7) + ": extra, not in the manifest",
                             folder_.file("m.json") + ": not all frames of the shot are painted"}));
}

TEST_F(VerifyTest, FramesThatAreStillToBePaintedAreNamed) {
  InputDigests target{"--target-path", {}};
  for (const int number : {-2, -1, 1, 2, 3, 5, 8, 9, 10}) target.files.push_back({number, {}});
  manifest_.fingerprint.inputs = {target};
  const std::string partial = folder_.file("m.json") + ": not all frames of the shot are painted";
  for (const bool claimed : {false, true}) {
    manifest_.complete = claimed;
    EXPECT_EQ(faults(), Lines{partial + "; it lacks -2 to -1, 5-10"});
  }
  manifest_.fingerprint.inputs[0].files.clear();
  for (int number = 1; number <= 3; ++number) {
    manifest_.fingerprint.inputs[0].files.push_back({number, {}});
  }
  EXPECT_EQ(faults(), Lines{});
  for (int number = 5; number < 205; number += 2) {
    manifest_.fingerprint.inputs[0].files.push_back({number, {}});
    manifest_.fingerprint.inputs[0].files.push_back({number + 1, {}});
    manifest_.frames.push_back({number, "f" + std::to_string(number) + ".png", {}});
    test::writeBytes(frame(number), {1});
  }
  const Lines many = faults();
  ASSERT_FALSE(many.empty());
  EXPECT_NE(many.back().find("; it lacks 6, 8, 10"), std::string::npos) << many.back();
  EXPECT_NE(many.back().find(" more"), std::string::npos) << many.back();
  EXPECT_LT(many.back().size(), partial.size() + 200);
}

TEST_F(VerifyTest, AFolderInAFramesPlaceIsAFault) {
  std::filesystem::remove(frame(3));
  std::filesystem::create_directory(frame(3));
  EXPECT_EQ(faults(), Lines{frame(3) + ": is no regular file"});
}

TEST_F(VerifyTest, IsStoppedBeforeAFrame) {
  test::writeBytes(folder_.file("m.json"), encode(manifest_));
  int left = 1;
  const auto stop = [&left] {
    if (left-- == 0) throw Interrupted("enough");
  };
  EXPECT_THROW((void)verify(folder_.file("m.json"), stop), Interrupted);
}

TEST_F(VerifyTest, AMissingManifestIsAnError) {
  EXPECT_THROW((void)verify(folder_.file("none.json")), Error);
}

}  // namespace
}  // namespace fluidymation
