#include "checkpoint/fingerprint.h"

#include <gtest/gtest.h>

namespace fluidymation {
namespace {

Digest digest(const std::string& content) { return digestOf(content.data(), content.size()); }

Fingerprint fingerprint() {
  Fingerprint result;
  result.version = "0.1.0";
  result.options = {{"--lambda", "2"}, {"--seed", "0"}};
  result.inputs = {{"--src-path", {{1, digest("a")}, {2, digest("b")}}},
                   {"--target-path", {{-3, digest("c")}}}};
  return result;
}

TEST(FingerprintTest, EqualOnesDoNotDiffer) {
  EXPECT_FALSE(difference(fingerprint(), fingerprint()).has_value());
}

TEST(FingerprintTest, NamesEachDifference) {
  const auto changed = [](auto change) {
    Fingerprint now = fingerprint();
    change(now);
    return difference(fingerprint(), now).value_or("none");
  };
  EXPECT_EQ(changed([](Fingerprint& f) { f.version = "0.2.0"; }),
            "fluidymation was 0.1.0, now 0.2.0");
  EXPECT_EQ(changed([](Fingerprint& f) { f.options[0].second = "3"; }), "--lambda was 2, now 3");
  EXPECT_EQ(changed([](Fingerprint& f) { f.options.pop_back(); }), "--seed was 0, now not given");
  EXPECT_EQ(changed([](Fingerprint& f) { f.options.emplace_back("--new", "on"); }),
            "--new was not given, now on");
  EXPECT_EQ(changed([](Fingerprint& f) { f.inputs[0].files[1].digest = digest("x"); }),
            "--src-path: frame 2 has changed");
  EXPECT_EQ(changed([](Fingerprint& f) {
              for (auto& file : f.inputs[0].files) file.digest = digest("x");
            }),
            "--src-path: frames 1, 2 have changed");
  EXPECT_EQ(changed([](Fingerprint& f) { f.inputs[0].files.pop_back(); }),
            "--src-path had 2 frames, 1 to 2, now has 1 frames, 1 to 1");
  EXPECT_EQ(changed([](Fingerprint& f) { f.inputs.pop_back(); }),
            "--target-path was given, now not");
  EXPECT_EQ(changed([](Fingerprint& f) {
              f.options[0].second = "3";
              f.inputs[1].files[0].digest = digest("x");
            }),
            "--lambda was 2, now 3; --target-path: frame -3 has changed");
}

TEST(FingerprintTest, ComesBackFromItsBytes) {
  ByteWriter bytes;
  write(fingerprint(), bytes);
  ByteReader reader(bytes.bytes().data(), bytes.bytes().size());
  EXPECT_FALSE(difference(readFingerprint(reader), fingerprint()).has_value());
  EXPECT_EQ(reader.left(), 0U);
}

}  // namespace
}  // namespace fluidymation
