#include "fluidymation/io/unnamed_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cassert>
#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <system_error>
#include <vector>

#include "fluidymation/core/error.h"

namespace fluidymation {
namespace {

namespace fs = std::filesystem;

constexpr mode_t kMode = S_IRUSR | S_IWUSR;

std::string nearestFolder(const std::string& folder) {
  std::error_code failure;
  fs::path path = fs::absolute(folder.empty() ? "." : folder, failure);
  while (!fs::is_directory(path, failure) && path.has_relative_path()) path = path.parent_path();
  return path.string();
}

/// @return  -1, and errno says why, where there can be none.
int openUnnamed(const std::string& folder) {
#ifdef O_TMPFILE
  const int descriptor = open(folder.c_str(), O_TMPFILE | O_RDWR | O_EXCL | O_CLOEXEC, kMode);
  if (descriptor >= 0) return descriptor;
  if (errno != EOPNOTSUPP && errno != EISDIR && errno != EINVAL) return -1;
#endif
  const std::string pattern = folder + "/.fluidymation-frames.XXXXXX";
  std::vector<char> name(pattern.begin(), pattern.end());
  name.push_back('\0');
  const int named = mkostemp(name.data(), O_CLOEXEC);
  if (named >= 0) unlink(name.data());
  return named;
}

}  // namespace

UnnamedFile::UnnamedFile(const std::string& folder)
    : folder_(nearestFolder(folder)), descriptor_(openUnnamed(folder_)) {
  if (descriptor_ < 0) fail("cannot be created", errno);
}

UnnamedFile::~UnnamedFile() { close(descriptor_); }

std::uint64_t UnnamedFile::append(const void* data, std::size_t byteCount) {
  const auto* bytes = static_cast<const char*>(data);
  std::size_t done = 0;
  while (done < byteCount) {
    const ssize_t written =
        pwrite(descriptor_, bytes + done, byteCount - done, static_cast<off_t>(size_ + done));
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) fail("cannot grow", written < 0 ? errno : ENOSPC);
    done += static_cast<std::size_t>(written);
  }
  const std::uint64_t begin = size_;
  size_ += byteCount;
  return begin;
}

void UnnamedFile::read(std::uint64_t offset, void* data, std::size_t byteCount) const {
  assert(offset + byteCount <= size_);
  auto* bytes = static_cast<char*>(data);
  std::size_t done = 0;
  while (done < byteCount) {
    const ssize_t got =
        pread(descriptor_, bytes + done, byteCount - done, static_cast<off_t>(offset + done));
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) fail("cannot be read", got < 0 ? errno : EIO);
    done += static_cast<std::size_t>(got);
  }
}

void UnnamedFile::fail(const std::string& what, int code) const {
  constexpr std::uint64_t kMebibyte = std::uint64_t{1} << 20;
  throw Error(folder_ + ": the temporary file for frames that wait for their turn " + what + " (" +
              std::generic_category().message(code) + "); it holds " +
              std::to_string(size_ / kMebibyte) +
              " MiB so far; wanted more room there, or frames on another disk");
}

}  // namespace fluidymation
