#pragma once

#include <string>
#include <vector>

#include "fluidymation/core/geometry.h"
#include "fluidymation/io/frame_pattern.h"
#include "fluidymation/options.h"

namespace fluidymation {

/// The files of an image sequence as found on disk: frame i is number start + i * speed.
struct FrameFiles {
  std::vector<int> numbers;        ///< the user's own frame numbers
  std::vector<std::string> paths;  ///< in the same order
  std::string note;  ///< one sentence for the user; empty when there is nothing to say

  [[nodiscard]] int count() const { return static_cast<int>(paths.size()); }
};

/// Finds the files of a sequence. `frames` is an upper bound: the sequence ends earlier where the
/// files end, with a note; a note too when more files follow than were asked for.
/// @param optionName  the option that gave the path, for messages ("--target-path").
/// @throws Error when no frame exists (names the first file wanted) or when there are holes (a
///   missing frame with an existing later one; all holes are listed).
[[nodiscard]] FrameFiles findFrames(const FramePattern& pattern, const SequenceOptions& sequence,
                                    const std::string& optionName);

/// Reads the headers of all frames. @throws Error unless all have one size; names the first frame
/// that differs, both sizes and the frame it differs from.
[[nodiscard]] Size commonSize(const FrameFiles& files);

}  // namespace fluidymation
