#include "bench/measure.h"

#include <cassert>
#include <set>

#include "bench/staged_synthesizer.h"
#include "fluidymation/core/parallel.h"
#include "fluidymation/guides/guide_stream.h"
#include "fluidymation/io/png.h"
#include "fluidymation/synthesis/synthesizer.h"
#include "support/temporary_folder.h"

namespace fluidymation::bench {
namespace {

/// As the pipeline does before it writes.
Image<Rgba8> toRgba(const Image<Lab>& picture, const GuideFrame& frame) {
  Image<Rgba8> output(picture.size());
  forEachRow(picture.height(), [&](int y) {
    for (int x = 0; x < picture.width(); ++x) {
      const std::uint8_t alpha = toByte(frame.coverageAt(x, y));
      if (alpha == 0) continue;
      const Rgb color = toRgb(picture(x, y));
      output(x, y) = {toByte(color.r), toByte(color.g), toByte(color.b), alpha};
    }
  });
  return output;
}

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

/// One frame as the tool paints it; its parts that are not the synthesizer's are stages too.
GuideFrame paintWhole(GuideStream& guides, Synthesizer& synthesizer, const std::string& path,
                      StageClock& clock) {
  GuideFrame frame = clock.time(Stage::kGuides, kNoLevel, [&] { return guides.next(); });
  const Image<Lab> picture =
      clock.time(Stage::kPaint, kNoLevel, [&] { return synthesizer.paint(frame); });
  const Image<Rgba8> rgba =
      clock.time(Stage::kRgba, kNoLevel, [&] { return toRgba(picture, frame); });
  clock.time(Stage::kPng, kNoLevel, [&] { writePng(path, rgba); });
  return frame;
}

}  // namespace

Measurement measure(const LoadedCase& loaded, int repetitions) {
  const int frames = static_cast<int>(loaded.targetMasks.size());
  assert(frames >= 2);
  const int later = frames - 1;
  const test::TemporaryFolder folder;
  Measurement result;
  for (int repetition = 0; repetition < repetitions; ++repetition) {
    StageClock total;  // of all frames but the first
    const Stopwatch ahead;
    GuideStream guides(
        frames,
        [&](int i) {
          const InputMask& mask = loaded.targetMasks[static_cast<std::size_t>(i)];
          return InputMask(mask.coverage.clone(), mask.soft);
        },
        loaded.targetGuides);
    const Cost guidesAhead = ahead.elapsed().dividedBy(frames);
    Synthesizer synthesizer(loaded.exemplar, loaded.synthesis);
    StagedSynthesizer staged(loaded.exemplar, loaded.synthesis);
    Cost firstFrame;
    std::size_t maskPixels = 0;
    for (int j = 0; j < frames; ++j) {
      StageClock clock;
      const Stopwatch whole;
      const GuideFrame frame = paintWhole(guides, synthesizer, folder.file("frame.png"), clock);
      clock.add({Stage::kFrame, kNoLevel}, whole.elapsed());
      staged.paint(frame, clock);
      result.sameMatches = result.sameMatches && agree(synthesizer.nnf(), staged.nnf());
      if (j == 0) {
        firstFrame = clock.costs().at({Stage::kFrame, kNoLevel});
        continue;
      }
      addAll(clock, total);
      maskPixels += countInside(frame.mask);
    }
    addSums(total);
    for (const auto& [stage, cost] : total.costs()) {
      result.costs[stage].push_back(cost.dividedBy(later));
    }
    result.costs[{Stage::kFirstFrame, kNoLevel}].push_back(firstFrame);
    result.costs[{Stage::kGuidesAhead, kNoLevel}].push_back(guidesAhead);
    result.maskPixels = static_cast<double>(maskPixels) / later;
  }
  return result;
}

}  // namespace fluidymation::bench
