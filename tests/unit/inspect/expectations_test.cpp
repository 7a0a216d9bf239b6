#include "inspect/expectations.h"

#include <gtest/gtest.h>

#include <functional>
#include <string>

namespace fluidymation {
namespace {

constexpr int kFrames = 20;

/// A sequence about which there is nothing to say: frames 101 to 120.
SequenceFigures calm(double speed) {
  SequenceFigures sequence;
  for (int i = 0; i < kFrames; ++i) {
    ShapeFigures frame;
    frame.number = 101 + i;
    frame.storedAreaPx = 1000.0;
    frame.framePx = 10000;
    frame.insidePx = 1000;
    frame.sharedPx = 950;
    frame.interiorPx = 500;
    frame.borderPx = 100;
    frame.depthPx = 15.0F;
    frame.borderSpeedPx = speed;
    sequence.frames.push_back(frame);
  }
  return sequence;
}

KnownRun goodRun() {
  KnownRun run;
  run.exemplar = calm(2.0);
  run.target = calm(4.0);
  run.borderWidthPx = 10.0F;
  run.rimWidthPx = 9.0F;
  run.blurSigmaPx = 2.0F;
  run.targetBlurSigmaPx = 3.0F;
  return run;
}

/// The only line that is told of a good run after `change`.
std::string lineAfter(const std::function<void(KnownRun&)>& change) {
  KnownRun run = goodRun();
  change(run);
  const std::vector<std::string> lines = expectations(run);
  std::string all;
  for (const std::string& line : lines) all += line + "\n";
  EXPECT_EQ(lines.size(), 1U) << all;
  return all;
}

void change(SequenceFigures& sequence, int first, int last,
            const std::function<void(ShapeFigures&)>& body) {
  for (ShapeFigures& frame : sequence.frames) {
    if (frame.number >= first && frame.number <= last) body(frame);
  }
}

void expectParts(const std::string& line, const std::vector<std::string>& parts) {
  for (const std::string& part : parts) {
    EXPECT_NE(line.find(part), std::string::npos) << part << "\n" << line;
  }
}

TEST(Expectations, AGoodRunIsNotTalkedAbout) { EXPECT_TRUE(expectations(goodRun()).empty()); }

TEST(Expectations, TellEmptyAndFullFrames) {
  expectParts(lineAfter([](KnownRun& run) {
                change(run.exemplar, 101, 102, [](ShapeFigures& f) {
                  f = {f.number, 0.0, f.framePx, 0, 0, 0, 0, 0, 0, 0.0F, 0.0};
                });
              }),
              {"exemplar: ", "empty in frames 101-102 (2 of 20)"});
  expectParts(lineAfter([](KnownRun& run) {
                change(run.target, 105, 105, [](ShapeFigures& f) { f.framePx = f.insidePx; });
              }),
              {"animation: ", "covers the whole picture in frame 105 (1 of 20)"});
}

TEST(Expectations, TellWhatSmoothingTakesAway) {
  expectParts(lineAfter([](KnownRun& run) {
                change(run.target, 103, 104, [](ShapeFigures& f) { f.storedAreaPx = 1250.0; });
              }),
              {"animation: smoothing by 3 px takes away up to 20 % of the shape in frames 103-104",
               "--target-blur-sigma 1.5"});
  EXPECT_TRUE([] {
    KnownRun run = goodRun();
    change(run.target, 101, 120, [](ShapeFigures& f) { f.storedAreaPx = 1090.0; });
    return expectations(run);
  }()
                  .empty());
}

TEST(Expectations, TellThinParts) {
  expectParts(lineAfter([](KnownRun& run) {
                change(run.target, 110, 119, [](ShapeFigures& f) { f.thinPx = 300; });
                change(run.target, 119, 119, [](ShapeFigures& f) { f.thinPx = 600; });
              }),
              {"animation: 30 % to 60 % of the shape are parts thinner than a patch of 5 px in "
               "frames 110-119 (10 of 20)",
               "--target-scale 2"});
}

TEST(Expectations, TellWhereThereIsNoInterior) {
  const auto shallow = [](ShapeFigures& f) {
    f.interiorPx = 0;
    f.depthPx = 6.0F;
  };
  expectParts(lineAfter([&](KnownRun& run) { change(run.exemplar, 101, 120, shallow); }),
              {"exemplar: no pixel is further from the edge than the border width of 10 px (6.0 px "
               "on average)",
               "--border-width 3"});
  expectParts(lineAfter([&](KnownRun& run) { change(run.target, 101, 110, shallow); }),
              {"animation: ", "frames 101-110 (10 of 20): all is painted as border"});
  KnownRun run = goodRun();
  change(run.target, 101, 101, shallow);  // one frame of twenty
  EXPECT_TRUE(expectations(run).empty());
}

TEST(Expectations, TellABorderThatIsNotTheMediums) {
  expectParts(
      lineAfter([](KnownRun& run) { run.rimWidthPx = 2.0F; }),
      {"exemplar: ", "within 2 px of the edge, the border is 10 px wide", "--border-width 2"});
  for (const float rim : {3.0F, 24.0F}) {
    KnownRun run = goodRun();
    run.rimWidthPx = rim;
    EXPECT_TRUE(expectations(run).empty());
  }
}

TEST(Expectations, TellAnimationsThatAreTooFast) {
  expectParts(lineAfter([](KnownRun& run) {
                change(run.target, 102, 111, [](ShapeFigures& f) { f.borderSpeedPx = 12.0; });
                change(run.target, 111, 111, [](ShapeFigures& f) { f.borderSpeedPx = 20.0; });
              }),
              {"animation: its edges move by 12.0 to 20.0 px a frame in frames 102-111 (10 of 20), "
               "those of the exemplar by 2.0",
               "--src-speed 2", "--preset calm"});
  expectParts(lineAfter([](KnownRun& run) { run.exemplar = calm(0.0); }),
              {"exemplar: its masks stand still"});
}

TEST(Expectations, TellJumps) {
  expectParts(lineAfter([](KnownRun& run) {
                change(run.target, 107, 107, [](ShapeFigures& f) { f.sharedPx = 100; });
              }),
              {"animation: the mask jumps from the frame before in frame 107 (1 of 20): as little "
               "as 10 % of it was covered"});
  expectParts(lineAfter([](KnownRun& run) {
                change(run.target, 107, 120, [](ShapeFigures& f) {
                  f.insidePx = 2000;
                  f.storedAreaPx = 2000.0;
                  f.sharedPx = f.number == 107 ? 1000 : 1950;
                });
              }),
              {"in frame 107 (1 of 20)"});
}

TEST(Expectations, TellTooLittleBareSurface) {
  expectParts(lineAfter([](KnownRun& run) {
                change(run.exemplar, 115, 120, [](ShapeFigures& f) { f.framePx = 1050; });
              }),
              {"exemplar: only 4.8 % of the picture is bare surface in frames 115-120 (6 of 20)"});
}

TEST(Expectations, LongListsOfFramesAreCut) {
  std::vector<int> all(100);
  std::vector<int> odd;
  for (int i = 0; i < 100; ++i) {
    all[static_cast<std::size_t>(i)] = i - 3;
    if (i % 2 != 0) odd.push_back(i);
  }
  EXPECT_EQ(framesText(all, {0, 1, 2, 5}), "-3--1, 2");
  EXPECT_EQ(framesText(all, odd), "-2, 0, 2, 4, 6, 8, 10, 12, 14, 16, 18, 20, ...");
  EXPECT_EQ(framesText(all, {}), "");
}

}  // namespace
}  // namespace fluidymation
