#pragma once

#include <gtest/gtest.h>

#include "fluidymation/core/image.h"

namespace fluidymation::test {

/// Succeeds when the images have one size and no pixel differs by more than `tolerance`; says
/// otherwise how many differ, where the first one is, and how large the largest difference is.
[[nodiscard]] ::testing::AssertionResult nearEverywhere(const Image<float>& expected,
                                                        const Image<float>& actual,
                                                        float tolerance);
[[nodiscard]] ::testing::AssertionResult nearEverywhere(const Image<Vec2>& expected,
                                                        const Image<Vec2>& actual, float tolerance);
[[nodiscard]] ::testing::AssertionResult equalEverywhere(const Mask& expected, const Mask& actual);

}  // namespace fluidymation::test
