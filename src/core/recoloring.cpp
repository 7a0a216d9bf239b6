#include "fluidymation/core/recoloring.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace fluidymation {

Recoloring::Recoloring(Lab surface, Lab medium, Lab wanted)
    : surfaceLightness_(surface.l),
      surface_(surface.a, surface.b),
      medium_(medium.a - surface.a, medium.b - surface.b),
      wanted_(wanted.a - surface.a, wanted.b - surface.b) {
  assert(colorDifference(surface, medium) >= kLeastDifference);
  const float lightness = medium.l - surface.l;
  const float squared = lightness * lightness + std::norm(medium_);
  axis_ = {lightness / squared, medium_.real() / squared, medium_.imag() / squared};
  // By the ratio of the chromas, the smaller by the larger: what is off the line of a gray medium
  // is no colour of it, and a gray one is to have none.
  const float larger = std::max(std::norm(medium_), std::norm(wanted_));
  if (larger > 0.0F) turning_ = wanted_ * std::conj(medium_) / larger;
}

Lab Recoloring::operator()(Lab color) const {
  const Chroma chroma = Chroma(color.a, color.b) - surface_;
  const float along =
      axis_.l * (color.l - surfaceLightness_) + axis_.a * chroma.real() + axis_.b * chroma.imag();
  const float amount = std::max(0.0F, along);
  const Chroma offLine = chroma - amount * medium_;
  const Chroma turning = 1.0F + std::min(amount, 1.0F) * (turning_ - 1.0F);
  const Chroma result = surface_ + amount * wanted_ + turning * offLine;
  return withinGamut({color.l, result.real(), result.imag()});
}

float colorDifference(Lab a, Lab b) { return std::hypot(a.l - b.l, a.a - b.a, a.b - b.b); }

Lab withinGamut(Lab color) {
  if (isInGamut(color)) return color;
  constexpr int kHalvings = 12;  // to 1/32 of a chroma of 128
  float inside = 0.0F;
  float outside = 1.0F;
  for (int i = 0; i < kHalvings; ++i) {
    const float middle = 0.5F * (inside + outside);
    (isInGamut({color.l, middle * color.a, middle * color.b}) ? inside : outside) = middle;
  }
  return {color.l, inside * color.a, inside * color.b};
}

}  // namespace fluidymation
