#include "checkpoint/checkpoint.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <limits>

#include "checkpoint/checkpoint_file.h"
#include "fluidymation/core/error.h"
#include "support/temporary_folder.h"

namespace fluidymation {
namespace {

using test::Bytes;
using test::messageOf;

constexpr CheckpointLimits kLimits{{24, 20}, 5, 3, {28, 22}, 4};
constexpr std::size_t kDigestBytes = 16;

Fingerprint fingerprint() {
  Fingerprint result;
  result.version = "0.1.0";
  result.options = {{"--lambda", "2"}};
  result.inputs = {{"--src-path", {{1, digestOf("a", 1)}}}};
  return result;
}

SynthesisState state() {
  SynthesisState result;
  result.frame = 2;
  result.size = kLimits.target;
  result.box = {4, 8, 20, 16};
  result.filmBegin = 2;
  result.nnf = NearestNeighborField(result.box.size());
  result.owed = Image<float>(result.box.size());
  result.picture = Image<Lab>(result.box.size());
  for (std::size_t i = 0; i < result.nnf.pixelCount(); i += 3) {
    const float angle = 0.1F * static_cast<float>(i);
    Match& match = result.nnf.data()[i];
    match = {0.25F * static_cast<float>(i % 90), 17.5F, 2 + static_cast<int>(i / 3 % 3),
             Rotation{std::cos(angle), std::sin(angle)}};
    if (i % 2 == 0) result.owed.data()[i] = 0.5F - 0.01F * static_cast<float>(i);
    // Also beside a match, where an outline cuts a pixel, and beyond white
    result.picture.data()[i + i % 2] = {1.5F * static_cast<float>(i), -3.5F, 0.0F};
  }
  return result;
}

FrameRecords frames() {
  return {FrameRecord{digestOf("x", 1), 0.5}, FrameRecord{digestOf("y", 1), 0.25}, {}, {}};
}

Bytes encoded() { return encode(fingerprint(), 0, frames(), state()); }

/// With the digest of what the bytes are now: what somebody forges, not what a disk spoils.
Bytes forged(Bytes bytes) {
  const Digest digest = digestOf(bytes.data(), bytes.size() - kDigestBytes);
  std::copy(digest.bytes.begin(), digest.bytes.end(), bytes.end() - kDigestBytes);
  return bytes;
}

std::optional<Checkpoint> decoded(const Bytes& bytes) {
  std::string differs;
  return decode(bytes, fingerprint(), kLimits, differs);
}

TEST(CheckpointTest, ComesBackAsItWas) {
  const std::optional<Checkpoint> checkpoint = decoded(encoded());
  ASSERT_TRUE(checkpoint.has_value());
  EXPECT_EQ(checkpoint->begin, 0);
  EXPECT_EQ(checkpoint->next(), 2);
  ASSERT_EQ(checkpoint->frames.size(), 4U);
  EXPECT_TRUE(checkpoint->frames[1]->digest == digestOf("y", 1));
  EXPECT_EQ(checkpoint->frames[1]->seconds, 0.25);
  EXPECT_FALSE(checkpoint->frames[2].has_value());
  const SynthesisState expected = state();
  EXPECT_TRUE(checkpoint->synthesis.size == expected.size);
  EXPECT_TRUE(checkpoint->synthesis.box == expected.box);
  EXPECT_EQ(checkpoint->synthesis.filmBegin, 2);
  ASSERT_TRUE(checkpoint->synthesis.nnf.size() == expected.nnf.size());
  EXPECT_EQ(std::memcmp(checkpoint->synthesis.nnf.data(), expected.nnf.data(),
                        expected.nnf.pixelCount() * sizeof(Match)),
            0);
  EXPECT_EQ(std::memcmp(checkpoint->synthesis.owed.data(), expected.owed.data(),
                        expected.owed.pixelCount() * sizeof(float)),
            0);
  EXPECT_EQ(std::memcmp(checkpoint->synthesis.picture.data(), expected.picture.data(),
                        expected.picture.pixelCount() * sizeof(Lab)),
            0);
}

TEST(CheckpointTest, IsLittleEndian) {
  const Bytes bytes = encoded();
  const Bytes beginning = {'F', 'L', 'U', 'I', 'D', 'S', 'T', '\n', 3, 0, 0, 0, 5, 0, 0, 0, '0'};
  EXPECT_TRUE(std::equal(beginning.begin(), beginning.end(), bytes.begin()));
}

TEST(CheckpointTest, OneChangedByteAnywhereIsNoticed) {
  const Bytes good = encoded();
  for (std::size_t i = 0; i < good.size(); ++i) {
    for (const unsigned flip : {0x01U, 0x80U, 0xFFU}) {
      Bytes bad = good;
      bad[i] = static_cast<std::uint8_t>(bad[i] ^ flip);
      EXPECT_THROW((void)decoded(bad), Error) << i;
    }
  }
}

TEST(CheckpointTest, NoOtherLengthIsTakenForIt) {
  const Bytes good = encoded();
  for (std::size_t length = 0; length < good.size(); ++length) {
    const Bytes bad(good.begin(), good.begin() + static_cast<std::ptrdiff_t>(length));
    EXPECT_THROW((void)decoded(bad), Error) << length;
    if (length < 64) continue;
    EXPECT_THROW((void)decoded(forged(bad)), Error) << length;
  }
  Bytes longer = good;
  longer.push_back(0);
  EXPECT_THROW((void)decoded(longer), Error);
  EXPECT_THROW((void)decoded(forged(longer)), Error);
}

TEST(CheckpointTest, ColorsFarOutsideOfEveryGamutAreRefused) {
  for (const float color : {2e4F, -2e4F, std::numeric_limits<float>::quiet_NaN()}) {
    SynthesisState bad = state();
    bad.picture.data()[6].b = color;
    EXPECT_EQ(messageOf<Error>([&] { (void)decoded(encode(fingerprint(), 0, frames(), bad)); }),
              "it is damaged: a colour is out of range");
  }
}

TEST(CheckpointTest, FlagsThatNothingIsKnownOfAreRefused) {
  Bytes bytes = encoded();
  SynthesisState bare = state();
  // The same but for the first pixel's match tells where its flags are
  bare.nnf.data()[0] = Match{};
  const Bytes other = encode(fingerprint(), 0, frames(), bare);
  const auto differ = std::mismatch(bytes.begin(), bytes.end(), other.begin(), other.end());
  ASSERT_EQ(*differ.first & 1, 1);
  *differ.first = static_cast<std::uint8_t>(*differ.first | 8);
  EXPECT_EQ(messageOf<Error>([&] { (void)decoded(forged(bytes)); }),
            "it is damaged: the flags of a pixel are out of range");
}

TEST(CheckpointTest, NoPixelTakesMoreThanIsReckonedWith) {
  SynthesisState full = state();
  const std::size_t before = encode(fingerprint(), 0, frames(), full).size();
  std::size_t more = 0;
  for (std::size_t i = 0; i < full.nnf.pixelCount(); ++i) {
    more += full.nnf.data()[i].exists() ? 0 : sizeof(Match);
    more += full.owed.data()[i] != 0.0F ? 0 : sizeof(float);
    more += full.picture.data()[i].l != 0.0F || full.picture.data()[i].a != 0.0F ? 0 : sizeof(Lab);
    full.nnf.data()[i] = {1.0F, 1.0F, 2, Rotation{}};
    full.owed.data()[i] = 1.0F;
    full.picture.data()[i] = {50.0F, 1.0F, 2.0F};
  }
  const Bytes bytes = encode(fingerprint(), 0, frames(), full);
  EXPECT_EQ(bytes.size(), before + more);
  const Bytes empty = [] {
    SynthesisState none = state();
    none.box = {};
    none.nnf = {};
    none.owed = {};
    none.picture = {};
    return encode(fingerprint(), 0, frames(), none);
  }();
  EXPECT_EQ(bytes.size() - empty.size(), kMostPixelBytes * full.nnf.pixelCount());
}

TEST(CheckpointTest, OneOfFramesThatAreNotHeldIsRefused) {
  SynthesisState bad = state();
  bad.filmBegin = 1;  // then its matches reach one frame too far
  const auto complaint = [&] {
    return messageOf<Error>([&] { (void)decoded(encode(fingerprint(), 0, frames(), bad)); });
  };
  EXPECT_EQ(complaint(), "it is damaged: the frame of a match is out of range");
  bad.filmBegin = 3;
  EXPECT_EQ(complaint(), "it is damaged: the first frame held is out of range");
}

/// Everything that the synthesis relies on.
bool isWithinLimits(const Checkpoint& checkpoint) {
  const SynthesisState& s = checkpoint.synthesis;
  const bool matchesLie = std::all_of(s.nnf.begin(), s.nnf.end(), [&s](const Match& m) {
    return !m.exists() || (std::abs(m.x) < 40.0F && std::abs(m.y) < 40.0F &&
                           m.frame >= s.filmBegin && m.frame < s.filmBegin + kLimits.heldFrames &&
                           std::abs(length(m.rotation.apply({1.0F, 0.0F})) - 1.0F) < 0.1F);
  });
  return matchesLie && s.filmBegin >= 0 &&
         s.filmBegin + kLimits.heldFrames <= kLimits.exemplarFrames && s.frame >= 1 &&
         s.frame <= 4 && s.size == kLimits.target && s.box.beginX >= 0 && s.box.endX <= 28 &&
         s.box.beginY >= 0 && s.box.endY <= 22 && s.nnf.size() == s.box.size() &&
         s.owed.size() == s.box.size() &&
         std::all_of(s.owed.begin(), s.owed.end(), [](float o) { return std::isfinite(o); }) &&
         s.picture.size() == s.box.size() &&
         std::all_of(s.picture.begin(), s.picture.end(),
                     [](const Lab& c) { return std::isfinite(c.l + c.a + c.b); }) &&
         checkpoint.frames.size() == 4;
}

TEST(CheckpointTest, AForgedOneIsRefusedOrHarmless) {
  const Bytes good = encoded();
  int harmless = 0;
  for (std::size_t i = 0; i + kDigestBytes < good.size(); ++i) {
    for (const std::uint8_t value : Bytes{0x00, 0x01, 0x7F, 0x80, 0xFF}) {
      Bytes bad = good;
      bad[i] = value;
      try {
        const std::optional<Checkpoint> checkpoint = decoded(forged(bad));
        if (!checkpoint) continue;  // of another run
        ++harmless;
        ASSERT_TRUE(isWithinLimits(*checkpoint)) << i << " " << int{value};
      } catch (const Error&) {
      }
    }
  }
  EXPECT_GT(harmless, 0);
}

TEST(CheckpointTest, OneOfAnotherRunSaysInWhatItDiffers) {
  Fingerprint now = fingerprint();
  now.options[0].second = "3";
  std::string differs;
  EXPECT_FALSE(decode(encoded(), now, kLimits, differs).has_value());
  EXPECT_EQ(differs, "--lambda was 2, now 3");
}

TEST(CheckpointTest, OneWithMoreThanARunCanHaveIsRefused) {
  Fingerprint many = fingerprint();
  many.options.assign(kMostOptions + 1, {"--lambda", "2"});
  std::string differs;
  const auto complaint = [&] {
    return messageOf<Error>(
        [&] { (void)decode(encode(many, 0, frames(), state()), fingerprint(), kLimits, differs); });
  };
  EXPECT_EQ(complaint(), "it is damaged: the number of options is out of range");
  many = fingerprint();
  many.inputs.resize(kMostInputs + 1);
  EXPECT_EQ(complaint(), "it is damaged: the number of inputs is out of range");
  many = fingerprint();
  many.inputs[0].files.resize(kMostFrames + 1);
  EXPECT_EQ(complaint(), "it is damaged: the number of an input's files is out of range");
  const Bytes other = encode(fingerprint(), 0, FrameRecords(1000), state());
  EXPECT_EQ(messageOf<Error>([&] { (void)decoded(other); }),
            "it is damaged: it is of another number of frames");
}

TEST(CheckpointTest, OneOfAnotherFormatIsRefusedByNumber) {
  Bytes bytes = encoded();
  bytes[8] = 9;
  EXPECT_EQ(messageOf<Error>([&] { (void)decoded(forged(bytes)); }), "it has format 9; wanted 3");
}

TEST(CheckpointTest, FilesThatAreNoneAreRefusedByName) {
  const test::TemporaryFolder folder;
  const auto complaint = [&](const Bytes& bytes) {
    test::writeBytes(folder.file("s"), bytes);
    return messageOf<Error>(
        [&] { (void)readCheckpoint(folder.file("s"), fingerprint(), kLimits); });
  };
  EXPECT_EQ(complaint({}), folder.file("s") + ": is empty; wanted a state of fluidymation");
  EXPECT_EQ(complaint(Bytes(100, 'x')),
            folder.file("s") + ": it is no state of fluidymation, or damaged");
  EXPECT_EQ(complaint(encoded()), "");
}

}  // namespace
}  // namespace fluidymation
