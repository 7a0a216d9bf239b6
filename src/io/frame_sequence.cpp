#include "fluidymation/io/frame_sequence.h"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <optional>
#include <system_error>
#include <utility>

#include "fluidymation/core/error.h"
#include "fluidymation/core/text.h"
#include "fluidymation/io/png.h"

namespace fluidymation {
namespace {

constexpr std::size_t kLongestList = 160;  // bytes of a list of missing frames
constexpr int kMostFilesNamed = 10;        // of a sequence, each in a line of its own

/// Number of the sequence's frame i, wide enough for any i.
[[nodiscard]] std::int64_t numberAt(const SequenceOptions& sequence, std::int64_t i) {
  return sequence.start + i * sequence.speed;
}

/// "--src" for "--src-path" and "--src-mask-path".
[[nodiscard]] std::string optionPrefix(const std::string& optionName) {
  return optionName.substr(0, optionName.find('-', 2));
}

void checkNumbers(const SequenceOptions& sequence, const std::string& optionName) {
  const std::int64_t last = numberAt(sequence, std::int64_t{sequence.frames} - 1);
  if (last >= std::numeric_limits<int>::min() && last <= std::numeric_limits<int>::max()) return;
  const std::string prefix = optionPrefix(optionName);
  throw UsageError(prefix + "-start " + std::to_string(sequence.start) + ", " + prefix +
                   "-frames " + std::to_string(sequence.frames) + ", " + prefix + "-speed " +
                   std::to_string(sequence.speed) + ": the last frame would have number " +
                   std::to_string(last) + "; wanted numbers from " +
                   std::to_string(std::numeric_limits<int>::min()) + " to " +
                   std::to_string(std::numeric_limits<int>::max()));
}

[[nodiscard]] std::string askedFor(const SequenceOptions& sequence) {
  const std::string first = std::to_string(sequence.start);
  if (sequence.frames == 1) return "frame " + first + " was asked for";
  return "frames " + first + " to " +
         std::to_string(numberAt(sequence, std::int64_t{sequence.frames} - 1)) + " in steps of " +
         std::to_string(sequence.speed) + " were asked for";
}

[[noreturn]] void failAtFirst(const FramePattern& pattern, const SequenceOptions& sequence,
                              const std::string& reason, const std::string& wayOut = "") {
  throw Error(pattern.path(sequence.start) + ": cannot be opened (" + reason + "); " +
              askedFor(sequence) + wayOut);
}

/// Numbers of all files of the pattern, ascending.
[[nodiscard]] std::vector<int> numbersIn(const FramePattern& pattern, std::error_code& failure) {
  std::vector<int> numbers;
  std::filesystem::directory_iterator entry(pattern.folder(), failure);
  for (; !failure && entry != std::filesystem::directory_iterator(); entry.increment(failure)) {
    if (const auto number = pattern.numberOf(entry->path().filename().string())) {
      numbers.push_back(*number);
    }
  }
  std::sort(numbers.begin(), numbers.end());
  return numbers;
}

/// The same. @throws Error where the folder cannot be read.
[[nodiscard]] std::vector<int> listNumbers(const FramePattern& pattern,
                                           const SequenceOptions& sequence) {
  std::error_code failure;
  std::vector<int> numbers = numbersIn(pattern, failure);
  if (failure) failAtFirst(pattern, sequence, failure.message());
  return numbers;
}

/// The same for files that go with others; here it is a fault that there is none.
[[nodiscard]] std::vector<int> listCompanions(const FramePattern& pattern,
                                              const std::string& optionName) {
  std::error_code failure;
  std::vector<int> numbers = numbersIn(pattern, failure);
  if (!failure && !numbers.empty()) return numbers;
  throw Error(optionName + " " + pattern.text() + ": there is no file of this pattern" +
              (failure ? " (" + pattern.folder() + ": " + failure.message() + ")" : "") +
              "; wanted one for every frame of " + optionPrefix(optionName) + "-path");
}

/// Ascending i >= 0 of all files that the sequence would meet if it never ended.
[[nodiscard]] std::vector<std::int64_t> indicesOf(const std::vector<int>& numbers,
                                                  const SequenceOptions& sequence) {
  std::vector<std::int64_t> indices;
  for (const int number : numbers) {
    const std::int64_t distance = std::int64_t{number} - sequence.start;
    if (distance % sequence.speed == 0 && distance / sequence.speed >= 0) {
      indices.push_back(distance / sequence.speed);
    }
  }
  std::sort(indices.begin(), indices.end());
  return indices;
}

/// "5-9, 12, 20-31", cut with "and 17 more" when it becomes long.
class FrameList {
 public:
  explicit FrameList(const SequenceOptions& sequence) : sequence_(sequence) {}

