#include "cli/thread_waiting.h"

#include <unistd.h>

#include <array>
#include <cstdlib>
#include <filesystem>
#include <system_error>

namespace fluidymation::cli {
namespace {

struct Setting {
  const char* name;
  const char* value;
};

/// Read by OpenMP's runtimes; the second by GCC's alone, in place of the first. A thousand turns, a
/// few microseconds, bridge the gap between two loops, and cost no time where nobody else works.
constexpr std::array<Setting, 2> kSettings{
    {{"OMP_WAIT_POLICY", "passive"}, {"GOMP_SPINCOUNT", "1000"}}};

}  // namespace

void keepWaitingThreadsFromSpinning(char* const* argv) {
  // NOLINTBEGIN(concurrency-mt-unsafe): no thread has been started yet
  for (const Setting& setting : kSettings) {
    if (std::getenv(setting.name) != nullptr) return;
  }
  // By its path, for a process goes by the name of the file it was started from
  std::error_code error;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", error);
  if (error) return;
  // The loader, where it was started with this program as its argument
  if (program.filename().string().rfind("ld-", 0) == 0) return;
  for (const Setting& setting : kSettings) {
    if (setenv(setting.name, setting.value, 0) != 0) return;  // else this would begin anew for ever
  }
  // NOLINTEND(concurrency-mt-unsafe)
  execv(program.c_str(), argv);  // returns only where it fails; then threads wait as they always do
}

}  // namespace fluidymation::cli
