#pragma once

#include "fluidymation/core/box.h"
#include "fluidymation/core/image.h"

namespace fluidymation {

/// How long the material of an animation lies where it is, for one frame after the other. A line
/// that is drawn is new where the brush is and older behind it (P§5).
class TargetAges {
 public:
  /// @param mask  of the next frame; all have one size.
  /// @return  for each mask pixel the frames since it was covered, 0 in the frame that covers it
  ///   and in the first one; 0 outside. Frames whose mask is that of the frame before, a hold, do
  ///   not count.
  [[nodiscard]] Image<float> next(const Mask& mask);
  /// The same of a part of the frame that holds all of the mask; parts may differ from frame to
  /// frame.
  /// @param box  of the part. @return  for the pixels of the part.
  [[nodiscard]] Image<float> next(const Mask& mask, const Box& box);

  /// Whether what stayed covered is older in the last frame than in the one before it.
  [[nodiscard]] bool haveGrown() const { return grown_; }

 private:
  bool isFirst_ = true;
  Box box_;    ///< of the last frame's part
  Mask mask_;  ///< of the last frame
  Image<float> ages_;
  bool grown_ = false;
};

/// The same for a film, in which material spreads: the age of a pixel is that of its drop.
class FilmAges {
 public:
  /// @param mask  of the next frame; all have one size.
  /// @return  for each mask pixel the frames since the part that it belongs to appeared; 0 outside.
  ///   Pixels keep the part that covered them, also where it merges with others. What is newly
  ///   covered belongs to the oldest part that it is connected to (8-neighbours), or is a new one.
  [[nodiscard]] Image<float> next(const Mask& mask);

 private:
  Image<int> births_;  ///< frame in which the pixel's part appeared; `kNone` outside
  int frame_ = 0;
};

}  // namespace fluidymation
