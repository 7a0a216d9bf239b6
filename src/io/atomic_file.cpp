#include "fluidymation/io/atomic_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <system_error>
#include <utility>

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

constexpr const char* kTemporaryMark = ".tmp.";
constexpr std::size_t kLetterCount = 16;
constexpr std::size_t kLongestPart = 200;  // of a file's name that its temporary one bears
constexpr const char* kProbeName = "write-test";

/// 64 random bits as letters, so that no listing takes them for a frame's number.
[[nodiscard]] std::string randomLetters() {
  std::array<unsigned char, kLetterCount / 2> bytes{};
  if (getentropy(bytes.data(), bytes.size()) != 0) return "";
  std::string letters;
  for (const unsigned char byte : bytes) {
    letters += static_cast<char>('a' + (byte >> 4U));
    letters += static_cast<char>('a' + (byte & 15U));
  }
  return letters;
}

struct CreatedFile {
  std::string path;
  int descriptor = -1;  ///< -1, and errno says why, where none could be created
};

/// A new, empty file to be renamed to `path`: hidden, so that no listing takes it for a frame, and
/// in the same folder, because only within one file system can a file be renamed. Runs that share
/// the folder may have equal process numbers, on several machines or in several containers: hence a
/// random name, and one that nobody has. Long names are cut: 255 bytes are the limit.
[[nodiscard]] CreatedFile createTemporary(const std::string& path) {
  constexpr mode_t kMode = 0666;  // less the user's mask, as for any new file
  constexpr int kAttempts = 100;
  const std::size_t slash = path.rfind('/');
  const std::size_t nameBegin = slash == std::string::npos ? 0 : slash + 1;
  const std::string prefix =
      path.substr(0, nameBegin) + "." + path.substr(nameBegin, kLongestPart) + kTemporaryMark;
  CreatedFile file;
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    const std::string letters = randomLetters();
    if (letters.empty()) break;
    file.path = prefix + letters;
    // O_EXCL also refuses to follow a link that somebody else puts there.
    file.descriptor = open(file.path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, kMode);
    if (file.descriptor >= 0 || errno != EEXIST) break;
  }
  return file;
}

/// Makes a renaming last: a file's name belongs to its folder. Nothing is lost where that fails,
/// for the file is whole under either name.
void flushFolder(const std::string& path) {
  const std::size_t slash = path.rfind('/');
  const std::string folder = slash == std::string::npos ? "." : path.substr(0, slash + 1);
  const int descriptor = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  fsync(descriptor);
  close(descriptor);
}

/// @return  whether that went well; else errno says why.
[[nodiscard]] bool flushToDisk(std::FILE* file) {
  if (std::fflush(file) != 0) return false;
  // Some file systems cannot flush and say so; nothing is lost by that.
  return fsync(fileno(file)) == 0 || errno == EINVAL || errno == ENOTSUP;
}

/// The file under its temporary name; removed again unless `publish` succeeds.
class TemporaryFile {
 public:
  explicit TemporaryFile(const std::string& path) : path_(path) {
    CreatedFile created = createTemporary(path);
    if (created.descriptor < 0) failToWrite(path_, errno);
    temporary_ = std::move(created.path);
    file_ = fdopen(created.descriptor, "wb");
    if (file_ != nullptr) return;
    const int code = errno;
    close(created.descriptor);
    std::remove(temporary_.c_str());
    failToWrite(path_, code);
  }

  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  ~TemporaryFile() {
    if (file_ != nullptr) std::fclose(file_);
    if (!published_) std::remove(temporary_.c_str());
  }

  /// Nothing may come as a null pointer, which fwrite must not be given.
  void append(const void* data, std::size_t byteCount) {
    if (byteCount == 0) return;
    errno = 0;
    if (std::fwrite(data, 1, byteCount, file_) != byteCount) failToWrite(path_, errno);
  }

  [[nodiscard]] const std::string& temporary() const { return temporary_; }

  /// A full disk may show only when the buffers are emptied, so each step is checked.
  void publish() {
    if (!flushToDisk(file_)) failToWrite(path_, errno);
    std::FILE* const file = file_;
    file_ = nullptr;
    if (std::fclose(file) != 0) failToWrite(path_, errno);
    if (std::rename(temporary_.c_str(), path_.c_str()) != 0) failToWrite(path_, errno);
    published_ = true;
    flushFolder(path_);
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

void writeAtomically(const std::string& path, const std::vector<std::uint8_t>& file) {
  writeAtomically(path, [&file](const ByteSink& sink) { sink(file.data(), file.size()); });
}

void replaceAtomically(const std::string& path,
                       const std::function<void(const std::string& temporary)>& write) {
  checkReplaceable(path);
  TemporaryFile file(path);
  write(file.temporary());
  file.publish();
}

void appendLine(const std::string& path, const std::string& line) {
  const int descriptor = open(path.c_str(), O_WRONLY | O_APPEND | O_NOFOLLOW | O_CLOEXEC);
  if (descriptor < 0) failToWrite(path, errno);
  std::FILE* const file = fdopen(descriptor, "ab");
  if (file == nullptr) {
    const int code = errno;
    close(descriptor);
    failToWrite(path, code);
  }
  errno = 0;
  const bool written = std::fwrite(line.data(), 1, line.size(), file) == line.size();
  int code = written && flushToDisk(file) ? 0 : errno;
  if (std::fclose(file) != 0 && code == 0) code = errno;
  if (code != 0) failToWrite(path, code);
}

std::optional<std::string> temporaryFileOf(const std::string& name) {
  const std::size_t mark = name.rfind(kTemporaryMark);
  if (mark == std::string::npos || mark < 2 || name[0] != '.') return std::nullopt;
  const std::string letters = name.substr(mark + std::strlen(kTemporaryMark));
  if (letters.size() != kLetterCount ||
      letters.find_first_not_of("abcdefghijklmnop") != std::string::npos) {
    return std::nullopt;
  }
  return name.substr(1, mark - 1);
}

int removeLeftovers(const std::string& folder,
                    const std::function<bool(const std::string& name)>& isOurs) {
  int removed = 0;
  std::error_code failure;
  fs::directory_iterator entry(folder, failure);
  for (; !failure && entry != fs::directory_iterator(); entry.increment(failure)) {
    const std::optional<std::string> file = temporaryFileOf(entry->path().filename().string());
    if (!file || (*file != kProbeName && !isOurs(*file))) continue;
    std::error_code ignored;
    if (fs::remove(entry->path(), ignored)) ++removed;
  }
  return removed;
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
  const CreatedFile probe = createTemporary(folder + "/" + kProbeName);
  if (probe.descriptor < 0) failToWriteIn(folder, errno);
  close(probe.descriptor);
  std::remove(probe.path.c_str());
}

}  // namespace fluidymation
