#include <gtest/gtest.h>

#include "fluidymation/core/error.h"
#include "fluidymation/io/flow_file.h"
#include "fluidymation/io/pfm.h"
#include "support/temporary_folder.h"

namespace fluidymation {
namespace {

using test::Bytes;
using test::bytesOf;
using test::readBytes;
using test::TemporaryFolder;

Bytes operator+(Bytes a, const Bytes& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

// IEEE 754, lowest byte first.
const Bytes kZero = {0x00, 0x00, 0x00, 0x00};
const Bytes kOne = {0x00, 0x00, 0x80, 0x3F};
const Bytes kMinusTwo = {0x00, 0x00, 0x00, 0xC0};
const Bytes kHalf = {0x00, 0x00, 0x00, 0x3F};

TEST(Pfm, OneChannelIsExactBottomRowFirst) {
  const TemporaryFolder folder;
  Image<float> image(Size{2, 2});
  image(0, 0) = 1.0F;
  image(1, 0) = -2.0F;
  image(1, 1) = 0.5F;
  writePfm(folder.file("a.pfm"), image);
  EXPECT_EQ(readBytes(folder.file("a.pfm")),
            bytesOf("Pf\n2 2\n-1.0\n") + kZero + kHalf + kOne + kMinusTwo);
}

TEST(Pfm, ThreeChannelsAreExact) {
  const TemporaryFolder folder;
  Image<Float3> image(Size{1, 2});
  image(0, 0) = {1.0F, -2.0F, 0.5F};
  writePfm(folder.file("a.pfm"), image);
  EXPECT_EQ(readBytes(folder.file("a.pfm")),
            bytesOf("PF\n1 2\n-1.0\n") + kZero + kZero + kZero + kOne + kMinusTwo + kHalf);
}

TEST(FlowFile, IsExactTopRowFirst) {
  const TemporaryFolder folder;
  Image<Vec2> flow(Size{2, 1});
  flow(0, 0) = {1.0F, -2.0F};
  flow(1, 0) = {0.5F, 0.0F};
  writeFlow(folder.file("a.flo"), flow);
  const Bytes size = {2, 0, 0, 0, 1, 0, 0, 0};
  EXPECT_EQ(readBytes(folder.file("a.flo")),
            bytesOf("PIEH") + size + kOne + kMinusTwo + kHalf + kZero);
}

TEST(FloatFiles, NameTheFileThatCannotBeWritten) {
  const TemporaryFolder folder;
  const std::string path = folder.file("none/a");
  const std::string message = path + ": cannot be written (No such file or directory)";
  EXPECT_EQ(test::messageOf<Error>([&] { writePfm(path, Image<float>(Size{1, 1})); }), message);
  EXPECT_EQ(test::messageOf<Error>([&] { writeFlow(path, Image<Vec2>(Size{1, 1})); }), message);
}

}  // namespace
}  // namespace fluidymation
