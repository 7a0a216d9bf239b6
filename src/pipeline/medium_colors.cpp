#include "pipeline/medium_colors.h"

#include <algorithm>
#include <cassert>
#include <cstdint>

#include "fluidymation/core/error.h"
#include "fluidymation/core/parallel.h"
#include "fluidymation/guides/distance_field.h"
#include "fluidymation/option_ranges.h"
#include "pipeline/sampled_frames.h"

namespace fluidymation {
namespace {

/// How far from any coverage the surface counts as bare.
[[nodiscard]] int marginPx(Size size) {
  constexpr int kLeastMarginPx = 4;
  constexpr int kSidesPerMargin = 50;  // 8 px of 400
  return std::max(kLeastMarginPx, std::max(size.width, size.height) / kSidesPerMargin);
}

}  // namespace

void MediumColors::Mean::add(Lab color, float weight) {
  const double w = weight;
  l_ += w * static_cast<double>(color.l);
  a_ += w * static_cast<double>(color.a);
  b_ += w * static_cast<double>(color.b);
  weight_ += w;
}

std::optional<Lab> MediumColors::Mean::mean() const {
  if (weight_ <= 0.0) return std::nullopt;
  return Lab{static_cast<float>(l_ / weight_), static_cast<float>(a_ / weight_),
             static_cast<float>(b_ / weight_)};
}

void MediumColors::add(const Image<Lab>& picture, const Image<float>& coverage) {
  assert(picture.size() == coverage.size());
  Mask covered(coverage.size());
  std::transform(coverage.begin(), coverage.end(), covered.begin(),
                 [](float c) { return static_cast<std::uint8_t>(c > 0.0F ? 1 : 0); });
  const int margin = marginPx(picture.size());
  const Image<float> distance = distanceWithin(covered, margin);
  for (std::size_t i = 0; i < picture.pixelCount(); ++i) {
    const Lab color = picture.data()[i];
    if (coverage.data()[i] > 0.0F) {
      medium_.add(color, coverage.data()[i]);
    } else if (distance.data()[i] > static_cast<float>(margin)) {
      surface_.add(color, 1.0F);
    }
  }
}

std::optional<Recoloring> recoloringFor(const Options& options, const Inputs& inputs,
                                        MaskChannel sourceChannel,
                                        const std::function<void()>& beforeFrame) {
  if (!options.recolor) return std::nullopt;
  MediumColors colors;
  for (const int frame : sampledFrames(inputs.color.files.count())) {
    beforeFrame();
    colors.add(toLab(readPicture(inputs.color, frame)),
               readMask(inputs.sourceMask, sourceChannel, frame).coverage);
  }
  const std::string option = "--recolor " + colorText(*options.recolor);
  if (!colors.surface() || !colors.medium()) {
    throw Error(option + ": the masks of --src-mask-path leave no " +
                (colors.surface() ? "paint" : "bare surface") +
                " in the film's frames; wanted some of both, to tell them apart");
  }
  const float difference = colorDifference(*colors.surface(), *colors.medium());
  if (difference < Recoloring::kLeastDifference) {
    throw Error(option + ": paint and bare surface of the film differ by " +
                numberText(difference) + " in CIELAB; wanted " +
                numberText(Recoloring::kLeastDifference) + " or more, to tell them apart");
  }
  return Recoloring(*colors.surface(), *colors.medium(), toLab(*options.recolor));
}

void recolor(const Recoloring& recoloring, const GuideFrame& guides, Image<Lab>& picture) {
  forEachRow(picture.height(), [&](int y) {
    for (int x = 0; x < picture.width(); ++x) {
      if (guides.coverageAt(x, y) > 0.0F) picture(x, y) = recoloring(picture(x, y));
    }
  });
}

}  // namespace fluidymation
