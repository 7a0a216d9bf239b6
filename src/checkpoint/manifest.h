#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "checkpoint/checkpoint.h"
#include "checkpoint/fingerprint.h"

namespace fluidymation {

/// What was painted from what: a JSON file beside the frames, for people, scripts and `--verify`.
/// It depends on inputs, options and seed only, so that equal runs have equal manifests; how long
/// frames took is kept apart.
struct Manifest {
  struct Frame {
    int number = 0;
    std::string file;  ///< its name, without the folder
    Digest digest;
  };

  Fingerprint fingerprint;
  /// Names and values of the options that say where files lie; with those of the fingerprint, all
  /// that is needed to paint the frames once more.
  std::vector<std::pair<std::string, std::string>> paths;
  bool complete = false;      ///< whether these are all frames of the shot
  std::vector<Frame> frames;  ///< in the sequence's order
};

/// The manifest's file. Paths and names that are no UTF-8 are written percent-encoded, as an object
/// that says so.
[[nodiscard]] std::vector<std::uint8_t> encode(const Manifest& manifest);

/// The reverse; the inputs' files come sorted by number.
/// @throws Error naming `path` when it cannot be read, is no manifest, or tells of a frame or of a
///   file twice.
[[nodiscard]] Manifest readManifest(const std::string& path);

/// Whether a manifest that was read tells of a run with this fingerprint.
[[nodiscard]] bool isOf(const Manifest& manifest, Fingerprint fingerprint);

/// How long the frames took, as JSON. @param numbers  the user's own, one for each record.
[[nodiscard]] std::vector<std::uint8_t> encodeTimes(const FrameRecords& frames,
                                                    const std::vector<int>& numbers);

}  // namespace fluidymation
