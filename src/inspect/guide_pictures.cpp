#include "inspect/guide_pictures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

#include "fluidymation/core/color.h"
#include "fluidymation/core/geometry.h"
#include "fluidymation/core/resize.h"
#include "inspect/numbers.h"
#include "pipeline/dump_name.h"
#include "pipeline/flow_color.h"

namespace fluidymation {
namespace {

constexpr std::array<const char*, 5> kChannels = {"flow", "extent-forward", "extent-backward",
                                                  "distance", "segments"};
constexpr Rgba8 kOutside{40, 40, 40, 255};  // black is no motion, white is much
constexpr float kFlowGain = 2.0F;           // full from half the fastest on, few pixels are faster
constexpr Rgba8 kBorder{240, 150, 60, 255};
constexpr Rgba8 kInterior{70, 130, 200, 255};

[[nodiscard]] Image<float> lengthsOf(const Image<Vec2>& vectors) {
  Image<float> result(vectors.size());
  std::transform(vectors.begin(), vectors.end(), result.begin(), [](Vec2 v) { return length(v); });
  return result;
}

[[nodiscard]] Size reducedSize(Size size) {
  const int longest = std::max(size.width, size.height);
  if (longest <= GuidePictures::kLongestSidePx) return size;
  return scaledSize(size, static_cast<double>(GuidePictures::kLongestSidePx) / longest);
}

/// A picture of what lies inside. @param color  of the pixel (x, y).
template <typename Color>
[[nodiscard]] Image<Rgba8> paintInside(const Image<float>& inside, const Color& color) {
  constexpr float kHalf = 0.5F;
  Image<Rgba8> picture(inside.size());
  for (int y = 0; y < inside.height(); ++y) {
    for (int x = 0; x < inside.width(); ++x) {
      picture(x, y) = inside(x, y) >= kHalf ? color(x, y) : kOutside;
    }
  }
  return picture;
}

[[nodiscard]] Rgba8 gray(float value) {
  const std::uint8_t level = toByte(value);
  return {level, level, level, 255};
}

/// Largest of all values inside; 1 where there is none, to divide by.
class Largest {
 public:
  void add(const Image<float>& inside, const Image<float>& values) {
    for (std::size_t i = 0; i < values.pixelCount(); ++i) {
      if (inside.data()[i] > 0.0F) largest_ = std::max(largest_, values.data()[i]);
    }
  }
  [[nodiscard]] float scale() const { return largest_ > 0.0F ? 1.0F / largest_ : 1.0F; }
  [[nodiscard]] std::string text(float share = 1.0F) const {
    return fixedText(static_cast<double>(share * largest_), 1);
  }

 private:
  float largest_ = 0.0F;
};

}  // namespace

bool GuidePictures::shows(int frame) const {
  const int count = std::min(frameCount_, kMostFrames);
  if (count == 1) return frame == 0;
  for (int i = 0; i < count; ++i) {
    const auto place = std::int64_t{i} * (frameCount_ - 1) / (count - 1);
    if (place == frame) return true;
  }
  return false;
}

void GuidePictures::keep(int number, const GuideFrame& frame) {
  const Size size = reducedSize(frame.mask.size());
  Image<float> inside(frame.mask.size());
  std::transform(frame.mask.begin(), frame.mask.end(), inside.begin(),
                 [](std::uint8_t m) { return m != 0 ? 1.0F : 0.0F; });
  const bool hasEdge = countInside(frame.mask) != frame.mask.pixelCount();
  frames_.push_back({number, resize(inside, size), resize(frame.flow, size),
                     resize(lengthsOf(frame.accForward), size),
                     resize(lengthsOf(frame.accBackward), size),
                     hasEdge ? resize(frame.distance, size) : Image<float>(size)});
}

std::vector<std::string> GuidePictures::paths(const std::string& stem) const {
  std::vector<std::string> all;
  for (const Kept& frame : frames_) {
    for (const char* channel : kChannels) {
      all.push_back(dumpStem(stem, frame.number) + "." + channel + ".png");
    }
  }
  return all;
}

std::string GuidePictures::write(const std::string& stem, float borderWidthPx) const {
  Largest flow;
  Largest forward;
  Largest backward;
  Largest depth;
  for (const Kept& frame : frames_) {
    flow.add(frame.inside, lengthsOf(frame.flow));
    forward.add(frame.inside, frame.extentForward);
    backward.add(frame.inside, frame.extentBackward);
    depth.add(frame.inside, frame.distance);
  }
  for (const Kept& frame : frames_) {
    const std::string path = dumpStem(stem, frame.number) + ".";
    Image<Rgba8> motion = paintInside(frame.inside, [&](int x, int y) {
      return flowColor(frame.flow(x, y), kFlowGain * flow.scale());
    });
    drawColorWheel(motion);
    writePng(path + "flow.png", motion);
    writePng(path + "extent-forward.png", paintInside(frame.inside, [&](int x, int y) {
               return gray(forward.scale() * frame.extentForward(x, y));
             }));
    writePng(path + "extent-backward.png", paintInside(frame.inside, [&](int x, int y) {
               return gray(backward.scale() * frame.extentBackward(x, y));
             }));
    writePng(path + "distance.png", paintInside(frame.inside, [&](int x, int y) {
               return gray(depth.scale() * frame.distance(x, y));
             }));
    writePng(path + "segments.png", paintInside(frame.inside, [&](int x, int y) {
               return frame.distance(x, y) < borderWidthPx ? kBorder : kInterior;
             }));
  }
  return "full intensity is " + flow.text(1.0F / kFlowGain) + " px a frame of flow, extents of " +
         forward.text() + " px forward and " + backward.text() + " px backward, " + depth.text() +
         " px from the edge";
}

void drawColorWheel(Image<Rgba8>& picture) {
  constexpr int kShareOfSide = 10;  // the radius is a tenth of the shorter side
  constexpr int kMarginPx = 4;
  const int radius = std::min(picture.width(), picture.height()) / kShareOfSide;
  const int middleX = picture.width() - radius - kMarginPx;
  const int middleY = picture.height() - radius - kMarginPx;
  for (int y = -radius; y <= radius; ++y) {
    for (int x = -radius; x <= radius; ++x) {
      const Vec2 arm{static_cast<float>(x), static_cast<float>(y)};
      const float share = length(arm) / static_cast<float>(std::max(radius, 1));
      if (share > 1.0F || !picture.contains(middleX + x, middleY + y)) continue;
      picture(middleX + x, middleY + y) =
          flowColor(arm, 1.0F / static_cast<float>(std::max(radius, 1)));
    }
  }
}

}  // namespace fluidymation
