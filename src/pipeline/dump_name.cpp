#include "pipeline/dump_name.h"

#include "fluidymation/io/frame_pattern.h"

namespace fluidymation {
namespace {

constexpr const char* kNumberPattern = "%05d";

}  // namespace

std::string dumpStem(const std::string& folder, int frameNumber) {
  return folder + "/" + FramePattern(kNumberPattern).path(frameNumber);
}

bool isDumpName(const std::string& fileName) {
  const std::size_t dot = fileName.find('.');
  return dot != fileName.rfind('.') &&
         FramePattern(kNumberPattern).numberOf(fileName.substr(0, dot)).has_value();
}

}  // namespace fluidymation
