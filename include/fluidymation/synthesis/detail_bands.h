#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "fluidymation/core/color.h"
#include "fluidymation/core/image.h"

namespace fluidymation {

/// Gaussians whose differences are the bands of a picture's detail, px: what is finer than the
/// first one, and what lies between the two. Coarser bands are the shapes that the search puts
/// together, and are left to it.
inline constexpr std::array<float, 2> kDetailSigmasPx{0.9F, 1.8F};

/// A picture's detail, finest band first; each of the picture's size, 0 outside the mask.
using DetailBands = std::array<Image<Lab>, kDetailSigmasPx.size()>;

/// Only the mask counts: a pixel of a Gaussian is the mean of those inside it.
/// @param picture  of the mask's size.
[[nodiscard]] DetailBands detailBands(const Image<Lab>& picture, const Mask& mask);

/// Upper bounds of the classes of depth below, border widths; the last class has none. A medium's
/// detail changes most where its rim ends, and hardly in its middle.
inline constexpr std::array<float, 9> kDetailDepths{0.4F, 0.6F, 0.8F, 1.0F, 1.35F,
                                                    1.8F, 2.5F, 3.5F, 5.0F};
inline constexpr std::size_t kDetailClasses = kDetailDepths.size() + 1;
/// The classes before this one are the rim, the others the inside.
inline constexpr std::size_t kFirstInsideClass = 4;
/// What lies less deep is the edge itself, px, and is left out of energies: its steps are no detail
/// of the medium.
inline constexpr float kEdgeDepthPx = 2.0F;

/// Nothing for what is not inside, or the edge itself.
[[nodiscard]] std::optional<std::size_t> detailClass(float depthPx, float borderWidthPx);

/// How much detail there is at each depth.
class DetailEnergy {
 public:
  /// @param detail  a pixel's value in each band.
  void add(std::size_t depthClass, const std::array<Lab, kDetailSigmasPx.size()>& detail);
  void add(const DetailEnergy& other);

  [[nodiscard]] std::int64_t pixels(std::size_t depthClass) const {
    return sums_[depthClass].pixels;
  }
  /// Sum over the pixels of squared distances in CIELAB from 0.
  [[nodiscard]] double squares(std::size_t depthClass, std::size_t band) const {
    return sums_[depthClass].squares[band];
  }

 private:
  struct Sum {
    std::int64_t pixels = 0;
    std::array<double, kDetailSigmasPx.size()> squares{};
  };
  std::array<Sum, kDetailClasses> sums_;
};

/// The energy of all that lies inside; the same at any number of threads.
/// @param depthPx  distance to the edge, positive inside; of the bands' size.
[[nodiscard]] DetailEnergy detailEnergy(const DetailBands& bands, const Image<float>& depthPx,
                                        float borderWidthPx);

}  // namespace fluidymation
