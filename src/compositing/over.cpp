#include "compositing/over.h"

#include <cassert>

namespace fluidymation {

Image<Rgb> composited(const Image<Rgba>& picture, const Image<Rgb>& background) {
  assert(picture.size() == background.size());
  Image<Rgb> result(picture.size());
  for (std::size_t i = 0; i < result.pixelCount(); ++i) {
    result.data()[i] = composited(picture.data()[i], background.data()[i]);
  }
  return result;
}

void layOver(const Image<Rgba>& picture, Image<Rgba>& canvas) {
  assert(picture.size() == canvas.size());
  for (std::size_t i = 0; i < canvas.pixelCount(); ++i) {
    canvas.data()[i] = composited(picture.data()[i], canvas.data()[i]);
  }
}

}  // namespace fluidymation
