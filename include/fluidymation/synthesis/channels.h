#pragma once

#include <algorithm>

namespace fluidymation {

/// Side of the square patch compared by the search and averaged by the vote, px; thesis §4.4.1.
inline constexpr int kPatchSize = 5;
inline constexpr int kPatchRadius = kPatchSize / 2;
inline constexpr int kPatchArea = kPatchSize * kPatchSize;

/// Channels of one pixel as the patch distance sees them.
enum Channel : int {
  kLightness,    ///< CIELAB L, 0..100
  kGreenRed,     ///< CIELAB a
  kBlueYellow,   ///< CIELAB b
  kEdge,         ///< kEdgeScale * min(distance / border width, 1), §3.4; or * blurred mask, P§3.1
  kExtForward,   ///< accumulated motion or age, see ExtentScale; §3.5
  kExtBackward,  ///< motion still to come, likewise; §3.5; 0 where ages are compared
  kDirectionX,   ///< unit direction of the flow; compared by angle where that has a weight
  kDirectionY,
  kChannelCount
};
inline constexpr int kColorChannels = 3;

/// Scales behind the weights of thesis §4.5. The thesis does not say in which units its channels
/// are compared, and read literally (sRGB in [0, 1], summed over the window) one pixel of motion
/// extent outweighs a plainly visible colour error: texture falls apart. With colours in CIELAB
/// and every term a mean over the window, a just visible colour error costs 1 to 3, one pixel of
/// edge distance at the border 5, five pixels of extent 0.28.
inline constexpr float kEdgeScale = 10.0F;
inline constexpr float kExtUnitPx = 3.0F;

/// Where extents are relative to the exemplar's (ExtentScale::boundedAt): the largest value of
/// their channels, and the extent at half of it as a share of the exemplar's mean extent.
inline constexpr float kLargestExtent = 5.0F;
inline constexpr float kHalfExtentShare = 1.0F;

/// Where ages are compared in the place of extents: the channel of the oldest material of the film.
/// With the extents' 5, at the same --flow-weight, the film's whole life costs no more than a
/// colour error of 2.7: what is new keeps the colours of the old paint beside it. With 20 the brush
/// is fresh in the pictures (docs/decisions.md has figures).
inline constexpr float kLargestAge = 20.0F;

/// How a motion extent, px, becomes a channel.
class ExtentScale {
 public:
  /// In units of kExtUnitPx, without bound, as the thesis has it.
  ExtentScale() = default;

  /// From 0 for no motion towards kLargestExtent for any: half of it at `halfPx` > 0. Extents are
  /// told apart where the exemplar has them; what has moved further than the exemplar ever does
  /// looks much like what has moved as far, and a film of twice the resolution compares alike.
  [[nodiscard]] static ExtentScale boundedAt(float halfPx) {
    ExtentScale scale;
    scale.halfPx_ = halfPx;
    return scale;
  }

  /// Of ages in the place of extents, frames: from 0 linearly to kLargestAge at `oldestFrames`, and
  /// no further: what is older than the film ever gets is as the film is in the end.
  [[nodiscard]] static ExtentScale ofAges(float oldestFrames) {
    ExtentScale scale;
    scale.ofAges_ = true;
    scale.oldestFrames_ = oldestFrames;
    return scale;
  }

  [[nodiscard]] bool isOfAges() const { return ofAges_; }

  /// Steps per unit when scaled extents are kept in fixed point, see FixedGuides: as fine as the
  /// largest of them allow. Without a bound 1023 units, 3000 px of movement, are told apart.
  [[nodiscard]] float stepsPerUnit() const {
    if (ofAges_) return 512.0F;
    return halfPx_ > 0.0F ? 2048.0F : 16.0F;
  }

  [[nodiscard]] float operator()(float extentPx) const {
    if (ofAges_) {
      if (oldestFrames_ <= 0.0F) return 0.0F;
      return kLargestAge * std::min(extentPx, oldestFrames_) / oldestFrames_;
    }
    return halfPx_ > 0.0F ? kLargestExtent * extentPx / (extentPx + halfPx_)
                          : extentPx / kExtUnitPx;
  }

 private:
  float halfPx_ = 0.0F;  ///< 0: linear
  bool ofAges_ = false;
  float oldestFrames_ = 0.0F;
};

/// The edge guide of thesis §3.4 from a signed distance, px; negative outside the mask.
[[nodiscard]] inline float edgeChannel(float distancePx, float borderWidthPx) {
  return kEdgeScale * std::min(distancePx / borderWidthPx, 1.0F);
}

}  // namespace fluidymation
