#pragma once

#include <cstdint>
#include <string>

namespace fluidymation {

/// What tells whether a file is still the one it was, without reading it. A file that is replaced
/// is another one, though its content may be the same; one that was changed within the resolution
/// of the file system's clock, its length kept, is not noticed.
struct FileIdentity {
  std::uint64_t device = 0;
  std::uint64_t inode = 0;
  std::int64_t byteCount = 0;
  std::int64_t changedSeconds = 0;  ///< when its content was changed last
  std::int64_t changedNanoseconds = 0;

  friend bool operator==(const FileIdentity& a, const FileIdentity& b) {
    return a.device == b.device && a.inode == b.inode && a.byteCount == b.byteCount &&
           a.changedSeconds == b.changedSeconds && a.changedNanoseconds == b.changedNanoseconds;
  }
  friend bool operator!=(const FileIdentity& a, const FileIdentity& b) { return !(a == b); }
};

/// @throws Error naming the file when it is not there.
[[nodiscard]] FileIdentity fileIdentityOf(const std::string& path);

/// To be called after a file was read: what was read may be something else than what the run has
/// taken the digest of.
/// @param before  of the time when the run began.
/// @throws Error naming the file when it is not the one it was.
void requireUnchanged(const std::string& path, const FileIdentity& before);

}  // namespace fluidymation
