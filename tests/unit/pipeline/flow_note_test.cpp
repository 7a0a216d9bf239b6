#include "pipeline/flow_note.h"

#include <gtest/gtest.h>

namespace fluidymation {
namespace {

TEST(FlowNote, NamesSequenceAndFrameOfAFlowThatDidNotSettle) {
  SolveReport report;
  report.cycles = 100;
  report.lastChange = 0.25F;
  report.converged = false;
  EXPECT_EQ(
      flowNote("--target-path t/%d.png", -7, report),
      "--target-path t/%d.png: frame -7: the motion inside the shape, or its direction, still "
      "changed by 0.25 after 100 cycles; it is painted as it stands");
}

TEST(FlowNote, SaysNothingOfASoundOne) {
  SolveReport report;
  report.cycles = 5;
  EXPECT_FALSE(flowNote("--target-path t/%d.png", 1, report));
}

}  // namespace
}  // namespace fluidymation
