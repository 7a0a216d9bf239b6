#include "fluidymation/synthesis/painted_vote.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "fluidymation/core/parallel.h"
#include "synthesis/sampling.h"
#include "synthesis/seam_blend.h"

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

/// A window that covers a pixel: where its centre lies from there, and its weight relative to one
/// centred on the pixel itself.
struct Voter {
  int dx = 0;
  int dy = 0;
  float weight = 0.0F;
};

/// Averages over the windows that cover a pixel. `read(frame, x, y)` reads the exemplar; where none
/// of the voters has a match, the nearest windows count alike.
/// @param trust  (x, y, match): how much a window counts besides, by where it has the pixel.
template <typename Reader, typename Trust>
Image<Lab> average(const NearestNeighborField& nnf, const Mask& wanted, const Reader& read,
                   const std::vector<Voter>& voters, const Trust& trust) {
  // Where the voters are trusted less than this, relative to a window centred on the pixel that has
  // it at its depth, all windows that cover the pixel are heard.
  constexpr float kDoubt = 0.1F;
  const Size size = nnf.size();
  Image<Lab> picture(size);
  forEachRow(size.height, [&](int y) {
    for (int x = 0; x < size.width; ++x) {
      if (wanted(x, y) == 0) continue;
      Float4 sum{};
      float weights = 0.0F;
      // Neighbouring windows mostly continue each other and read the same place
      Match lastRead;
      Float4 last{};
      const auto add = [&](int nx, int ny, float weight) {
        const Match here =
            nnf(nx, ny).moved({static_cast<float>(x - nx), static_cast<float>(y - ny)});
        if (!areAlike(here, lastRead)) {
          last = read(here.frame, here.x, here.y);
          lastRead = here;
        }
        const float trusted = weight * trust(x, y, here);
        sum += trusted * last;
        weights += trusted;
      };
      for (const Voter& voter : voters) {
        const int nx = x + voter.dx;
        const int ny = y + voter.dy;
        if (nnf.contains(nx, ny) && nnf(nx, ny).exists()) add(nx, ny, voter.weight);
      }
      if (weights > 0.0F && weights < kDoubt) {
        sum = Float4{};
        weights = 0.0F;
        forEachWindow(nnf, x, y, [&](int nx, int ny) { add(nx, ny, 1.0F); });
      }
      if (weights == 0.0F) {
        const int nearest = nearestWindow(nnf, x, y);
        forEachWindow(nnf, x, y, [&](int nx, int ny) {
          if ((x - nx) * (x - nx) + (y - ny) * (y - ny) == nearest) add(nx, ny, 1.0F);
        });
      }
      if (weights == 0.0F) continue;
      const float share = 1.0F / weights;
      picture(x, y) = {share * sum[0], share * sum[1], share * sum[2]};
    }
  });
  return picture;
}

/// Weighs windows by the depths of exemplar and target; see VoteOptions::depthSigmaPx.
class DepthTrust {
 public:
  /// @param guides  of the target; null where all windows count alike.
  DepthTrust(const ExemplarLevel& exemplar, const Image<FixedGuides>* guides, float sigmaPx)
      : exemplar_(exemplar), guides_(sigmaPx > 0.0F ? guides : nullptr) {
    if (guides_ == nullptr) return;
    const float sigmaSteps = sigmaPx / exemplar.borderWidthPx() * kEdgeScale * kEdgeSteps;
    scale_ = -0.5F / (sigmaSteps * sigmaSteps);
  }

  [[nodiscard]] float operator()(int x, int y, const Match& match) const {
    if (guides_ == nullptr) return 1.0F;
    // However far off, a window counts where there is no better one
    constexpr float kLeastTrust = 1e-6F;
    const int sx = std::clamp(match.nearestX(), 0, exemplar_.size().width - 1);
    const int sy = std::clamp(match.nearestY(), 0, exemplar_.size().height - 1);
    const auto apart = static_cast<float>((*guides_)(x, y).edge -
                                          exemplar_.texel(sx, sy, match.frame).guides.edge);
    return std::max(std::exp(scale_ * apart * apart), kLeastTrust);
  }

 private:
  const ExemplarLevel& exemplar_;
  const Image<FixedGuides>* guides_;
  float scale_ = 0.0F;  ///< per square of a step of the edge guide
};

