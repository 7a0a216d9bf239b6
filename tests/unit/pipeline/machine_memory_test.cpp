#include "pipeline/machine_memory.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <limits>
#include <string>

#include "support/temporary_folder.h"

namespace fluidymation {
namespace {

constexpr std::int64_t kNoLimit = std::numeric_limits<std::int64_t>::max();

class MachineMemory : public ::testing::Test {
 protected:
  void write(const std::string& name, const std::string& text) {
    std::filesystem::create_directories(std::filesystem::path(folder_.file(name)).parent_path());
    test::writeBytes(folder_.file(name), test::bytesOf(text));
  }
  [[nodiscard]] std::int64_t limit(const std::string& groups) const {
    return groupMemoryBytes(groups, folder_.path());
  }

 private:
  test::TemporaryFolder folder_;
};

TEST_F(MachineMemory, OfAGroupIsTheLeastOfItAndThoseAboveIt) {
  write("job/memory.max", "3000000\n");
  write("job/step/memory.max", "max\n");
  EXPECT_EQ(limit("0::/job/step\n"), 3000000);
  write("job/step/memory.max", "2000000\n");
  EXPECT_EQ(limit("0::/job/step\n"), 2000000);
  EXPECT_EQ(limit("0::/job\n"), 3000000);
  EXPECT_EQ(limit("0::/\n"), kNoLimit);
}

TEST_F(MachineMemory, InAContainerIsThatOfTheRoot) {
  write("memory.max", "5000000\n");
  EXPECT_EQ(limit("0::/known/to/the/host/only\n"), 5000000);
}

TEST_F(MachineMemory, OfTheFirstVersionIsThatOfItsController) {
  write("memory/job/memory.limit_in_bytes", "4000000\n");
  EXPECT_EQ(limit("7:cpu,cpuacct:/other\n5:hugetlb,memory:/job\n0::/\n"), 4000000);
}

TEST_F(MachineMemory, HasNoLimitWhereNoneCanBeRead) {
  write("job/memory.max", "-7 or so\n");
  for (const char* groups : {"", "nonsense", "0::/job\n", "1:memory:\n", "::::\n"}) {
    EXPECT_EQ(limit(groups), kNoLimit) << groups;
  }
}

TEST(MachineMemoryItself, IsThereAndNoMoreThanAnyMachineHas) {
  EXPECT_GT(machineMemoryBytes(), 64 << 20);
  EXPECT_LT(machineMemoryBytes(), std::int64_t{1} << 50);
}

}  // namespace
}  // namespace fluidymation
