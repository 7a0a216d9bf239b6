#pragma once

#include <array>
#include <map>

#include "fluidymation/core/color.h"
#include "fluidymation/core/image.h"
#include "fluidymation/synthesis/detail_bands.h"
#include "fluidymation/synthesis/exemplar.h"
#include "fluidymation/synthesis/nnf.h"

namespace fluidymation {

/// The detail of the frames of one film, of each as soon as it is asked for.
class FilmDetail {
 public:
  /// @param exemplar  always of the same film.
  /// @param k  of the frames that the exemplar holds.
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
/// depth of each pixel, in the frame of its match. Their difference from 1 counts n / (n + 50)
/// for n pixels.
/// @param painted  the picture's energy.
/// @param depthPx  distance to the edge, positive inside; of the size of `nnf`. Not stretched in
///   thin parts, whatever they are painted from: what is seen so near to an edge is to be as strong
///   as what the film shows there.
[[nodiscard]] DetailGains detailGains(const Exemplar& exemplar, FilmDetail& film,
                                      const NearestNeighborField& nnf, const Image<float>& depthPx,
                                      const DetailEnergy& painted);

/// Brings the finest detail of a painted picture to the film's own energy: averaging and smooth
/// matches have taken from it, and seams have added to it. What the film has as energy depends on
/// how deep a place lies and on the film's time. Of the rim, the edge included, and of the inside
/// each band is enlarged or made smaller as a whole, so that detail stays where it is. Not in the
/// thesis; docs/quality.md has the figures.
/// @param share  of the change that is made, in [0, 1].
/// @param mask     of the target; pixels outside it that its outline cuts stay as they are.
/// @param depthPx  distance to the edge, positive inside, px.
/// @param picture  of their size; changed inside the mask. Colours may leave the gamut.
void restoreDetail(const Exemplar& exemplar, FilmDetail& film, const NearestNeighborField& nnf,
                   const Mask& mask, const Image<float>& depthPx, float share, Image<Lab>& picture);

}  // namespace fluidymation
