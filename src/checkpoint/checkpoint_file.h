#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "checkpoint/checkpoint.h"

namespace fluidymation {

/// A checkpoint's file, or why it cannot be gone on from.
struct FoundCheckpoint {
  std::optional<Checkpoint> checkpoint;
  std::string differs;  ///< where it is of another run: in what that differs from this one
};

/// @throws Error naming the file when it cannot be read, is damaged or of another format.
[[nodiscard]] FoundCheckpoint readCheckpoint(const std::string& path, const Fingerprint& now,
                                             const CheckpointLimits& limits);

/// All bytes of a file. @throws Error naming the file when it cannot be read, is empty, no regular
/// file or of more than `mostBytes`. @param wanted  what it should be, for the message.
[[nodiscard]] std::vector<std::uint8_t> readWhole(const std::string& path, std::int64_t mostBytes,
                                                  const std::string& wanted);

}  // namespace fluidymation
