#pragma once

#include <functional>
#include <string>
#include <vector>

#include "fluidymation/core/image.h"
#include "fluidymation/guides/guide_frame.h"
#include "fluidymation/io/png.h"

namespace fluidymation {

/// Pictures of a sequence's guides for people. Keeps the guides of a few frames, reduced, so that
/// all of them can be shown by one scale.
class GuidePictures {
 public:
  static constexpr int kMostFrames = 6;       ///< shown of a sequence, evenly spread
  static constexpr int kLongestSidePx = 640;  ///< of a picture

  explicit GuidePictures(int frameCount) : frameCount_(frameCount) {}

  /// Whether this frame (from 0) is one that is shown.
  [[nodiscard]] bool shows(int frame) const;

  void keep(int number, const GuideFrame& frame);

  /// Files that `write` would write: `stem`NNNNN.CHANNEL.png of each frame kept, CHANNEL one of
  /// flow, extent-forward, extent-backward, distance and segments.
  [[nodiscard]] std::vector<std::string> paths(const std::string& stem) const;

  /// Writes them, into a folder that exists.
  /// @return  what full intensity stands for, one line.
  /// @throws Error naming the file.
  [[nodiscard]] std::string write(const std::string& stem, float borderWidthPx) const;

 private:
  struct Kept {
    int number = 0;
    Image<float> inside;  ///< share of each picture's pixel that lies inside the smoothed mask
    Image<Vec2> flow;
    Image<float> extentForward;
    Image<float> extentBackward;
    Image<float> distance;
  };

  int frameCount_;
  std::vector<Kept> frames_;
};

/// Draws a disc into the lower right corner that shows `flowColor` of all directions, out of whose
/// middle each points; full intensity at its rim.
void drawColorWheel(Image<Rgba8>& picture);

}  // namespace fluidymation
