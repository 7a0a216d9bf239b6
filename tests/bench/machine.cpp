#include "bench/machine.h"

#include <fstream>
#include <map>
#include <thread>

#include "commit.h"

namespace fluidymation::bench {
namespace {

/// The first processor's entries of /proc/cpuinfo; empty where there is no such file.
std::map<std::string, std::string> processorInfo() {
  std::map<std::string, std::string> entries;
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line) && !line.empty();) {
    const std::size_t colon = line.find(':');
    if (colon == std::string::npos) continue;
    const std::size_t nameEnd = line.find_last_not_of(" \t", colon - 1);
    const std::size_t valueBegin = line.find_first_not_of(" \t", colon + 1);
    if (nameEnd == std::string::npos || valueBegin == std::string::npos) continue;
    entries[line.substr(0, nameEnd + 1)] = line.substr(valueBegin);
  }
  return entries;
}

std::string processor() {
  std::map<std::string, std::string> info = processorInfo();
  std::string text = info.count("model name") != 0 ? info["model name"] : "unknown";
  if (info.count("cpu family") != 0 && info.count("model") != 0) {
    text += ", family " + info["cpu family"] + " model " + info["model"];
  }
  return text + ", " + std::to_string(std::thread::hardware_concurrency()) + " logical processors";
}

}  // namespace

Facts factsOfMachine(int threads) {
  return {{"commit", FLUIDYMATION_COMMIT},
          {"compiler", FLUIDYMATION_COMPILER},
          {"flags", FLUIDYMATION_COMPILER_FLAGS},
          {"processor", processor()},
          {"threads", std::to_string(threads)}};
}

}  // namespace fluidymation::bench
