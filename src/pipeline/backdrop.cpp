#include "pipeline/backdrop.h"

#include <filesystem>
#include <system_error>

#include "compositing/bare_surface.h"
#include "compositing/plain_background.h"
#include "fluidymation/core/error.h"
#include "fluidymation/io/png.h"

namespace fluidymation {
namespace {

[[nodiscard]] Image<Rgb> exemplarSurface(const std::string& option, const Inputs& inputs,
                                         const std::function<void()>& beforeFile) {
  const MaskChannel channel = maskChannel(inputs.sourceMask, beforeFile);
  BareSurface surface(inputs.color.scaled);
  for (int k = 0; k < inputs.color.files.count(); ++k) {
    beforeFile();
    surface.add(readPicture(inputs.color, k), readMask(inputs.sourceMask, channel, k).coverage);
  }
  if (surface.known()) return surface.filled();
  throw Error(option +
              " exemplar: its masks leave no pixel bare in any frame; wanted a colour or a PNG "
              "file");
}

}  // namespace

Image<Rgb> backdrop(const std::string& option, const std::string& text, const Inputs& inputs,
                    Size size, const std::function<void()>& beforeFile) {
  if (const std::optional<Rgb> color = colorOf(text)) return Image<Rgb>(size, *color);
  if (text == kExemplarSurface) return spread(exemplarSurface(option, inputs, beforeFile), size);
  std::error_code ignored;
  if (!std::filesystem::exists(text, ignored)) {
    throw UsageError(option + " " + text +
                     ": no colour, and no file of that name; wanted #RRGGBB, white, black, gray, a "
                     "PNG file, or exemplar");
  }
  return filledBy(readColor(text), size);
}

}  // namespace fluidymation
