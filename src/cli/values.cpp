#include "cli/values.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <optional>
#include <string_view>

#include "fluidymation/core/error.h"

namespace fluidymation::cli {
namespace {

/// Reads all of `text` as one number; nothing for trailing characters, overflow and emptiness. -0
/// is 0: a run goes on only with the values that it began with, as they are written.
/// std::from_chars and not strtod: a locale with a decimal comma must not change what is read.
template <typename T>
[[nodiscard]] std::optional<T> parseWhole(const std::string& text) {
  T value{};
  const char* const end = text.data() + text.size();
  const auto [stop, failure] = std::from_chars(text.data(), end, value);
  if (failure != std::errc{} || stop != end) return std::nullopt;
  return value == T{} ? T{} : value;
}

/// As `parseWhole`; nothing also outside `range`. Compared in T, so that 0.9900000001 is 0.99 as a
/// float and not above it.
template <typename T>
[[nodiscard]] std::optional<T> parseWithin(const std::string& text, const Range& range) {
  const std::optional<T> value = parseWhole<T>(text);
  return value && range.contains(*value) ? value : std::nullopt;
}

/// Whether `text` is a number that is not 0, but nearer to it than any T.
template <typename T>
[[nodiscard]] bool vanishes(const std::string& text) {
  const std::optional<long double> value = parseWhole<long double>(text);
  return value && !parseWhole<T>(text) && std::abs(*value) < 1.0L;
}

template <typename T>
[[nodiscard]] T parseReal(const std::string& option, const std::string& text, const Range& range,
                          const std::string& others = "") {
  if (const std::optional<T> value = parseWithin<T>(text, range)) return *value;
  throw UsageError(shown(option, text) + ": " + (vanishes<T>(text) ? "is too near to 0; " : "") +
                   "wanted a number in " + range.text() + others);
}

[[nodiscard]] std::vector<std::string> splitAtCommas(const std::string& text) {
  std::vector<std::string> parts(1);
  for (const char c : text) {
    if (c == ',') {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  return parts;
}

/// "10-80", or "7" for "7-7".
[[nodiscard]] std::optional<FrameNumbers> parseFirstAndLast(const std::string& text) {
  // The hyphen between the numbers is the first one behind a digit.
  const std::size_t hyphen = text.find('-', 1);
  const auto first = parseWithin<int>(text.substr(0, hyphen), ranges::kFrameNumbers);
  const auto last = hyphen == std::string::npos
                        ? first
                        : parseWithin<int>(text.substr(hyphen + 1), ranges::kFrameNumbers);
  if (first && last) return FrameNumbers{*first, *last};
  return std::nullopt;
}

}  // namespace

float parseFloat(const std::string& option, const std::string& text, const Range& range,
                 const std::string& others) {
  return parseReal<float>(option, text, range, others);
}

std::optional<float> parseAutomatic(const std::string& option, const std::string& text,
                                    const Range& range) {
  if (text == kAutomaticWord) return std::nullopt;
  return parseFloat(option, text, range, std::string(" or ") + kAutomaticWord);
}

double parseDouble(const std::string& option, const std::string& text, const Range& range) {
  return parseReal<double>(option, text, range);
}

int parseInt(const std::string& option, const std::string& text, const Range& range,
             bool zeroAllowed) {
  const std::optional<int> value = parseWithin<int>(text, range);
  if (value && (zeroAllowed || *value != 0)) return *value;
  throw UsageError(shown(option, text) + ": wanted a whole number in " + range.text() +
                   (zeroAllowed ? "" : " other than 0"));
}

std::uint64_t parseSeed(const std::string& option, const std::string& text) {
  if (const auto seed = parseWhole<std::uint64_t>(text)) return *seed;
  throw UsageError(shown(option, text) + ": wanted a whole number in [0, " +
                   std::to_string(std::numeric_limits<std::uint64_t>::max()) + "]");
}

std::int64_t parseBytes(const std::string& option, const std::string& text, std::int64_t least) {
  constexpr double kMostBytes = 9e15;  // every whole number up to there is a double
  const std::size_t digits = std::min(text.find_first_not_of("0123456789."), text.size());
  const std::optional<double> number = parseWhole<double>(text.substr(0, digits));
  std::string unit = text.substr(digits);
  if (!unit.empty() && unit[0] >= 'a' && unit[0] <= 'z') {
    unit[0] = static_cast<char>(unit[0] - 'a' + 'A');
  }
  constexpr std::string_view kUnits = "KMGT";
  double factor = 1.0;
  bool known = unit.empty();
  for (const char c : kUnits) {
    const std::string letter(1, c);
    factor *= 1024.0;
    if (unit != letter && unit != letter + "B" && unit != letter + "iB") continue;
    known = true;
    break;
  }
  const double bytes = number.value_or(0.0) * (unit.empty() ? 1.0 : factor);
  if (known && bytes >= static_cast<double>(least) && bytes <= kMostBytes) {
    return static_cast<std::int64_t>(bytes);
  }
  throw UsageError(shown(option, text) + ": wanted a size of at least " +
                   std::to_string(least >> 20) + "M, with K, M, G or T, e.g. 800M or 4G");
}

std::vector<int> parseIntList(const std::string& option, const std::string& text,
                              const Range& range) {
  std::vector<int> values;
  const std::vector<std::string> parts = splitAtCommas(text);
  if (parts.size() <= static_cast<std::size_t>(ranges::kLongestList)) {
    for (const std::string& part : parts) {
      const std::optional<int> value = parseWithin<int>(part, range);
      if (value) values.push_back(*value);
    }
  }
  if (values.size() == parts.size()) return values;
  throw UsageError(shown(option, text) + ": wanted 1 to " + std::to_string(ranges::kLongestList) +
                   " whole numbers in " + range.text() + " separated by commas, e.g. 4,3,2");
}

FloatPair parseDescendingPair(const std::string& option, const std::string& text,
                              const Range& range) {
  const std::vector<std::string> parts = splitAtCommas(text);
  if (parts.size() != 2) {
    throw UsageError(shown(option, text) + ": wanted two numbers m_u,m_l in pixels, e.g. 10,2");
  }
  const auto upper = parseWithin<float>(parts[0], range);
  const auto lower = parseWithin<float>(parts[1], range);
  if (upper && lower && *upper > *lower) return {*upper, *lower};
  throw UsageError(shown(option, text) + ": wanted two numbers m_u,m_l in " + range.text() +
                   " pixels with m_u greater than m_l, e.g. 10,2");
}

FrameNumbers parseFrameNumbers(const std::string& option, const std::string& text) {
  if (const auto numbers = parseFirstAndLast(text)) return *numbers;
  throw UsageError(shown(option, text) + ": wanted two frame numbers, e.g. 10-80");
}

FrameRange parseFrameRange(const std::string& option, const std::string& text) {
  constexpr Range kSteps{1, ranges::kSpeeds.high};
  const std::size_t cross = text.find('x');
  const auto numbers = parseFirstAndLast(text.substr(0, cross));
  const auto step = cross == std::string::npos ? std::optional<int>(1)
                                               : parseWithin<int>(text.substr(cross + 1), kSteps);
  if (!numbers || !step) {
    throw UsageError(shown(option, text) +
                     ": wanted two frame numbers and a step from 1 up, e.g. " +
                     "10-80x2, or without x2");
  }
  const std::int64_t distance = std::int64_t{numbers->last} - numbers->first;
  const std::int64_t frames = std::abs(distance) / *step + 1;
  if (!ranges::kFrameCounts.contains(static_cast<double>(frames))) {
    throw UsageError(shown(option, text) + ": " + std::to_string(frames) +
                     " frames; wanted a number in " + ranges::kFrameCounts.text());
  }
  return {numbers->first, static_cast<int>(frames), distance < 0 ? -*step : *step};
}

std::string frameRangeText(const FrameRange& range) {
  const std::int64_t last = range.first + (std::int64_t{range.frames} - 1) * range.step;
  const int step = std::abs(range.step);
  std::string text = std::to_string(range.first);
  text += '-';
  text += std::to_string(last);
  if (step == 1) return text;
  text += 'x';
  return text + std::to_string(step);
}

std::string shown(const std::string& option, const std::string& text) {
  constexpr std::size_t kLongestShown = 80;
  if (text.empty()) return option + " with an empty value";
  const bool cut = text.size() > kLongestShown;
  return option + " " + oneLine(cut ? text.substr(0, kLongestShown) + "..." : text);
}

std::string noteLine(const std::string& text) {
  return "fluidymation: note: " + oneLine(text) + "\n";
}

std::string oneLine(std::string text) {
  // As bytes: whether char is signed depends on the machine
  constexpr unsigned char kC1Lead = 0xC2;  // the controls U+0080 to U+009F are C2 80 to C2 9F
  unsigned char before = 0;
  for (char& c : text) {
    const auto byte = static_cast<unsigned char>(c);
    const bool c1 = before == kC1Lead && byte >= 0x80 && byte <= 0x9F;
    before = byte;
    if (byte < ' ' || byte == 0x7F || c1) c = '?';
  }
  return text;
}

}  // namespace fluidymation::cli
