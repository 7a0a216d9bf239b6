#include "pipeline/backdrop.h"

#include <filesystem>
#include <optional>
#include <system_error>

#include "compositing/bare_surface.h"
#include "compositing/plain_background.h"
#include "fluidymation/core/error.h"
#include "fluidymation/io/png.h"

namespace fluidymation {
namespace {

[[nodiscard]] Image<Rgb> exemplarSurface(const std::string& option, const Inputs& inputs, Size size,
                                         const std::function<void()>& beforeFile) {
  const MaskChannel channel = maskChannel(inputs.sourceMask, beforeFile);
  BareSurface surface(inputs.color.scaled);
  for (int k = 0; k < inputs.color.files.count(); ++k) {
    beforeFile();
    surface.add(readPicture(inputs.color, k), readMask(inputs.sourceMask, channel, k).coverage);
  }
  if (surface.known()) return surface.spread(size);
  throw Error(option +
              " exemplar: its masks leave no pixel bare in any frame; wanted a colour or a PNG "
              "file");
}

}  // namespace

bool isBackgroundFile(const std::string& text) {
  return !colorOf(text) && text != kExemplarSurface;
}

std::string backgroundText(const std::string& text) {
  const std::optional<Rgb> color = colorOf(text);
  if (!color) return text;
  std::string bytes = colorText({toByte(color->r), toByte(color->g), toByte(color->b)});
  const std::optional<Rgb> rounded = colorOf(bytes);
  const bool isSame =
      rounded && rounded->r == color->r && rounded->g == color->g && rounded->b == color->b;
  return isSame ? bytes : text;
}

void requireBackground(const std::string& option, const std::string& text) {
  std::error_code ignored;
  if (!isBackgroundFile(text) || std::filesystem::exists(text, ignored)) return;
  throw UsageError(option + " " + text +
                   ": no colour, and no file of that name; wanted #RRGGBB, white, black, gray, a "
                   "PNG file, or exemplar");
}

Image<Rgb> backdrop(const std::string& option, const std::string& text, const Inputs& inputs,
                    Size size, const std::function<void()>& beforeFile) {
  if (const std::optional<Rgb> color = colorOf(text)) return Image<Rgb>(size, *color);
  if (text == kExemplarSurface) return exemplarSurface(option, inputs, size, beforeFile);
  requireBackground(option, text);
  const Image<Rgb> picture = readColor(text);
  if (inputs.background) requireUnchanged(text, inputs.background->identity);
  return filledBy(picture, size);
}

}  // namespace fluidymation