/// By how much the step from one pixel to the next should be another one. The window of either,
/// continued, shows both pixels, and so a step of the film. The larger of the two is wanted, by how
/// much it is trusted: the mean of two that do not agree has half their energy. Within a piece of
/// the exemplar, and beside a pixel without a match of its own, the step is to stay as it is.
/// @param picture  the windows' mean.
/// @return  in the last lane how much the step counts, see WantedSteps.
template <typename Reader, typename Trust>
Float4 wantedStep(const NearestNeighborField& nnf, Pixel from, Pixel to, const Reader& read,
                  const Trust& trust, const Image<Lab>& picture) {
  const Match& own = nnf(from.x, from.y);
  const Match& other = nnf(to.x, to.y);
  constexpr Float4 kAsItIs{0.0F, 0.0F, 0.0F, 1.0F};
  if (!own.exists() || !other.exists()) return kAsItIs;
  const Vec2 step{static_cast<float>(to.x - from.x), static_cast<float>(to.y - from.y)};
  const Match ownThere = own.moved(step);
  if (areAlike(ownThere, other)) return kAsItIs;
  const Match otherHere = other.moved({-step.x, -step.y});
  const auto colorOf = [&](const Match& match) { return read(match.frame, match.x, match.y); };
  const auto squared = [](const Float4& v) { return v[0] * v[0] + v[1] * v[1] + v[2] * v[2]; };
  const Float4 inOwn = colorOf(ownThere) - colorOf(own);
  const Float4 inOther = colorOf(other) - colorOf(otherHere);
  const float trustInOwn = trust(from.x, from.y, own) * trust(to.x, to.y, ownThere);
  const float trustInOther = trust(from.x, from.y, otherHere) * trust(to.x, to.y, other);
  const bool ownIsLarger = trustInOwn * squared(inOwn) >= trustInOther * squared(inOther);
  const Lab& here = picture(from.x, from.y);
  const Lab& there = picture(to.x, to.y);
  Float4 wanted = ownIsLarger ? inOwn : inOther;
  wanted -= Float4{there.l - here.l, there.a - here.a, there.b - here.b, 0.0F};
  wanted[3] = ownIsLarger ? trustInOwn : trustInOther;
  return wanted;
}

/// Changes the picture where the windows of neighbouring pixels do not continue each other, see
/// VoteOptions::seamWeight.
template <typename Reader, typename Trust>
void blendSeams(const NearestNeighborField& nnf, const Mask& wanted, const Reader& read,
                const Trust& trust, float seamWeight, Image<Lab>& picture) {
  const Size size = nnf.size();
  WantedSteps steps(size);
  forEachRow(size.height, [&](int y) {
    for (int x = 0; x < size.width; ++x) {
      if (wanted(x, y) == 0) continue;
      const auto stepTo = [&](int nx, int ny) {
        return nnf.contains(nx, ny) && wanted(nx, ny) != 0
                   ? wantedStep(nnf, {x, y}, {nx, ny}, read, trust, picture)
                   : Float4{};
      };
      steps.right(x, y) = stepTo(x + 1, y);
      steps.down(x, y) = stepTo(x, y + 1);
    }
  });
  const Image<Float4> changes = seamChanges(steps, seamWeight);
  forEachRow(size.height, [&](int y) {
    for (int x = 0; x < size.width; ++x) {
      if (wanted(x, y) == 0) continue;
      Lab& color = picture(x, y);
      const Float4& change = changes(x, y);
      color = {color.l + change[0], color.a + change[1], color.b + change[2]};
    }
  });
}

/// All windows with a Gaussian weight worth counting; with sigma 0 all alike.
std::vector<Voter> votersOf(float sigmaPx) {
  constexpr float kNoWeight = 1e-3F;  // too little to be seen beside the pixel's own window
  const auto along = [sigmaPx](int offset) {
    const float t = sigmaPx > 0.0F ? static_cast<float>(offset) / sigmaPx : 0.0F;
    return std::exp(-0.5F * t * t);
  };
  std::vector<Voter> voters;
  for (int dy = -kPatchRadius; dy <= kPatchRadius; ++dy) {
    for (int dx = -kPatchRadius; dx <= kPatchRadius; ++dx) {
      const float weight = along(dx) * along(dy);
      if (weight >= kNoWeight) voters.push_back({dx, dy, weight});
    }
  }
  return voters;
}

}  // namespace

Image<Lab> paintedVote(const ExemplarLevel& exemplar, const Mask& wanted,
                       const NearestNeighborField& nnf, const VoteOptions& options,
                       const Image<FixedGuides>* guides) {
  const std::vector<Voter> voters = votersOf(options.sigmaPx);
  const DepthTrust trust(exemplar, guides, options.depthSigmaPx);
  const auto averaged = [&](const auto& read) {
    const auto reader = [&](int frame, float x, float y) { return read(exemplar, frame, x, y); };
    Image<Lab> picture = average(nnf, wanted, reader, voters, trust);
    if (options.seamWeight > 0.0F) {
      blendSeams(nnf, wanted, reader, trust, options.seamWeight, picture);
    }
    return picture;
  };
  switch (options.interpolation) {
    case Interpolation::kBilinear:
      return averaged(sampleBilinear);
    case Interpolation::kCubic:
      return averaged(sampleCubic);
    case Interpolation::kLanczos:
      break;
  }
  const LanczosKernel kernel;
  return averaged([&kernel](const ExemplarLevel& level, int frame, float x, float y) {
    return sampleLanczos(kernel, level, frame, x, y);
  });
}

}  // namespace fluidymation
