#pragma once

#include <functional>
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
///   missing frame with an existing later one, also one past the frames asked for; all holes are
///   listed, runs as "5-9", a very long list is cut). @throws UsageError naming the options when
///   start + i * speed leaves the range of int. Of a sequence that is wanted completely, frames
///   missing at its end are holes, too.
[[nodiscard]] FrameFiles findFrames(const FramePattern& pattern, const SequenceOptions& sequence,
                                    const std::string& optionName);

/// Finds the files of a sequence that has one for every frame of another.
/// @param frames       the other sequence; `sequence` are its options.
/// @param optionName   the option that gave the pattern, for messages ("--target-flow-path").
/// @param dispensable  the frame whose file may be missing, -1 for none; its path is empty then.
/// @throws Error naming the option and all frames that are missing.
[[nodiscard]] FrameFiles findCompanions(const FramePattern& pattern, const FrameFiles& frames,
                                        const SequenceOptions& sequence,
                                        const std::string& optionName, int dispensable);

/// Reads the headers of all frames. @throws Faults unless all can be read and have one size; names
/// the frames that cannot, and those that differ, both sizes and the frame they differ from, up to
/// ten and how many more there are.
[[nodiscard]] Size commonSize(const FrameFiles& files);

/// Compares the sizes of files, as `sizeOf` reads them, with that of the frames they belong to.
/// Files that need not be there have empty paths. @throws Faults likewise.
void requireSize(const FrameFiles& files, const FrameFiles& frames, Size wanted,
                 const std::function<Size(const std::string&)>& sizeOf);

/// Compares the first frames of two sequences that `commonSize` has accepted.
/// @throws Error naming both files and sizes when an exemplar and its masks differ.
void requireMasksOfSameSize(const FrameFiles& exemplar, const FrameFiles& masks);

}  // namespace fluidymation
