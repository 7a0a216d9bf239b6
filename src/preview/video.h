#pragma once

#include <functional>
#include <string>

#include "fluidymation/core/image.h"
#include "fluidymation/io/png.h"

namespace fluidymation {

enum class VideoFormat { kGif, kMp4 };

/// Whether a program of the name ffmpeg is in one of the folders of PATH.
[[nodiscard]] bool hasFfmpeg();

/// Has ffmpeg encode pictures of one size with even sides (asserted). No shell is asked; the file
/// is replaced in one step. One picture is in memory at a time.
/// @param frame  gives picture i; alpha is ignored.
/// @param stopIfWanted  called while ffmpeg is waited for; may throw, then ffmpeg is ended.
/// @throws Error naming the file, with ffmpeg's last words; whatever `frame` throws.
void writeVideo(
    const std::string& path, VideoFormat format, int frameCount, int framesPerSecond,
    const std::function<Image<Rgba8>(int frame)>& frame,
    const std::function<void()>& stopIfWanted = [] {});

}  // namespace fluidymation
