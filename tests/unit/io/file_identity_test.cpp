#include "fluidymation/io/file_identity.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>

#include "fluidymation/core/error.h"
#include "support/temporary_folder.h"

namespace fluidymation {
namespace {

using test::bytesOf;
using test::messageOf;

class FileIdentityTest : public ::testing::Test {
 protected:
  FileIdentityTest() {
    test::writeBytes(path_, bytesOf("as it was"));
    setTime(path_, 1000);
    before_ = fileIdentityOf(path_);
  }

  static void setTime(const std::string& path, long nanoseconds) {
    const timespec times[2] = {{1, nanoseconds}, {1, nanoseconds}};
    ASSERT_EQ(utimensat(AT_FDCWD, path.c_str(), times, 0), 0);
  }
  [[nodiscard]] std::string complaint() const {
    return messageOf<Error>([&] { requireUnchanged(path_, before_); });
  }
  [[nodiscard]] std::string changed(const std::string& what) const {
    return path_ + ": changed while the run was at work (" + what +
           "); wanted inputs that stay as they are until all is painted";
  }

  test::TemporaryFolder folder_;
  std::string path_ = folder_.file("a.png");
  FileIdentity before_;
};

TEST_F(FileIdentityTest, WhatNobodyTouchesIsUnchanged) { EXPECT_EQ(complaint(), ""); }

TEST_F(FileIdentityTest, ReadingChangesNothing) {
  (void)test::readBytes(path_);
  EXPECT_EQ(complaint(), "");
}

TEST_F(FileIdentityTest, ALaterTimeIsNoticed) {
  setTime(path_, 1001);
  EXPECT_EQ(complaint(), changed("it was written to"));
}

TEST_F(FileIdentityTest, AnotherLengthIsNoticed) {
  test::writeBytes(path_, bytesOf("longer than it was"));
  setTime(path_, 1000);
  EXPECT_EQ(complaint(), changed("it was written to, 9 bytes at first, then 18"));
}

TEST_F(FileIdentityTest, AnotherFileInItsPlaceIsNoticed) {
  const std::string other = folder_.file("other");
  test::writeBytes(other, bytesOf("as it was"));
  setTime(other, 1000);
  std::filesystem::rename(other, path_);
  EXPECT_EQ(complaint(), changed("another file took its place"));
}

TEST_F(FileIdentityTest, AMissingFileIsNamed) {
  std::filesystem::remove(path_);
  EXPECT_EQ(complaint(), path_ + ": cannot be opened (No such file or directory)");
}

}  // namespace
}  // namespace fluidymation
