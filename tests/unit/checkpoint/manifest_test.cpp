#include "checkpoint/manifest.h"

#include <gtest/gtest.h>

#include "fluidymation/core/error.h"
#include "support/temporary_folder.h"

namespace fluidymation {
namespace {

using test::Bytes;
using test::bytesOf;
using test::messageOf;
using test::TemporaryFolder;

Manifest manifest() {
  Manifest result;
  result.fingerprint.version = "0.1.0";
  result.fingerprint.options = {{"--seed", "7"}, {"--lambda", "2"}};
  // Played backwards
  result.fingerprint.inputs = {{"--target-path", {{11, digestOf("b", 1)}, {9, digestOf("a", 1)}}}};
  result.paths = {{"--out-path", "out/%d.png"}};
  result.complete = true;
  result.frames = {{11, "11.png", digestOf("x", 1)}, {9, "9.png", digestOf("y", 1)}};
  return result;
}

std::string textOf(const Bytes& bytes) { return {bytes.begin(), bytes.end()}; }

TEST(ManifestTest, ComesBackAsItWas) {
  const TemporaryFolder folder;
  test::writeBytes(folder.file("m.json"), encode(manifest()));
  const Manifest back = readManifest(folder.file("m.json"));
  EXPECT_TRUE(isOf(back, manifest().fingerprint));
  EXPECT_TRUE(back.complete);
  EXPECT_EQ(back.paths, manifest().paths);
  ASSERT_EQ(back.frames.size(), 2U);
  EXPECT_EQ(back.frames[0].number, 11);
  EXPECT_EQ(back.frames[0].file, "11.png");
  EXPECT_TRUE(back.frames[1].digest == digestOf("y", 1));
  Fingerprint other = manifest().fingerprint;
  other.options[0].second = "8";
  EXPECT_FALSE(isOf(back, other));
}

TEST(ManifestTest, KeepsTheOrderAndSaysNothingOfTime) {
  const std::string text = textOf(encode(manifest()));
  EXPECT_LT(text.find("--seed"), text.find("--lambda"));
  EXPECT_LT(text.find("11.png"), text.find("\"9.png"));
  EXPECT_EQ(text.find("seconds"), std::string::npos);
  EXPECT_EQ(textOf(encodeTimes({FrameRecord{{}, 0.12345}, {}}, {3, 4})),
            "{\n \"program\": \"fluidymation\",\n \"frames\": [\n  {\n   \"number\": 3,\n   "
            "\"seconds\": 0.123\n  }\n ]\n}\n");
}

TEST(ManifestTest, TakesNamesThatAreNoUtf8) {
  Manifest odd = manifest();
  odd.paths[0].second = "out\xff/%d.png";
  EXPECT_NE(textOf(encode(odd)).find("out\xEF\xBF\xBD/%d.png"), std::string::npos);
}

TEST(ManifestTest, WhatIsNoneIsRefusedByName) {
  const TemporaryFolder folder;
  const std::string path = folder.file("m.json");
  const auto complaint = [&](const std::string& text) {
    test::writeBytes(path, bytesOf(text));
    return messageOf<Error>([&] { (void)readManifest(path); });
  };
  const std::string good = textOf(encode(manifest()));
  const auto with = [&](const std::string& from, const std::string& to) {
    std::string text = good;
    text.replace(text.find(from), from.size(), to);
    return text;
  };
  const std::string damaged = path + ": is damaged, or no manifest of fluidymation";
  EXPECT_EQ(complaint(good), "");
  const std::string noNumber = path + ": holds a number that is none, or out of range";
  for (const char* number : {"1e300", "5000000000", "18446744073709551615", "-5000000000", "9.0"}) {
    EXPECT_EQ(complaint(with("\"number\": 9", "\"number\": " + std::string(number))), noNumber);
    EXPECT_EQ(complaint(with("\"format\": 1", "\"format\": " + std::string(number))), noNumber);
  }
  Manifest many = manifest();
  many.fingerprint.inputs.clear();
  for (const char* option : {"a", "b", "c", "d", "e", "f"}) {
    many.fingerprint.inputs.push_back({option, {}});
  }
  EXPECT_EQ(complaint(textOf(encode(many))), path + ": holds more than a run can have");
  EXPECT_EQ(complaint("[]"), path + ": is no manifest of fluidymation");
  EXPECT_EQ(complaint("{}"), path + ": is no manifest of fluidymation");
  EXPECT_EQ(complaint(std::string(100'000, '[')), damaged);
  EXPECT_EQ(complaint(with("\"format\": 1", "\"format\": 9")), path + ": has format 9; wanted 1");
  EXPECT_EQ(complaint(with("\"complete\": true", "\"complete\": 1")), damaged);
  EXPECT_EQ(complaint(with("\"11.png\"", "\"../11.png\"")),
            path + ": holds a file name that is none");
  EXPECT_EQ(complaint(with("\"11.png\"", "\"..\"")), path + ": holds a file name that is none");
  EXPECT_EQ(complaint(with(digestOf("x", 1).text(), "12")), path + ": holds a digest that is none");
  EXPECT_EQ(complaint(with("\"9\": ", "\"nine\": ")), path + ": holds a frame number that is none");
  for (std::size_t length = 1; length + 2 < good.size(); ++length) {
    EXPECT_NE(complaint(good.substr(0, length)), "") << length;
  }
}

}  // namespace
}  // namespace fluidymation
