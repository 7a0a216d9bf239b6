#include "fluidymation/io/frame_folder.h"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <system_error>
#include <utility>

#include "fluidymation/core/error.h"

namespace fluidymation {
namespace {

constexpr std::size_t kMostShapesNamed = 4;

[[nodiscard]] bool isDigit(char c) { return c >= '0' && c <= '9'; }
[[nodiscard]] char lowerCase(char c) {
  return static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
}

[[nodiscard]] bool endsWith(const std::string& name, const std::string& ending) {
  return name.size() > ending.size() &&
         std::equal(ending.rbegin(), ending.rend(), name.rbegin(),
                    [](char wanted, char found) { return wanted == lowerCase(found); });
}

/// Names that count, in the folder's order. @throws Error where the folder cannot be read.
[[nodiscard]] std::vector<std::string> namesIn(const std::string& folder,
                                               const std::vector<std::string>& endings) {
  std::vector<std::string> names;
  std::error_code failure;
  std::filesystem::directory_iterator entry(folder, failure);
  for (; !failure && entry != std::filesystem::directory_iterator(); entry.increment(failure)) {
    std::string name = entry->path().filename().string();
    const bool counts = std::any_of(endings.begin(), endings.end(), [&](const std::string& ending) {
      return endsWith(name, ending);
    });
    std::error_code ignored;
    if (!counts || name.front() == '.' || !entry->is_regular_file(ignored)) continue;
    names.push_back(std::move(name));
  }
  if (failure) throw Error(folder + ": the folder cannot be read (" + failure.message() + ")");
  return names;
}

/// A name cut where digits begin and end: texts[0] digits[0] texts[1] ... texts[n].
struct CutName {
  std::vector<std::string> texts;
  std::vector<std::string> digits;
};

[[nodiscard]] CutName cut(const std::string& name) {
  CutName parts;
  parts.texts.emplace_back();
  bool inDigits = false;
  for (const char c : name) {
    if (isDigit(c)) {
      if (!inDigits) parts.digits.emplace_back();
      parts.digits.back() += c;
    } else {
      if (inDigits) parts.texts.emplace_back();
      parts.texts.back() += c;
    }
    inDigits = isDigit(c);
  }
  if (inDigits) parts.texts.emplace_back();
  return parts;
}

/// Which of the numbers of names with the same texts counts the frames.
[[nodiscard]] std::size_t countingNumber(const std::vector<CutName>& names) {
  const std::size_t last = names.front().digits.size() - 1;
  std::optional<std::size_t> differing;
  for (std::size_t i = 0; i <= last; ++i) {
    const bool differs = std::any_of(names.begin(), names.end(), [&](const CutName& name) {
      return name.digits[i] != names.front().digits[i];
    });
    if (!differs) continue;
    if (differing) return last;
    differing = i;
  }
  return differing.value_or(last);
}

/// What names have round their number.
using Shape = std::pair<std::string, std::string>;

/// The numbers of all names of each shape, as they are written.
using Shapes = std::map<Shape, std::vector<std::string>>;

[[nodiscard]] Shapes shapesOf(const std::vector<std::string>& names) {
  std::map<std::vector<std::string>, std::vector<CutName>> byTexts;
  for (const std::string& name : names) {
    CutName parts = cut(name);
    if (!parts.digits.empty()) byTexts[parts.texts].push_back(std::move(parts));
  }
  Shapes shapes;
  for (const auto& [texts, group] : byTexts) {
    const std::size_t counting = countingNumber(group);
    for (const CutName& name : group) {
      Shape shape;
      for (std::size_t i = 0; i < texts.size(); ++i) {
        std::string& part = i <= counting ? shape.first : shape.second;
        part += texts[i];
        if (i != counting && i < name.digits.size()) part += name.digits[i];
      }
      shapes[shape].push_back(name.digits[counting]);
    }
  }
  return shapes;
}

/// Percent signs doubled, as patterns want them.
[[nodiscard]] std::string asPatternText(const std::string& text) {
  std::string result;
  for (const char c : text) result += c == '%' ? std::string("%%") : std::string(1, c);
  return result;
}

/// How many digits numbers are filled up to with zeros, 0 where they are not; nothing where they
/// are not alike.
[[nodiscard]] std::optional<std::size_t> commonWidth(const std::vector<std::string>& numbers) {
  const auto isPadded = [](const std::string& n) { return n.size() > 1 && n.front() == '0'; };
  const auto padded = std::find_if(numbers.begin(), numbers.end(), isPadded);
  if (padded == numbers.end()) return 0;
  const std::size_t width = padded->size();
  const bool alike = std::all_of(numbers.begin(), numbers.end(), [&](const std::string& n) {
    return n.size() == width || (n.size() > width && !isPadded(n));
  });
  return alike ? std::optional<std::size_t>(width) : std::nullopt;
}

[[nodiscard]] std::string conversion(std::size_t width) {
  return width == 0 ? "%d" : "%0" + std::to_string(width) + "d";
}

/// "rim_%05d.png (24 files)"
[[nodiscard]] std::string described(const Shape& shape, const std::vector<std::string>& numbers) {
  return asPatternText(shape.first) + conversion(commonWidth(numbers).value_or(0)) +
         asPatternText(shape.second) + " (" + std::to_string(numbers.size()) +
         (numbers.size() == 1 ? " file)" : " files)");
}

[[noreturn]] void refuseSeveral(const std::string& begin, const Shapes& shapes) {
  std::string text;
  std::size_t named = 0;
  for (const auto& [shape, numbers] : shapes) {
    if (named++ == kMostShapesNamed) break;
    text += (text.empty() ? "" : ", ") + described(shape, numbers);
  }
  if (shapes.size() > kMostShapesNamed) {
    text += " and " + std::to_string(shapes.size() - kMostShapesNamed) + " more";
  }
  throw Error(begin + "holds files of " + std::to_string(shapes.size()) +
              " shapes of name: " + text + "; wanted one of them as a pattern");
}

[[nodiscard]] std::string withSlash(const std::string& folder) {
  return asPatternText(folder) + (folder.back() == '/' ? "" : "/");
}

}  // namespace

FolderSequence sequenceIn(const std::string& folder, const std::string& optionName,
                          const std::vector<std::string>& endings) {
  const Shapes shapes = shapesOf(namesIn(folder, endings));
  const std::string begin = optionName + " " + folder + ": ";
  if (shapes.empty()) {
    std::string wanted;
    for (const std::string& ending : endings) wanted += (wanted.empty() ? "" : " or ") + ending;
    throw Error(begin + "the folder holds no numbered file; wanted names such as 00001" + wanted);
  }
  if (shapes.size() > 1) refuseSeveral(begin, shapes);
  const auto& [shape, numbers] = *shapes.begin();
  const std::optional<std::size_t> width = commonWidth(numbers);
  if (!width) {
    throw Error(begin + "numbers are filled up with zeros to different widths, such as " +
                *std::min_element(numbers.begin(), numbers.end()) + " and " +
                *std::max_element(numbers.begin(), numbers.end()) + "; wanted one width");
  }
  std::set<int> found;
  for (const std::string& text : numbers) {
    int number = 0;
    if (std::from_chars(text.data(), text.data() + text.size(), number).ec != std::errc{}) {
      std::string message = begin;
      message += "the number ";
      message += text;
      throw Error(message + " is too large; wanted none above 2147483647");
    }
    found.insert(number);
  }
  return {withSlash(folder) + asPatternText(shape.first) + conversion(*width) +
              asPatternText(shape.second),
          *found.begin(), *found.rbegin()};
}

std::string patternIn(const std::string& folder) { return withSlash(folder) + "%05d.png"; }

}  // namespace fluidymation
