#include "fluidymation/synthesis/detail_restoration.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "fluidymation/core/box.h"
#include "fluidymation/core/parallel.h"
#include "fluidymation/guides/distance_field.h"
#include "fluidymation/guides/gaussian.h"

namespace fluidymation {
namespace {

constexpr std::size_t kBands = kDetailSigmasPx.size();
static_assert(kDetailDepths[kFirstInsideClass - 1] == 1.0F);
/// A class of a frame that has fewer pixels does not speak for it.
constexpr std::int64_t kFewestPixels = 50;
/// Over so many pixels of depth the rim's gain becomes the inside's.
constexpr float kBlendPx = 4.0F;

DetailEnergy energyOfFilm(const ExemplarLevel& film, int k) {
  Mask mask(film.size());
  forEachRow(mask.height(), [&](int y) {
    for (int x = 0; x < mask.width(); ++x) {
      mask(x, y) = film.segment(x, y, k) != Segment::kOutside ? 1 : 0;
    }
  });
  const Image<float> depthPx = signedDistance(mask);
  const Box whole{0, 0, mask.width(), mask.height()};
  const Box box = grown(boundingBox(mask), gaussianReach(kDetailSigmasPx.back()), mask.size());
  Image<Lab> picture(box.size());
  forEachRow(picture.height(), [&](int y) {
    for (int x = 0; x < picture.width(); ++x) {
      picture(x, y) = film.texel(box.beginX + x, box.beginY + y, k).color.lab();
    }
  });
  return detailEnergy(detailBands(picture, recropped(mask, whole, box)),
                      recropped(depthPx, whole, box), film.borderWidthPx());
}

/// The class of the same part, rim or inside, with enough pixels that lies nearest to `depthClass`;
/// the shallower one of two.
std::optional<std::size_t> nearestKnown(const DetailEnergy& energy, std::size_t depthClass) {
  const bool isRim = depthClass < kFirstInsideClass;
  const std::size_t begin = isRim ? 0 : kFirstInsideClass;
  const std::size_t end = isRim ? kFirstInsideClass : kDetailClasses;
  std::optional<std::size_t> best;
  const auto away = [depthClass](std::size_t c) {
    return c < depthClass ? depthClass - c : c - depthClass;
  };
  for (std::size_t c = begin; c < end; ++c) {
    if (energy.pixels(c) < kFewestPixels) continue;
    if (!best || away(c) < away(*best)) best = c;
  }
  return best;
}

/// Energy of a part, rim or inside.
struct PartEnergy {
  double pixels = 0.0;
  std::array<double, kBands> squares{};

  void add(const DetailEnergy& energy, std::size_t depthClass, double timesPixels) {
    pixels += timesPixels;
    for (std::size_t band = 0; band < kBands; ++band) {
      squares[band] += timesPixels * energy.squares(depthClass, band) /
                       static_cast<double>(energy.pixels(depthClass));
    }
  }
};

std::array<float, kBands> gainsOf(const PartEnergy& wanted, const PartEnergy& painted) {
  std::array<float, kBands> gains;
  gains.fill(1.0F);
  if (wanted.pixels == 0.0) return gains;
  for (std::size_t band = 0; band < kBands; ++band) {
    const double has = painted.squares[band] / painted.pixels;
    if (!(has > 0.0)) continue;
    const double gain =
        std::clamp(std::sqrt(wanted.squares[band] / wanted.pixels / has),
                   static_cast<double>(kLeastDetailGain), static_cast<double>(kMostDetailGain));
    const double trust = painted.pixels / (painted.pixels + static_cast<double>(kFewestPixels));
    gains[band] = static_cast<float>(1.0 + trust * (gain - 1.0));
  }
  return gains;
}

/// How many pixels of each depth show each frame of the exemplar.
std::vector<std::array<std::int64_t, kDetailClasses>> usesOf(const NearestNeighborField& nnf,
                                                             const Image<float>& depthPx,
                                                             float borderWidthPx, int frames) {
  std::vector<std::array<std::int64_t, kDetailClasses>> uses(static_cast<std::size_t>(frames));
  for (int y = 0; y < nnf.height(); ++y) {
    for (int x = 0; x < nnf.width(); ++x) {
      if (!nnf(x, y).exists()) continue;
      const auto depthClass = detailClass(depthPx(x, y), borderWidthPx);
      if (depthClass) ++uses[static_cast<std::size_t>(nnf(x, y).frame)][*depthClass];
    }
  }
  return uses;
}

}  // namespace

const DetailEnergy& FilmDetail::of(const Exemplar& exemplar, int k) {
  const auto found = known_.find(exemplar.firstFrame() + k);
  if (found != known_.end()) return found->second;
  return known_.emplace(exemplar.firstFrame() + k, energyOfFilm(exemplar.level(0), k))
      .first->second;
}

DetailGains detailGains(const Exemplar& exemplar, FilmDetail& film, const NearestNeighborField& nnf,
                        const Image<float>& depthPx, const DetailEnergy& painted) {
  const ExemplarLevel& finest = exemplar.level(0);
  const auto uses = usesOf(nnf, depthPx, finest.borderWidthPx(), finest.frameCount());
  struct Part {
    PartEnergy wanted;
    PartEnergy painted;
  };
  std::array<Part, 2> parts;  // rim, inside
  const auto partOf = [&parts](std::size_t depthClass) -> Part& {
    return parts[depthClass < kFirstInsideClass ? 0 : 1];
  };
  for (std::size_t k = 0; k < uses.size(); ++k) {
    for (std::size_t c = 0; c < kDetailClasses; ++c) {
      if (uses[k][c] == 0 || painted.pixels(c) == 0) continue;
      const auto pixels = static_cast<double>(uses[k][c]);
      const DetailEnergy& energy = film.of(exemplar, static_cast<int>(k));
      const auto known = nearestKnown(energy, c);
      if (!known) continue;
      // Either side has the same pixels, or else depths would be compared with others
      partOf(c).wanted.add(energy, *known, pixels);
      partOf(c).painted.add(painted, c, pixels);
    }
  }
  return {gainsOf(parts[0].wanted, parts[0].painted), gainsOf(parts[1].wanted, parts[1].painted)};
}

void restoreDetail(const Exemplar& exemplar, FilmDetail& film, const NearestNeighborField& nnf,
                   const Mask& mask, const Image<float>& depthPx, float share,
                   Image<Lab>& picture) {
  assert(picture.size() == mask.size() && picture.size() == depthPx.size());
  if (share == 0.0F) return;
  const float borderWidthPx = exemplar.level(0).borderWidthPx();
  const DetailBands bands = detailBands(picture, mask);
  const DetailGains gains =
      detailGains(exemplar, film, nnf, depthPx, detailEnergy(bands, depthPx, borderWidthPx));
  forEachRow(picture.height(), [&](int y) {
    for (int x = 0; x < picture.width(); ++x) {
      if (mask(x, y) == 0) continue;
      const float inside =
          std::clamp((depthPx(x, y) - borderWidthPx) / kBlendPx + 0.5F, 0.0F, 1.0F);
      Lab& color = picture(x, y);
      for (std::size_t band = 0; band < kBands; ++band) {
        const float gain = gains.rim[band] + inside * (gains.inside[band] - gains.rim[band]);
        const float more = share * (gain - 1.0F);
        const Lab& detail = bands[band](x, y);
        color = {color.l + more * detail.l, color.a + more * detail.a, color.b + more * detail.b};
      }
    }
  });
}

}  // namespace fluidymation
