// The manifest that the real program leaves beside its frames, and what --verify tells by it.

#include <gtest/gtest.h>

#include <string>

#include "resumed_scene.h"

namespace fluidymation::test {
namespace {

class RunManifest : public ResumedScene {};

TEST_F(RunManifest, TheManifestIsTheSameWhateverTheThreads) {
  EXPECT_EQ(scene_.paint(quietly(everyFrame({{"--threads", "3"}}))).exitCode, 0);
  EXPECT_EQ(scene_.read(kManifest), manifest_);
}

TEST_F(RunManifest, VerifyTellsOfEachFrameThatIsNotAsItWasPainted) {
  const auto check = [&] { return scene_.paintWithoutDefaults({{"--verify", kManifest}}); };
  EXPECT_TRUE(failedWith(
      1, std::string(kManifest) + ": cannot be opened (No such file or directory)", check()));
  EXPECT_EQ(scene_.paint(quietly(everyFrame())).exitCode, 0);
  const ProcessResult good = check();
  EXPECT_EQ(good.exitCode, 0);
  EXPECT_EQ(good.out, std::string(kManifest) + ": 6 frames are as painted\n");
  scene_.remove(SmallScene::frame("out", 2));
  scene_.write(SmallScene::frame("out", 4), bytesOf("retouched"));
  scene_.write(SmallScene::frame("out", 9), bytesOf("extra"));
  const ProcessResult bad = check();
  EXPECT_EQ(bad.exitCode, 1);
  EXPECT_EQ(bad.out,
            "out/00002.png: missing\nout/00004.png: changed\n"
            "out/00009.png: extra, not in the manifest\n");
  EXPECT_TRUE(failedWith(2, "--verify, --seed: wanted --verify alone",
                         scene_.paintWithoutDefaults({{"--verify", kManifest}, {"--seed", "1"}})));
}

TEST_F(RunManifest, TheManifestOfAStoppedRunSaysThatItIsIncomplete) {
  leaveState();
  const ProcessResult result = scene_.paintWithoutDefaults({{"--verify", kManifest}});
  EXPECT_EQ(result.exitCode, 1);
  EXPECT_NE(result.out.find(std::string(kManifest) +
                            ": not all frames of the shot are painted; it lacks "),
            std::string::npos);
}

}  // namespace
}  // namespace fluidymation::test
