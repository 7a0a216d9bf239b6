#pragma once

#include <map>

#include "fluidymation/core/color.h"
#include "fluidymation/core/image.h"
#include "fluidymation/synthesis/detail_bands.h"
#include "fluidymation/synthesis/exemplar.h"
#include "fluidymation/synthesis/nnf.h"

namespace fluidymation {

/// One frame of the film in so many is looked at: its detail changes slowly.
inline constexpr int kDetailEvery = 4;

/// The detail of the film's frames, of each as soon as it is asked for.
class FilmDetail {
 public:
  /// Of frame `k` of those that the exemplar holds, or one within kDetailEvery frames of it. Which
  /// one depends on the frame and on what is held alone, not on what was asked for before.
  [[nodiscard]] const DetailEnergy& of(const Exemplar& exemplar, int k);

 private:
  std::map<int, DetailEnergy> known_;  ///< by their numbers in the whole film
};

/// What a band of the rim and of the inside is multiplied by.
struct DetailGains {
  std::array<float, kDetailSigmasPx.size()> rim{1.0F, 1.0F};
  std::array<float, kDetailSigmasPx.size()> inside{1.0F, 1.0F};
};

/// Bounds of gains. Where a painting lacks more, what it shows is another part of the film, which
/// has less detail of its own; to enlarge that leaves specks (docs/quality.md).
inline constexpr float kLeastDetailGain = 0.75F;
inline constexpr float kMostDetailGain = 1.25F;

/// The gains that bring a painting's energy to the film's: to that of the film on average at the
/// depth of each pixel, in the frame of its match. They tend to 1 for few pixels, as
/// n / (n + 50).
/// @param painted  the picture's energy.
/// @param depthPx  distance to the edge, positive inside; of the size of `nnf`.
[[nodiscard]] DetailGains detailGains(const Exemplar& exemplar, FilmDetail& film,
                                      const NearestNeighborField& nnf, const Image<float>& depthPx,
                                      const DetailEnergy& painted);

/// Brings the finest detail of a painted picture to the film's own energy: averaging and smooth
/// matches have taken from it, and seams have added to it. What the film has as energy depends on
/// its rim and inside, on how deep a place lies and on the film's time; within rim and inside a
/// painting's detail is enlarged or made smaller as a whole, so that it stays where it is. Not in
/// the thesis; docs/quality.md has the figures.
/// @param share  of the change that is made, in [0, 1].
/// @param mask     of the painted pixels.
/// @param depthPx  distance to the edge, positive inside, px.
/// @param picture  of their size; changed inside the mask. Colours may leave the gamut.
void restoreDetail(const Exemplar& exemplar, FilmDetail& film, const NearestNeighborField& nnf,
                   const Mask& mask, const Image<float>& depthPx, float share,
                   Image<Lab>& picture);

}  // namespace fluidymation
