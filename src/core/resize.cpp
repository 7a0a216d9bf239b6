#include "fluidymation/core/resize.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "fluidymation/core/parallel.h"

namespace fluidymation {
namespace {

/// The input pixels first..first+weights.size()-1 of one side that make one output pixel.
struct Span {
  int first = 0;
  std::vector<float> weights;  ///< sum 1
};

/// Area averaging: the output pixel covers `ratio` input pixels, each weighted by its overlap.
Span areaSpan(int out, int inputLength, double ratio) {
  const double begin = out * ratio;
  const double end = std::min((out + 1) * ratio, static_cast<double>(inputLength));
  Span span;
  span.first = static_cast<int>(std::floor(begin));
  const int last = std::min(static_cast<int>(std::ceil(end)), inputLength) - 1;
  for (int i = span.first; i <= last; ++i) {
    const double overlap = std::min(end, i + 1.0) - std::max(begin, static_cast<double>(i));
    span.weights.push_back(static_cast<float>(overlap / (end - begin)));
  }
  return span;
}

/// Bilinear between the two nearest input pixels; the edge repeats.
Span bilinearSpan(int out, int inputLength, double ratio) {
  const double centre = (out + 0.5) * ratio - 0.5;
  const double position = std::clamp(centre, 0.0, inputLength - 1.0);
  Span span;
  span.first = std::min(static_cast<int>(std::floor(position)), std::max(inputLength - 2, 0));
  const auto fraction = static_cast<float>(position - span.first);
  span.weights = {1.0F - fraction};
  if (inputLength > 1) span.weights.push_back(fraction);
  return span;
}

std::vector<Span> spans(int inputLength, int outputLength) {
  const double ratio = static_cast<double>(inputLength) / outputLength;
  std::vector<Span> result;
  result.reserve(static_cast<std::size_t>(outputLength));
  for (int i = 0; i < outputLength; ++i) {
    result.push_back(ratio > 1.0 ? areaSpan(i, inputLength, ratio)
                                 : bilinearSpan(i, inputLength, ratio));
  }
  return result;
}

float scaled(float value, float weight) { return value * weight; }
Rgb scaled(Rgb value, float weight) {
  return {value.r * weight, value.g * weight, value.b * weight};
}
Vec2 scaled(Vec2 value, float weight) { return weight * value; }
void add(float& sum, float value) { sum += value; }
void add(Vec2& sum, Vec2 value) { sum += value; }
void add(Rgb& sum, Rgb value) {
  sum.r += value.r;
  sum.g += value.g;
  sum.b += value.b;
}

template <typename T>
Image<T> resizeImage(const Image<T>& image, Size size) {
  if (size == image.size()) return image.clone();
  const std::vector<Span> columns = spans(image.width(), size.width);
  const std::vector<Span> rows = spans(image.height(), size.height);

  Image<T> narrow(Size{size.width, image.height()});
  forEachRow(image.height(), [&](int y) {
    for (int x = 0; x < size.width; ++x) {
      const Span& span = columns[static_cast<std::size_t>(x)];
      T sum{};
      for (std::size_t i = 0; i < span.weights.size(); ++i) {
        add(sum, scaled(image(span.first + static_cast<int>(i), y), span.weights[i]));
      }
      narrow(x, y) = sum;
    }
  });

  Image<T> result(size);
  forEachRow(size.height, [&](int y) {
    const Span& span = rows[static_cast<std::size_t>(y)];
    for (std::size_t i = 0; i < span.weights.size(); ++i) {
      const T* input = narrow.row(span.first + static_cast<int>(i));
      for (int x = 0; x < size.width; ++x) add(result(x, y), scaled(input[x], span.weights[i]));
    }
  });
  return result;
}

}  // namespace

Size scaledSize(Size size, double scale) {
  const auto side = [scale](int length) {
    return std::max(1, static_cast<int>(std::lround(length * scale)));
  };
  return {side(size.width), side(size.height)};
}

Image<float> resize(const Image<float>& image, Size size) { return resizeImage(image, size); }
Image<Rgb> resize(const Image<Rgb>& image, Size size) { return resizeImage(image, size); }
Image<Vec2> resize(const Image<Vec2>& image, Size size) { return resizeImage(image, size); }

}  // namespace fluidymation
