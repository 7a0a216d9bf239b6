#pragma once

#include <cmath>

namespace fluidymation {

inline constexpr float kTwoPi = 6.2831853F;

/// The largest integer that is not above `value`, which must fit an int. Inline, unlike std::floor
/// where the instruction set has no rounding.
[[nodiscard]] inline int floorToInt(float value) {
  const int towardsZero = static_cast<int>(value);
  return towardsZero - (value < static_cast<float>(towardsZero) ? 1 : 0);
}

/// Width and height in pixels.
struct Size {
  int width = 0;
  int height = 0;
  friend bool operator==(const Size& a, const Size& b) {
    return a.width == b.width && a.height == b.height;
  }
  friend bool operator!=(const Size& a, const Size& b) { return !(a == b); }
};

/// A place on the pixel grid: x right, y down.
struct Pixel {
  int x = 0;
  int y = 0;
};

/// A point or a movement in the image plane: pixels, x right, y down.
struct Vec2 {
  float x = 0.0F;
  float y = 0.0F;

  friend Vec2 operator+(Vec2 a, Vec2 b) { return {a.x + b.x, a.y + b.y}; }
  friend Vec2 operator-(Vec2 a, Vec2 b) { return {a.x - b.x, a.y - b.y}; }
  friend Vec2 operator*(float s, Vec2 a) { return {s * a.x, s * a.y}; }
  Vec2& operator+=(Vec2 b) { return *this = *this + b; }
};

[[nodiscard]] inline float dot(Vec2 a, Vec2 b) { return a.x * b.x + a.y * b.y; }
[[nodiscard]] inline float length(Vec2 a) { return std::sqrt(dot(a, a)); }

/// A rotation in the image plane held as (cos, sin), so that turning a vector needs no
/// trigonometry. R_theta = [cos -sin; sin cos]; with y down a positive angle turns clockwise.
struct Rotation {
  float cosine = 1.0F;
  float sine = 0.0F;

  [[nodiscard]] Vec2 apply(Vec2 v) const {
    return {cosine * v.x - sine * v.y, sine * v.x + cosine * v.y};
  }
  [[nodiscard]] Rotation inverse() const { return {cosine, -sine}; }
  [[nodiscard]] Rotation opposite() const { return {-cosine, -sine}; }
  [[nodiscard]] float angleRad() const { return std::atan2(sine, cosine); }

  /// The rotation that turns unit vector `from` into unit vector `to`.
  [[nodiscard]] static Rotation between(Vec2 from, Vec2 to) {
    return {dot(from, to), from.x * to.y - from.y * to.x};
  }
};

}  // namespace fluidymation
