#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace fluidymation {

/// A temporary file without a name, on the disk of a folder. The system frees it when the process
/// ends, however it ends; where a file system knows no such files, it has a name for a moment,
/// .NAME.LETTERS, before it is unlinked.
class UnnamedFile {
 public:
  /// @param folder  the nearest folder on its way that exists is the one that is used.
  /// @throws Error naming the folder and the system's reason.
  explicit UnnamedFile(const std::string& folder);
  UnnamedFile(const UnnamedFile&) = delete;
  UnnamedFile& operator=(const UnnamedFile&) = delete;
  ~UnnamedFile();

  [[nodiscard]] std::uint64_t size() const { return size_; }

  /// @return  where the bytes begin. @throws Error naming the folder, the bytes held already and
  /// the system's reason; the file is then as it was.
  std::uint64_t append(const void* data, std::size_t byteCount);

  /// @throws Error likewise, also when the bytes are not there.
  void read(std::uint64_t offset, void* data, std::size_t byteCount) const;

 private:
  [[noreturn]] void fail(const std::string& what, int code) const;

  std::string folder_;
  int descriptor_ = -1;
  std::uint64_t size_ = 0;
};

}  // namespace fluidymation
