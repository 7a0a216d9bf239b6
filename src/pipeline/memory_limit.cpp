#include "pipeline/memory_limit.h"

#include <optional>

#include "fluidymation/core/error.h"
#include "fluidymation/core/text.h"
#include "fluidymation/option_ranges.h"
#include "pipeline/machine_memory.h"

namespace fluidymation {
namespace {

/// A run that holds so many frames of the film at a time, with masks as large as they may be where
/// they have not been read: so that it is not refused once they are.
[[nodiscard]] RunSize holding(int frames, const RunSize& run) {
  RunSize part = run;
  part.heldFrames = frames;
  const auto pixels = [](Size size) { return std::int64_t{size.width} * size.height; };
  if (part.exemplarMaskPixels == 0) part.exemplarMaskPixels = pixels(part.exemplar);
  if (part.targetMaskPixels == 0) part.targetMaskPixels = pixels(part.target);
  return part;
}

/// A number of frames of the film, fewer than all and as many as bisection finds, that a run may
/// hold at a time within the limit; none where that does not help enough.
[[nodiscard]] std::optional<int> windowWithin(std::int64_t limit, const RunSize& run) {
  int fitting = 0;
  int tooMany = run.exemplarFrames;
  while (tooMany - fitting > 1) {
    const int middle = fitting + (tooMany - fitting) / 2;
    (bytesOfRun(holding(middle, run)) <= limit ? fitting : tooMany) = middle;
  }
  if (fitting < ranges::kLeastWindowFrames) return std::nullopt;
  return fitting;
}

/// What makes a run smaller that needs more than the limit.
[[nodiscard]] std::string waysToNeedLess(const Options& options, const RunSize& run,
                                         std::int64_t limit) {
  if (options.sourceWindowFrames > ranges::kLeastWindowFrames) {
    return "lower --src-frames, --src-window, --src-scale, --target-scale or --threads";
  }
  std::string ways = "lower --src-frames, --src-scale, --target-scale or --threads";
  if (options.sourceWindowFrames != 0) return ways;
  if (const std::optional<int> frames = windowWithin(limit, run)) {
    ways += ", or hold a part of the film at a time: --src-window " + std::to_string(*frames) +
            " needs at most about " + memoryText(bytesOfRun(holding(*frames, run)));
  }
  return ways;
}

}  // namespace

std::int64_t memoryLimitBytes(const Options& options) {
  return options.maxMemoryBytes ? *options.maxMemoryBytes : machineMemoryBytes();
}

void requireMemory(const Options& options, const RunSize& run) {
  const std::int64_t bytes = bytesOfRun(run);
  const std::int64_t limit = memoryLimitBytes(options);
  if (bytes <= limit) return;
  throw UsageError("--src-path " + options.source.path + ", --target-path " + options.target.path +
                   ": " + std::to_string(run.exemplarFrames) + " frames of " +
                   sizeText(run.exemplar) + " and " + std::to_string(run.targetFrames) + " of " +
                   sizeText(run.target) + ", stored with up to " + sizeText(run.largestStored) +
                   ", need about " + memoryText(bytes) + " of memory; wanted at most " +
                   memoryText(limit) +
                   (options.maxMemoryBytes ? " (--max-memory" : " (what this machine has") + "); " +
                   waysToNeedLess(options, run, limit));
}

std::string memoryNote(const Options& options, const RunSize& run) {
  return "memory: at most about " + memoryText(bytesOfRun(run)) + ", of " +
         memoryText(memoryLimitBytes(options)) +
         (options.maxMemoryBytes ? " (--max-memory)" : " that this machine has");
}

}  // namespace fluidymation
