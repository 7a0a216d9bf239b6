#include "compositing/plain_background.h"

#include <algorithm>
#include <cmath>

#include "fluidymation/core/box.h"
#include "fluidymation/core/resize.h"

namespace fluidymation {

Image<Rgb> filledBy(const Image<Rgb>& picture, Size size) {
  const double scale = std::max(static_cast<double>(size.width) / picture.width(),
                                static_cast<double>(size.height) / picture.height());
  const auto shown = [scale](int length, int most) {
    return std::clamp(static_cast<int>(std::lround(length / scale)), 1, most);
  };
  const Size part{shown(size.width, picture.width()), shown(size.height, picture.height())};
  const int x = (picture.width() - part.width) / 2;
  const int y = (picture.height() - part.height) / 2;
  return resize(cropped(picture, {x, y, x + part.width, y + part.height}), size);
}

}  // namespace fluidymation
