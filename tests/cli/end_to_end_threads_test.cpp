// That neither threads nor the environment change what the real program paints.

#include <gtest/gtest.h>

#include <map>
#include <string>

#include "support/environment.h"
#include "support/process.h"
#include "support/sanitizers.h"
#include "support/small_scene.h"

namespace fluidymation::test {
namespace {

using Painting = SmallScene::Painting;

TEST(EndToEndFrames, ThreadsChangeNoByte) {
  // The finest level that is searched is 85x80: more than one tile of 64x64, and more rows than are
  // handed out at a time.
  const SmallScene scene(2, {44, 40}, {170, 160});
  const Painting one = scene.painting({{"--threads", "1"}});
  for (const char* threads : {"2", "5"}) {
    EXPECT_TRUE(scene.painting({{"--threads", threads}}) == one) << threads;
  }
  EXPECT_TRUE(scene.painting({{"--threads", "1"}}) == one) << "another run";
  EXPECT_TRUE(scene.painting({{"--threads", "2"}, {"--seed", "1"}}) != one);
}

TEST(EndToEndFrames, ThreadsChangeNothingThatIsDumped) {
  const SmallScene scene(4);
  const auto dumped = [&](const std::string& threads) {
    EXPECT_EQ(scene
                  .paint({{"--threads", threads},
                          {"--dump-guides", "dump" + threads},
                          {"--out-path", "out" + threads + "/%05d.png"},
                          {"--quiet", ""}})
                  .exitCode,
              0);
    return filesOf(scene.file("dump" + threads + "/target"));
  };
  const Painting one = dumped("1");
  EXPECT_FALSE(one.empty());
  for (const char* threads : {"2", "5"}) EXPECT_TRUE(dumped(threads) == one) << threads;
}

TEST(EndToEndFrames, ThreadsThatCannotBeStartedAreRefusedBeforeAnythingElse) {
  // A sanitizer reserves far more address space than the limit set below, so that the program could
  // not even start: only a build without one can tell.
  if (kSanitized) GTEST_SKIP() << "sanitizers need terabytes of address space";
  const SmallScene scene(1);
  ProcessSetup setup;
  setup.addressSpaceBytes = 1'000'000'000;  // a thread's stack takes 2 or 8 MB of it
  EXPECT_TRUE(failedNaming(1, "--threads 1024: only ", {" can be started (", "wanted fewer"},
                           scene.paint({{"--quiet", ""}, {"--threads", "1024"}}, setup)));
  EXPECT_TRUE(scene.names("out").empty());
  EXPECT_EQ(scene.paint({{"--quiet", ""}, {"--threads", "2"}}, setup).exitCode, 0);
}

TEST(EndToEndFrames, TheEnvironmentChangesNoByte) {
  const SmallScene scene(2);
  const Painting expected = scene.painting();
  for (const auto& [name, value] : std::map<std::string, std::string>{{"OMP_NUM_THREADS", "3"},
                                                                      {"OMP_DYNAMIC", "true"},
                                                                      {"OMP_SCHEDULE", "static,1"},
                                                                      {"OMP_THREAD_LIMIT", "2"},
                                                                      {"SLURM_CPUS_PER_TASK", "3"},
                                                                      {"LC_ALL", "de_DE.UTF-8"}}) {
    scene.remove("out");
    ProcessSetup setup;
    setup.environment[name] = value;
    ToolOptions options = SmallScene::defaults();
    options.erase("--threads");
    const ProcessResult result = scene.paintWithoutDefaults(options, setup);
    EXPECT_EQ(result.exitCode, 0) << name;
    EXPECT_TRUE(filesOf(scene.file("out")) == expected) << name << "=" << value;
  }
}

#ifndef __clang__  // whose OpenMP has other words
/// What OpenMP prints of its settings before the program begins, the last time it does.
std::string settingsOfOpenMp(const ProcessSetup& setup) {
  const ProcessResult result = runProcess(FLUIDYMATION_PROGRAM, {"--version"}, setup);
  EXPECT_EQ(result.exitCode, 0) << result.err;
  const std::size_t last = result.err.rfind("OPENMP DISPLAY ENVIRONMENT BEGIN");
  return last == std::string::npos ? "" : result.err.substr(last);
}

TEST(EndToEndThreads, WaitingThreadsDoNotSpinUnlessTheUserWantsIt) {
  const EnvironmentVariable policy("OMP_WAIT_POLICY", nullptr);
  const EnvironmentVariable spins("GOMP_SPINCOUNT", nullptr);
  ProcessSetup setup;
  setup.environment["OMP_DISPLAY_ENV"] = "verbose";
  EXPECT_NE(settingsOfOpenMp(setup).find("GOMP_SPINCOUNT = '1000'"), std::string::npos);

  setup.environment["OMP_WAIT_POLICY"] = "active";
  const std::string wanted = settingsOfOpenMp(setup);
  EXPECT_NE(wanted.find("OMP_WAIT_POLICY = 'ACTIVE'"), std::string::npos);
  EXPECT_EQ(wanted.find("GOMP_SPINCOUNT = '1000'"), std::string::npos);
}
#endif

}  // namespace
}  // namespace fluidymation::test
