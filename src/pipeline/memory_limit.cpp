#include "pipeline/memory_limit.h"

#include "fluidymation/core/error.h"
#include "fluidymation/core/text.h"
#include "pipeline/machine_memory.h"

namespace fluidymation {

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
                   (options.maxMemoryBytes ? " (--max-memory" : " (what this machine has") +
                   "); lower --src-frames, --src-window, --src-scale, --target-scale or --threads");
}

std::string memoryNote(const Options& options, const RunSize& run) {
  return "memory: at most about " + memoryText(bytesOfRun(run)) + ", of " +
         memoryText(memoryLimitBytes(options)) +
         (options.maxMemoryBytes ? " (--max-memory)" : " that this machine has");
}

}  // namespace fluidymation
