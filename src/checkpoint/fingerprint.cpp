#include "checkpoint/fingerprint.h"

#include <algorithm>
#include <initializer_list>
#include <limits>
#include <string_view>

#include "fluidymation/core/error.h"

namespace fluidymation {
namespace {

constexpr std::size_t kLongestList = 5;  // of changed files

/// A list of clauses, separated by semicolons.
class Sentence {
 public:
  /// One clause, from its parts.
  void add(std::initializer_list<std::string_view> parts) {
    if (!text_.empty()) text_ += "; ";
    for (const std::string_view part : parts) text_ += part;
  }
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  std::string text_;
};

[[nodiscard]] const std::string* valueOf(const Fingerprint& fingerprint, const std::string& name) {
  for (const auto& [option, value] : fingerprint.options) {
    if (option == name) return &value;
  }
  return nullptr;
}

[[nodiscard]] const InputDigests* inputOf(const Fingerprint& fingerprint,
                                          const std::string& option) {
  for (const InputDigests& input : fingerprint.inputs) {
    if (input.option == option) return &input;
  }
  return nullptr;
}

[[nodiscard]] std::string framesText(const InputDigests& input) {
  if (input.files.empty()) return "no frames";
  return std::to_string(input.files.size()) + " frames, " +
         std::to_string(input.files.front().number) + " to " +
         std::to_string(input.files.back().number);
}

[[nodiscard]] bool haveSameNumbers(const InputDigests& a, const InputDigests& b) {
  return std::equal(a.files.begin(), a.files.end(), b.files.begin(), b.files.end(),
                    [](const auto& x, const auto& y) { return x.number == y.number; });
}

void compare(const InputDigests& had, const InputDigests& now, Sentence& sentence) {
  if (!haveSameNumbers(had, now)) {
    sentence.add({had.option, " had ", framesText(had), ", now has ", framesText(now)});
    return;
  }
  std::string numbers;
  std::size_t changed = 0;
  for (std::size_t i = 0; i < had.files.size(); ++i) {
    if (had.files[i].digest == now.files[i].digest) continue;
    ++changed;
    if (changed > kLongestList) continue;
    numbers += (numbers.empty() ? " " : ", ") + std::to_string(had.files[i].number);
  }
  if (changed == 0) return;
  if (had.option == kBackgroundOption) {  // one picture, and no sequence
    sentence.add({had.option, " has changed"});
    return;
  }
  if (changed > kLongestList) {
    numbers += " and " + std::to_string(changed - kLongestList) + " more";
  }
  sentence.add({had.option, ": ", changed == 1 ? "frame" : "frames", numbers,
                changed == 1 ? " has" : " have", " changed"});
}

[[nodiscard]] std::size_t countOf(std::size_t leastBytes, std::size_t most, const char* what,
                                  ByteReader& bytes) {
  const std::size_t count = bytes.count(leastBytes, what);
  if (count <= most) return count;
  throw Error(std::string("it is damaged: ") + what + " is out of range");
}

}  // namespace

std::optional<std::string> difference(const Fingerprint& had, const Fingerprint& now) {
  Sentence sentence;
  if (had.version != now.version) {
    sentence.add({"fluidymation was ", had.version, ", now ", now.version});
  }
  for (const auto& [option, value] : now.options) {
    const std::string* const before = valueOf(had, option);
    if (before == nullptr) {
      sentence.add({option, " was not given, now ", value});
    } else if (*before != value) {
      sentence.add({option, " was ", *before, ", now ", value});
    }
  }
  for (const auto& [option, value] : had.options) {
    if (valueOf(now, option) == nullptr) sentence.add({option, " was ", value, ", now not given"});
  }
  for (const InputDigests& input : now.inputs) {
    const InputDigests* const before = inputOf(had, input.option);
    if (before == nullptr) {
      sentence.add({input.option, " was not given"});
    } else {
      compare(*before, input, sentence);
    }
  }
  for (const InputDigests& input : had.inputs) {
    if (inputOf(now, input.option) == nullptr) sentence.add({input.option, " was given, now not"});
  }
  if (sentence.text().empty()) return std::nullopt;
  return sentence.text();
}

void write(const Fingerprint& fingerprint, ByteWriter& bytes) {
  bytes.text(fingerprint.version);
  bytes.count(fingerprint.options.size());
  for (const auto& [option, value] : fingerprint.options) {
    bytes.text(option);
    bytes.text(value);
  }
  bytes.count(fingerprint.inputs.size());
  for (const InputDigests& input : fingerprint.inputs) {
    bytes.text(input.option);
    bytes.count(input.files.size());
    for (const InputDigests::File& file : input.files) {
      bytes.number(file.number);
      bytes.digest(file.digest);
    }
  }
}

Fingerprint readFingerprint(ByteReader& bytes) {
  constexpr std::size_t kTextBytes = 4;   // at least
  constexpr std::size_t kFileBytes = 20;  // number and digest
  Fingerprint fingerprint;
  fingerprint.version = bytes.text("the version");
  const std::size_t options = countOf(2 * kTextBytes, kMostOptions, "the number of options", bytes);
  for (std::size_t i = 0; i < options; ++i) {
    std::string option = bytes.text("an option's name");
    fingerprint.options.emplace_back(std::move(option), bytes.text("an option's value"));
  }
  const std::size_t inputs = countOf(2 * kTextBytes, kMostInputs, "the number of inputs", bytes);
  for (std::size_t i = 0; i < inputs; ++i) {
    InputDigests input;
    input.option = bytes.text("an input's name");
    input.files.resize(countOf(kFileBytes, kMostFrames, "the number of an input's files", bytes));
    for (InputDigests::File& file : input.files) {
      file.number = bytes.number(std::numeric_limits<int>::min(), std::numeric_limits<int>::max(),
                                 "a file's number");
      file.digest = bytes.digest();
    }
    fingerprint.inputs.push_back(std::move(input));
  }
  return fingerprint;
}

}  // namespace fluidymation
