#include "fluidymation/automatic.h"

#include <gtest/gtest.h>

#include <cmath>

namespace fluidymation {
namespace {

TEST(AutomaticWidths, GrowWithTheResolution) {
  for (const int scale : {1, 2, 4}) {
    const double area = 40'000.0 * scale * scale;
    EXPECT_FLOAT_EQ(automaticBlurSigmaPx({area, area}), 2.5F * static_cast<float>(scale));
    EXPECT_NEAR(automaticBorderWidthPx({400 * scale, 222 * scale}),
                10.4F * static_cast<float>(scale), 0.1F * static_cast<float>(scale));
  }
}

TEST(AutomaticWidths, EmptyFramesDoNotCount) {
  EXPECT_EQ(automaticBlurSigmaPx({0, 40'000, 0, 0}), automaticBlurSigmaPx({40'000}));
  EXPECT_EQ(automaticBlurSigmaPx({0, 0}), 0.0F);
  EXPECT_EQ(automaticBlurSigmaPx({}), 0.0F);
}

TEST(AutomaticWidths, MeasuredBordersStayNearThoseBySize) {
  const Size film{400, 222};
  const float bySize = automaticBorderWidthPx(film);
  EXPECT_EQ(boundedBorderWidthPx(std::nullopt, film), bySize);
  EXPECT_EQ(boundedBorderWidthPx(12.0F, film), 12.0F);
  EXPECT_FLOAT_EQ(boundedBorderWidthPx(1.0F, film), bySize / 2);
  EXPECT_FLOAT_EQ(boundedBorderWidthPx(99.0F, film), 2 * bySize);
}

TEST(AutomaticWidths, AreMeansOverFramesAndTenthsOfAPixel) {
  EXPECT_FLOAT_EQ(automaticBlurSigmaPx({10'000, 30'000}), 1.8F);  // 1.77
  EXPECT_FLOAT_EQ(automaticBorderWidthPx({1, 1}), 1.0F);
}

}  // namespace
}  // namespace fluidymation
