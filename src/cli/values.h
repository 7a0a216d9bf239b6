#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "fluidymation/option_ranges.h"
#include "fluidymation/options.h"

namespace fluidymation::cli {

// The readers of option values. The whole text must be one number (or list); nothing depends on the
// locale. All throw UsageError: "--mask-threshold 0.7: wanted a number in (0, 0.5]".

/// @param others  what is wanted else, for the message: " or auto".
[[nodiscard]] float parseFloat(const std::string& option, const std::string& text,
                               const Range& range, const std::string& others = "");
[[nodiscard]] double parseDouble(const std::string& option, const std::string& text,
                                 const Range& range);
[[nodiscard]] int parseInt(const std::string& option, const std::string& text, const Range& range,
                           bool zeroAllowed = true);
[[nodiscard]] std::uint64_t parseSeed(const std::string& option, const std::string& text);

/// A number of bytes, with K, M, G or T for powers of 1024: "800M", "1.5G", "4GiB".
[[nodiscard]] std::int64_t parseBytes(const std::string& option, const std::string& text,
                                      std::int64_t least);

/// What stands for a value that is found from the inputs.
inline constexpr const char* kAutomaticWord = "auto";

/// A number, or nothing for `kAutomaticWord`.
[[nodiscard]] std::optional<float> parseAutomatic(const std::string& option,
                                                  const std::string& text, const Range& range);

/// Comma-separated whole numbers, 1 to `ranges::kLongestList` of them.
[[nodiscard]] std::vector<int> parseIntList(const std::string& option, const std::string& text,
                                            const Range& range);

/// Exactly two numbers, the first greater than the second.
struct FloatPair {
  float first = 0.0F;
  float second = 0.0F;
};
[[nodiscard]] FloatPair parseDescendingPair(const std::string& option, const std::string& text,
                                            const Range& range);

/// Two frame numbers, "10-80", or "7" for "7-7"; negative ones too: "-3--1".
[[nodiscard]] FrameNumbers parseFrameNumbers(const std::string& option, const std::string& text);

/// Frames that a sequence consists of: `frames` of them from `first` on in steps of `step`.
struct FrameRange {
  int first = 0;
  int frames = 1;
  int step = 1;  ///< negative backwards
};

/// "10-80x2"; "80-10" backwards, "7" for one frame, "10-80" for all; negative numbers, too.
[[nodiscard]] FrameRange parseFrameRange(const std::string& option, const std::string& text);

/// The reverse.
[[nodiscard]] std::string frameRangeText(const FrameRange& range);

/// `option`, and `text` as far as it is short and printable: how every complaint begins.
[[nodiscard]] std::string shown(const std::string& option, const std::string& text);

/// `text` on one line: control characters become '?'.
[[nodiscard]] std::string oneLine(std::string text);

/// "fluidymation: note: frames may differ", and the line's end: how every note is told.
[[nodiscard]] std::string noteLine(const std::string& text);

}  // namespace fluidymation::cli
