#include "inspect/input_check.h"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <system_error>
#include <tuple>
#include <utility>

#include "fluidymation/core/error.h"
#include "fluidymation/io/flow_file.h"
#include "fluidymation/io/frame_pattern.h"
#include "fluidymation/io/frame_sequence.h"
#include "fluidymation/io/png.h"
#include "pipeline/outputs.h"

namespace fluidymation {
namespace {

/// Collects what goes wrong, each message once.
class FaultList {
 public:
  /// @return  whether `attempt` threw no Error.
  bool none(const std::function<void()>& attempt) {
    try {
      attempt();
      return true;
    } catch (const Faults& found) {
      for (const std::string& line : found.lines()) add(line);
      return false;
    } catch (const Error& error) {
      add(error.what());
      return false;
    }
  }

  [[nodiscard]] bool empty() const { return messages_.empty(); }

  [[nodiscard]] std::vector<std::string> take() {
    if (unlisted_ > 0) messages_.push_back("... and " + std::to_string(unlisted_) + " more");
    return std::move(messages_);
  }

 private:
  void add(const std::string& message) {
    if (std::find(messages_.begin(), messages_.end(), message) != messages_.end()) return;
    if (messages_.size() < static_cast<std::size_t>(kMostFaults)) {
      messages_.push_back(message);
    } else {
      ++unlisted_;
    }
  }

  std::vector<std::string> messages_;
  int unlisted_ = 0;
};

/// The frames that are there of a sequence with gaps, among as many as could be looked for in a
/// moment.
FrameFiles existing(const FramePattern& pattern, const SequenceOptions& sequence) {
  constexpr int kMostFrames = 10000;
  FrameFiles files;
  for (int i = 0; i < std::min(sequence.frames, kMostFrames); ++i) {
    const std::int64_t number = sequence.start + std::int64_t{i} * sequence.speed;
    if (number < std::numeric_limits<int>::min() || number > std::numeric_limits<int>::max()) break;
    const std::string path = pattern.path(static_cast<int>(number));
    std::error_code ignored;
    if (!std::filesystem::exists(path, ignored)) continue;
    files.numbers.push_back(static_cast<int>(number));
    files.paths.push_back(path);
  }
  return files;
}

/// The files of a sequence; where some are missing, the others.
FrameFiles find(const std::string& path, const SequenceOptions& sequence, const std::string& option,
                FaultList& faults) {
  const FramePattern pattern(path);
  FrameFiles files;
  if (faults.none([&] { files = findFrames(pattern, sequence, option); })) return files;
  return existing(pattern, sequence);
}

}  // namespace

CheckedInputs checkInputs(const Options& options, const std::function<void()>& beforeFile) {
  CheckedInputs checked;
  FaultList faults;
  const auto decodeAll = [&](const FrameFiles& files, const auto& decode) {
    for (const std::string& path : files.paths) {
      beforeFile();
      if (path.empty()) continue;  // a flow file that is not needed
      faults.none([&] { decode(path); });
      ++checked.filesRead;
    }
  };
  const auto decodePicture = [](const std::string& path) { (void)readPng(path); };
  for (const auto& [path, sequence, option] :
       {std::tuple{options.source.path, options.source, "--src-path"},
        std::tuple{options.sourceMaskPath, options.source, "--src-mask-path"},
        std::tuple{options.target.path, options.target, "--target-path"}}) {
    const FrameFiles files = find(path, sequence, option, faults);
    decodeAll(files, decodePicture);
    if (files.count() > 0) faults.none([&files = files] { (void)commonSize(files); });
  }

  Observer notes;
  notes.note = [&](const std::string& note) { checked.notes.push_back(note); };
  Inputs inputs;
  if (!faults.none([&] { inputs = openInputs(options, notes); })) {
    checked.faults = faults.take();
    return checked;
  }
  for (const auto* flow : {&inputs.sourceFlow, &inputs.targetFlow}) {
    if (!*flow) continue;
    const Size stored = (*flow)->stored;
    decodeAll((*flow)->files, [stored](const std::string& path) { (void)readFlow(path, stored); });
  }
  if (!options.outPath.empty()) faults.none([&] { (void)checkOutput(options, inputs); });
  if (faults.empty()) checked.inputs = std::move(inputs);
  checked.faults = faults.take();
  return checked;
}

}  // namespace fluidymation
