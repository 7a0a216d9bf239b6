#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace fluidymation::test {

/// An empty folder of the test's own, removed with all it holds.
class TemporaryFolder {
 public:
  TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder();

  [[nodiscard]] const std::string& path() const { return path_; }
  [[nodiscard]] std::string file(const std::string& name) const { return path_ + "/" + name; }

  /// Names of all entries, hidden ones too, sorted.
  [[nodiscard]] std::vector<std::string> names() const;

 private:
  std::string path_;
};

using Bytes = std::vector<std::uint8_t>;

[[nodiscard]] Bytes readBytes(const std::string& path);
void writeBytes(const std::string& path, const Bytes& bytes);
[[nodiscard]] Bytes bytesOf(const std::string& text);

/// What `action` throws as an Error (or a kind of it); "" when it throws nothing.
template <typename Failure, typename Action>
[[nodiscard]] std::string messageOf(const Action& action) {
  try {
    action();
  } catch (const Failure& failure) {
    return failure.what();
  }
  return "";
}

}  // namespace fluidymation::test
