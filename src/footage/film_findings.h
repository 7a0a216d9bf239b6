#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "fluidymation/core/color.h"
#include "fluidymation/core/geometry.h"
#include "fluidymation/core/image.h"

namespace fluidymation {

/// What was seen of a frame while its mask was made.
struct FrameFindings {
  int number = 0;
  std::int64_t inside = 0;         ///< pixels
  bool touchesBorder = false;      ///< the mask has pixels at the picture's border
  std::optional<Vec2> offsetPx;    ///< of the camera since the bare surface was taken
  std::optional<Lab> lightDrift;   ///< of the surface, likewise
  std::int64_t lighterPixels = 0;  ///< of the matte: lighter than the surface
};

/// What was seen of a film.
struct FilmFindings {
  Size size;
  std::vector<FrameFindings> frames;
  float threshold = 0.0F;
  std::string thresholdOrigin;      ///< "chosen by the film"
  std::string surface;              ///< "median of frames 1 to 5"
  bool surfaceIsFirstFrame = true;  ///< and nothing was said of paint on it
  std::int64_t smallestHolePx = 0;
};

/// Share of a picture from which on a mask counts as holding all of it.
inline constexpr double kWholeShare = 0.98;

[[nodiscard]] bool isWhole(std::int64_t inside, Size size);

/// Lines for people: size, surface, threshold, shares.
[[nodiscard]] std::vector<std::string> filmReport(const FilmFindings& film);

/// What is wrong, in which frames, by how much, and what to do.
/// @param everPainted  what any mask that is not whole holds.
[[nodiscard]] std::vector<std::string> filmWarnings(const FilmFindings& film,
                                                    const Mask& everPainted);

/// "frame 3", "frames 3 to 7, 9"; a long list is cut: "... and 12 more".
/// @param numbers  one or more (asserted), in the film's order.
[[nodiscard]] std::string frameListText(const std::vector<int>& numbers);

}  // namespace fluidymation