  /// Frames [begin, end) of the sequence.
  void add(std::int64_t begin, std::int64_t end) {
    const std::int64_t first = numberAt(sequence_, begin);
    const std::int64_t last = numberAt(sequence_, end - 1);
    count_ += end - begin;
    if (text_.size() > kLongestList) {
      unlisted_ += end - begin;
      return;
    }
    if (!text_.empty()) text_ += ", ";
    text_ += std::to_string(first);
    if (last != first) text_ += (first < 0 || last < 0 ? " to " : "-") + std::to_string(last);
  }

  [[nodiscard]] std::int64_t count() const { return count_; }
  [[nodiscard]] std::string text() const {
    return unlisted_ == 0 ? text_ : text_ + " and " + std::to_string(unlisted_) + " more";
  }

 private:
  const SequenceOptions& sequence_;
  std::string text_;
  std::int64_t count_ = 0;
  std::int64_t unlisted_ = 0;
};

[[nodiscard]] FrameList findHoles(const std::vector<std::int64_t>& indices, std::int64_t end,
                                  const SequenceOptions& sequence) {
  FrameList holes(sequence);
  std::int64_t expected = 0;
  for (const std::int64_t i : indices) {
    if (std::min(i, end) > expected) holes.add(expected, std::min(i, end));
    if (i >= end) break;
    expected = i + 1;
  }
  if (!indices.empty() && end > indices.back() + 1) holes.add(indices.back() + 1, end);
  return holes;
}

/// What is wrong with files of a sequence, one line each, and how many are left unnamed.
class FaultyFiles {
 public:
  void add(const std::string& fault) {
    if (++count_ <= kMostFilesNamed) lines_.push_back(fault);
  }

  /// @throws Faults where there are some.
  void throwIfAny() {
    if (count_ == 0) return;
    const int unnamed = count_ - kMostFilesNamed;
    if (unnamed > 0) lines_.back() += "; " + std::to_string(unnamed) + " more files have faults";
    throw Faults(std::move(lines_));
  }

