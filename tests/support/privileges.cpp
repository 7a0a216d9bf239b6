#include "support/privileges.h"

#include <grp.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <system_error>

namespace fluidymation::test {
namespace {

constexpr uid_t kNobody = 65534;
constexpr gid_t kNogroup = 65534;
constexpr int kRefused = 126;  // exit code

void give(const std::string& path) {
  if (lchown(path.c_str(), kNobody, kNogroup) != 0) {
    throw std::system_error(errno, std::generic_category(), "lchown " + path);
  }
}

}  // namespace

bool mayDoEverything() { return geteuid() == 0; }

void giveAway(const std::string& folder) {
  if (!mayDoEverything()) return;
  give(folder);
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    give(entry.path().string());
  }
}

void dropPrivileges() {
  if (!mayDoEverything()) return;
  if (setgroups(0, nullptr) != 0 || setgid(kNogroup) != 0 || setuid(kNobody) != 0) _exit(kRefused);
}

}  // namespace fluidymation::test
