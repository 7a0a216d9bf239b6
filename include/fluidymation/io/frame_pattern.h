#pragma once

#include <optional>
#include <string>
#include <utility>

namespace fluidymation {

/// A path with exactly one integer conversion, such as "out/%05d.png": %d, %i, %u with optional
/// zero flag and width up to 20; "%%" stands for a percent sign. Or with hashes instead, one for
/// each digit: "out/#####.png" is "out/%05d.png". Hashes are plain letters in a folder's name and
/// beside a conversion. Parsed once; user text never reaches a printf function.
class FramePattern {
 public:
  /// @throws UsageError that shows the pattern and says what is wrong with it: no conversion, two,
  ///   a hostile or unfinished one, a conversion in a folder's name, an empty file name.
  explicit FramePattern(const std::string& text);

  [[nodiscard]] const std::string& text() const { return text_; }

  /// File of frame `number`: "out/%05d.png" gives "out/00012.png" for 12; negative numbers are
  /// written as printf would.
  [[nodiscard]] std::string path(int number) const;

  /// Folder of all frames; "." where the pattern names none.
  [[nodiscard]] std::string folder() const;

  /// What a file's name has before and behind its number: "rim_" and ".png" of "out/rim_%05d.png".
  [[nodiscard]] std::pair<std::string, std::string> nameParts() const;

  /// The number of a file name (without folder) that `path` could have made, else nothing.
  [[nodiscard]] std::optional<int> numberOf(const std::string& fileName) const;

 private:
  std::string text_;
  std::string head_;
  std::string tail_;
  int width_ = 0;
  bool zeroPadded_ = false;
};

}  // namespace fluidymation
