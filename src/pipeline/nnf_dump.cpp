#include "pipeline/nnf_dump.h"

#include <cstddef>
#include <cstdint>
#include <limits>

#include "fluidymation/core/color.h"
#include "fluidymation/io/atomic_file.h"
#include "fluidymation/io/pfm.h"
#include "fluidymation/io/png.h"
#include "pipeline/dump_name.h"

namespace fluidymation {
namespace {

std::uint8_t share(float value, int extent) {
  const float relative = extent > 1 ? value / static_cast<float>(extent - 1) : 0.0F;
  return toByte(relative);
}

}  // namespace

void dumpNearestNeighborField(const std::string& folder, int frameNumber,
                              const NearestNeighborField& nnf,
                              const std::vector<int>& sourceNumbers, Size exemplarSize) {
  constexpr float kNoMatch = std::numeric_limits<float>::quiet_NaN();
  Image<Float3> coordinates(nnf.size(), Float3{kNoMatch, kNoMatch, kNoMatch});
  Image<float> angles(nnf.size());
  Image<Rgba8> picture(nnf.size());
  const int frameCount = static_cast<int>(sourceNumbers.size());
  for (int y = 0; y < nnf.height(); ++y) {
    for (int x = 0; x < nnf.width(); ++x) {
      const Match& match = nnf(x, y);
      if (!match.exists()) continue;
      const auto number = static_cast<float>(sourceNumbers[static_cast<std::size_t>(match.frame)]);
      coordinates(x, y) = {match.x, match.y, number};
      angles(x, y) = match.rotation.angleRad();
      picture(x, y) = {share(match.x, exemplarSize.width),
                       share(static_cast<float>(match.frame), frameCount),
                       share(match.y, exemplarSize.height), 255};
    }
  }
  createFolder(folder);
  const std::string stem = dumpStem(folder, frameNumber);
  writePfm(stem + ".nnf.pfm", coordinates);
  writePfm(stem + ".theta.pfm", angles);
  writePng(stem + ".nnf.png", picture);
}

}  // namespace fluidymation
