#pragma once

#include <functional>
#include <optional>

#include "fluidymation/core/color.h"
#include "fluidymation/core/image.h"
#include "fluidymation/core/recoloring.h"
#include "fluidymation/guides/guide_frame.h"
#include "fluidymation/options.h"
#include "pipeline/inputs.h"

namespace fluidymation {

/// Mean colours of a medium and of the surface under it.
class MediumColors {
 public:
  /// Counts one frame of the film: each pixel for the medium by its coverage, and for the surface
  /// where it lies well outside, for the mask may end where the paint still fades.
  /// @param coverage  of the same size, in [0, 1].
  void add(const Image<Lab>& picture, const Image<float>& coverage);

  /// Nothing where no pixel was counted.
  [[nodiscard]] std::optional<Lab> surface() const { return surface_.mean(); }
  [[nodiscard]] std::optional<Lab> medium() const { return medium_.mean(); }

 private:
  class Mean {
   public:
    void add(Lab color, float weight);
    [[nodiscard]] std::optional<Lab> mean() const;

   private:
    double l_ = 0.0;
    double a_ = 0.0;
    double b_ = 0.0;
    double weight_ = 0.0;
  };

  Mean surface_;
  Mean medium_;
};

/// What `--recolor` asks for; nothing where it is not given. Looks at some of the film's frames.
/// @param beforeFrame  called before each frame that is read; may throw to stop.
/// @throws Error where surface and medium cannot be told apart, or one of them is nowhere seen.
[[nodiscard]] std::optional<Recoloring> recoloringFor(const Options& options, const Inputs& inputs,
                                                      MaskChannel sourceChannel,
                                                      const std::function<void()>& beforeFrame);

/// Gives the painted pixels of a frame their other colour. @param guides  mask and coverage.
void recolor(const Recoloring& recoloring, const GuideFrame& guides, Image<Lab>& picture);

}  // namespace fluidymation
