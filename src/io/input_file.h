#pragma once

#include <cstdint>
#include <cstdio>
#include <memory>
#include <string>

namespace fluidymation {

struct FileCloser {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

/// A regular file that is not empty, open for reading.
struct InputFile {
  std::unique_ptr<std::FILE, FileCloser> file;
  std::int64_t byteCount = 0;
};

/// @param wanted     what the file should be, for the message: "a PNG file".
/// @param mostBytes  that it may have.
/// @throws Error naming the file when it cannot be opened, is empty, too large or no regular file.
[[nodiscard]] InputFile openInput(const std::string& path, const std::string& wanted,
                                  std::int64_t mostBytes);

}  // namespace fluidymation
