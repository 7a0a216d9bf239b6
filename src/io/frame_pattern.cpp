#include "fluidymation/io/frame_pattern.h"

#include <algorithm>
#include <charconv>

#include "fluidymation/core/error.h"
#include "fluidymation/io/input_limits.h"

namespace fluidymation {
namespace {

constexpr int kLargestWidth = 20;           // digits; no int has more than 10
constexpr std::size_t kLongestShown = 120;  // bytes of a faulty pattern shown in its message

[[nodiscard]] bool isDigit(char c) { return c >= '0' && c <= '9'; }
[[nodiscard]] bool isControl(char c) { return static_cast<unsigned char>(c) < ' ' || c == '\x7f'; }

[[noreturn]] void refuse(const std::string& pattern, const std::string& what) {
  std::string shown =
      pattern.size() <= kLongestShown ? pattern : pattern.substr(0, kLongestShown) + "...";
  std::replace_if(shown.begin(), shown.end(), isControl, '?');
  throw UsageError(shown + ": " + what +
                   "; wanted a path with exactly one frame number, e.g. frames/%05d.png");
}

/// One '%' and what belongs to it.
struct Conversion {
  std::size_t length = 0;  ///< bytes, from the '%' on
  bool literalPercent = false;
  bool zeroPadded = false;
  int width = 0;
};

[[nodiscard]] Conversion parseConversion(const std::string& text, std::size_t begin) {
  Conversion conversion;
  std::size_t i = begin + 1;
  if (i < text.size() && text[i] == '%') {
    conversion.literalPercent = true;
    conversion.length = 2;
    return conversion;
  }
  for (; i < text.size() && text[i] == '0'; ++i) conversion.zeroPadded = true;
  for (; i < text.size() && isDigit(text[i]); ++i) {
    conversion.width = 10 * conversion.width + (text[i] - '0');
    if (conversion.width > kLargestWidth) {
      refuse(text, "the width of the frame number is above " + std::to_string(kLargestWidth));
    }
  }
  if (i == text.size()) refuse(text, "the % is followed by no conversion (%% is a percent sign)");
  if (text[i] != 'd' && text[i] != 'i' && text[i] != 'u') {
    const std::string found = text.substr(begin, i - begin + 1);
    refuse(text, '"' + found +
                     "\" is no frame number (%d, %i, %u, also %5d and %05d; %% is a percent sign)");
  }
  conversion.length = i + 1 - begin;
  return conversion;
}

/// Whether some '%' of `text` is more than a percent sign.
[[nodiscard]] bool hasConversion(const std::string& text) {
  for (std::size_t i = text.find('%'); i != std::string::npos; i = text.find('%', i)) {
    const Conversion conversion = parseConversion(text, i);
    if (!conversion.literalPercent) return true;
    i += conversion.length;
  }
  return false;
}

/// "###", as "%03d" would be; only in a file's name.
[[nodiscard]] Conversion parseHashes(const std::string& text, std::size_t begin) {
  Conversion conversion;
  conversion.zeroPadded = true;
  conversion.length = std::min(text.find_first_not_of('#', begin), text.size()) - begin;
  if (conversion.length > static_cast<std::size_t>(kLargestWidth)) {
    refuse(text, "more than " + std::to_string(kLargestWidth) + " # in a row");
  }
  conversion.width = static_cast<int>(conversion.length);
  return conversion;
}

}  // namespace

FramePattern::FramePattern(const std::string& text) : text_(text) {
  if (text.empty()) throw UsageError("the path is empty; wanted one such as frames/%05d.png");
  if (text.size() > kMaxPatternBytes) {
    refuse(text, "longer than " + std::to_string(kMaxPatternBytes) + " bytes");
  }
  if (std::any_of(text.begin(), text.end(), isControl)) {
    refuse(text, "contains a line break or another control character");
  }
  const std::size_t nameBegin = text.rfind('/') + 1;  // npos + 1 is 0
  const std::size_t hashesFrom = hasConversion(text) ? text.size() : nameBegin;
  bool found = false;
  for (std::size_t i = 0; i < text.size();) {
    std::string& part = found ? tail_ : head_;
    const bool hashes = text[i] == '#' && i >= hashesFrom;
    if (text[i] != '%' && !hashes) {
      part += text[i++];
      continue;
    }
    const Conversion conversion = hashes ? parseHashes(text, i) : parseConversion(text, i);
    i += conversion.length;
    if (conversion.literalPercent) {
      part += '%';
      continue;
    }
    if (found) refuse(text, "contains more than one frame number");
    found = true;
    width_ = conversion.width;
    zeroPadded_ = conversion.zeroPadded;
  }
  if (!found) refuse(text, "contains no frame number");
  if (tail_.find('/') != std::string::npos) {
    refuse(text, "the frame number is in a folder's name, not in the file's");
  }
}

std::string FramePattern::path(int number) const {
  const bool negative = number < 0;
  std::string digits = std::to_string(number).substr(negative ? 1 : 0);
  const std::size_t taken = digits.size() + (negative ? 1 : 0);
  const auto width = static_cast<std::size_t>(width_);
  const std::string padding(width > taken ? width - taken : 0, zeroPadded_ ? '0' : ' ');
  const std::string sign = negative ? "-" : "";
  return head_ + (zeroPadded_ ? sign + padding : padding + sign) + digits + tail_;
}

std::string FramePattern::folder() const {
  const std::size_t slash = head_.rfind('/');
  if (slash == std::string::npos) return ".";
  return slash == 0 ? "/" : head_.substr(0, slash);
}

std::pair<std::string, std::string> FramePattern::nameParts() const {
  const std::size_t slash = head_.rfind('/');
  return {head_.substr(slash == std::string::npos ? 0 : slash + 1), tail_};
}

std::optional<int> FramePattern::numberOf(const std::string& fileName) const {
  const std::size_t slash = head_.rfind('/');
  const std::size_t nameBegin = slash == std::string::npos ? 0 : slash + 1;
  const std::size_t headLength = head_.size() - nameBegin;
  if (fileName.size() < headLength + tail_.size()) return std::nullopt;
  const char* first = fileName.data() + headLength;
  const char* const last = fileName.data() + fileName.size() - tail_.size();
  while (first != last && *first == ' ') ++first;
  int number = 0;
  const auto [end, failure] = std::from_chars(first, last, number);
  if (failure != std::errc{} || end != last) return std::nullopt;
  // Only the one spelling that `path` gives counts: with %05d, "0012" and "000012" are no frames.
  if (path(number).substr(nameBegin) != fileName) return std::nullopt;
  return number;
}

}  // namespace fluidymation
