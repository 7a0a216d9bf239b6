#pragma once

#include <cstdint>
#include <string>

#include "fluidymation/options.h"
#include "pipeline/memory.h"

namespace fluidymation {

/// What a run may need: --max-memory, else what the machine has.
[[nodiscard]] std::int64_t memoryLimitBytes(const Options& options);

/// @throws UsageError naming the sequences, what they need, what there may be and which options
///   make it less, when that is more than the limit. Where the whole film is held, it says how many
///   frames of it at a time would fit (--src-window), if any do.
void requireMemory(const Options& options, const RunSize& run);

/// "memory: at most about 534 MiB, of 23.6 GiB that this machine has", for the user.
[[nodiscard]] std::string memoryNote(const Options& options, const RunSize& run);

}  // namespace fluidymation
