// Any file as a flow file: Middlebury's .flo, or a PNG file as KITTI has it.
#include <algorithm>
#include <cmath>
#include <cstdint>

#include "fluidymation/core/error.h"
#include "fluidymation/io/flow_file.h"
#include "fluidymation/io/png.h"
#include "fuzz_target.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t byteCount) {
  using namespace fluidymation;
  constexpr std::int64_t kMostPixels = 1 << 18;  // more takes so long that little else is tried
  const fuzz::MemoryFile file(data, byteCount);
  try {
    const Size size = readFlowSize(file.path());
    fuzz::require(size.width >= 1 && size.height >= 1 && size.width <= kMaxImageSidePx &&
                      size.height <= kMaxImageSidePx,
                  "a size lies within the limits");
    if (std::int64_t{size.width} * size.height > kMostPixels) return 0;
    const Image<Vec2> flow = readFlow(file.path(), size);
    fuzz::require(flow.size() == size, "a flow has the size its header claims");
    fuzz::require(std::all_of(flow.begin(), flow.end(),
                              [](Vec2 v) {
                                return std::abs(v.x) <= kMaxFlowPx && std::abs(v.y) <= kMaxFlowPx;
                              }),
                  "vectors are finite and within the limit");
  } catch (const Error& error) {
    fuzz::requireNaming(error.what(), file.path());
  }
  return 0;
}
