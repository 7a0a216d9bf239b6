#include "fluidymation/guides/gaussian.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "fluidymation/core/parallel.h"

namespace fluidymation {

std::vector<float> gaussianKernel(float sigma) {
  if (!(sigma > 0.0F)) return {1.0F};
  const int radius = gaussianReach(sigma);
  std::vector<double> weights;
  double sum = 0.0;
  for (int offset = 0; offset <= radius; ++offset) {
    const double t = offset / static_cast<double>(sigma);
    weights.push_back(std::exp(-0.5 * t * t));
    sum += (offset == 0 ? 1.0 : 2.0) * weights.back();
  }
  std::vector<float> kernel;
  kernel.reserve(weights.size());
  for (const double weight : weights) kernel.push_back(static_cast<float>(weight / sum));
  return kernel;
}

Image<float> gaussianBlur(const Image<float>& image, float sigmaPx) {
  const std::vector<float> kernel = gaussianKernel(sigmaPx);
  const int radius = static_cast<int>(kernel.size()) - 1;
  if (radius == 0 || image.empty()) return image.clone();
  const int width = image.width();

  // The offsets are the outer loop, so that the inner one runs over neighbouring pixels
  Image<float> narrow(image.size());
  forEachRow(image.height(), [&](int y) {
    std::vector<float> padded(static_cast<std::size_t>(width) +
                              2 * static_cast<std::size_t>(radius));
    int from = -radius;
    for (float& value : padded) value = image.clamped(from++, y);
    const float* centre = padded.data() + radius;
    float* out = narrow.row(y);
    for (int x = 0; x < width; ++x) out[x] = kernel[0] * centre[x];
    for (int offset = 1; offset <= radius; ++offset) {
      const float weight = kernel[static_cast<std::size_t>(offset)];
      for (int x = 0; x < width; ++x) out[x] += weight * (centre[x - offset] + centre[x + offset]);
    }
  });

  Image<float> result(image.size());
  forEachRow(image.height(), [&](int y) {
    const float* centre = narrow.row(y);
    float* out = result.row(y);
    for (int x = 0; x < width; ++x) out[x] = kernel[0] * centre[x];
    for (int offset = 1; offset <= radius; ++offset) {
      const float weight = kernel[static_cast<std::size_t>(offset)];
      const float* above = narrow.row(std::max(y - offset, 0));
      const float* below = narrow.row(std::min(y + offset, image.height() - 1));
      for (int x = 0; x < width; ++x) out[x] += weight * (above[x] + below[x]);
    }
  });
  return result;
}

}  // namespace fluidymation
