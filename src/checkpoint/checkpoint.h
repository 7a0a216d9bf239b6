#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "checkpoint/fingerprint.h"
#include "fluidymation/core/color.h"
#include "fluidymation/core/geometry.h"
#include "fluidymation/io/digest.h"
#include "fluidymation/synthesis/nnf.h"
#include "fluidymation/synthesis/synthesis_state.h"

namespace fluidymation {

/// A painted frame as it was written.
struct FrameRecord {
  Digest digest;         ///< of the file
  double seconds = 0.0;  ///< since the frame before was written, or painting began
};

/// Of all frames of a target, in its order; nothing for those that are still to be painted.
using FrameRecords = std::vector<std::optional<FrameRecord>>;

/// Everything that is needed to go on after a frame.
struct Checkpoint {
  Fingerprint fingerprint;
  /// The frame, counted from 0, that was painted afresh, without one before it. From there on every
  /// frame was painted after the one before it.
  int begin = 0;
  FrameRecords frames;
  SynthesisState synthesis;

  /// The frame to be painted next.
  [[nodiscard]] int next() const { return synthesis.frame; }
};

/// What a checkpoint of this run may hold at most: what is read is not trusted.
struct CheckpointLimits {
  Size exemplar;
  int exemplarFrames = 0;  ///< of the whole film
  int heldFrames = 0;      ///< of these, as many as are held at a time; [1, exemplarFrames]
  Size target;
  int targetFrames = 0;
};

/// Bytes of a pixel in a file, at most: flags, match, movement owed, colour.
inline constexpr std::size_t kMostPixelBytes = 1 + sizeof(Match) + sizeof(float) + sizeof(Lab);

/// The checkpoint as the bytes of a file: a mark, the format's version, the fields, and the digest
/// of all that. Numbers are little-endian.
[[nodiscard]] std::vector<std::uint8_t> encode(const Fingerprint& fingerprint, int begin,
                                               const FrameRecords& frames,
                                               const SynthesisState& synthesis);

/// The reverse. Only a checkpoint whose fingerprint is `now` is read to its end.
/// @return  nothing, and `differs` says in what its fingerprint differs, or the checkpoint.
/// @throws Error, without a file's name, when it is damaged, of another format or out of its range.
[[nodiscard]] std::optional<Checkpoint> decode(const std::vector<std::uint8_t>& bytes,
                                               const Fingerprint& now,
                                               const CheckpointLimits& limits,
                                               std::string& differs);

}  // namespace fluidymation
