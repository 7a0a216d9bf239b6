// With programs of the test's own in the place of ffmpeg.

#include "preview/video.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <functional>
#include <string>

#include "fluidymation/core/error.h"
#include "support/environment.h"
#include "support/temporary_folder.h"

namespace fluidymation {
namespace {

class Video : public ::testing::Test {
 protected:
  /// A program ffmpeg, found first in the PATH, that is this shell script.
  void install(const std::string& script) {
    const std::string text = "#!/bin/sh\n" + script + "\n";
    test::writeBytes(folder_.file("ffmpeg"), {text.begin(), text.end()});
    chmod(folder_.file("ffmpeg").c_str(), 0755);
  }

  [[nodiscard]] std::string file(const std::string& name) const { return folder_.file(name); }

  void write(
      int frames, const std::function<void()>& stopIfWanted = [] {}) const {
    writeVideo(
        file("film $(touch x).mp4"), VideoFormat::kMp4, frames, 12,
        [](int frame) {
          return Image<Rgba8>({4, 2}, Rgba8{static_cast<std::uint8_t>(frame), 1, 2, 255});
        },
        stopIfWanted);
  }

  [[nodiscard]] std::string text(const std::string& name) const {
    const test::Bytes bytes = test::readBytes(file(name));
    return {bytes.begin(), bytes.end()};
  }

  test::TemporaryFolder folder_;
  const std::string folders_ = folder_.path() + ":/usr/bin:/bin";
  const test::EnvironmentVariable environment_{"PATH", folders_.c_str()};
};

TEST_F(Video, PicturesReachTheProgramAsTheyAreAndItsFileTakesTheName) {
  install("for last; do :; done; cat > \"${last#file:}\"; echo \"$@\" > " + file("words"));
  EXPECT_TRUE(hasFfmpeg());
  write(3);
  const std::string film = text("film $(touch x).mp4");
  ASSERT_EQ(film.size(), 3U * 4U * 2U * 3U);
  EXPECT_EQ(film.substr(24, 3), std::string("\1\1\2"));
  EXPECT_NE(text("words").find("-pix_fmt rgb24 -s 4x2 -r 12 -i pipe:0 "), std::string::npos);
}

TEST_F(Video, AProgramThatFailsIsQuotedAndTheOldFileStays) {
  test::writeBytes(file("film $(touch x).mp4"), {1, 2, 3});
  install("cat > /dev/null; echo first >&2; echo no such codec >&2; exit 3");
  EXPECT_EQ(test::messageOf<Error>([&] { write(2); }),
            file("film $(touch x).mp4") + ": ffmpeg failed (no such codec)");
  EXPECT_EQ(test::readBytes(file("film $(touch x).mp4")), (test::Bytes{1, 2, 3}));
}

TEST_F(Video, AProgramThatReadsNoFurtherIsNoSignal) {
  std::signal(SIGPIPE, SIG_IGN);  // as in the tool
  install("echo full >&2; exit 1");
  EXPECT_EQ(test::messageOf<Error>([&] { write(20000); }),
            file("film $(touch x).mp4") + ": ffmpeg failed (full)");
}

TEST_F(Video, AProgramThatEndsEarlyHasFailedWhateverItSays) {
  std::signal(SIGPIPE, SIG_IGN);
  test::writeBytes(file("film $(touch x).mp4"), {1, 2, 3});
  install("exit 0");
  EXPECT_EQ(test::messageOf<Error>([&] { write(20000); }),
            file("film $(touch x).mp4") + ": ffmpeg ended before it had read all pictures");
  EXPECT_EQ(test::readBytes(file("film $(touch x).mp4")), (test::Bytes{1, 2, 3}));
}

TEST_F(Video, AProgramThatHangsIsEndedWhenThatIsWanted) {
  // Reading nothing, and reading all
  for (const char* script : {"sleep 600", "cat > /dev/null; sleep 600"}) {
    SCOPED_TRACE(script);
    install("echo $$ > " + file("process") + "; " + script);
    std::remove(file("process").c_str());
    const auto stopsOnceItRuns = [this, begin = std::chrono::steady_clock::now()] {
      const bool runs = access(file("process").c_str(), F_OK) == 0 && text("process").size() > 1;
      const auto waited = std::chrono::steady_clock::now() - begin;
      if (runs && waited > std::chrono::milliseconds(200)) throw Interrupted("enough");
    };
    EXPECT_THROW(write(20000, stopsOnceItRuns), Interrupted);
    EXPECT_NE(kill(std::stoi(text("process")), 0), 0) << "it goes on";
  }
}

TEST_F(Video, IsNotThereWhereThePathHasNone) {
  const test::EnvironmentVariable none("PATH", folder_.path().c_str());
  EXPECT_FALSE(hasFfmpeg());
}

TEST_F(Video, AFailingFrameEndsTheProgram) {
  install("cat > /dev/null; sleep 600");
  EXPECT_THROW(writeVideo(file("a.gif"), VideoFormat::kGif, 2, 12,
                          [](int frame) -> Image<Rgba8> {
                            if (frame == 1) throw Error("frame 2 is damaged");
                            return Image<Rgba8>({4, 2});
                          }),
               Error);
}

}  // namespace
}  // namespace fluidymation
