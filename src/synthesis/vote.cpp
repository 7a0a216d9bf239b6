#include "fluidymation/synthesis/vote.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

#include "fluidymation/core/parallel.h"
#include "fluidymation/synthesis/sampling.h"

namespace fluidymation {
namespace {

/// `visit(nx, ny)` for the centres of the windows that cover (x, y) and have a match.
template <typename Visit>
void forEachWindow(const NearestNeighborField& nnf, int x, int y, const Visit& visit) {
  for (int ny = std::max(y - kPatchRadius, 0); ny <= std::min(y + kPatchRadius, nnf.height() - 1);
       ++ny) {
    for (int nx = std::max(x - kPatchRadius, 0); nx <= std::min(x + kPatchRadius, nnf.width() - 1);
         ++nx) {
      if (nnf(nx, ny).exists()) visit(nx, ny);
    }
  }
}

/// Square of the distance to the nearest centre of a window that covers (x, y); larger than any
/// where none does.
int nearestWindow(const NearestNeighborField& nnf, int x, int y) {
  int nearest = 2 * kPatchRadius * kPatchRadius + 1;
  forEachWindow(nnf, x, y, [&](int nx, int ny) {
    nearest = std::min(nearest, (x - nx) * (x - nx) + (y - ny) * (y - ny));
  });
  return nearest;
}

/// Averages over the windows that cover a pixel. `wanted(x, y)` tells whether it has to be known,
/// `read(frame, x, y)` reads the exemplar, `weightOf(dx, dy)` is the weight of a window whose
/// centre lies that far away, relative to one centred on the pixel itself; where no window has any,
/// the nearest ones count alike.
template <typename Wanted, typename Reader, typename WeightOf>
VotedPicture average(const NearestNeighborField& nnf, const Wanted& wanted, const Reader& read,
                     const WeightOf& weightOf) {
  constexpr float kNoWeight = 1e-3F;  // too little to be seen beside the pixel's own window
  const Size size = nnf.size();
  VotedPicture picture{Image<Lab>(size), Mask(size)};
  forEachRow(size.height, [&](int y) {
    for (int x = 0; x < size.width; ++x) {
      if (!wanted(x, y)) continue;
      Float4 sum{};
      float weights = 0.0F;
      const auto add = [&](int nx, int ny, float weight) {
        const Match here =
            nnf(nx, ny).moved({static_cast<float>(x - nx), static_cast<float>(y - ny)});
        sum += weight * read(here.frame, here.x, here.y);
        weights += weight;
      };
      forEachWindow(nnf, x, y, [&](int nx, int ny) {
        const float weight = weightOf(x - nx, y - ny);
        if (weight >= kNoWeight) add(nx, ny, weight);
      });
      if (weights == 0.0F) {
        const int nearest = nearestWindow(nnf, x, y);
        forEachWindow(nnf, x, y, [&](int nx, int ny) {
          if ((x - nx) * (x - nx) + (y - ny) * (y - ny) == nearest) add(nx, ny, 1.0F);
        });
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

class LanczosReader {
 public:
  explicit LanczosReader(const ExemplarLevel& exemplar) : exemplar_(exemplar) {}
  [[nodiscard]] Float4 operator()(int frame, float x, float y) const {
    return sampleLanczos(kernel_, exemplar_.frame(frame), exemplar_.size(), x, y);
  }

 private:
  const ExemplarLevel& exemplar_;
  LanczosKernel kernel_;
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
  return average(
      nnf, [&segment](int x, int y) { return segment(x, y) != Segment::kOutside; },
      BilinearReader(exemplar), [](int, int) { return 1.0F; });
}

VotedPicture paintedVote(const ExemplarLevel& exemplar, const Mask& wanted,
                         const NearestNeighborField& nnf, const VoteOptions& options) {
  const auto isWanted = [&wanted](int x, int y) { return wanted(x, y) != 0; };
  const auto weights = windowWeights(options.sigmaPx);
  const auto weightOf = [&weights](int dx, int dy) {
    return weights[static_cast<std::size_t>(std::abs(dx))] *
           weights[static_cast<std::size_t>(std::abs(dy))];
  };
  switch (options.interpolation) {
    case Interpolation::kBilinear:
      return average(nnf, isWanted, BilinearReader(exemplar), weightOf);
    case Interpolation::kCubic:
      return average(nnf, isWanted, CubicReader(exemplar), weightOf);
    case Interpolation::kLanczos:
      break;
  }
  return average(nnf, isWanted, LanczosReader(exemplar), weightOf);
}

}  // namespace fluidymation
