#include "pipeline/run_journal.h"

#include <gtest/gtest.h>

namespace fluidymation {
namespace {

using Seconds = CheckpointClock::Seconds;

TEST(CheckpointClockTest, CountsFramesWhereToldHowMany) {
  const CheckpointClock clock(3);
  EXPECT_FALSE(clock.isDue(1, Seconds(1e6)));
  EXPECT_FALSE(clock.isDue(2, Seconds(1e6)));
  EXPECT_TRUE(clock.isDue(3, Seconds(0.0)));
}

TEST(CheckpointClockTest, NeverTakesMoreThanItsShare) {
  // States take from nothing to several frames' time.
  for (const double cost : {0.001, 0.02, 0.1, 1.0, 5.0}) {
    CheckpointClock clock(std::nullopt);
    double elapsed = 0.0;
    double spent = 0.0;
    int saved = 0;
    for (int frame = 0; frame < 2000; ++frame) {
      elapsed += 0.7;
      if (!clock.isDue(1, Seconds(elapsed))) continue;
      clock.saved(Seconds(cost));
      elapsed += cost;
      spent += cost;
      ++saved;
      // All but the first one, of which nothing is known
      if (saved > 1) {
        EXPECT_LE(spent - cost, kCheckpointShare * elapsed) << cost;
      }
    }
    EXPECT_LE(spent, kCheckpointShare * elapsed + cost) << cost;
    EXPECT_GT(saved, 0);
    if (cost <= 0.01) {
      EXPECT_GT(saved, 1990) << "as good as every frame";
    }
  }
}

}  // namespace
}  // namespace fluidymation
