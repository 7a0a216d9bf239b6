#include "preview/backdrop.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <system_error>

#include "fluidymation/core/box.h"
#include "fluidymation/core/error.h"
#include "fluidymation/core/resize.h"
#include "fluidymation/io/png.h"
#include "preview/bare_surface.h"

namespace fluidymation {
namespace {

[[nodiscard]] int hexDigit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

/// The middle of the picture that has the shape of `size`, scaled to it.
[[nodiscard]] Image<Rgb> fillingMiddle(const Image<Rgb>& picture, Size size) {
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

[[nodiscard]] Image<Rgb> exemplarSurface(const Inputs& inputs,
                                         const std::function<void()>& beforeFile) {
  const MaskChannel channel = maskChannel(inputs.sourceMask, beforeFile);
  BareSurface surface(inputs.color.scaled);
  for (int k = 0; k < inputs.color.files.count(); ++k) {
    beforeFile();
    surface.add(readPicture(inputs.color, k), readMask(inputs.sourceMask, channel, k).coverage);
  }
  if (surface.known()) return surface.filled();
  throw Error(
      "--preview-background exemplar: its masks leave no pixel bare in any frame; wanted a colour "
      "or a PNG file");
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

Image<Rgb> backdrop(const std::string& text, const Inputs& inputs, Size size,
                    const std::function<void()>& beforeFile) {
  if (const std::optional<Rgb> color = colorOf(text)) return Image<Rgb>(size, *color);
  if (text == "exemplar") return spread(exemplarSurface(inputs, beforeFile), size);
  std::error_code ignored;
  if (!std::filesystem::exists(text, ignored)) {
    throw UsageError("--preview-background " + text +
                     ": no colour, and no file of that name; wanted #RRGGBB, white, black, gray, a "
                     "PNG file, or exemplar");
  }
  return fillingMiddle(readColor(text), size);
}

}  // namespace fluidymation
