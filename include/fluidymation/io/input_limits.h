#pragma once

#include <cstddef>
#include <cstdint>

namespace fluidymation {

// What is read at most, whoever made it: files come from anywhere. Each limit is far beyond what a
// film or an animation needs; within them all sums and products of sizes fit 64 bits. They are
// checked before memory is asked for. SECURITY.md lists them.

/// A side of a picture: twice the width of an 8K film frame.
inline constexpr int kMaxImageSidePx = 16384;

/// Pixels of a picture, three times an 8K frame. While an exemplar frame of the limit is read, RGBA
/// and RGB floats exist side by side: 28 bytes a pixel, 3.1 GiB (8 more, the rows as stored, when
/// it is interlaced and has 16 bits). Scaling and the guides come on top.
inline constexpr std::int64_t kMaxImagePixels = 120'000'000;

/// Bytes of a picture's or flow's file. The largest there can be, 120 million pixels of 16-bit RGBA
/// that nothing compresses or as many vectors, has 960 million; the rest is for profiles and texts.
/// Without a limit a file with nothing behind its picture would be digested for hours.
inline constexpr std::int64_t kMaxImageFileBytes = std::int64_t{1} << 30;

/// Largest component of a known flow, px per frame; more is a slip or another byte order.
inline constexpr float kMaxFlowPx = 1e5F;

/// Frames of a sequence: eleven hours of film.
inline constexpr int kMaxFrames = 1'000'000;

/// Bytes of a path with a frame number; Linux refuses paths from 4096 up.
inline constexpr std::size_t kMaxPatternBytes = 4000;

}  // namespace fluidymation
