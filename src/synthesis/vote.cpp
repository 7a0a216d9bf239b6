#include "fluidymation/synthesis/vote.h"

#include <algorithm>

#include "fluidymation/core/parallel.h"
#include "fluidymation/synthesis/sampling.h"

namespace fluidymation {

VotedPicture vote(const ExemplarLevel& exemplar, const Image<Segment>& segment,
                  const NearestNeighborField& nnf) {
  const Size size = nnf.size();
  VotedPicture picture{Image<Lab>(size), Mask(size)};
  forEachRow(size.height, [&](int y) {
    for (int x = 0; x < size.width; ++x) {
      if (segment(x, y) == Segment::kOutside) continue;
      Float4 sum{};
      int votes = 0;
      for (int ny = std::max(y - kPatchRadius, 0);
           ny <= std::min(y + kPatchRadius, size.height - 1); ++ny) {
        for (int nx = std::max(x - kPatchRadius, 0);
             nx <= std::min(x + kPatchRadius, size.width - 1); ++nx) {
          if (!nnf(nx, ny).exists()) continue;
          const Match here =
              nnf(nx, ny).moved({static_cast<float>(x - nx), static_cast<float>(y - ny)});
          sum += sampleClamped(exemplar.frame(here.frame), exemplar.size(), here.x, here.y).low;
          ++votes;
        }
      }
      if (votes == 0) continue;
      const float share = 1.0F / static_cast<float>(votes);
      picture.color(x, y) = {share * sum[0], share * sum[1], share * sum[2]};
      picture.exists(x, y) = 1;
    }
  });
  return picture;
}

}  // namespace fluidymation
