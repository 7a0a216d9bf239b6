#include "footage/light_meter.h"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstdint>

#include "fluidymation/core/index.h"

namespace fluidymation {
namespace {

constexpr int kMostCellsAlong = 24;
constexpr int kLeastCellPx = 8;
constexpr std::size_t kLeastCells = 4;

[[nodiscard]] int cellsAlong(int length) {
  return std::clamp(length / kLeastCellPx, 1, kMostCellsAlong);
}

[[nodiscard]] int cellOf(int place, int length, int cells) {
  return static_cast<int>(std::int64_t{place} * cells / length);
}

}  // namespace

LightMeter::LightMeter(const Image<Lab>& bare)
    : size_(bare.size()),
      cells_{cellsAlong(bare.width()), cellsAlong(bare.height())},
      bare_(meansOf(bare)) {}

void LightMeter::add(const Image<Lab>& frame) { frames_.push_back(meansOf(frame)); }

std::vector<Lab> LightMeter::drift(const Mask& everPainted) const {
  const std::vector<std::size_t> unpainted = unpaintedCells(everPainted);
  std::vector<Lab> drifts;
  if (unpainted.size() < kLeastCells) return drifts;
  const float share = 1.0F / static_cast<float>(unpainted.size());
  for (const Cells& frame : frames_) {
    Lab drift;
    for (const std::size_t cell : unpainted) {
      drift.l += share * (frame[cell].l - bare_[cell].l);
      drift.a += share * (frame[cell].a - bare_[cell].a);
      drift.b += share * (frame[cell].b - bare_[cell].b);
    }
    drifts.push_back(drift);
  }
  return drifts;
}

LightMeter::Cells LightMeter::meansOf(const Image<Lab>& picture) const {
  assert(picture.size() == size_);
  struct Sum {
    double l = 0.0;
    double a = 0.0;
    double b = 0.0;
    double pixels = 0.0;
  };
  std::vector<Sum> sums(at(cells_.width) * at(cells_.height));
  for (int y = 0; y < size_.height; ++y) {
    const std::size_t row = at(cellOf(y, size_.height, cells_.height)) * at(cells_.width);
    for (int x = 0; x < size_.width; ++x) {
      Sum& sum = sums[row + at(cellOf(x, size_.width, cells_.width))];
      const Lab color = picture(x, y);
      sum.l += color.l;
      sum.a += color.a;
      sum.b += color.b;
      sum.pixels += 1.0;
    }
  }
  Cells means;
  for (const Sum& sum : sums) {
    means.push_back({static_cast<float>(sum.l / sum.pixels), static_cast<float>(sum.a / sum.pixels),
                     static_cast<float>(sum.b / sum.pixels)});
  }
  return means;
}

std::vector<std::size_t> LightMeter::unpaintedCells(const Mask& everPainted) const {
  assert(everPainted.size() == size_);
  Mask painted(cells_);
  for (int y = 0; y < size_.height; ++y) {
    for (int x = 0; x < size_.width; ++x) {
      if (everPainted(x, y) == 0) continue;
      painted(cellOf(x, size_.width, cells_.width), cellOf(y, size_.height, cells_.height)) = 1;
    }
  }
  std::vector<std::size_t> unpainted;
  for (int y = 0; y < cells_.height; ++y) {
    for (int x = 0; x < cells_.width; ++x) {
      bool isApart = true;
      for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) isApart = isApart && painted.clamped(x + dx, y + dy) == 0;
      }
      if (isApart) unpainted.push_back(at(y) * at(cells_.width) + at(x));
    }
  }
  return unpainted;
}

}  // namespace fluidymation
