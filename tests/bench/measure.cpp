#include "bench/measure.h"

#include <cassert>
#include <cstdint>
#include <utility>
#include <vector>

#include "bench/stage_timer.h"
#include "fluidymation/core/color.h"
#include "fluidymation/guides/guide_stream.h"
#include "fluidymation/io/png.h"
#include "fluidymation/synthesis/synthesizer.h"
#include "pipeline/frame_writer.h"
#include "support/temporary_folder.h"

namespace fluidymation::bench {
namespace {

/// Adds the costs of one clock to those of another.
void addAll(const StageClock& from, StageClock& to) {
  for (const auto& [stage, cost] : from.costs()) to.add(stage, cost);
}

/// Sums of the stages that have levels, beside their parts.
void addSums(StageClock& clock) {
  const std::map<StageOfLevel, Cost> parts = clock.costs();
  for (const auto& [stage, cost] : parts) {
    if (stage.level != kNoLevel) clock.add({stage.stage, kNoLevel}, cost);
  }
}

/// Reads the target's masks, and tells what a frame of that costs.
std::unique_ptr<GuideStream> openGuides(const LoadedCase& loaded, StageClock& clock) {
  const auto frames = static_cast<int>(loaded.targetFiles.size());
  StageClock reading;
  const Stopwatch all;
  auto guides = std::make_unique<GuideStream>(
      frames,
      [&](int i) {
        return reading.time(TimedStage::kReading, [&] {
          return readMask(loaded.targetFiles[static_cast<std::size_t>(i)], loaded.targetSize);
        });
      },
      loaded.targetGuides);
  Cost ahead = all.elapsed();
  ahead -= reading.sum();
  clock.add({TimedStage::kReading, kNoLevel}, reading.sum().dividedBy(frames));
  clock.add({TimedStage::kGuidesAhead, kNoLevel}, ahead.dividedBy(frames));
  return guides;
}

/// Makes frames as the tool does.
class FrameMaker {
 public:
  FrameMaker(const LoadedCase& loaded, GuideStream& guides)
      : guides_(guides),
        timer_(clock_),
        synthesizer_(loaded.exemplar, loaded.synthesis, &timer_),
        path_(folder_.file("frame.png")) {}
  FrameMaker(const FrameMaker&) = delete;
  FrameMaker& operator=(const FrameMaker&) = delete;

  /// Makes the next frame, from guides to file; @return  pixels of its mask.
  std::size_t next() {
    clock_ = {};
    const Stopwatch whole;
    const std::size_t maskPixels = make();
    const Cost frame = whole.elapsed();
    Cost other = frame;
    other -= clock_.sum();
    clock_.add({TimedStage::kOther, kNoLevel}, other);
    clock_.add({TimedStage::kFrame, kNoLevel}, frame);
    return maskPixels;
  }

  /// Of the frame made last.
  [[nodiscard]] const StageClock& clock() const { return clock_; }

 private:
  std::size_t make() {
    synthesizer_.paint(clock_.time(TimedStage::kGuides,
                                   [&] { return guides_.nextPart(synthesizer_.marginPx()); }));
    const Stopwatch writing;
    encoding_ = {};
    writer_.write(path_, synthesizer_.part(), synthesizer_.picture(), synthesizer_.guides());
    Cost file = writing.elapsed();
    file -= encoding_;
    clock_.add({TimedStage::kPng, kNoLevel}, encoding_);
    clock_.add({TimedStage::kFile, kNoLevel}, file);
    return countInside(synthesizer_.guides().mask);
  }

  GuideStream& guides_;
  StageClock clock_;
  StageTimer timer_;
  Synthesizer synthesizer_;
  Cost encoding_;  ///< of the frame made last
  FrameWriter writer_{FrameForm{}, [this](const FrameWriter::Output& output) {
                        const Stopwatch encoding;
                        std::vector<std::uint8_t> file =
                            encodePng(std::get<Image<Rgba8>>(output.pixels), output.part);
                        encoding_ = encoding.elapsed();
                        return file;
                      }};
  test::TemporaryFolder folder_;
  std::string path_;
};

}  // namespace

Measurement measure(const LoadedCase& loaded, int repetitions) {
  const auto frames = static_cast<int>(loaded.targetFiles.size());
  assert(frames >= 2);
  const int later = frames - 1;
  Measurement result;
  for (int repetition = 0; repetition < repetitions; ++repetition) {
    StageClock perFrame;
    const std::unique_ptr<GuideStream> guides = openGuides(loaded, perFrame);
    FrameMaker maker(loaded, *guides);
    maker.next();
    perFrame.add({TimedStage::kFirstFrame, kNoLevel},
                 maker.clock().costs().at({TimedStage::kFrame, kNoLevel}));

    StageClock total;  // of all frames but the first
    std::size_t maskPixels = 0;
    for (int j = 1; j < frames; ++j) {
      maskPixels += maker.next();
      addAll(maker.clock(), total);
    }
    addSums(total);
    for (const auto& [stage, cost] : total.costs()) perFrame.add(stage, cost.dividedBy(later));
    for (const auto& [stage, cost] : perFrame.costs()) result.costs[stage].push_back(cost);
    result.maskPixels = static_cast<double>(maskPixels) / later;
  }
  return result;
}

}  // namespace fluidymation::bench
