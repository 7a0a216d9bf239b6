#pragma once

#include <cstdint>
#include <vector>

#include "checkpoint/checkpoint.h"

namespace fluidymation::fuzz {

/// Of a run over four frames of 28x22 px with an exemplar of five frames of 24x20 px.
inline constexpr CheckpointLimits kStateLimits{{24, 20}, 5, 3, {28, 22}, 4};

/// What this run's states are compared with.
[[nodiscard]] Fingerprint stateFingerprint();

/// A state of this run after two frames.
[[nodiscard]] std::vector<std::uint8_t> encodedState();

/// With the digest at the end that the bytes before it have: what somebody forges, not what a disk
/// spoils. Texts that are too short for one come back as they are.
void forgeDigest(std::uint8_t* bytes, std::size_t byteCount);

}  // namespace fluidymation::fuzz
