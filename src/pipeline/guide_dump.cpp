#include "pipeline/guide_dump.h"

#include <algorithm>
#include <cstdint>
#include <string>

#include "fluidymation/core/color.h"
#include "fluidymation/core/parallel.h"
#include "fluidymation/io/atomic_file.h"
#include "fluidymation/io/flow_file.h"
#include "fluidymation/io/pfm.h"
#include "fluidymation/io/png.h"
#include "pipeline/dump_name.h"
#include "pipeline/flow_color.h"

namespace fluidymation {
namespace {

Image<float> lengths(const Image<Vec2>& vectors) {
  Image<float> result(vectors.size());
  forEachRow(vectors.height(), [&](int y) {
    for (int x = 0; x < vectors.width(); ++x) result(x, y) = length(vectors(x, y));
  });
  return result;
}

/// What to multiply by so that the largest value becomes 1; all-zero images stay zero.
float normalization(const Image<float>& image) {
  float largest = 0.0F;
  for (const float value : image) largest = std::max(largest, value);
  return largest > 0.0F ? 1.0F / largest : 0.0F;
}

Image<std::uint8_t> maskPicture(const Mask& mask) {
  Image<std::uint8_t> picture(mask.size());
  forEachRow(mask.height(), [&](int y) {
    for (int x = 0; x < mask.width(); ++x) picture(x, y) = mask(x, y) != 0 ? 255 : 0;
  });
  return picture;
}

Image<std::uint8_t> normalizedPicture(const Image<float>& image) {
  const float scale = normalization(image);
  Image<std::uint8_t> picture(image.size());
  forEachRow(image.height(), [&](int y) {
    for (int x = 0; x < image.width(); ++x) picture(x, y) = toByte(scale * image(x, y));
  });
  return picture;
}

/// `flowColor`, relative to the frame's fastest pixel.
Image<Rgba8> flowPicture(const Image<Vec2>& flow) {
  const Image<float> speed = lengths(flow);
  const float scale = normalization(speed);
  Image<Rgba8> picture(flow.size());
  forEachRow(flow.height(), [&](int y) {
    for (int x = 0; x < flow.width(); ++x) {
      picture(x, y) = flowColor(flow(x, y), scale);
    }
  });
  return picture;
}

}  // namespace

void dumpGuides(const std::string& folder, int frameNumber, const GuideFrame& guides) {
  createFolder(folder);
  const std::string path = dumpStem(folder, frameNumber);
  const Image<float> extForward = lengths(guides.accForward);
  const Image<float> extBackward = lengths(guides.accBackward);
  writeGrayPng(path + ".mask.png", maskPicture(guides.mask));
  writePfm(path + ".dist.pfm", guides.distance);
  if (!guides.shape.empty()) writePfm(path + ".shape.pfm", guides.shape);
  if (!guides.age.empty()) writePfm(path + ".age.pfm", guides.age);
  writeFlow(path + ".flow.flo", guides.flow);
  writePfm(path + ".ext_fwd.pfm", extForward);
  writePfm(path + ".ext_bwd.pfm", extBackward);
  writePng(path + ".flow.png", flowPicture(guides.flow));
  writeGrayPng(path + ".ext_fwd.png", normalizedPicture(extForward));
  writeGrayPng(path + ".ext_bwd.png", normalizedPicture(extBackward));
}

}  // namespace fluidymation
