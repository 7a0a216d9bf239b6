#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "fluidymation/io/digest.h"

namespace fluidymation {

/// What a run may replace: digests of files with the names of frames, by the frames' numbers (the
/// user's own). A frame has several where one was being replaced when a run ended.
///
/// Its file is text, a line "NUMBER DIGEST" for each digest, so that a line more can be appended.
using FrameDigests = std::map<int, std::vector<Digest>>;

/// @return  whether frame `number` may be replaced where it is a file of that digest.
[[nodiscard]] bool holds(const FrameDigests& frames, int number, const Digest& digest);

/// Adds what is not there yet.
void add(int number, const Digest& digest, FrameDigests& frames);

/// One line of the file, with its end.
[[nodiscard]] std::string lineOf(int number, const Digest& digest);

[[nodiscard]] std::vector<std::uint8_t> encode(const FrameDigests& frames);

/// The reverse. Lines that are no such lines, or were not written to their end, count for nothing,
/// and so does a file that is not there or cannot be read: then less may be replaced.
[[nodiscard]] FrameDigests readReplaceableFrames(const std::string& path);

}  // namespace fluidymation