 private:
  std::vector<std::string> lines_;
  int count_ = 0;
};

/// "frames 1 to 3 are used"
[[nodiscard]] std::string used(const std::vector<int>& numbers) {
  const std::string first = std::to_string(numbers.front());
  if (numbers.size() == 1) return "frame " + first + " is used";
  return "frames " + first + " to " + std::to_string(numbers.back()) + " are used";
}

}  // namespace

FrameFiles findFrames(const FramePattern& pattern, const SequenceOptions& sequence,
                      const std::string& optionName) {
  checkNumbers(sequence, optionName);
  const std::vector<int> present = listNumbers(pattern, sequence);
  const std::vector<std::int64_t> indices = indicesOf(present, sequence);
  const std::int64_t frames = sequence.frames;
  if (indices.empty() || indices.front() >= frames) {
    std::string wayOut;
    if (!present.empty()) {
      wayOut = "; files of this pattern are numbered " + std::to_string(present.front()) + " to " +
               std::to_string(present.back()) + " (" + optionPrefix(optionName) + "-start)";
    }
    failAtFirst(pattern, sequence, "No such file or directory", wayOut);
  }

  const std::int64_t end = sequence.complete ? frames : std::min(frames, indices.back() + 1);
  const FrameList holes = findHoles(indices, end, sequence);
  if (holes.count() > 0) {
    throw Error(optionName + " " + pattern.text() + ": " + std::to_string(holes.count()) +
                (holes.count() == 1 ? " frame is" : " frames are") + " missing" +
                (indices.back() + 1 < end ? ": " : " although later ones exist: ") + holes.text() +
                "; " + askedFor(sequence));
  }

  FrameFiles files;
  for (std::int64_t i = 0; i < end; ++i) {
    files.numbers.push_back(static_cast<int>(numberAt(sequence, i)));
    files.paths.push_back(pattern.path(files.numbers.back()));
  }
  const std::string name = optionName + " " + pattern.text() + ": ";
  const std::string framesOption = optionPrefix(optionName) + "-frames";
  if (end < frames) {
    files.note = name + "the sequence ends with frame " + std::to_string(files.numbers.back()) +
                 ", after " + std::to_string(end) + " of at most " + std::to_string(frames) +
                 " frames (" + framesOption + ")";
  } else if (indices.back() >= frames) {
    const auto following = indices.end() - std::lower_bound(indices.begin(), indices.end(), frames);
    files.note = name + used(files.numbers) + "; " + std::to_string(following) +
                 (following == 1 ? " more follows (" : " more follow (") + framesOption + ")";
  }
  return files;
}

FrameFiles findCompanions(const FramePattern& pattern, const FrameFiles& frames,
                          const SequenceOptions& sequence, const std::string& optionName,
                          int dispensable) {
  const std::vector<int> present = listCompanions(pattern, optionName);
  FrameFiles files;
  FrameList missing(sequence);
  std::int64_t missingSince = -1;
  for (int i = 0; i < frames.count(); ++i) {
    const int number = frames.numbers[static_cast<std::size_t>(i)];
    const bool found = std::binary_search(present.begin(), present.end(), number);
    const bool missed = !found && i != dispensable;
    if (missed && missingSince < 0) missingSince = i;
    if (!missed && missingSince >= 0) {
      missing.add(missingSince, i);
      missingSince = -1;
    }
    files.numbers.push_back(number);
    files.paths.push_back(found ? pattern.path(number) : std::string());
  }
  if (missingSince >= 0) missing.add(missingSince, frames.count());
  if (missing.count() == 0) return files;
  std::string exception;
  if (dispensable >= 0) exception = dispensable == 0 ? " but the first" : " but the last";
  throw Error(optionName + " " + pattern.text() + ": " + std::to_string(missing.count()) +
              (missing.count() == 1 ? " frame is" : " frames are") + " missing: " + missing.text() +
              "; wanted one file for every frame of " + optionPrefix(optionName) + "-path" +
              exception);
}

Size commonSize(const FrameFiles& files) {
  std::optional<Size> first;
  std::string firstPath;
  FaultyFiles faulty;
  for (const std::string& path : files.paths) {
    try {
      const Size size = readPngSize(path);
      if (!first) {
        first = size;
        firstPath = path;
      }
      if (size == *first) continue;
      std::string fault = path;
      fault += ": size " + sizeText(size);
      fault += ", but " + firstPath;
      faulty.add(fault + " is " + sizeText(*first) +
                 "; all frames of a sequence must have one size");
    } catch (const Error& error) {
      faulty.add(error.what());
    }
  }
  faulty.throwIfAny();
  return *first;
}

void requireSize(const FrameFiles& files, const FrameFiles& frames, Size wanted,
                 const std::function<Size(const std::string&)>& sizeOf) {
  FaultyFiles faulty;
  for (std::size_t i = 0; i < files.paths.size(); ++i) {
    const std::string& path = files.paths[i];
    if (path.empty()) continue;
    try {
      const Size size = sizeOf(path);
      if (size == wanted) continue;
      faulty.add(path + ": size " + sizeText(size) + ", but " + frames.paths[i] + " is " +
                 sizeText(wanted) + "; a flow and its masks must agree");
    } catch (const Error& error) {
      faulty.add(error.what());
    }
  }
  faulty.throwIfAny();
}

void requireMasksOfSameSize(const FrameFiles& exemplar, const FrameFiles& masks) {
  const Size exemplarSize = readPngSize(exemplar.paths.front());
  const Size maskSize = readPngSize(masks.paths.front());
  if (maskSize == exemplarSize) return;
  throw Error(masks.paths.front() + ": size " + sizeText(maskSize) + ", but " +
              exemplar.paths.front() + " is " + sizeText(exemplarSize) +
              "; an exemplar and its masks must agree");
}

}  // namespace fluidymation
