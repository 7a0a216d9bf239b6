#include "io/input_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <new>
#include <system_error>

#include "fluidymation/core/error.h"

namespace fluidymation {

InputFile openInput(const std::string& path, const std::string& wanted, std::int64_t mostBytes) {
  // Without O_NONBLOCK a named pipe of that name would wait for a writer for ever.
  const int descriptor = open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
  if (descriptor < 0) {
    throw Error(path + ": cannot be opened (" + std::generic_category().message(errno) + ")");
  }
  InputFile result;
  result.file.reset(fdopen(descriptor, "rb"));
  if (!result.file) {
    close(descriptor);
    throw std::bad_alloc();
  }
  struct stat status {};
  if (fstat(descriptor, &status) != 0 || !S_ISREG(status.st_mode)) {
    throw Error(path + ": is " + (S_ISDIR(status.st_mode) ? "a folder" : "no regular file") +
                "; wanted " + wanted);
  }
  if (status.st_size == 0) throw Error(path + ": is empty; wanted " + wanted);
  if (status.st_size > mostBytes) {
    throw Error(path + ": has " + std::to_string(status.st_size) + " bytes; wanted " + wanted +
                " of at most " + std::to_string(mostBytes));
  }
  result.byteCount = status.st_size;
  return result;
}

}  // namespace fluidymation
