#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

/// What libFuzzer calls with one input, and `replay.cpp` with each file of the corpus: one a
/// program. Ends the program (`require`, a sanitizer, an exception that is no Error) where a
/// promise is broken. @return  0.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t byteCount);

namespace fluidymation::fuzz {

/// Says which promise was broken and aborts, unless it holds.
void require(bool holds, const char* promise);

/// A complaint of the tool about the file `path`: it begins with its name.
void requireNaming(const std::string& message, const std::string& path);

/// A regular file in memory that holds an input.
class MemoryFile {
 public:
  /// Aborts where the system has no memory for it.
  MemoryFile(const std::uint8_t* data, std::size_t byteCount);
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  ~MemoryFile();

  /// Opens the file from its beginning.
  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  int descriptor_;
  std::string path_;
};

}  // namespace fluidymation::fuzz
