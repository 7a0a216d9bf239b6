#include "pipeline/run_fingerprint.h"

#include <string>
#include <utility>

#include "fluidymation/core/version.h"
#include "pipeline/backdrop.h"
#include "pipeline/option_texts.h"
#include "pipeline/painting_order.h"

namespace fluidymation {
namespace {

[[nodiscard]] InputDigests digestsOf(const std::string& option, const FrameFiles& files,
                                     const std::function<void()>& beforeEach) {
  InputDigests input{option, {}};
  for (std::size_t i = 0; i < files.paths.size(); ++i) {
    if (files.paths[i].empty()) continue;  // a flow that need not be there
    beforeEach();
    input.files.push_back({files.numbers[i], digestOfFile(files.paths[i])});
  }
  return input;
}

}  // namespace

Fingerprint fingerprintOf(const Options& options, const Inputs& inputs,
                          const std::function<void()>& beforeEach) {
  Options found = options;
  found.source.frames = inputs.color.files.count();  // not how many were asked for at most
  if (found.sourceWindowFrames >= found.source.frames) found.sourceWindowFrames = 0;
  found.target.frames = inputs.target.files.count();
  if (found.reverse == Reverse::kOn) found.target = backwards(found.target);  // as it was given
  Fingerprint fingerprint;
  fingerprint.version = version();
  fingerprint.options = shapingOptions(found);
  const auto add = [&](const char* option, const FrameFiles& files) {
    fingerprint.inputs.push_back(digestsOf(option, files, beforeEach));
  };
  add("--src-path", inputs.color.files);
  add("--src-mask-path", inputs.sourceMask.files);
  add("--target-path", inputs.target.files);
  if (inputs.sourceFlow) add("--src-flow-path", inputs.sourceFlow->files);
  if (inputs.targetFlow) add("--target-flow-path", inputs.targetFlow->files);
  if (options.background && isBackgroundFile(*options.background)) {
    beforeEach();
    fingerprint.inputs.push_back({kBackgroundOption, {{0, digestOfFile(*options.background)}}});
  }
  return fingerprint;
}

}  // namespace fluidymation
