#include "cli/progress_lines.h"

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "cli/progress.h"
#include "cli/values.h"

namespace fluidymation::cli {
namespace {

[[nodiscard]] const char* word(ReadingStage stage) {
  switch (stage) {
    case ReadingStage::kFilmMasks:
      return "film masks";
    case ReadingStage::kFilmMovement:
      return "film movement";
    case ReadingStage::kTargetMasks:
      return "target masks";
    case ReadingStage::kTargetMovement:
      break;
  }
  return "target movement";
}

class JsonLines : public RunListener {
 public:
  JsonLines(std::ostream& out, RunPlace place) : out_(out), place_(std::move(place)) {}

  void readingBegins() override {}

  void reading(const ReadingReport& report) override {
    using Json = nlohmann::ordered_json;
    Json object = {{"reading", word(report.stage)}, {"done", report.done}, {"count", report.count}};
    if (!place_.layer.empty()) object["layer"] = place_.layer;
    constexpr int kOneLine = -1;
    out_ << object.dump(kOneLine, ' ', false, Json::error_handler_t::replace) + "\n" << std::flush;
  }

  void paintingBegins(int /*frame*/, int /*frameCount*/) override {}

  void frameDone(const FrameReport& report) override {
    using Json = nlohmann::ordered_json;
    Json object = {{"frame", report.frameNumber},
                   {"index", report.index},
                   {"count", report.count},
                   {"seconds", report.seconds}};
    if (!place_.layer.empty()) object["layer"] = place_.layer;
    object["path"] = report.path;
    constexpr int kOneLine = -1;
    out_ << object.dump(kOneLine, ' ', false, Json::error_handler_t::replace) + "\n" << std::flush;
  }

  void failed(const std::string& /*reason*/) override {}  // stderr and the exit code say it

 private:
  std::ostream& out_;
  RunPlace place_;
};

class OpenJobDescriptionLines : public RunListener {
 public:
  OpenJobDescriptionLines(std::ostream& out, RunPlace place)
      : out_(out), place_(std::move(place)) {}

  void readingBegins() override {
    tell("progress", std::to_string(kPercent * place_.index / place_.count));
    tell("status", place_.label() + "reading the masks and the exemplar");
  }

  void reading(const ReadingReport& report) override {
    tell("status", place_.label() + "reading the " + readingText(report));
  }

  void paintingBegins(int frame, int frameCount) override {
    begin_ = frame;
    tell("status", place(frame, frameCount) + " is painted");
  }

  void frameDone(const FrameReport& report) override {
    const std::int64_t painted = report.index + 1 - begin_;
    const std::int64_t frames = report.count - begin_;
    const std::int64_t done = place_.index * frames + painted;
    tell("progress", std::to_string(kPercent * done / (place_.count * frames)));
    tell("status", place(report.index, report.count) + " is written: " + report.path);
  }

  void failed(const std::string& reason) override { tell("fail", reason); }

 private:
  static constexpr int kPercent = 100;

  [[nodiscard]] std::string place(int frame, int frameCount) const {
    return place_.label() + "frame " + std::to_string(frame + 1) + " of " +
           std::to_string(frameCount);
  }

  void tell(const char* kind, const std::string& text) {
    out_ << "openjd_" + std::string(kind) + ": " + oneLine(text) + "\n" << std::flush;
  }

  std::ostream& out_;
  RunPlace place_;
  int begin_ = 0;  ///< index of the first frame that this run paints
};

}  // namespace

std::unique_ptr<RunListener> progressLines(ProgressFormat format, std::ostream& out,
                                           const RunPlace& place) {
  switch (format) {
    case ProgressFormat::kJson:
      return std::make_unique<JsonLines>(out, place);
    case ProgressFormat::kOpenJobDescription:
      return std::make_unique<OpenJobDescriptionLines>(out, place);
    case ProgressFormat::kHuman:
      break;
  }
  return nullptr;
}

}  // namespace fluidymation::cli
