#include "inspect/shape_figures.h"

#include <algorithm>
#include <cassert>
#include <numeric>

#include "fluidymation/core/geometry.h"
#include "fluidymation/guides/local_thickness.h"
#include "fluidymation/guides/motion.h"

namespace fluidymation {
namespace {

/// Pixels inside that lie on the picture's rim.
[[nodiscard]] std::int64_t rimPixels(const Mask& mask) {
  std::int64_t count = 0;
  for (int y = 0; y < mask.height(); ++y) {
    const bool outerRow = y == 0 || y == mask.height() - 1;
    for (int x = 0; x < mask.width(); ++x) {
      if (!outerRow && x != 0 && x != mask.width() - 1) continue;
      count += mask(x, y) != 0 ? 1 : 0;
    }
  }
  return count;
}

void measureDepths(const GuideFrame& frame, float borderWidthPx, ShapeFigures& figures) {
  const Image<float> thickness = localThickness(frame.distance, kThinRadiusPx);
  for (int y = 0; y < frame.mask.height(); ++y) {
    for (int x = 0; x < frame.mask.width(); ++x) {
      if (frame.mask(x, y) == 0) continue;
      figures.depthPx = std::max(figures.depthPx, frame.distance(x, y));
      figures.interiorPx += frame.distance(x, y) >= borderWidthPx ? 1 : 0;
      figures.thinPx += thickness(x, y) < kThinRadiusPx ? 1 : 0;
    }
  }
}

}  // namespace

ShapeFigures measureShape(const GuideFrame& frame, const Mask* previous, float borderWidthPx) {
  assert(previous == nullptr || previous->size() == frame.mask.size());
  ShapeFigures figures;
  figures.framePx = static_cast<std::int64_t>(frame.mask.pixelCount());
  figures.insidePx = static_cast<std::int64_t>(countInside(frame.mask));
  if (figures.empty()) return figures;
  if (previous != nullptr) {
    figures.sharedPx = std::inner_product(
        frame.mask.begin(), frame.mask.end(), previous->begin(), std::int64_t{0}, std::plus<>(),
        [](std::uint8_t a, std::uint8_t b) { return a != 0 && b != 0 ? 1 : 0; });
  }
  figures.cutPx = rimPixels(frame.mask);
  if (figures.full()) {  // there is no edge, and distances are stand-ins
    figures.interiorPx = figures.insidePx;
    return figures;
  }
  measureDepths(frame, borderWidthPx, figures);
  const Mask border = borderPixels(frame.mask);
  double speeds = 0.0;
  for (int y = 0; y < border.height(); ++y) {
    for (int x = 0; x < border.width(); ++x) {
      if (border(x, y) == 0) continue;
      ++figures.borderPx;
      speeds += static_cast<double>(length(frame.flow(x, y)));
    }
  }
  if (figures.borderPx > 0) figures.borderSpeedPx = speeds / static_cast<double>(figures.borderPx);
  return figures;
}

std::int64_t SequenceFigures::insidePx() const {
  return std::accumulate(
      frames.begin(), frames.end(), std::int64_t{0},
      [](std::int64_t sum, const ShapeFigures& frame) { return sum + frame.insidePx; });
}

Spread spreadOf(const std::vector<double>& values) {
  if (values.empty()) return {};
  const auto [least, largest] = std::minmax_element(values.begin(), values.end());
  const double sum = std::accumulate(values.begin(), values.end(), 0.0);
  return {*least, sum / static_cast<double>(values.size()), *largest};
}

double medianOf(std::vector<double> values) {
  if (values.empty()) return 0.0;
  std::sort(values.begin(), values.end());
  const std::size_t middle = values.size() / 2;
  return values.size() % 2 != 0 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

double typicalBorderSpeed(const SequenceFigures& sequence) {
  std::vector<double> speeds;
  for (std::size_t i = 1; i < sequence.frames.size(); ++i) {
    if (sequence.frames[i].borderPx > 0) speeds.push_back(sequence.frames[i].borderSpeedPx);
  }
  return medianOf(std::move(speeds));
}

}  // namespace fluidymation
