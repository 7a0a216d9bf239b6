#pragma once

#include <array>
#include <optional>
#include <vector>

#include "fluidymation/core/color.h"
#include "fluidymation/core/image.h"
#include "fluidymation/guides/guide_frame.h"

namespace fluidymation {

/// Collects how an exemplar's colours depend on the distance to the edge, in steps of a pixel, over
/// all its frames.
class RimProfile {
 public:
  /// @param picture  of the frame's size.
  void add(const GuideFrame& frame, const Image<Lab>& picture);

  /// Within what distance of the edge most of the change of colour happens, px, looking no deeper
  /// than `kReach` border widths: the least distance from which on the mean colours stay within
  /// `kSettledShare` of the way from the inside's to the one furthest from it. The inside is the
  /// deeper half of the depths looked at that hold `kLeastShare` of the pixels each.
  /// @return  nothing where no mask has an edge, or the colours hardly differ.
  [[nodiscard]] std::optional<float> rimWidthPx(float borderWidthPx) const;

  static constexpr double kReach = 4.0;
  static constexpr double kSettledShare = 0.25;
  static constexpr double kLeastShare = 0.002;
  /// Rims whose colours differ by less than this from the inside are none: a CIELAB difference that
  /// is hardly seen (about 2.3 is one that is just noticed, Mahy et al. 1994).
  static constexpr double kLeastContrast = 2.3;

 private:
  struct Step {
    std::array<double, 3> sum{};
    double count = 0.0;
  };
  std::vector<Step> steps_;  ///< step i: distances from i to i + 1 px
};

}  // namespace fluidymation
