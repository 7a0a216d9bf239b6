#include "pipeline/fault_list.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "fluidymation/core/error.h"

namespace fluidymation {
namespace {

using Lines = std::vector<std::string>;

TEST(FaultList, GathersEachMessageOnceInOrder) {
  FaultList faults;
  EXPECT_TRUE(faults.gather([] {}));
  EXPECT_TRUE(faults.empty());
  EXPECT_NO_THROW(faults.throwIfAny());
  EXPECT_FALSE(faults.gather([] { throw Error("b"); }));
  EXPECT_FALSE(faults.gather([] { throw Faults({"a", "b"}); }));
  EXPECT_FALSE(faults.gather([] { throw UsageError("c"); }));
  EXPECT_EQ(faults.lines(), (Lines{"b", "a", "c"}));
  try {
    faults.throwIfAny();
    FAIL() << "nothing was thrown";
  } catch (const Faults& thrown) {
    EXPECT_EQ(thrown.lines(), (Lines{"b", "a", "c"}));
  }
}

TEST(FaultList, MisuseEndsEverythingWhereItIsSaidTo) {
  FaultList faults;
  EXPECT_TRUE(faults.gatherUnlessMisused([] {}));
  EXPECT_FALSE(faults.gatherUnlessMisused([] { throw Error("a"); }));
  EXPECT_FALSE(faults.gatherUnlessMisused([] { throw Faults({"b", "c"}); }));
  EXPECT_THROW(faults.gatherUnlessMisused([] { throw UsageError("d"); }), UsageError);
  EXPECT_EQ(faults.lines(), (Lines{"a", "b", "c"}));
}

TEST(FaultList, CountsWhatIsBeyondTheMost) {
  FaultList faults(2);
  for (const char* message : {"a", "b", "c", "a", "d"}) {
    faults.gather([message] { throw Error(message); });
  }
  EXPECT_EQ(faults.lines(), (Lines{"a", "b", "... and 2 more"}));
}

}  // namespace
}  // namespace fluidymation
