#include "fuzz_target.h"

#include <sys/mman.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>

namespace fluidymation::fuzz {

void require(bool holds, const char* promise) {
  if (holds) return;
  std::fprintf(stderr, "broken promise: %s\n", promise);
  std::abort();
}

void requireNaming(const std::string& message, const std::string& path) {
  require(message.compare(0, path.size() + 2, path + ": ") == 0,
          "a complaint begins with the file's name");
}

MemoryFile::MemoryFile(const std::uint8_t* data, std::size_t byteCount)
    : descriptor_(memfd_create("input", MFD_CLOEXEC)),
      path_("/proc/self/fd/" + std::to_string(descriptor_)) {
  require(descriptor_ >= 0, "a file in memory can be made");
  for (std::size_t written = 0; written < byteCount;) {
    const ssize_t count = write(descriptor_, data + written, byteCount - written);
    require(count > 0, "a file in memory can be written");
    written += static_cast<std::size_t>(count);
  }
}

MemoryFile::~MemoryFile() { close(descriptor_); }

}  // namespace fluidymation::fuzz
