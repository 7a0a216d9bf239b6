#include "fluidymation/io/file_identity.h"

#include <sys/stat.h>

#include <cerrno>
#include <system_error>

#include "fluidymation/core/error.h"

namespace fluidymation {

FileIdentity fileIdentityOf(const std::string& path) {
  struct stat status {};
  if (stat(path.c_str(), &status) != 0) {
    throw Error(path + ": cannot be opened (" + std::generic_category().message(errno) + ")");
  }
  FileIdentity identity;
  identity.device = status.st_dev;
  identity.inode = status.st_ino;
  identity.byteCount = status.st_size;
  identity.changedSeconds = status.st_mtim.tv_sec;
  identity.changedNanoseconds = status.st_mtim.tv_nsec;
  return identity;
}

void requireUnchanged(const std::string& path, const FileIdentity& before) {
  const FileIdentity now = fileIdentityOf(path);
  if (now == before) return;
  std::string what = "it was written to";
  if (now.inode != before.inode || now.device != before.device)
    what = "another file took its place";
  if (now.byteCount != before.byteCount) {
    what += ", " + std::to_string(before.byteCount) + " bytes at first, then " +
            std::to_string(now.byteCount);
  }
  throw Error(path + ": changed while the run was at work (" + what +
              "); wanted inputs that stay as they are until all is painted");
}

}  // namespace fluidymation
