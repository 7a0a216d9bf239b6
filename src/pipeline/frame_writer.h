#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "fluidymation/core/color.h"
#include "fluidymation/core/frame_part.h"
#include "fluidymation/core/image.h"
#include "fluidymation/guides/guide_frame.h"
#include "fluidymation/io/digest.h"
#include "fluidymation/io/png.h"
#include "fluidymation/options.h"
#include "pipeline/painted_pixels.h"

namespace fluidymation {

/// What the files of painted frames hold.
struct FrameForm {
  BitDepth bitDepth = BitDepth::k8;
  int compressionLevel = kDefaultCompression;  ///< 0 to 9, see `encodePng`
  Image<Rgb> background = {};  ///< what frames are laid over; empty: they are transparent
  ColorChunks color = {};      ///< of the files
};

/// Writes painted frames as PNG files. A frame that looks as the one before costs no encoding: the
/// same bytes are written once more.
class FrameWriter {
 public:
  /// What a file shows, which is transparent black beyond the part.
  struct Output {
    FramePart part;
    std::variant<Image<Rgba8>, Image<Rgba16>> pixels;
  };
  using Encoder = std::function<std::vector<std::uint8_t>(const Output& output)>;

  explicit FrameWriter(FrameForm form);
  /// @param encode  takes the place of `encodePng`.
  FrameWriter(FrameForm form, Encoder encode);
  FrameWriter(const FrameWriter&) = delete;
  FrameWriter& operator=(const FrameWriter&) = delete;
  ~FrameWriter() = default;

  /// @param part    what picture and guides show; nothing is painted beyond it.
  /// @param guides  mask and coverage of the frame.
  /// @param beforeWriting  is told what the file is going to be; may throw to leave it as it is.
  /// @return  of the file.
  /// @throws Error naming the file that cannot be written.
  Digest write(const std::string& path, const FramePart& part, const Image<Lab>& picture,
               const GuideFrame& guides,
               const std::function<void(const Digest&)>& beforeWriting = {});

 private:
  [[nodiscard]] Output outputOf(const PaintedPart& painted) const;

  FrameForm form_;
  Encoder encode_;
  Image<Rgba8> bare8_;    ///< the background in the form of the files; empty without one
  Image<Rgba16> bare16_;  ///< likewise
  SrgbByteEncoder colors_;
  Output last_;
  std::vector<std::uint8_t> lastFile_;  ///< `last_` encoded
};

}  // namespace fluidymation
