#pragma once

#include <cstdint>
#include <string>

#include "fluidymation/io/input_limits.h"
#include "fluidymation/options.h"

namespace fluidymation {

/// Numbers an option accepts. Each end belongs to it unless it is open.
struct Range {
  double low = 0.0;
  double high = 0.0;
  bool lowOpen = false;
  bool highOpen = false;

  /// False for NaN. A float is compared with the ends as floats: 0.99 is 0.99 in either type.
  [[nodiscard]] bool contains(double value) const;
  [[nodiscard]] bool contains(float value) const;
  [[nodiscard]] bool contains(int value) const;

  [[nodiscard]] std::string text() const;  ///< "(0, 0.5]"
};

/// What the options accept, for the engine and the command line alike. Most upper ends are far
/// beyond anything useful; they catch slips and keep sums and products of options within their
/// types.
namespace ranges {

inline constexpr Range kFrameNumbers{-1e9, 1e9};
inline constexpr Range kFrameCounts{1, kMaxFrames};
/// Frames of the film that are held at a time: 0 for all; of a single one nothing can move.
inline constexpr Range kWindowFrameCounts{0, kMaxFrames};
inline constexpr int kLeastWindowFrames = 2;
inline constexpr Range kSpeeds{-1e6, 1e6};  ///< and not 0
inline constexpr Range kScales{0, 16, true};
inline constexpr Range kSigmasPx{0, 1000};
/// The distances of 3 sigma frames on either side are held and summed for every frame: 301 at 50.
inline constexpr Range kTimeSigmasFrames{0, 50};
inline constexpr Range kThresholds{0, 0.5, true};
inline constexpr Range kWeights{0, 1e6};
inline constexpr Range kVoteSigmasPx{0, 100};
inline constexpr Range kSeamWeights{0, 100};  ///< seams of 10 px on either side at 100
inline constexpr Range kChangeShares{0, 1};
inline constexpr Range kDetailShares{0, 1};
inline constexpr Range kDeepenings{0, 1000};
/// More than the whole drift would be drift the other way.
inline constexpr Range kColorCorrections{0, 1};
inline constexpr Range kOccurrenceRadii{0, 1e4};
inline constexpr Range kDepthReaches{0, 1e4};
/// The search box shrinks to a pixel in log(side) / -log(alpha) candidates, each a patch distance:
/// 21 of them for 400 px at 0.75, 596 at 0.99, and without bound towards 1.
inline constexpr Range kAlphas{0, 0.99, true};
inline constexpr Range kWidthsPx{0.1, 1e4};  ///< squares of the edge guide stay finite
inline constexpr Range kModulationBoundsPx{0, 1e5};
inline constexpr Range kModulationShares{0, 10};  ///< of border width or target side
inline constexpr Range kPatchmatchIterations{1, 1000};
inline constexpr Range kOptIterations{0, 1000};
inline constexpr Range kCompressionLevels{kLeastCompression, kMostCompression};
inline constexpr Range kThreads{1, 1024};
inline constexpr Range kCheckpointFrames{1, 1e6};
inline constexpr Range kPreviewFrames{1, 1e6};

/// Bytes of memory that a run may need: the program alone takes some 16 MiB.
inline constexpr std::int64_t kLeastMemoryBytes = std::int64_t{16} << 20;

/// Iteration counts in a list, at least one: a pyramid has no more levels than this.
inline constexpr int kLongestList = 32;

}  // namespace ranges

/// Shortest text that reads back as `value`, with a decimal point in any locale.
[[nodiscard]] std::string numberText(double value);
[[nodiscard]] std::string numberText(float value);

/// @throws UsageError naming `option` unless `pattern` is a path with one frame number.
void checkPattern(const std::string& option, const std::string& pattern);

/// The same for frames to write, whose name has to end in .png, in letters of either case: PNG is
/// what they are.
void checkOutputPattern(const std::string& option, const std::string& pattern);

/// Makes sure that every option is one the engine can work with. What the command line has parsed
/// always is; other callers may have written anything into `options`.
/// @throws UsageError naming the option, its value and what is wanted.
void validate(const Options& options);

}  // namespace fluidymation
