#include "support/comparison.h"

#include <cmath>

namespace fluidymation::test {
namespace {

template <typename T, typename Difference, typename Print>
::testing::AssertionResult compare(const Image<T>& expected, const Image<T>& actual,
                                   double tolerance, const Difference& difference,
                                   const Print& print) {
  if (expected.size() != actual.size()) {
    return ::testing::AssertionFailure()
           << "size " << actual.width() << "x" << actual.height() << ", expected "
           << expected.width() << "x" << expected.height();
  }
  double largest = 0.0;
  int count = 0;
  int firstX = 0;
  int firstY = 0;
  for (int y = 0; y < expected.height(); ++y) {
    for (int x = 0; x < expected.width(); ++x) {
      const double d = difference(expected(x, y), actual(x, y));
      if (d <= tolerance) continue;  // also false for NaN
      if (count++ == 0) {
        firstX = x;
        firstY = y;
      }
      if (!(d <= largest)) largest = d;
    }
  }
  if (count == 0) return ::testing::AssertionSuccess();
  ::testing::AssertionResult failure = ::testing::AssertionFailure();
  failure << count << " pixels differ, first at (" << firstX << ", " << firstY << "): ";
  print(failure, actual(firstX, firstY));
  failure << ", expected ";
  print(failure, expected(firstX, firstY));
  return failure << " +- " << tolerance << "; largest difference " << largest;
}

}  // namespace

::testing::AssertionResult nearEverywhere(const Image<float>& expected, const Image<float>& actual,
                                          float tolerance) {
  return compare(
      expected, actual, tolerance,
      [](float a, float b) { return std::abs(static_cast<double>(a) - static_cast<double>(b)); },
      [](::testing::AssertionResult& out, float v) { out << v; });
}

::testing::AssertionResult nearEverywhere(const Image<Vec2>& expected, const Image<Vec2>& actual,
                                          float tolerance) {
  return compare(
      expected, actual, tolerance,
      [](Vec2 a, Vec2 b) { return static_cast<double>(length(a - b)); },
      [](::testing::AssertionResult& out, Vec2 v) { out << "(" << v.x << ", " << v.y << ")"; });
}

::testing::AssertionResult equalEverywhere(const Mask& expected, const Mask& actual) {
  return compare(
      expected, actual, 0.0, [](std::uint8_t a, std::uint8_t b) { return std::abs(a - b); },
      [](::testing::AssertionResult& out, std::uint8_t v) { out << static_cast<int>(v); });
}

}  // namespace fluidymation::test
