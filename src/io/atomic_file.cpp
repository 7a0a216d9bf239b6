#include "fluidymation/io/atomic_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <system_error>

#include "fluidymation/core/error.h"

namespace fluidymation {
namespace {

namespace fs = std::filesystem;

[[nodiscard]] std::string systemReason(int code) { return std::generic_category().message(code); }

[[noreturn]] void failToWrite(const std::string& path, int code) {
  throw Error(path + ": cannot be written (" + systemReason(code) + ")");
}

[[noreturn]] void failToCreate(const std::string& folder, const std::string& reason) {
  throw Error(folder + ": the folder cannot be created (" + reason + ")");
}

[[noreturn]] void failToWriteIn(const std::string& folder, int code) {
  throw Error(folder + ": files cannot be created in this folder (" + systemReason(code) + ")");
}

/// Hidden, so that no listing takes it for a frame, and in the folder of `path`, because only
/// within one file system can a file be renamed. Long names are cut: 255 bytes are the limit.
[[nodiscard]] std::string temporaryName(const std::string& path) {
  constexpr std::size_t kLongestPart = 200;
  const std::size_t slash = path.rfind('/');
  const std::size_t nameBegin = slash == std::string::npos ? 0 : slash + 1;
  return path.substr(0, nameBegin) + "." + path.substr(nameBegin, kLongestPart) + ".tmp." +
         std::to_string(getpid());
}

/// The file under its temporary name; removed again unless `publish` succeeds.
class TemporaryFile {
 public:
  explicit TemporaryFile(const std::string& path) : path_(path), temporary_(temporaryName(path)) {
    // What an earlier process of the same number left behind; "x" then refuses to follow a link
    // that somebody else puts there.
    std::remove(temporary_.c_str());
    file_ = std::fopen(temporary_.c_str(), "wbxe");
    if (file_ == nullptr) failToWrite(path_, errno);
  }

  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  ~TemporaryFile() {
    if (file_ != nullptr) std::fclose(file_);
    if (!published_) std::remove(temporary_.c_str());
  }

  void append(const void* data, std::size_t byteCount) {
    errno = 0;
    if (std::fwrite(data, 1, byteCount, file_) != byteCount) failToWrite(path_, errno);
  }

  /// A full disk may show only when the buffers are emptied, so each step is checked.
  void publish() {
    if (std::fflush(file_) != 0) failToWrite(path_, errno);
    // Some file systems cannot flush and say so; nothing is lost by that.
    if (fsync(fileno(file_)) != 0 && errno != EINVAL && errno != ENOTSUP) failToWrite(path_, errno);
    std::FILE* const file = file_;
    file_ = nullptr;
    if (std::fclose(file) != 0) failToWrite(path_, errno);
    if (std::rename(temporary_.c_str(), path_.c_str()) != 0) failToWrite(path_, errno);
    published_ = true;
  }

 private:
  std::string path_;
  std::string temporary_;
  std::FILE* file_ = nullptr;
  bool published_ = false;
};

}  // namespace

void checkReplaceable(const std::string& path) {
  struct stat status {};
  if (stat(path.c_str(), &status) != 0) {
    if (errno != ENOENT) failToWrite(path, errno);
  } else if (!S_ISREG(status.st_mode)) {
    // Renaming would replace a device such as /dev/null by a picture.
    throw Error(path + ": cannot be written (" +
                (S_ISDIR(status.st_mode) ? "it is a folder" : "it exists and is no regular file") +
                ")");
  }
}

void writeAtomically(const std::string& path, const std::function<void(const ByteSink&)>& write) {
  checkReplaceable(path);
  TemporaryFile file(path);
  write([&file](const void* data, std::size_t byteCount) { file.append(data, byteCount); });
  file.publish();
}

void checkFolderCreatable(const std::string& folder) {
  std::error_code ignored;
  fs::path existing = folder;
  while (!fs::exists(existing, ignored) && existing.has_relative_path()) {
    existing = existing.parent_path();
  }
  if (existing.empty()) existing = ".";
  const bool complete = existing == fs::path(folder);
  if (!fs::is_directory(existing, ignored)) {
    failToCreate(folder, complete ? "it exists and is no folder" : systemReason(ENOTDIR));
  }
  if (faccessat(AT_FDCWD, existing.c_str(), W_OK | X_OK, AT_EACCESS) == 0) return;
  if (complete) failToWriteIn(folder, errno);
  failToCreate(folder, systemReason(errno));
}

void createFolder(const std::string& folder) {
  std::error_code failure;
  fs::create_directories(folder, failure);
  // Whether `failure` is set for a folder that exists depends on trailing slashes and links.
  std::error_code ignored;
  if (fs::is_directory(folder, ignored)) return;
  failToCreate(folder, failure ? failure.message() : "it exists and is no folder");
}

void checkFolderWritable(const std::string& folder) {
  const std::string probe = temporaryName(folder + "/write-test");
  std::remove(probe.c_str());
  std::FILE* const file = std::fopen(probe.c_str(), "wbxe");
  if (file == nullptr) failToWriteIn(folder, errno);
  std::fclose(file);
  std::remove(probe.c_str());
}

}  // namespace fluidymation
