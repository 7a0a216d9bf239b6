#include "support/golden.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

#include "fluidymation/io/png.h"

namespace fluidymation::test {
namespace {

/// Red, green, blue, alpha as they stand in the file.
std::array<int, 4> channelsOf(const Rgba& pixel) {
  const auto byte = [](float value) { return static_cast<int>(std::lround(255.0F * value)); };
  return {byte(pixel.r), byte(pixel.g), byte(pixel.b), byte(pixel.a)};
}

std::string text(const std::array<int, 4>& pixel) {
  return "(" + std::to_string(pixel[0]) + ", " + std::to_string(pixel[1]) + ", " +
         std::to_string(pixel[2]) + ", " + std::to_string(pixel[3]) + ")";
}

}  // namespace

::testing::AssertionResult isGolden(const std::string& expectedPath, const std::string& actualPath,
                                    const GoldenTolerance& tolerance) {
  const Image<Rgba> expected = readPng(expectedPath);
  const Image<Rgba> actual = readPng(actualPath);
  if (expected.size() != actual.size()) {
    return ::testing::AssertionFailure() << actualPath << ": size " << actual.width() << "x"
                                         << actual.height() << ", not that of " << expectedPath;
  }
  int painted = 0;
  int beyond = 0;
  int largest = 0;
  std::array<double, 3> meanShift{};
  std::string first;
  for (int y = 0; y < expected.height(); ++y) {
    for (int x = 0; x < expected.width(); ++x) {
      const std::array<int, 4> e = channelsOf(expected(x, y));
      const std::array<int, 4> a = channelsOf(actual(x, y));
      const std::string place = "(" + std::to_string(x) + ", " + std::to_string(y) + ") is " +
                                text(a) + ", not " + text(e);
      if (e[3] != a[3]) {
        return ::testing::AssertionFailure()
               << actualPath << ": alpha differs, pixel " << place << " of " << expectedPath;
      }
      if (e[3] == 0) continue;  // shows no colour, whichever it has
      ++painted;
      int error = 0;
      for (std::size_t c = 0; c < 3; ++c) {
        error = std::max(error, std::abs(e[c] - a[c]));
        meanShift[c] += a[c] - e[c];
      }
      largest = std::max(largest, error);
      if (error > tolerance.threshold && beyond++ == 0) first = place;
    }
  }
  const double count = std::max(painted, 1);
  double shift = 0.0;
  for (const double channel : meanShift) shift = std::max(shift, std::abs(channel) / count);
  const double share = beyond / count;
  if (largest <= tolerance.hardLimit && share <= tolerance.share && shift <= tolerance.meanColor) {
    return ::testing::AssertionSuccess();
  }
  return ::testing::AssertionFailure()
         << actualPath << " is not the picture of " << expectedPath << ": largest error " << largest
         << " (limit " << tolerance.hardLimit << "), " << 100.0 * share
         << " % of the painted pixels beyond " << tolerance.threshold << " (limit "
         << 100.0 * tolerance.share << " %), mean colour off by " << shift << " (limit "
         << tolerance.meanColor << ")" << (first.empty() ? "" : "; the first pixel, " + first);
}

}  // namespace fluidymation::test
