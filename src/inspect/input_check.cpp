#include "inspect/input_check.h"

#include <algorithm>
#include <cstddef>
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
#include "pipeline/fault_list.h"
#include "pipeline/outputs.h"

namespace fluidymation {
namespace {

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
  if (faults.gather([&] { files = findFrames(pattern, sequence, option); })) return files;
  return existing(pattern, sequence);
}

}  // namespace

CheckedInputs checkInputs(const Options& options, const std::function<void()>& beforeFile) {
  CheckedInputs checked;
  FaultList faults(static_cast<std::size_t>(kMostFaults));
  const auto decodeAll = [&](const FrameFiles& files, const auto& decode) {
    for (const std::string& path : files.paths) {
      beforeFile();
      if (path.empty()) continue;  // a flow file that is not needed
      faults.gather([&] { decode(path); });
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
    if (files.count() > 0) faults.gather([&files = files] { (void)commonSize(files); });
  }

  Observer notes;
  notes.note = [&](const std::string& note) { checked.notes.push_back(note); };
  Inputs inputs;
  if (!faults.gather([&] { inputs = openInputs(options, notes); })) {
    checked.faults = faults.lines();
    return checked;
  }
  for (const auto* flow : {&inputs.sourceFlow, &inputs.targetFlow}) {
    if (!*flow) continue;
    const Size stored = (*flow)->stored;
    decodeAll((*flow)->files, [stored](const std::string& path) { (void)readFlow(path, stored); });
  }
  if (!options.outPath.empty()) faults.gather([&] { (void)checkOutput(options, inputs); });
  if (faults.empty()) checked.inputs = std::move(inputs);
  checked.faults = faults.lines();
  return checked;
}

}  // namespace fluidymation
