#include "pipeline/machine_memory.h"

#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>
#include <system_error>

namespace fluidymation {
namespace {

constexpr std::int64_t kNoLimit = std::numeric_limits<std::int64_t>::max();

/// The number a file begins with; no limit where there is none ("max").
std::int64_t limitIn(const std::string& path) {
  std::ifstream file(path);
  std::string word;
  if (!(file >> word)) return kNoLimit;
  std::int64_t bytes = 0;
  const auto [stop, failure] = std::from_chars(word.data(), word.data() + word.size(), bytes);
  return failure == std::errc{} && bytes > 0 ? bytes : kNoLimit;
}

/// The least limit of a group and those above it. In a container the path may be one that only the
/// host knows: then the root's own files are those of the container.
std::int64_t leastLimit(const std::string& root, std::string group, const std::string& file) {
  const std::filesystem::path folder(root);
  std::int64_t least = limitIn((folder / file).string());
  while (group.size() > 1 && group.front() == '/') {
    least = std::min(least, limitIn((folder / group.substr(1) / file).string()));
    group.erase(group.rfind('/'));
  }
  return least;
}

bool hasMemory(const std::string& controllers) {
  std::istringstream names(controllers);
  for (std::string name; std::getline(names, name, ',');) {
    if (name == "memory") return true;
  }
  return false;
}

}  // namespace

std::int64_t groupMemoryBytes(const std::string& processGroups, const std::string& root) {
  std::int64_t least = kNoLimit;
  std::istringstream lines(processGroups);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t first = line.find(':');
    const std::size_t second = first == std::string::npos ? first : line.find(':', first + 1);
    if (second == std::string::npos) continue;
    const std::string controllers = line.substr(first + 1, second - first - 1);
    const std::string group = line.substr(second + 1);
    if (controllers.empty()) {  // version 2
      least = std::min(least, leastLimit(root, group, "memory.max"));
    } else if (hasMemory(controllers)) {
      least = std::min(least, leastLimit(root + "/memory", group, "memory.limit_in_bytes"));
    }
  }
  return least;
}

std::int64_t machineMemoryBytes() {
  const std::int64_t pages = sysconf(_SC_PHYS_PAGES);
  const std::int64_t pageBytes = sysconf(_SC_PAGESIZE);
  const std::int64_t machine = pages > 0 && pageBytes > 0 ? pages * pageBytes : kNoLimit;
  std::ifstream file("/proc/self/cgroup");
  std::ostringstream groups;
  groups << file.rdbuf();
  return std::min(machine, groupMemoryBytes(groups.str(), "/sys/fs/cgroup"));
}

}  // namespace fluidymation
