#include "compositing/plain_background.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "fluidymation/core/box.h"
#include "fluidymation/core/resize.h"

namespace fluidymation {
namespace {

[[nodiscard]] int hexDigit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

}  // namespace

std::optional<Rgb> colorOf(const std::string& text) {
  constexpr float kMiddle = 0.5F;
  if (text == "white") return Rgb{1.0F, 1.0F, 1.0F};
  if (text == "black") return Rgb{};
  if (text == "gray") return Rgb{kMiddle, kMiddle, kMiddle};
  if ((text.size() != 4 && text.size() != 7) || text[0] != '#') return std::nullopt;
  const std::size_t digits = (text.size() - 1) / 3;
  std::array<float, 3> channels{};
  for (std::size_t c = 0; c < channels.size(); ++c) {
    const int high = hexDigit(text[1 + c * digits]);
    const int low = hexDigit(text[1 + c * digits + digits - 1]);
    if (high < 0 || low < 0) return std::nullopt;
    constexpr float kWhite = 255.0F;
    channels[c] = static_cast<float>(16 * high + low) / kWhite;
  }
  return Rgb{channels[0], channels[1], channels[2]};
}

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
