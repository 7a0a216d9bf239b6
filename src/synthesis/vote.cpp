#include "fluidymation/synthesis/vote.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

#include "fluidymation/core/parallel.h"
#include "fluidymation/synthesis/sampling.h"

namespace fluidymation {
namespace {

/// Averages over the windows that cover a pixel. `read(frame, x, y)` reads the exemplar,
/// `weightOf(dx, dy)` is the weight of a window whose centre lies that far away.
template <typename Reader, typename WeightOf>
VotedPicture average(const Image<Segment>& segment, const NearestNeighborField& nnf,
                     const Reader& read, const WeightOf& weightOf) {
  const Size size = nnf.size();
  VotedPicture picture{Image<Lab>(size), Mask(size)};
  forEachRow(size.height, [&](int y) {
    for (int x = 0; x < size.width; ++x) {
      if (segment(x, y) == Segment::kOutside) continue;
      Float4 sum{};
      float weights = 0.0F;
      for (int ny = std::max(y - kPatchRadius, 0);
           ny <= std::min(y + kPatchRadius, size.height - 1); ++ny) {
        for (int nx = std::max(x - kPatchRadius, 0);
             nx <= std::min(x + kPatchRadius, size.width - 1); ++nx) {
          if (!nnf(nx, ny).exists()) continue;
          const Match here =
              nnf(nx, ny).moved({static_cast<float>(x - nx), static_cast<float>(y - ny)});
          const float weight = weightOf(x - nx, y - ny);
          sum += weight * read(here.frame, here.x, here.y);
          weights += weight;
        }
      }
      if (weights == 0.0F) continue;
      const float share = 1.0F / weights;
      picture.color(x, y) = {share * sum[0], share * sum[1], share * sum[2]};
      picture.exists(x, y) = 1;
    }
  });
  return picture;
}

/// Reads one exemplar level between its pixels.
class BilinearReader {
 public:
  explicit BilinearReader(const ExemplarLevel& exemplar) : exemplar_(exemplar) {}
  [[nodiscard]] Float4 operator()(int frame, float x, float y) const {
    return sampleClamped(exemplar_.frame(frame), exemplar_.size(), x, y).low;
  }

 private:
  const ExemplarLevel& exemplar_;
};

class CubicReader {
 public:
  explicit CubicReader(const ExemplarLevel& exemplar) : exemplar_(exemplar) {}
  [[nodiscard]] Float4 operator()(int frame, float x, float y) const {
    return sampleCubic(exemplar_.frame(frame), exemplar_.size(), x, y);
  }

 private:
  const ExemplarLevel& exemplar_;
};

/// Weights for distances 0..kPatchRadius along one axis; not normalized.
std::array<float, kPatchRadius + 1> windowWeights(float sigmaPx) {
  std::array<float, kPatchRadius + 1> weights{};
  for (std::size_t d = 0; d < weights.size(); ++d) {
    const float t = sigmaPx > 0.0F ? static_cast<float>(d) / sigmaPx : 0.0F;
    weights[d] = std::exp(-0.5F * t * t);
  }
  return weights;
}

}  // namespace

VotedPicture vote(const ExemplarLevel& exemplar, const Image<Segment>& segment,
                  const NearestNeighborField& nnf) {
  return average(segment, nnf, BilinearReader(exemplar), [](int, int) { return 1.0F; });
}

VotedPicture paintedVote(const ExemplarLevel& exemplar, const Image<Segment>& segment,
                         const NearestNeighborField& nnf, const VoteOptions& options) {
  const auto weights = windowWeights(options.sigmaPx);
  const auto weightOf = [&weights](int dx, int dy) {
    return weights[static_cast<std::size_t>(std::abs(dx))] *
           weights[static_cast<std::size_t>(std::abs(dy))];
  };
  if (options.interpolation == Interpolation::kCubic) {
    return average(segment, nnf, CubicReader(exemplar), weightOf);
  }
  return average(segment, nnf, BilinearReader(exemplar), weightOf);
}

}  // namespace fluidymation
