#pragma once

namespace fluidymation {

// The fixed point of the kernels, the same in all of them. Positions between pixels:
inline constexpr int kSubpixelBits = 16;
inline constexpr float kSubpixels = 65536.0F;  ///< steps per pixel
static_assert(kSubpixels == static_cast<float>(1 << kSubpixelBits));
/// Weights of an interpolation, and shares of a blend.
inline constexpr int kShareBits = 15;
inline constexpr float kShareStep = 1.0F / 32768.0F;
static_assert(kShareStep * static_cast<float>(1 << kShareBits) == 1.0F);

}  // namespace fluidymation
