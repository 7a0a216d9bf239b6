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

TEST(ManifestTest, NamesThatAreNoUtf8ComeBackAsTheyWere) {
  const TemporaryFolder folder;
  Manifest odd = manifest();
  odd.paths[0].second = "out\xff/100%%\xc3\xa4 %d.png";
  odd.frames[0].file = "\xfe-\xff\"\n11.png";
  const std::string text = textOf(encode(odd));
  EXPECT_NE(text.find("\"percent-encoded\": \"out%FF/100%25%25%C3%A4%20%25d.png\""),
            std::string::npos);
  EXPECT_NE(text.find("\"file\": \"9.png\""), std::string::npos) << "others stay readable";
  test::writeBytes(folder.file("m.json"), encode(odd));
  const Manifest back = readManifest(folder.file("m.json"));
  EXPECT_EQ(back.paths, odd.paths);
  ASSERT_EQ(back.frames.size(), 2U);
  EXPECT_EQ(back.frames[0].file, odd.frames[0].file);
}

TEST(ManifestTest, NothingComesTwice) {
  const TemporaryFolder folder;
  const std::string path = folder.file("m.json");
  const auto complaint = [&](const Manifest& forged) {
    test::writeBytes(path, encode(forged));
    return messageOf<Error>([&] { (void)readManifest(path); });
  };
  Manifest forged = manifest();
  forged.frames.push_back({11, "12.png", digestOf("z", 1)});
  EXPECT_EQ(complaint(forged), path + ": tells of frame 11 twice");
  forged.frames.back() = {12, "11.png", digestOf("z", 1)};
  EXPECT_EQ(complaint(forged), path + ": tells of the file 11.png twice");
  forged.frames.back() = {12, "12.png", digestOf("z", 1)};
  EXPECT_EQ(complaint(forged), "");
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
  for (const char* option : {"a", "b", "c", "d", "e", "f", "g"}) {
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
  for (const char* number : {"09", "-0", "+9", " 9", ""}) {
    EXPECT_EQ(complaint(with("\"9\": ", "\"" + std::string(number) + "\": ")),
              path + ": holds a frame number that is none");
  }
  // What has no members is not the same as what has none of them.
  const std::string inputs =
      good.substr(good.find(" \"inputs\": ") + 11,
                  good.find(" \"frames\": ") - good.find(" \"inputs\": ") - 11);
  const std::string options = good.substr(good.find("{\n  \"--seed\""), 40);
  for (const char* nothing : {"null", "[]", "7", "\"\""}) {
    EXPECT_EQ(complaint(with(inputs, std::string(nothing) + ",\n")), damaged) << nothing;
    EXPECT_EQ(complaint(with(options.substr(0, options.find('}') + 1), nothing)), damaged);
  }
  EXPECT_EQ(complaint(with("\"frames\": [", "\"frames\": null, \"more\": [")), damaged);
  EXPECT_EQ(complaint(with("\"11.png\"", R"({"percent-encoded": "../1"})")),
            path + ": holds a file name that is none");
  for (const char* bad : {"%", "%4", "%G0", "a%ff", "a b", "%41"}) {
    EXPECT_EQ(complaint(with("\"11.png\"", R"({"percent-encoded": ")" + std::string(bad) + "\"}")),
              path + ": holds a text that is badly encoded")
        << bad;
  }
  EXPECT_EQ(complaint(with("\"11.png\"", R"({"percent": "1"})")), damaged);
  for (std::size_t length = 1; length + 2 < good.size(); ++length) {
    EXPECT_NE(complaint(good.substr(0, length)), "") << length;
  }
}

}  // namespace
}  // namespace fluidymation
