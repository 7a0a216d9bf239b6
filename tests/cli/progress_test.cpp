#include "cli/progress.h"

#include <gtest/gtest.h>

#include <chrono>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "cli/throttle.h"

namespace fluidymation::cli {
namespace {

FrameReport report(int index, double seconds) {
  return {index, 80, index + 101, seconds, "out/" + std::to_string(index + 101) + ".png"};
}

TEST(Progress, ATerminalGetsOneLineThatIsRewritten) {
  std::ostringstream out;
  Progress progress(out, Progress::Style::kTerminal);
  progress.readingBegins();
  progress.paintingBegins(0, 80);
  progress.frameDone(report(0, 1.0));
  progress.frameDone(report(1, 0.5));
  progress.finishLine();
  progress.finishLine();
  EXPECT_EQ(out.str(),
            "\rreading the masks and the exemplar ...\x1b[K"
            "\rframe 1 of 80 ...\x1b[K"
            "\rframe 1 of 80  1.00 s/frame  01:19 left\x1b[K"
            "\rframe 2 of 80  0.75 s/frame  00:59 left\x1b[K\n");
}

TEST(Progress, EveryLineOfARunAmongSeveralSaysWhichItIs) {
  for (const auto& [style, expected] :
       {std::pair{Progress::Style::kPlain,
                  "layer a (1 of 2): painting 80 frames ...\n"
                  "fluidymation: note: layer a (1 of 2): odd\n"
                  "layer a (1 of 2): frame 1 of 80  1.00 s  out/101.png\n"
                  "layer a (1 of 2): 1 frame in 00:01: out/101.png\n"},
        std::pair{Progress::Style::kTerminal,
                  "\rlayer a (1 of 2): frame 1 of 80 ...\x1b[K"
                  "\r\x1b[Kfluidymation: note: layer a (1 of 2): odd\n"
                  "\rlayer a (1 of 2): frame 1 of 80 ...\x1b[K"
                  "\rlayer a (1 of 2): frame 1 of 80  1.00 s/frame  01:19 left\x1b[K"
                  "\rlayer a (1 of 2): 1 frame in 00:01: out/101.png\x1b[K\n"}}) {
    std::ostringstream out;
    Progress progress(out, style, "layer a (1 of 2): ");
    progress.paintingBegins(0, 80);
    progress.note("odd");
    progress.frameDone(report(0, 1.0));
    progress.allDone();
    EXPECT_EQ(out.str(), expected);
  }
}

TEST(Progress, AFailureEndsTheLineAndIsToldByOthers) {
  std::ostringstream out;
  Progress progress(out, Progress::Style::kTerminal);
  progress.paintingBegins(0, 80);
  RunListener& listener = progress;
  listener.failed("the disk is full");
  listener.failed("the disk is full");
  EXPECT_EQ(out.str(), "\rframe 1 of 80 ...\x1b[K\n");
}

TEST(Progress, ReadingShowsOnATerminalOnly) {
  const auto shown = [](Progress::Style style) {
    std::ostringstream out;
    Progress progress(out, style);
    progress.readingBegins();
    progress.reading({ReadingStage::kTargetMasks, 12, 400});
    progress.finishLine();
    return out.str();
  };
  EXPECT_EQ(shown(Progress::Style::kTerminal),
            "\rreading the masks and the exemplar ...\x1b[K"
            "\rreading the masks of the animation: 12 of 400 ...\x1b[K\n");
  EXPECT_EQ(shown(Progress::Style::kPlain), "");
  EXPECT_EQ(shown(Progress::Style::kQuiet), "");
}

/// A clock that a test sets.
struct SetClock {
  using duration = std::chrono::milliseconds;
  using rep = duration::rep;
  using period = duration::period;
  using time_point = std::chrono::time_point<SetClock>;
  static time_point now() { return time_point(time); }
  static duration time;
};
SetClock::duration SetClock::time{0};

TEST(Progress, AThrottleLetsThroughOnceInAPause) {
  using std::chrono::milliseconds;
  SetClock::time = milliseconds{1000};
  Throttle<SetClock> throttle(milliseconds{200});
  std::vector<int> through;
  for (int ms = 0; ms <= 1000; ms += 50) {
    SetClock::time = milliseconds{1000 + ms};
    if (throttle.isDue()) through.push_back(ms);
  }
  EXPECT_EQ(through, (std::vector<int>{200, 400, 600, 800, 1000}));
  SetClock::time = milliseconds{2300};
  EXPECT_TRUE(throttle.isDue());
  EXPECT_FALSE(throttle.isDue());
}

TEST(Progress, AFileGetsOnePlainLinePerFrame) {
  std::ostringstream out;
  Progress progress(out, Progress::Style::kPlain);
  progress.readingBegins();
  progress.paintingBegins(0, 80);
  progress.frameDone(report(0, 1.0));
  progress.note("something\nodd");
  progress.frameDone(report(1, 0.256));
  progress.allDone();
  EXPECT_EQ(out.str(),
            "painting 80 frames ...\n"
            "frame 1 of 80  1.00 s  out/101.png\n"
            "fluidymation: note: something?odd\n"
            "frame 2 of 80  0.26 s  out/102.png\n"
            "2 frames in 00:01: out/101.png to out/102.png\n");
}

TEST(Progress, ATerminalIsToldInTheEndWhereTheFramesAre) {
  std::ostringstream one;
  Progress single(one, Progress::Style::kTerminal);
  single.frameDone({0, 1, 7, 61.0, "out/\n7.png"});
  single.allDone();
  EXPECT_EQ(one.str(),
            "\rframe 1 of 1  61.00 s/frame  00:00 left\x1b[K"
            "\r1 frame in 01:01: out/?7.png\x1b[K\n");

  std::ostringstream two;
  Progress progress(two, Progress::Style::kTerminal);
  progress.frameDone(report(0, 1.0));
  progress.frameDone(report(1, 2.0));
  two.str("");
  progress.allDone();
  EXPECT_EQ(two.str(), "\r2 frames in 00:03: out/101.png to out/102.png\x1b[K\n");
}

TEST(Progress, NotesStandAboveTheLineBeingRewritten) {
  std::ostringstream out;
  Progress progress(out, Progress::Style::kTerminal);
  progress.note("first");
  progress.frameDone(report(79, 1.0));
  progress.note("last");
  EXPECT_EQ(out.str(),
            "fluidymation: note: first\n"
            "\rframe 80 of 80  1.00 s/frame  00:00 left\x1b[K"
            "\r\x1b[Kfluidymation: note: last\n"
            "\rframe 80 of 80  1.00 s/frame  00:00 left\x1b[K");
}

TEST(Progress, CountsTheFramesOfThisRunWhereOthersWerePaintedBefore) {
  std::ostringstream out;
  Progress progress(out, Progress::Style::kTerminal);
  progress.paintingBegins(70, 80);
  progress.frameDone(report(70, 2.0));
  EXPECT_EQ(out.str(),
            "\rframe 71 of 80 ...\x1b[K"
            "\rframe 71 of 80  2.00 s/frame  00:18 left\x1b[K");
}

TEST(Progress, AFileIsToldWhichFramesAreStillToBePainted) {
  std::ostringstream out;
  Progress progress(out, Progress::Style::kPlain);
  progress.paintingBegins(70, 80);
  EXPECT_EQ(out.str(), "painting frames 71 to 80 of 80 ...\n");
}

TEST(Progress, TellsHowToSeeTheFrames) {
  std::ostringstream out;
  Progress progress(out, Progress::Style::kPlain);
  progress.tellOfPreview();
  EXPECT_EQ(out.str(), "");  // there is none to see
  progress.frameDone(report(0, 1.0));
  out.str("");
  progress.tellOfPreview();
  progress.previewWritten("p\n.png");
  EXPECT_EQ(out.str(),
            "to look at them: fluidymation preview, the same options, and --preview FILE.apng\n"
            "preview: p?.png\n");
}

TEST(Progress, QuietSaysNothing) {
  std::ostringstream out;
  Progress progress(out, Progress::Style::kQuiet);
  progress.readingBegins();
  progress.paintingBegins(0, 80);
  progress.note("something");
  progress.frameDone(report(0, 1.0));
  progress.allDone();
  progress.tellOfPreview();
  progress.previewWritten("p.png");
  EXPECT_EQ(out.str(), "");
}

TEST(Progress, ClockTextGrowsAnHourColumnWhenNeeded) {
  EXPECT_EQ(clockText(0.0), "00:00");
  EXPECT_EQ(clockText(28.4), "00:28");
  EXPECT_EQ(clockText(59.6), "01:00");
  EXPECT_EQ(clockText(3599.0), "59:59");
  EXPECT_EQ(clockText(3723.0), "1:02:03");
  EXPECT_EQ(clockText(360000.0), "100:00:00");
  EXPECT_EQ(clockText(-1.0), "00:00");
}

}  // namespace
}  // namespace fluidymation::cli
