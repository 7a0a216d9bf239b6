#include "fluidymation/io/record_store.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "fluidymation/core/error.h"
#include "support/temporary_folder.h"

namespace fluidymation {
namespace {

using Bytes = std::vector<std::uint8_t>;

/// Records of all kinds of lengths, also empty ones.
std::vector<Bytes> someRecords(int count) {
  std::vector<Bytes> records;
  for (int i = 0; i < count; ++i) {
    Bytes bytes(static_cast<std::size_t>((i * 37) % 101));
    for (std::size_t k = 0; k < bytes.size(); ++k) {
      bytes[k] = static_cast<std::uint8_t>(i + 7 * static_cast<int>(k));
    }
    records.push_back(bytes);
  }
  return records;
}

TEST(RecordStore, GivesBackWhatWasAddedWhereverItLies) {
  const test::TemporaryFolder folder;
  const std::vector<Bytes> records = someRecords(60);
  for (const std::size_t memoryBytes : {0U, 1U, 500U, 1U << 20U}) {
    SCOPED_TRACE(memoryBytes);
    RecordStore store({memoryBytes, folder.path()});
    std::vector<RecordStore::Record> added;
    for (const Bytes& record : records) {
      added.push_back(store.add(record));
      EXPECT_LE(store.bytesInMemory(), memoryBytes);
    }
    for (std::size_t i = records.size(); i-- > 0;) {
      EXPECT_EQ(store.get<std::uint8_t>(added[i]), records[i]);
    }
    EXPECT_EQ(store.bytesOnDisk() > 0, memoryBytes < (1U << 20U));
  }
}

TEST(RecordStore, KeepsTheTypesOfValues) {
  const test::TemporaryFolder folder;
  RecordStore store({0, folder.path()});
  const std::vector<double> numbers = {1.5, -0.0, 1e300};
  const std::vector<std::uint16_t> shares = {0, 65535};
  const auto first = store.add(numbers);
  const auto second = store.add(shares);
  EXPECT_EQ(store.get<double>(first), numbers);
  EXPECT_EQ(store.get<std::uint16_t>(second), shares);
}

TEST(RecordStore, WhatIsDroppedMakesRoomInMemory) {
  const test::TemporaryFolder folder;
  RecordStore store({100, folder.path()});
  const Bytes large(100, 1);
  const auto first = store.add(large);
  EXPECT_EQ(store.bytesOnDisk(), 0U);
  const auto second = store.add(large);
  EXPECT_EQ(store.bytesOnDisk(), 100U);
  store.drop(first);
  EXPECT_EQ(store.bytesInMemory(), 0U);
  const auto third = store.add(large);
  EXPECT_EQ(store.bytesOnDisk(), 100U);
  store.drop(second);  // on the disk: takes nothing of the memory's
  EXPECT_EQ(store.bytesInMemory(), 100U);
  EXPECT_EQ(store.get<std::uint8_t>(third), large);
}

TEST(RecordStore, ItsFileIsSeenByNobodyAndMadeOnlyWhereItIsNeeded) {
  const test::TemporaryFolder folder;
  const std::string missing = folder.file("not/yet/there");
  {
    RecordStore store({0, missing});
    (void)store.add(Bytes(1000, 3));
    EXPECT_EQ(store.bytesOnDisk(), 1000U);
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
  }
  RecordStore none({1000, "/proc/self"});  // no files can be made there
  EXPECT_NO_THROW((void)none.add(Bytes(1000, 3)));
}

TEST(RecordStore, SaysWhereNoFileCanBeMade) {
  RecordStore store({0, "/proc/self"});
  const std::string said = test::messageOf<Error>([&] { (void)store.add(Bytes(10, 1)); });
  EXPECT_EQ(
      said.find("/proc/self: the temporary file for frames that wait for their turn cannot be "
                "created ("),
      0U)
      << said;
}

TEST(RecordStore, SaysWhenTheDiskTakesNoMoreAndKeepsWhatItHas) {
  const test::TemporaryFolder folder;
  rlimit before{};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  rlimit small = before;
  small.rlim_cur = 1000;
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
  RecordStore store({0, folder.path()});
  const Bytes record(600, 9);
  const auto first = store.add(record);
  const std::string said = test::messageOf<Error>([&] { (void)store.add(Bytes(600, 1)); });
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &before), 0);
  std::signal(SIGXFSZ, handler);
  EXPECT_NE(said.find("cannot grow (File too large); it holds 0 MiB so far; wanted "
                      "more room there, or frames on another disk"),
            std::string::npos)
      << said;
  EXPECT_EQ(store.bytesOnDisk(), 600U);
  EXPECT_EQ(store.get<std::uint8_t>(first), record);
}

}  // namespace
}  // namespace fluidymation
