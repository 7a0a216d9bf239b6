#pragma once

#include <string>
#include <vector>

namespace fluidymation {

/// The only image sequence of a folder.
struct FolderSequence {
  std::string pattern;  ///< for `FramePattern`
  int lowest = 0;       ///< number of a file that is there
  int highest = 0;      ///< likewise
};

/// Finds the files of a folder that share one shape of name with one number in it. The number is
/// where names of a shape differ; where they differ in several numbers, or not at all, it is the
/// last one. Hidden files, files of other endings and names without a number are passed over.
/// @param endings     of the files that count, in lower case, with the dot; upper case counts, too.
/// @param optionName  the option that gave the folder, for messages ("--target-path").
/// @throws Error naming the folder where it cannot be read, holds no such file, or files of more
///   than one shape, all of which are named.
[[nodiscard]] FolderSequence sequenceIn(const std::string& folder, const std::string& optionName,
                                        const std::vector<std::string>& endings);

/// The pattern of frames NUMBER.png, five digits wide, in a folder.
[[nodiscard]] std::string patternIn(const std::string& folder);

}  // namespace fluidymation
