#include "pipeline/frame_line.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <functional>
#include <future>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "support/temporary_folder.h"

namespace fluidymation {
namespace {

using test::messageOf;
using Events = std::vector<std::string>;

constexpr ThreadShares kOneAfterTheOther{1, 0, 0};
constexpr ThreadShares kSideBySide{1, 1, 1};

std::string named(const char* what, int frame) { return what + std::to_string(frame); }

/// Stages that do nothing but count, and note what the caller is told. What a frame's stages do can
/// be replaced, to have them wait or fail.
class Line {
 public:
  explicit Line(const ThreadShares& threads) : threads_(threads) {}

  std::function<void(int)> onGuide = [](int) {};
  std::function<void(int)> onPaint = [](int) {};
  std::function<void(int)> onWrite = [](int) {};
  std::function<void(int)> onBegin = [](int) {};

  void run(int frameCount) {
    FrameStages stages;
    stages.guide = [this](int frame) {
      EXPECT_EQ(frame, guided++);
      onGuide(frame);
      GuidePart guides;
      guides.guides.diffusion.cycles = frame;  // goes along with the frame
      return guides;
    };
    stages.paint = [this](int frame, GuidePart guides) {
      EXPECT_EQ(std::this_thread::get_id(), caller_);
      EXPECT_EQ(guides.guides.diffusion.cycles, frame);
      onPaint(frame);
      std::vector<PaintedFrame> painted(1);
      painted.front().guides = std::move(guides.guides);
      return painted;
    };
    stages.write = [this](int frame, const PaintedFrame& painted) {
      EXPECT_EQ(painted.guides.diffusion.cycles, frame);
      onWrite(frame);
      EXPECT_EQ(frame, written++);
    };
    double toldSeconds = 0.0;
    FrameEvents events;
    events.begins = [this](int frame) {
      tell("begins ", frame);
      onBegin(frame);
    };
    events.painted = [this](int frame) { tell("painted ", frame); };
    events.written = [this, &toldSeconds](int frame, double seconds) {
      EXPECT_GT(written.load(), frame) << "told of before it was written";
      toldSeconds += seconds;
      tell("written ", frame);
    };
    const auto start = std::chrono::steady_clock::now();
    runFrames({0, frameCount}, stages, threads_, events);
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
    EXPECT_LE(toldSeconds, spent.count());
    EXPECT_EQ(toldSeconds > 0.0, frameCount > 0);
  }

  /// What the caller was told, without "begins".
  [[nodiscard]] Events finished() const {
    Events all;
    for (const std::string& event : told) {
      if (event.find("begins") != 0) all.push_back(event);
    }
    return all;
  }

  std::atomic<int> guided{0};
  std::atomic<int> written{0};
  Events told;

 private:
  void tell(const char* what, int frame) {
    EXPECT_EQ(std::this_thread::get_id(), caller_);
    told.push_back(named(what, frame));
  }

