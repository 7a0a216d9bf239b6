#pragma once

#include "fluidymation/core/box.h"
#include "fluidymation/core/geometry.h"
#include "fluidymation/core/image.h"

namespace fluidymation {

/// The part of a frame that an image of the box's size shows.
struct FramePart {
  Size frame;  ///< size of the whole
  Box box;     ///< within it

  [[nodiscard]] static FramePart whole(Size size) {
    return {size, {0, 0, size.width, size.height}};
  }

  friend bool operator==(const FramePart& a, const FramePart& b) {
    return a.frame == b.frame && a.box == b.box;
  }
};

/// The whole frame of which `image` shows `part`, of what is T{} in every pixel beyond it:
/// pictures, masks, coverage, matches, movement; not distances.
template <typename T>
[[nodiscard]] Image<T> wholeFrame(const Image<T>& image, const FramePart& part) {
  return recropped(image, part.box, FramePart::whole(part.frame).box);
}

}  // namespace fluidymation
