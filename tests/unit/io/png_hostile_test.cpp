// Files that are damaged, hostile or no pictures at all: each is refused by name, in one line,
// without asking for memory first.
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <algorithm>
#include <csignal>
#include <random>

#include "fluidymation/core/error.h"
#include "fluidymation/io/png.h"
#include "support/png_maker.h"

namespace fluidymation {
namespace {

using test::Bytes;
using test::bytesOf;
using test::messageOf;
using test::PngChunk;
using test::PngColor;
using test::PngSpec;
using test::TemporaryFolder;

class HostilePng : public ::testing::Test {
 protected:
  [[nodiscard]] std::string complaint(const Bytes& file) const {
    test::writeBytes(path_, file);
    return messageOf<Error>([&] { (void)readPng(path_); });
  }
  [[nodiscard]] std::string sizeComplaint(const Bytes& file) const {
    test::writeBytes(path_, file);
    return messageOf<Error>([&] { (void)readPngSize(path_); });
  }

  TemporaryFolder folder_;
  std::string path_ = folder_.file("a.png");
};

Bytes wellFormed(PngColor color = PngColor::kRgb, bool interlaced = false) {
  PngSpec spec;
  spec.size = {20, 15};
  spec.color = color;
  spec.interlaced = interlaced;
  std::mt19937 random(5);
  for (int i = 0; i < 20 * 15 * test::channelsOf(color); ++i) {
    spec.samples.push_back(static_cast<std::uint16_t>(random() & 0xFFU));
  }
  return test::makePng(spec);
}

/// 1-bit gray `width` x `height` whose pixels are the given zlib stream.
Bytes grayPng(std::uint32_t width, std::uint32_t height, const Bytes& pixels) {
  return test::joinPng(
      {{"IHDR", test::pngHeader(width, height, 1, 0)}, {"IDAT", pixels}, {"IEND", {}}});
}

TEST_F(HostilePng, TruncatedAtAnyLengthIsRefused) {
  for (const bool interlaced : {false, true}) {
    const Bytes whole = wellFormed(PngColor::kRgb, interlaced);
    ASSERT_EQ(complaint(whole), "");
    for (std::size_t length = 0; length < whole.size(); ++length) {
      const std::string message =
          complaint(Bytes(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(length)));
      ASSERT_EQ(message.find(path_ + ": "), 0U) << length << " bytes: " << message;
    }
  }
}

TEST_F(HostilePng, SaysWhatIsWrong) {
  const Bytes whole = wellFormed();
  EXPECT_EQ(complaint({}), path_ + ": is empty; wanted a PNG file");
  EXPECT_EQ(complaint(bytesOf("GIF89a and so on, long enough for a header")),
            path_ + ": is no PNG file");
  EXPECT_EQ(complaint(bytesOf("x")), path_ + ": is no PNG file");
  EXPECT_EQ(complaint(Bytes(whole.begin(), whole.begin() + 20)),
            path_ + ": damaged PNG file (it ends within the header)");
  EXPECT_EQ(complaint(Bytes(whole.begin(), whole.end() - 20)),
            path_ + ": damaged PNG file (it ends too early)");
}

TEST_F(HostilePng, AnyFlippedByteIsRefused) {
  // Every byte of a PNG is covered by a signature, a length, a name or a check sum. Flipping bits
  // of a name could make it an unknown chunk, but its check sum then fails.
  const Bytes whole = wellFormed();
  for (std::size_t i = 0; i < whole.size(); ++i) {
    Bytes flipped = whole;
    flipped[i] ^= 0x10U;
    const std::string message = complaint(flipped);
    ASSERT_EQ(message.find(path_ + ": "), 0U) << "byte " << i << ": " << message;
    ASSERT_EQ(message.find('\n'), std::string::npos);
  }
}

TEST_F(HostilePng, RandomDamageWithRightCheckSumsNeverCrashes) {
  const std::vector<PngChunk> chunks = test::splitPng(wellFormed(PngColor::kRgba, true));
  std::mt19937 random(11);
  for (int round = 0; round < 300; ++round) {
    std::vector<PngChunk> damaged = chunks;
    PngChunk& chunk = damaged[random() % damaged.size()];
    for (int i = 0; i < 3 && !chunk.data.empty(); ++i) {
      chunk.data[random() % chunk.data.size()] = static_cast<std::uint8_t>(random() & 0xFFU);
    }
    (void)complaint(test::joinPng(damaged));  // the sanitizers watch
  }
}

TEST_F(HostilePng, TrailingBytesAreIgnored) {
  Bytes file = wellFormed();
  for (const char c : std::string("appended by a camera"))
    file.push_back(static_cast<std::uint8_t>(c));
  EXPECT_EQ(complaint(file), "");
}

TEST_F(HostilePng, PixelsThatEndEarlyAreRefused) {
  EXPECT_EQ(complaint(grayPng(64, 64, test::deflatedZeros(9 * 64))), "");
  EXPECT_EQ(complaint(grayPng(64, 64, test::deflatedZeros(9 * 63))),
            path_ + ": damaged PNG file (Not enough image data)");
}

TEST_F(HostilePng, PixelsWithoutEndAreRefused) {
  constexpr std::size_t kNeeded = 9 * 64;
  const std::string expected =
      path_ + ": damaged PNG file (there is more data than its pixels need)";
  const auto complaintOf = [&](const std::vector<Bytes>& pixels, int interlace) {
    std::vector<PngChunk> chunks = {{"IHDR", test::pngHeader(64, 64, 1, 0, interlace)}};
    for (const Bytes& part : pixels) chunks.push_back({"IDAT", part});
    chunks.push_back({"IEND", {}});
    return complaint(test::joinPng(chunks));
  };
  for (const int interlace : {0, 1}) {
    EXPECT_EQ(complaintOf({test::deflatedZeros(kNeeded + 2000)}, interlace), "")
        << "what some encoders leave behind the last row does no harm";
    const Bytes bomb = test::deflatedZeros(kNeeded + 60'000'000);
    EXPECT_EQ(complaintOf({bomb}, interlace), expected);
    // However it is cut into chunks.
    constexpr std::ptrdiff_t kPart = 100;
    std::vector<Bytes> parts;
    for (auto at = bomb.begin(); at != bomb.end();) {
      const auto end = at + std::min(kPart, bomb.end() - at);
      parts.emplace_back(at, end);
      at = end;
    }
    EXPECT_EQ(complaintOf(parts, interlace), expected);
  }
}

TEST_F(HostilePng, GiganticClaimsAreRefusedFromTheHeader) {
  const Bytes pixels = test::deflatedZeros(100);
  const auto claim = [&](std::uint32_t width, std::uint32_t height) {
    const Bytes file = grayPng(width, height, pixels);
    EXPECT_EQ(complaint(file), sizeComplaint(file));
    return sizeComplaint(file);
  };
  const std::string wanted = " pixels; wanted at most 16384 a side and 120 million in all";
  EXPECT_EQ(claim(100000, 100000), path_ + ": claims 100000x100000" + wanted);
  EXPECT_EQ(claim(0x7FFFFFFF, 0x7FFFFFFF), path_ + ": claims 2147483647x2147483647" + wanted);
  EXPECT_EQ(claim(0xFFFFFFFF, 1), path_ + ": claims 4294967295x1" + wanted);
  EXPECT_EQ(claim(16384, 16384), path_ + ": claims 16384x16384" + wanted);
  EXPECT_EQ(claim(0, 5), path_ + ": damaged PNG file (it claims 0x5 pixels)");
}

TEST_F(HostilePng, ASmallFileCannotClaimManyPixels) {
  const Bytes file = grayPng(16384, 7000, test::deflatedZeros(100));
  const std::string expected = path_ + ": damaged PNG file (its " + std::to_string(file.size()) +
                               " bytes cannot hold the 16384x7000 pixels it claims)";
  EXPECT_EQ(sizeComplaint(file), expected) << "before anybody allocates for this size";
  EXPECT_EQ(complaint(file), expected);
}

TEST_F(HostilePng, BombsInOtherChunksCostNothing) {
  constexpr std::size_t kUnpacked = 60'000'000;
  Bytes text = bytesOf("Comment");
  text.push_back(0);
  text.push_back(0);
  const Bytes packed = test::deflatedZeros(kUnpacked);
  text.insert(text.end(), packed.begin(), packed.end());
  rusage before{};
  getrusage(RUSAGE_SELF, &before);
  for (const char* name : {"zTXt", "iCCP"}) {
    std::vector<PngChunk> chunks = test::splitPng(wellFormed());
    chunks.insert(chunks.begin() + 1, {name, text});
    EXPECT_EQ(complaint(test::joinPng(chunks)), "") << name;
  }
  std::vector<PngChunk> many = test::splitPng(wellFormed());
  many.insert(many.begin() + 1, 5000, PngChunk{"tEXt", bytesOf(std::string("a\0b", 3))});
  EXPECT_EQ(complaint(test::joinPng(many)), "");
  rusage after{};
  getrusage(RUSAGE_SELF, &after);
  EXPECT_LT(after.ru_maxrss - before.ru_maxrss, 20000) << "kilobytes";
}

TEST_F(HostilePng, HeadersWithImpossibleTypesAreRefused) {
  for (const auto& [depth, type] : {std::pair{3, 0}, {16, 3}, {4, 2}, {8, 5}, {255, 255}, {0, 0}}) {
    const Bytes file = test::joinPng({{"IHDR", test::pngHeader(8, 8, depth, type)},
                                      {"IDAT", test::deflatedZeros(8 * 33)},
                                      {"IEND", {}}});
    EXPECT_NE(complaint(file), "") << depth << " bit, type " << type;
  }
  EXPECT_NE(complaint(test::joinPng({{"IHDR", test::pngHeader(8, 8, 8, 3)},
                                     {"IDAT", test::deflatedZeros(72)},
                                     {"IEND", {}}})),
            "")
      << "a palette image without palette";
}

TEST_F(HostilePng, AFileThatIsNoLongerAsExpectedIsRefused) {
  test::writeBytes(path_, wellFormed());
  EXPECT_EQ(readPng(path_, Size{20, 15}).size(), (Size{20, 15}));
  for (const Size planned : {Size{15, 20}, Size{20, 16}, Size{2000, 15}}) {
    const std::string expected = path_ + ": changed while being read (" +
                                 std::to_string(planned.width) + "x" +
                                 std::to_string(planned.height) + " pixels at first, then 20x15)";
    EXPECT_EQ(messageOf<Error>([&] { (void)readPng(path_, planned); }), expected);
    EXPECT_EQ(messageOf<Error>([&] { (void)readColor(path_, planned); }), expected);
    EXPECT_EQ(messageOf<Error>([&] { (void)readCoverage(path_, MaskChannel::kAlpha, planned); }),
              expected);
    EXPECT_EQ(messageOf<Error>([&] { (void)hasTransparency(path_, planned); }), expected);
  }
}

TEST_F(HostilePng, WhatIsNoFileIsRefused) {
  const auto complaintAt = [](const std::string& path) {
    const std::string message = messageOf<Error>([&] { (void)readPng(path); });
    EXPECT_EQ(messageOf<Error>([&] { (void)readPngSize(path); }), message);
    return message;
  };
  EXPECT_EQ(complaintAt(folder_.path()), folder_.path() + ": is a folder; wanted a PNG file");
  EXPECT_EQ(complaintAt("/dev/null"), "/dev/null: is no regular file; wanted a PNG file");
  EXPECT_EQ(complaintAt(folder_.file("none.png")),
            folder_.file("none.png") + ": cannot be opened (No such file or directory)");
  test::writeBytes(path_, bytesOf("x"));
  EXPECT_EQ(complaintAt(path_ + "/b.png"), path_ + "/b.png: cannot be opened (Not a directory)");
  const std::string pipe = folder_.file("pipe.png");
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_EQ(complaintAt(pipe), pipe + ": is no regular file; wanted a PNG file");
}

TEST_F(HostilePng, AFullDiskLeavesTheOlderPicture) {
  const Image<std::uint8_t> old(Size{2, 2}, 7);
  writeGrayPng(path_, old);
  const Bytes before = test::readBytes(path_);
  Image<Rgba8> large(Size{100, 100});
  std::mt19937 random(3);
  for (Rgba8& p : large) p.r = static_cast<std::uint8_t>(random() & 0xFFU);
  rlimit unlimited{};
  getrlimit(RLIMIT_FSIZE, &unlimited);
  rlimit full = unlimited;
  full.rlim_cur = 5000;
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  setrlimit(RLIMIT_FSIZE, &full);
  const std::string message = messageOf<Error>([&] { writePng(path_, large); });
  setrlimit(RLIMIT_FSIZE, &unlimited);
  std::signal(SIGXFSZ, handler);
  EXPECT_EQ(message, path_ + ": cannot be written (File too large)");
  EXPECT_EQ(test::readBytes(path_), before);
  EXPECT_EQ(folder_.names(), std::vector<std::string>{"a.png"});
}

}  // namespace
}  // namespace fluidymation
