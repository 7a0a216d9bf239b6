#include "checkpoint/replaceable_frames.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "fluidymation/core/error.h"
#include "fluidymation/io/atomic_file.h"
#include "support/temporary_folder.h"

namespace fluidymation {
namespace {

[[nodiscard]] Digest digestOfText(const std::string& text) {
  return digestOf(text.data(), text.size());
}

const Digest kFirst = digestOfText("first");
const Digest kSecond = digestOfText("second");

TEST(ReplaceableFrames, AreReadAsTheyWereWrittenAndAppended) {
  const test::TemporaryFolder folder;
  const std::string path = folder.file("list.txt");
  FrameDigests frames;
  add(7, kFirst, frames);
  add(-2, kSecond, frames);
  add(7, kFirst, frames);
  writeAtomically(path, encode(frames));
  EXPECT_EQ(readReplaceableFrames(path), frames);
  EXPECT_EQ(frames[7].size(), 1U);
  appendLine(path, lineOf(7, kSecond));
  const FrameDigests read = readReplaceableFrames(path);
  EXPECT_TRUE(holds(read, 7, kFirst));
  EXPECT_TRUE(holds(read, 7, kSecond));
  EXPECT_FALSE(holds(read, -2, kFirst));
  EXPECT_FALSE(holds(read, 8, kFirst));
}

TEST(ReplaceableFrames, OfDamagedLinesAreNone) {
  const test::TemporaryFolder folder;
  const std::string path = folder.file("list.txt");
  const std::string good = lineOf(3, kFirst);
  for (const std::string& text : std::vector<std::string>{
           std::string(), std::string("\n\n"), good.substr(0, good.size() - 1), " " + good, "3\n",
           std::string("3 \n"), "x" + good, "99999999999999999999" + good,
           good.substr(0, good.size() - 2) + "\n", good.substr(0, good.size() - 1) + "0\n"}) {
    test::writeBytes(path, test::bytesOf(text));
    EXPECT_TRUE(readReplaceableFrames(path).empty()) << text;
    test::writeBytes(path, test::bytesOf(text + "\n" + good));
    EXPECT_TRUE(holds(readReplaceableFrames(path), 3, kFirst)) << text;
  }
  EXPECT_TRUE(readReplaceableFrames(folder.file("none.txt")).empty());
  EXPECT_TRUE(readReplaceableFrames(folder.file("")).empty());
}

TEST(ReplaceableFrames, AreAppendedToAFileThatIsThereOnly) {
  const test::TemporaryFolder folder;
  const std::string path = folder.file("none.txt");
  EXPECT_EQ(test::messageOf<Error>([&] { appendLine(path, lineOf(1, kFirst)); }),
            path + ": cannot be written (No such file or directory)");
}

}  // namespace
}  // namespace fluidymation
