#include "cli/progress_lines.h"

#include <nlohmann/json.hpp>

#include "cli/values.h"

namespace fluidymation::cli {
namespace {

class JsonLines : public ProgressLines {
 public:
  explicit JsonLines(std::ostream& out) : out_(out) {}

  void readingBegins() override {}
  void paintingBegins(int /*frame*/, int /*frameCount*/) override {}

  void frameDone(const FrameReport& report) override {
    using Json = nlohmann::ordered_json;
    const Json object = {{"frame", report.frameNumber},
                         {"index", report.index},
                         {"count", report.count},
                         {"seconds", report.seconds},
                         {"path", report.path}};
    constexpr int kOneLine = -1;
    out_ << object.dump(kOneLine, ' ', false, Json::error_handler_t::replace) + "\n" << std::flush;
  }

  void failed(const std::string& /*reason*/) override {}  // stderr and the exit code say it

 private:
  std::ostream& out_;
};

class OpenJobDescriptionLines : public ProgressLines {
 public:
  explicit OpenJobDescriptionLines(std::ostream& out) : out_(out) {}

  void readingBegins() override {
    tell("progress", "0");
    tell("status", "reading the masks and the exemplar");
  }

  void paintingBegins(int frame, int frameCount) override {
    begin_ = frame;
    tell("status", place(frame, frameCount) + " is painted");
  }

  void frameDone(const FrameReport& report) override {
    constexpr int kPercent = 100;
    const int painted = report.index + 1 - begin_;
    tell("progress", std::to_string(kPercent * painted / (report.count - begin_)));
    tell("status", place(report.index, report.count) + " is written: " + report.path);
  }

  void failed(const std::string& reason) override { tell("fail", reason); }

 private:
  [[nodiscard]] static std::string place(int frame, int frameCount) {
    return "frame " + std::to_string(frame + 1) + " of " + std::to_string(frameCount);
  }

  void tell(const char* kind, const std::string& text) {
    out_ << "openjd_" + std::string(kind) + ": " + oneLine(text) + "\n" << std::flush;
  }

  std::ostream& out_;
  int begin_ = 0;  ///< index of the first frame that this run paints
};

}  // namespace

std::unique_ptr<ProgressLines> progressLines(ProgressFormat format, std::ostream& out) {
  switch (format) {
    case ProgressFormat::kJson:
      return std::make_unique<JsonLines>(out);
    case ProgressFormat::kOpenJobDescription:
      return std::make_unique<OpenJobDescriptionLines>(out);
    case ProgressFormat::kHuman:
      break;
  }
  return nullptr;
}

}  // namespace fluidymation::cli
