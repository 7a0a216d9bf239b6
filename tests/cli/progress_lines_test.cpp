#include "cli/progress_lines.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

namespace fluidymation::cli {
namespace {

std::vector<std::string> linesOf(const std::string& text) {
  std::istringstream in(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

TEST(ProgressLines, JsonHasOneObjectPerFrameAndNothingElse) {
  std::ostringstream out;
  const auto lines = progressLines(ProgressFormat::kJson, out);
  lines->readingBegins();
  lines->paintingBegins(0, 2);
  lines->frameDone({0, 2, 101, 0.25, "out/101.png"});
  lines->frameDone({1, 2, 102, 1.5, "out/102.png"});
  lines->failed("no");
  EXPECT_EQ(out.str(),
            "{\"frame\":101,\"index\":0,\"count\":2,\"seconds\":0.25,\"path\":\"out/101.png\"}\n"
            "{\"frame\":102,\"index\":1,\"count\":2,\"seconds\":1.5,\"path\":\"out/102.png\"}\n");
}

TEST(ProgressLines, SayWhichLayerAFrameIsOf) {
  std::ostringstream out;
  progressLines(ProgressFormat::kJson, out, {"horse", false, 0, 3})
      ->frameDone({0, 2, 101, 0.25, "a.png"});
  progressLines(ProgressFormat::kJson, out, {"", true, 2, 3})->frameDone({0, 2, 1, 0.5, "b.png"});
  EXPECT_EQ(out.str(),
            "{\"frame\":101,\"index\":0,\"count\":2,\"seconds\":0.25,\"layer\":\"horse\","
            "\"path\":\"a.png\"}\n"
            "{\"frame\":1,\"index\":0,\"count\":2,\"seconds\":0.5,\"path\":\"b.png\"}\n");
}

TEST(ProgressLines, ShareThePercentageAmongLayers) {
  std::ostringstream out;
  const auto first = progressLines(ProgressFormat::kOpenJobDescription, out, {"a", false, 0, 3});
  first->readingBegins();
  first->frameDone({1, 2, 2, 0.5, "a.png"});
  const auto last = progressLines(ProgressFormat::kOpenJobDescription, out, {"", true, 2, 3});
  last->frameDone({0, 2, 1, 0.5, "b.png"});
  last->frameDone({1, 2, 2, 0.5, "c.png"});
  EXPECT_EQ(out.str(),
            "openjd_progress: 0\n"
            "openjd_status: layer a (1 of 2): reading the masks and the exemplar\n"
            "openjd_progress: 33\n"
            "openjd_status: layer a (1 of 2): frame 2 of 2 is written: a.png\n"
            "openjd_progress: 83\n"
            "openjd_status: composite: frame 1 of 2 is written: b.png\n"
            "openjd_progress: 100\n"
            "openjd_status: composite: frame 2 of 2 is written: c.png\n");
}

TEST(ProgressLines, TellsWhatIsReadBeforeTheFirstFrame) {
  const std::vector<ReadingReport> reports = {{ReadingStage::kFilmMasks, 3, 20},
                                              {ReadingStage::kFilmMovement, 4, 20},
                                              {ReadingStage::kTargetMasks, 12, 400},
                                              {ReadingStage::kTargetMovement, 400, 400}};
  std::ostringstream json;
  std::ostringstream status;
  for (const ReadingReport& report : reports) {
    progressLines(ProgressFormat::kJson, json)->reading(report);
    progressLines(ProgressFormat::kOpenJobDescription, status)->reading(report);
  }
  EXPECT_EQ(json.str(),
            "{\"reading\":\"film masks\",\"done\":3,\"count\":20}\n"
            "{\"reading\":\"film movement\",\"done\":4,\"count\":20}\n"
            "{\"reading\":\"target masks\",\"done\":12,\"count\":400}\n"
            "{\"reading\":\"target movement\",\"done\":400,\"count\":400}\n");
  EXPECT_EQ(status.str(),
            "openjd_status: reading the masks of the exemplar: 3 of 20\n"
            "openjd_status: reading the movement of the exemplar: 4 of 20\n"
            "openjd_status: reading the masks of the animation: 12 of 400\n"
            "openjd_status: reading the movement of the animation: 400 of 400\n");
}

TEST(ProgressLines, JsonIsValidForAnyFileName) {
  std::string everyByte;
  for (int byte = 1; byte <= 255; ++byte) everyByte += static_cast<char>(byte);
  const std::vector<std::string> names = {"a\"b\\c.png", "line\nbreak\r.png", "\xc3\xa4.png",
                                          "\xc3", everyByte};
  constexpr std::size_t kInUtf8 = 3;  // of these
  std::ostringstream out;
  const auto lines = progressLines(ProgressFormat::kJson, out);
  for (const std::string& name : names) lines->frameDone({0, 1, 1, 0.0, name});
  const std::vector<std::string> written = linesOf(out.str());
  ASSERT_EQ(written.size(), names.size());
  for (std::size_t i = 0; i < names.size(); ++i) {
    const nlohmann::json object = nlohmann::json::parse(written[i], nullptr, false);
    ASSERT_FALSE(object.is_discarded()) << written[i];
    if (i < kInUtf8) {
      EXPECT_EQ(object["path"], names[i]);
    }
  }
  EXPECT_EQ(nlohmann::json::parse(written[3])["path"], "\xef\xbf\xbd");
}

TEST(ProgressLines, OpenJobDescriptionGetsPercentagesOfWhatThisRunPaints) {
  std::ostringstream out;
  const auto lines = progressLines(ProgressFormat::kOpenJobDescription, out);
  lines->readingBegins();
  lines->paintingBegins(2, 5);
  lines->frameDone({2, 5, 30, 0.5, "out/\n30.png"});
  lines->frameDone({3, 5, 31, 0.5, "out/31.png"});
  lines->frameDone({4, 5, 32, 0.5, "out/32.png"});
  EXPECT_EQ(out.str(),
            "openjd_progress: 0\n"
            "openjd_status: reading the masks and the exemplar\n"
            "openjd_status: frame 3 of 5 is painted\n"
            "openjd_progress: 33\n"
            "openjd_status: frame 3 of 5 is written: out/?30.png\n"
            "openjd_progress: 66\n"
            "openjd_status: frame 4 of 5 is written: out/31.png\n"
            "openjd_progress: 100\n"
            "openjd_status: frame 5 of 5 is written: out/32.png\n");
}

TEST(ProgressLines, OpenJobDescriptionIsToldOfAFailureInOneLine) {
  std::ostringstream out;
  progressLines(ProgressFormat::kOpenJobDescription, out)->failed("a: cannot be read\n(gone)");
  EXPECT_EQ(out.str(), "openjd_fail: a: cannot be read?(gone)\n");
}

TEST(ProgressLines, PeopleGetNone) {
  std::ostringstream out;
  EXPECT_EQ(progressLines(ProgressFormat::kHuman, out), nullptr);
}

}  // namespace
}  // namespace fluidymation::cli
