#include "rigid_motion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "fluidymation/core/parallel.h"

namespace fluidymation {
namespace {

/// Shares of the squared normal speeds between which a fit comes to be believed. Measured on the
/// galloping horse (translation with swinging legs): 0.4 to 0.6; on discs, bars and cogwheels that
/// travel or turn: above 0.9; on an arm that waves at a body at rest: below 0.2.
constexpr double kUnexplainedShare = 0.3;
constexpr double kExplainedShare = 0.7;

/// Added to the normal equations, relative to their size: a border that says nothing of a movement
/// (a disc of its rotation, a straight front of what goes along it) leaves it at zero.
constexpr double kRidge = 0.003;

/// Refits, each of which gives less weight to what the last one left: 1 / (1 + (rest / scale)^2),
/// with a scale of kScaleShare of the part's root mean square speed. What most of the border does
/// counts, and a long arm does not turn the body that it swings from.
constexpr int kRefits = 8;
constexpr double kScaleShare = 0.3;

constexpr std::size_t kUnknowns = 4;  // translation x, y; rotation; scaling
using Vector = std::array<double, kUnknowns>;
using Matrix = std::array<Vector, kUnknowns>;

/// Solves a x = b for a symmetric, positive definite a, by Cholesky's decomposition.
Vector solvePositive(Matrix a, Vector b) {
  for (std::size_t i = 0; i < kUnknowns; ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      double sum = a[i][j];
      for (std::size_t k = 0; k < j; ++k) sum -= a[i][k] * a[j][k];
      a[i][j] = i == j ? std::sqrt(sum) : sum / a[j][j];
    }
  }
  for (std::size_t i = 0; i < kUnknowns; ++i) {
    for (std::size_t k = 0; k < i; ++k) b[i] -= a[i][k] * b[k];
    b[i] /= a[i][i];
  }
  for (std::size_t i = kUnknowns; i-- > 0;) {
    for (std::size_t k = i + 1; k < kUnknowns; ++k) b[i] -= a[k][i] * b[k];
    b[i] /= a[i][i];
  }
  return b;
}

/// The border of one part, and the movement fitted to it.
struct Part {
  double count = 0.0;
  double centreX = 0.0;
  double centreY = 0.0;
  double radius = 0.0;  ///< root mean square distance from the centre, px: the unit of lengths
  Matrix normal{};
  Vector right{};
  double weights = 0.0;
  double squaredSpeeds = 0.0;
  double squaredRests = 0.0;
  Vector motion{};  ///< translation, and rotation and scaling times `radius`; px per frame

  [[nodiscard]] Vector row(int x, int y, Vec2 n) const {
    const double dx = (x - centreX) / radius;
    const double dy = (y - centreY) / radius;
    const auto nx = static_cast<double>(n.x);
    const auto ny = static_cast<double>(n.y);
    return {nx, ny, ny * dx - nx * dy, nx * dx + ny * dy};
  }

  [[nodiscard]] double speedAlong(int x, int y, Vec2 n) const {
    const Vector a = row(x, y, n);
    return a[0] * motion[0] + a[1] * motion[1] + a[2] * motion[2] + a[3] * motion[3];
  }

  [[nodiscard]] Vec2 at(int x, int y) const {
    const double dx = (x - centreX) / radius;
    const double dy = (y - centreY) / radius;
    return {static_cast<float>(motion[0] - motion[2] * dy + motion[3] * dx),
            static_cast<float>(motion[1] + motion[2] * dx + motion[3] * dy)};
  }

  /// Weight of a border pixel in the next fit.
  [[nodiscard]] double weightOf(int x, int y, Vec2 n, double speed) const {
    const double scale = kScaleShare * std::sqrt(squaredSpeeds / count);
    if (scale <= 0.0) return 1.0;
    const double rest = (speed - speedAlong(x, y, n)) / scale;
    return 1.0 / (1.0 + rest * rest);
  }

  void forgetEquations() {
    normal = {};
    right = {};
    weights = 0.0;
  }

  void addEquation(const Vector& a, double speed, double weight) {
    for (std::size_t i = 0; i < kUnknowns; ++i) {
      for (std::size_t k = 0; k < kUnknowns; ++k) normal[i][k] += weight * a[i] * a[k];
      right[i] += weight * a[i] * speed;
    }
    weights += weight;
  }

  void solve() {
    if (squaredSpeeds <= 0.0) return;
    for (std::size_t i = 0; i < kUnknowns; ++i) normal[i][i] += kRidge * weights;
    motion = solvePositive(normal, right);
  }

  /// Trust in the fit, 0 to 1.
  [[nodiscard]] double trust() const {
    if (squaredSpeeds <= 0.0) return 0.0;
    const double explained = 1.0 - squaredRests / squaredSpeeds;
    const double t = std::clamp(
        (explained - kUnexplainedShare) / (kExplainedShare - kUnexplainedShare), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
  }
};

}  // namespace

Image<Vec2> rigidMotion(const Components& parts, const Mask& border, const Image<Vec2>& normals,
                        const Image<float>& speeds, Pixel origin) {
  std::vector<Part> fits(static_cast<std::size_t>(parts.count));
  // One after the other, in row order: sums of doubles depend on their order.
  const auto forEachNormal = [&](const auto& body) {
    for (int y = 0; y < border.height(); ++y) {
      for (int x = 0; x < border.width(); ++x) {
        const Vec2 n = normals(x, y);
        if (border(x, y) == 0 || (n.x == 0.0F && n.y == 0.0F)) continue;
        body(fits[static_cast<std::size_t>(parts.label(x, y))], origin.x + x, origin.y + y, n,
             static_cast<double>(speeds(x, y)));
      }
    }
  };

  forEachNormal([](Part& part, int x, int y, Vec2 /*n*/, double /*speed*/) {
    part.count += 1.0;
    part.centreX += x;
    part.centreY += y;
  });
  for (Part& part : fits) {
    if (part.count == 0.0) continue;
    part.centreX /= part.count;
    part.centreY /= part.count;
  }
  forEachNormal([](Part& part, int x, int y, Vec2 /*n*/, double /*speed*/) {
    const double dx = x - part.centreX;
    const double dy = y - part.centreY;
    part.radius += dx * dx + dy * dy;
  });
  for (Part& part : fits) {
    part.radius = part.count == 0.0 ? 1.0 : std::max(std::sqrt(part.radius / part.count), 1.0);
  }

  forEachNormal([](Part& part, int /*x*/, int /*y*/, Vec2 /*n*/, double speed) {
    part.squaredSpeeds += speed * speed;
  });
  for (int fit = 0; fit <= kRefits; ++fit) {
    for (Part& part : fits) part.forgetEquations();
    forEachNormal([fit](Part& part, int x, int y, Vec2 n, double speed) {
      part.addEquation(part.row(x, y, n), speed, fit == 0 ? 1.0 : part.weightOf(x, y, n, speed));
    });
    for (Part& part : fits) part.solve();
  }
  forEachNormal([](Part& part, int x, int y, Vec2 n, double speed) {
    const double rest = speed - part.speedAlong(x, y, n);
    part.squaredRests += rest * rest;
  });
  for (Part& part : fits) {
    const double trust = part.trust();
    for (double& component : part.motion) component *= trust;
  }

  Image<Vec2> motion(border.size());
  forEachRow(border.height(), [&](int y) {
    for (int x = 0; x < border.width(); ++x) {
      const int label = parts.label(x, y);
      if (label < 0) continue;
      motion(x, y) = fits[static_cast<std::size_t>(label)].at(origin.x + x, origin.y + y);
    }
  });
  return motion;
}

}  // namespace fluidymation
