#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "checkpoint/byte_reader.h"
#include "checkpoint/byte_writer.h"
#include "fluidymation/io/digest.h"
#include "fluidymation/option_ranges.h"

namespace fluidymation {

// What a run can have at most: what is read is not trusted.
inline constexpr std::size_t kMostOptions = 128;  ///< the command line has fewer
inline constexpr std::size_t kMostInputs = 6;     ///< film, masks, target, two flows, background
/// The input that is one file and no sequence; its number counts for nothing.
inline constexpr const char* kBackgroundOption = "--background";
inline constexpr auto kMostFrames = static_cast<std::size_t>(ranges::kFrameCounts.high);

/// The files of one input option.
struct InputDigests {
  struct File {
    int number = 0;  ///< the user's own frame number
    Digest digest;
  };
  std::string option;       ///< "--src-path"
  std::vector<File> files;  ///< in the sequence's order
};

/// Everything that the bytes of the painted frames depend on. Not where files lie and what they are
/// called, nor how many threads paint.
struct Fingerprint {
  std::string version;  ///< of the engine
  /// Names and values of all options that change a byte, widths as they were found.
  std::vector<std::pair<std::string, std::string>> options;
  std::vector<InputDigests> inputs;
};

/// One line that says in what `had` differs from `now`: "--lambda was 2, now 3; --src-path: frame 7
/// has changed". Nothing where they are alike.
[[nodiscard]] std::optional<std::string> difference(const Fingerprint& had, const Fingerprint& now);

void write(const Fingerprint& fingerprint, ByteWriter& bytes);

/// @throws Error as ByteReader does.
[[nodiscard]] Fingerprint readFingerprint(ByteReader& bytes);

}  // namespace fluidymation
