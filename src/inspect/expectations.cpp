#include "inspect/expectations.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>

#include "fluidymation/core/index.h"
#include "fluidymation/option_ranges.h"
#include "inspect/numbers.h"

namespace fluidymation {
namespace {

using FrameTest = std::function<bool(const ShapeFigures& frame)>;

[[nodiscard]] double share(std::int64_t part, std::int64_t whole) {
  return whole > 0 ? static_cast<double>(part) / static_cast<double>(whole) : 0.0;
}

/// Frames of a sequence, by index.
class Frames {
 public:
  Frames(const SequenceFigures& sequence, const std::function<bool(std::size_t)>& test) {
    for (std::size_t i = 0; i < sequence.frames.size(); ++i) {
      all_.push_back(sequence.frames[i].number);
      if (test(i)) chosen_.push_back(static_cast<int>(i));
    }
  }
  Frames(const SequenceFigures& sequence, const FrameTest& test)
      : Frames(sequence, std::function<bool(std::size_t)>(
                             [&](std::size_t i) { return test(sequence.frames[i]); })) {}

  [[nodiscard]] bool none() const { return chosen_.empty(); }
  [[nodiscard]] bool few() const {
    return static_cast<double>(chosen_.size()) < kTellFewFrames * static_cast<double>(all_.size());
  }
  /// "frames 3-7, 9 (6 of 30)"
  [[nodiscard]] std::string text() const {
    return (chosen_.size() == 1 ? "frame " : "frames ") + framesText(all_, chosen_) + " (" +
           std::to_string(chosen_.size()) + " of " + std::to_string(all_.size()) + ")";
  }
  /// Of the chosen ones.
  template <typename Value>
  [[nodiscard]] Spread spread(const SequenceFigures& sequence, const Value& value) const {
    std::vector<double> values;
    for (const int i : chosen_) values.push_back(value(sequence.frames[at(i)]));
    return spreadOf(values);
  }

