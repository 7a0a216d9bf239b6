#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "fluidymation/core/color.h"
#include "fluidymation/core/image.h"
#include "fluidymation/guides/guide_frame.h"
#include "fluidymation/io/digest.h"
#include "fluidymation/io/png.h"
#include "fluidymation/options.h"

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
  using Pixels = std::variant<Image<Rgba8>, Image<Rgba16>>;
  using Encoder = std::function<std::vector<std::uint8_t>(const Pixels& pixels)>;

  explicit FrameWriter(FrameForm form);
  /// @param encode  takes the place of `encodePng`.
  FrameWriter(FrameForm form, Encoder encode)
      : form_(std::move(form)), encode_(std::move(encode)) {}
  FrameWriter(const FrameWriter&) = delete;
  FrameWriter& operator=(const FrameWriter&) = delete;
  ~FrameWriter() = default;

  /// @param guides  mask and coverage of the frame.
  /// @param beforeWriting  is told what the file is going to be; may throw to leave it as it is.
  /// @return  of the file.
  /// @throws Error naming the file that cannot be written.
  Digest write(const std::string& path, const Image<Lab>& picture, const GuideFrame& guides,
               const std::function<void(const Digest&)>& beforeWriting = {});

 private:
  [[nodiscard]] Pixels pixelsOf(const Image<Lab>& picture, const GuideFrame& guides) const;

  FrameForm form_;
  Encoder encode_;
  SrgbByteEncoder colors_;
  Pixels last_;
  std::vector<std::uint8_t> lastFile_;  ///< `last_` encoded
};

}  // namespace fluidymation
