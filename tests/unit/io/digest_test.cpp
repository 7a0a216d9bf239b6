#include "fluidymation/io/digest.h"

#include <gtest/gtest.h>

#include "fluidymation/core/error.h"
#include "support/temporary_folder.h"

namespace fluidymation {
namespace {

using test::Bytes;
using test::messageOf;
using test::TemporaryFolder;

TEST(DigestTest, IsTheOneThatXxhsumPrints) {
  EXPECT_EQ(digestOf("", 0).text(), "99aa06d3014798d86001c324468d497f");  // xxhsum -H2 /dev/null
}

TEST(DigestTest, ComesBackFromItsText) {
  const Digest digest = digestOf("abc", 3);
  EXPECT_TRUE(Digest::parse(digest.text()) == digest);
  for (const std::string& bad : {std::string(), digest.text().substr(1), digest.text() + "0",
                                 std::string(32, 'g'), std::string(32, 'A')}) {
    EXPECT_FALSE(Digest::parse(bad).has_value()) << bad;
  }
}

TEST(DigestTest, OfAFileIsThatOfItsBytes) {
  const TemporaryFolder folder;
  for (const std::size_t size : {0U, 1U, 240U, 241U, 262'144U, 262'145U, 1'000'003U}) {
    Bytes bytes(size);
    for (std::size_t i = 0; i < size; ++i) bytes[i] = static_cast<std::uint8_t>(i * i / 7);
    test::writeBytes(folder.file("f"), bytes);
    EXPECT_TRUE(digestOfFile(folder.file("f")) == digestOf(bytes.data(), bytes.size())) << size;
  }
}

TEST(DigestTest, NamesAFileThatCannotBeRead) {
  const TemporaryFolder folder;
  EXPECT_EQ(messageOf<Error>([&] { (void)digestOfFile(folder.file("none")); }),
            folder.file("none") + ": cannot be read (No such file or directory)");
  EXPECT_EQ(messageOf<Error>([&] { (void)digestOfFile(folder.path()); }),
            folder.path() + ": cannot be read (Is a directory)");
}

}  // namespace
}  // namespace fluidymation
