#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "fluidymation/core/color.h"
#include "fluidymation/core/image.h"
#include "fluidymation/guides/guide_frame.h"
#include "fluidymation/io/digest.h"
#include "fluidymation/io/png.h"

namespace fluidymation {

/// Straight alpha: painted, and as opaque as the shape covers the pixel; fully transparent where it
/// does not.
/// @param guides  mask and coverage of the frame.
[[nodiscard]] Image<Rgba8> toOutput(const Image<Lab>& picture, const GuideFrame& guides,
                                    const SrgbByteEncoder& encoder);

/// Writes painted frames as PNG files. A frame that looks as the one before costs no encoding: the
/// same bytes are written once more.
class FrameWriter {
 public:
  using Encoder = std::function<std::vector<std::uint8_t>(const Image<Rgba8>& pixels)>;

  explicit FrameWriter(Encoder encode) : encode_(std::move(encode)) {}
  /// @param compressionLevel  0 to 9, see `encodePng`.
  explicit FrameWriter(int compressionLevel)
      : FrameWriter([compressionLevel](const Image<Rgba8>& pixels) {
          return encodePng(pixels, compressionLevel);
        }) {}

  /// @param guides  mask and coverage of the frame.
  /// @return  of the file.
  /// @throws Error naming the file that cannot be written.
  Digest write(const std::string& path, const Image<Lab>& picture, const GuideFrame& guides);

 private:
  Encoder encode_;
  SrgbByteEncoder colors_;
  Image<Rgba8> last_;
  std::vector<std::uint8_t> lastFile_;  ///< `last_` encoded
};

}  // namespace fluidymation
