#pragma once

#include <complex>

#include "fluidymation/core/color.h"

namespace fluidymation {

/// Gives a medium that lies on a surface another hue and chroma, and leaves each pixel its
/// lightness; the paper colours its waving figure (P fig. 10d) and does not say how. How much of
/// the medium a pixel shows is found from its colour, along the line from the surface's to the
/// medium's: at the surface nothing changes, the medium's mean gets the wanted hue and chroma, and
/// more of it gets more chroma. What is off that line keeps its size or less, and turns with the
/// hue.
class Recoloring {
 public:
  /// Surface and medium must differ by so much in CIELAB, else no pixel tells them apart: about the
  /// least difference that is noticed (Mahy et al., Evaluation of Uniform Color Differences, 1994).
  static constexpr float kLeastDifference = 2.3F;

  /// @param surface  mean colour of the bare surface.
  /// @param medium   mean colour of the medium; at least `kLeastDifference` away (asserted).
  /// @param wanted   a and b count, its lightness does not.
  Recoloring(Lab surface, Lab medium, Lab wanted);

  /// @return  of the same lightness, within the sRGB gamut: with less chroma where there is no such
  ///   colour.
  [[nodiscard]] Lab operator()(Lab color) const;

 private:
  using Chroma = std::complex<float>;  ///< a + ib: its argument is the hue

  float surfaceLightness_;
  Chroma surface_;
  Lab axis_;        ///< from the surface to the medium, over its squared length
  Chroma medium_;   ///< from the surface
  Chroma wanted_;   ///< likewise
  Chroma turning_;  ///< of what is off the line, at the medium: by the hue, at most of length 1
};

/// The distance of two colours in CIELAB: the CIE's 1976 colour difference.
[[nodiscard]] float colorDifference(Lab a, Lab b);

/// The most colourful of the same lightness and hue that sRGB has, unless it has the colour itself.
[[nodiscard]] Lab withinGamut(Lab color);

}  // namespace fluidymation