 private:
  std::vector<int> all_;
  std::vector<int> chosen_;
};

/// One decimal, as an option's value.
[[nodiscard]] std::string tenths(double value) {
  return numberText(std::round(10.0 * value) / 10.0);
}

void tellOfEmptyFrames(const std::string& name, const SequenceFigures& sequence,
                       std::vector<std::string>& lines) {
  const Frames empty(sequence, FrameTest([](const ShapeFigures& f) { return f.empty(); }));
  if (!empty.none()) {
    lines.push_back(name + ": the smoothed mask is empty in " + empty.text() +
                    "; nothing is there to paint or to paint with");
  }
  const Frames full(sequence, FrameTest([](const ShapeFigures& f) { return f.full(); }));
  if (!full.none()) {
    lines.push_back(name + ": the mask covers the whole picture in " + full.text() +
                    ", which then have neither edge nor motion; check that masks are bright, or "
                    "opaque, where the material is");
  }
}

void tellOfLoss(const std::string& name, const std::string& option, float sigmaPx,
                const SequenceFigures& sequence, std::vector<std::string>& lines) {
  const auto lost = [](const ShapeFigures& f) {
    return f.storedAreaPx > 0.0 ? 1.0 - static_cast<double>(f.insidePx) / f.storedAreaPx : 0.0;
  };
  const Frames frames(sequence,
                      FrameTest([&](const ShapeFigures& f) { return lost(f) > kTellLostShare; }));
  if (frames.none()) return;
  lines.push_back(name + ": smoothing by " + numberText(sigmaPx) + " px takes away up to " +
                  percentText(frames.spread(sequence, lost).largest) + " of the shape in " +
                  frames.text() + "; keep it with " + option + " " +
                  tenths(0.5 * static_cast<double>(sigmaPx)));
}

void tellOfThinParts(const KnownRun& run, std::vector<std::string>& lines) {
  const auto thin = [](const ShapeFigures& f) { return share(f.thinPx, f.insidePx); };
  const Frames frames(run.target,
                      FrameTest([&](const ShapeFigures& f) { return thin(f) > kTellThinShare; }));
  if (frames.none()) return;
  const Spread spread = frames.spread(run.target, thin);
  lines.push_back("animation: " + percentText(spread.least) + " to " + percentText(spread.largest) +
                  " of the shape are parts thinner than a patch of " + std::to_string(kPatchSize) +
                  " px in " + frames.text() +
                  ": little texture fits in; --target-scale 2 paints them larger");
}

void tellOfInteriors(const KnownRun& run, std::vector<std::string>& lines) {
  const auto hasNone =
      FrameTest([](const ShapeFigures& f) { return !f.empty() && !f.full() && f.interiorPx == 0; });
  const std::string width = numberText(run.borderWidthPx) + " px";
  for (const bool ofExemplar : {true, false}) {
    const SequenceFigures& sequence = ofExemplar ? run.exemplar : run.target;
    const Frames frames(sequence, hasNone);
    if (frames.none() || frames.few()) continue;
    const double depth =
        frames.spread(sequence, [](const ShapeFigures& f) { return double{f.depthPx}; }).mean;
    std::string line = ofExemplar ? "exemplar" : "animation";
    line += ": no pixel is further from the edge than the border width of " + width + " (" +
            fixedText(depth, 1) + " px on average) in " + frames.text() + ": ";
    line += ofExemplar ? "there is no interior to paint with" : "all is painted as border";
    lines.push_back(line + "; try --border-width " + tenths(std::max(1.0, 0.5 * depth)));
  }
}

void tellOfRim(const KnownRun& run, std::vector<std::string>& lines) {
  const double rim = std::max(1.0, double{run.rimWidthPx});
  const double width = run.borderWidthPx;
  if (width <= kTellWidthRatio * rim) return;
  lines.push_back("exemplar: most of the change of its colours lies within " + tenths(rim) +
                  " px of the edge, the border is " + numberText(run.borderWidthPx) +
                  " px wide; compare --border-width " + tenths(rim));
}

void tellOfSpeed(const KnownRun& run, std::vector<std::string>& lines) {
  const double exemplar = typicalBorderSpeed(run.exemplar);
  if (typicalBorderSpeed(run.target) <= 0.0) return;
  if (exemplar <= 0.0) {
    lines.emplace_back(
        "exemplar: its masks stand still, the animation moves; there is no motion to paint with: "
        "choose frames in which the medium spreads (--src-start, --src-frames)");
    return;
  }
  const Frames frames(run.target, FrameTest([&](const ShapeFigures& f) {
                        return f.borderSpeedPx > kTellSpeedRatio * exemplar;
                      }));
  if (frames.none() || frames.few()) return;
  const Spread speeds =
      frames.spread(run.target, [](const ShapeFigures& f) { return f.borderSpeedPx; });
  std::string line = "animation: its edges move by " + fixedText(speeds.least, 1) + " to " +
                     fixedText(speeds.largest, 1) + " px a frame in " + frames.text() +
                     ", those of the exemplar by " + fixedText(exemplar, 1) +
                     ": the picture will jump; slow the animation down";
  constexpr int kFewestFrames = 10;  // of an exemplar that is worth having
  const int exemplarFrames = static_cast<int>(run.exemplar.frames.size());
  const int wanted = static_cast<int>(std::ceil(speeds.mean / (kTellSpeedRatio * exemplar)));
  const int step = std::min(wanted, exemplarFrames / kFewestFrames);
  if (step > 1)
    line += ", or speed the exemplar up with --src-speed " + std::to_string(run.sourceSpeed * step);
  lines.push_back(line + ", or try --preset calm");
}

void tellOfJumps(const KnownRun& run, std::vector<std::string>& lines) {
  const std::vector<ShapeFigures>& all = run.target.frames;
  std::int64_t largest = 0;
  for (const ShapeFigures& frame : all) largest = std::max(largest, frame.insidePx);
  const auto jumps = [&](std::size_t i) {
    if (i == 0 || all[i].empty() || all[i - 1].empty()) return false;
    const std::int64_t smaller = std::min(all[i].insidePx, all[i - 1].insidePx);
    const std::int64_t step = std::abs(all[i].insidePx - all[i - 1].insidePx);
    return share(all[i].sharedPx, smaller) < kTellOverlapShare ||
           share(step, largest) > kTellAreaStep;
  };
  const Frames frames(run.target, std::function<bool(std::size_t)>(jumps));
  if (frames.none()) return;
  const double overlap =
      frames.spread(run.target, [](const ShapeFigures& f) { return share(f.sharedPx, f.insidePx); })
          .least;
  lines.push_back("animation: the mask jumps from the frame before in " + frames.text() +
                  ": as little as " + percentText(overlap) +
                  " of it was covered; paint stays behind there: split the shot at cuts "
                  "(--target-start, --target-frames), or slow it down");
}

void tellOfBareSurface(const KnownRun& run, std::vector<std::string>& lines) {
  const auto bare = [](const ShapeFigures& f) { return 1.0 - share(f.insidePx, f.framePx); };
  const Frames frames(run.exemplar, FrameTest([&](const ShapeFigures& f) {
                        return !f.full() && bare(f) < kTellBareShare;
                      }));
  if (frames.none() || frames.few()) return;
  lines.push_back("exemplar: only " + percentText(frames.spread(run.exemplar, bare).least) +
                  " of the picture is bare surface in " + frames.text() +
                  ": edges have little to be painted with; leave these frames out (--src-frames)");
}

}  // namespace

std::vector<std::string> expectations(const KnownRun& run) {
  std::vector<std::string> lines;
  tellOfEmptyFrames("exemplar", run.exemplar, lines);
  tellOfEmptyFrames("animation", run.target, lines);
  tellOfLoss("exemplar", "--blur-sigma", run.blurSigmaPx, run.exemplar, lines);
  tellOfLoss("animation", "--target-blur-sigma", run.targetBlurSigmaPx, run.target, lines);
  tellOfThinParts(run, lines);
  tellOfInteriors(run, lines);
  tellOfRim(run, lines);
  tellOfSpeed(run, lines);
  tellOfJumps(run, lines);
  tellOfBareSurface(run, lines);
  return lines;
}

std::string framesText(const std::vector<int>& all, const std::vector<int>& chosen) {
  constexpr int kMostRuns = 12;
  std::string text;
  int runs = 0;
  for (std::size_t i = 0; i < chosen.size();) {
    std::size_t last = i;
    while (last + 1 < chosen.size() && chosen[last + 1] == chosen[last] + 1) ++last;
    if (++runs > kMostRuns) return text + ", ...";
    if (!text.empty()) text += ", ";
    text += std::to_string(all[at(chosen[i])]);
    if (last > i) text += "-" + std::to_string(all[at(chosen[last])]);
    i = last + 1;
  }
  return text;
}

}  // namespace fluidymation