  ThreadShares threads_;
  std::thread::id caller_ = std::this_thread::get_id();
};

/// Whether `promise` is kept soon: a test must fail rather than hang.
bool isKept(std::future<void>& promise) {
  return promise.wait_for(std::chrono::seconds(60)) == std::future_status::ready;
}

class FrameLine : public ::testing::TestWithParam<ThreadShares> {};

TEST_P(FrameLine, TakesEveryFrameThroughAllStagesAndTellsInOrder) {
  Line line(GetParam());
  line.run(4);
  EXPECT_EQ(line.finished(), (Events{"painted 0", "written 0", "painted 1", "written 1",
                                     "painted 2", "written 2", "painted 3", "written 3"}));
  EXPECT_EQ(line.guided, 4);
  EXPECT_EQ(line.written, 4);
}

TEST_P(FrameLine, ASingleFrameAndNoneAreFine) {
  Line one(GetParam());
  one.run(1);
  EXPECT_EQ(one.told, (Events{"begins 0", "painted 0", "written 0"}));
  Line none(GetParam());
  none.run(0);
  EXPECT_EQ(none.told, Events{});
}

TEST_P(FrameLine, AFaultOfTheWriterComesOutAndNothingIsWrittenAfterIt) {
  Line line(GetParam());
  line.onWrite = [](int frame) {
    if (frame == 1) throw std::runtime_error("disk full");
  };
  EXPECT_EQ(messageOf<std::runtime_error>([&] { line.run(5); }), "disk full");
  EXPECT_EQ(line.written, 1);
  EXPECT_EQ(line.finished(), (Events{"painted 0", "written 0", "painted 1"}));
}

TEST_P(FrameLine, AFaultOfTheGuidesComesAfterTheFramesBeforeIt) {
  Line line(GetParam());
  line.onGuide = [](int frame) {
    if (frame == 2) throw std::runtime_error("no memory");
  };
  EXPECT_EQ(messageOf<std::runtime_error>([&] { line.run(5); }), "no memory");
  EXPECT_EQ(line.finished(), (Events{"painted 0", "written 0", "painted 1", "written 1"}));
}

TEST_P(FrameLine, AFaultOfThePaintingComesAfterTheFramesBeforeIt) {
  Line line(GetParam());
  line.onPaint = [](int frame) {
    if (frame == 2) throw std::runtime_error("no memory");
  };
  EXPECT_EQ(messageOf<std::runtime_error>([&] { line.run(5); }), "no memory");
  EXPECT_EQ(line.finished(), (Events{"painted 0", "written 0", "painted 1", "written 1"}));
}

TEST_P(FrameLine, OfTwoFaultsTheOneOfTheEarlierFrameComesOut) {
  Line line(GetParam());
  line.onWrite = [](int frame) {
    if (frame == 1) throw std::runtime_error("disk full");
  };
  line.onPaint = [](int frame) {
    if (frame == 2) throw std::runtime_error("no memory");
  };
  EXPECT_EQ(messageOf<std::runtime_error>([&] { line.run(5); }), "disk full");
  EXPECT_EQ(line.written, 1);
}

TEST_P(FrameLine, WhoStopsBetweenFramesFindsAllBeforeItWritten) {
  for (int last = 0; last < 4; ++last) {
    Line line(GetParam());
    line.onBegin = [last](int frame) {
      if (frame == last) throw std::runtime_error("stop");
    };
    EXPECT_EQ(messageOf<std::runtime_error>([&] { line.run(4); }), "stop");
    EXPECT_EQ(line.written, last);
    EXPECT_EQ(line.finished().size(), static_cast<std::size_t>(2 * last));
  }
}

INSTANTIATE_TEST_SUITE_P(Threads, FrameLine, ::testing::Values(kOneAfterTheOther, kSideBySide),
                         [](const auto& tested) {
                           return tested.param.beside() > 0 ? "sideBySide" : "oneAfterTheOther";
                         });

TEST(FrameLineAlone, DoesNothingBeforeItIsWanted) {
  Line line(kOneAfterTheOther);
  std::vector<std::string> order;
  const auto note = [&order](const char* what) {
    return [&order, what](int frame) { order.push_back(named(what, frame)); };
  };
  line.onGuide = note("guide ");
  line.onPaint = note("paint ");
  line.onWrite = note("write ");
  line.run(2);
  EXPECT_EQ(order, (std::vector<std::string>{"guide 0", "paint 0", "write 0", "guide 1", "paint 1",
                                             "write 1"}));
}

TEST(FrameLineSideBySide, GuidesAndWritingGoOnWhileAFrameIsPainted) {
  Line line(kSideBySide);
  std::promise<void> written;
  std::promise<void> guided;
  std::future<void> writing = written.get_future();
  std::future<void> guiding = guided.get_future();
  line.onWrite = [&](int frame) {
    if (frame == 0) written.set_value();
  };
  line.onGuide = [&](int frame) {
    if (frame == 2) guided.set_value();
  };
  line.onPaint = [&](int frame) {
    if (frame != 1) return;
    EXPECT_TRUE(isKept(writing)) << "frame 0 is to be written";
    EXPECT_TRUE(isKept(guiding)) << "the guides of frame 2 are to be made";
  };
  line.run(3);
}

TEST(FrameLineSideBySide, TheGuidesAreNoMoreThanOneFrameAhead) {
  Line line(kSideBySide);
  line.onPaint = [&](int frame) { EXPECT_LE(line.guided, frame + 2); };
  line.onWrite = [&](int frame) { EXPECT_LE(line.guided, frame + 3); };
  line.run(50);
}

TEST(FrameLineSideBySide, AFaultOfTheWriterComesOutWhenTheSearchBesideItIsDone) {
  Line line(kSideBySide);
  std::promise<void> searching;
  std::future<void> search = searching.get_future();
  std::atomic<bool> searched{false};
  line.onPaint = [&](int frame) {
    if (frame != 1) return;
    searching.set_value();
    searched = true;
  };
  line.onWrite = [&](int) {
    EXPECT_TRUE(isKept(search)) << "frame 1 is painted meanwhile";
    throw std::runtime_error("disk full");
  };
  EXPECT_EQ(messageOf<std::runtime_error>([&] { line.run(4); }), "disk full");
  EXPECT_TRUE(searched);
  EXPECT_EQ(line.written, 0);
  EXPECT_EQ(line.finished(), Events{"painted 0"});
}

TEST(FrameLineSideBySide, WhoStopsWhileAFrameIsBeingWrittenWaitsForIt) {
  Line line(kSideBySide);
  std::promise<void> stopping;
  std::future<void> stop = stopping.get_future();
  line.onWrite = [&](int frame) {
    if (frame != 1) return;
    EXPECT_TRUE(isKept(stop));
  };
  line.onBegin = [&](int frame) {
    if (frame != 2) return;
    stopping.set_value();
    throw std::runtime_error("stop");
  };
  EXPECT_EQ(messageOf<std::runtime_error>([&] { line.run(4); }), "stop");
  EXPECT_EQ(line.written, 2);
  EXPECT_EQ(line.finished().back(), "written 1");
}

TEST(ShareThreads, OneThreadHasNothingBesideIt) {
  EXPECT_EQ(shareThreads(1).paint, 1);
  EXPECT_EQ(shareThreads(1).beside(), 0);
  for (const int threads : {2, 3, 16, 1024}) {
    EXPECT_EQ(shareThreads(threads).paint, threads);
    EXPECT_GE(shareThreads(threads).guide, 1);
    EXPECT_LE(shareThreads(threads).guide, std::max(1, threads / 4));
    EXPECT_EQ(shareThreads(threads).write, 1);
  }
}

}  // namespace
}  // namespace fluidymation
