#include "pipeline/frame_form.h"

#include <cstddef>
#include <optional>
#include <string>

#include "fluidymation/io/color_chunks.h"
#include "pipeline/backdrop.h"

namespace fluidymation {
namespace {

/// What the first frame says about its colours.
[[nodiscard]] ColorChunks carriedChunks(const Options& options, const InputSequence& pictures,
                                        const Observer& observer,
                                        const std::function<void()>& beforeFile) {
  const auto tell = [&](const std::string& note) {
    if (observer.note) observer.note("--src-path " + options.source.path + ": " + note);
  };
  std::optional<FoundColorChunks> first;
  int others = 0;
  std::string firstOther;
  for (std::size_t k = 0; k < pictures.files.paths.size(); ++k) {
    beforeFile();
    const std::string& path = pictures.files.paths[k];
    FoundColorChunks found = readColorChunks(path);
    requireUnchanged(path, pictures.identities[k]);
    if (!first) {
      first = std::move(found);
    } else if (found.chunks != first->chunks) {
      if (others++ == 0) {
        firstOther = "frame " + std::to_string(pictures.files.numbers[k]) + " (" +
                     namesOf(found.chunks) + ")";
      }
    }
  }
  const std::string firstFrame = "frame " + std::to_string(pictures.files.numbers.front());
  if (!first->refused.empty()) {
    tell("chunks of " + firstFrame + " are damaged, against each other or not of RGB pictures (" +
         first->refused + "); the painted frames go without them");
  }
  if (others > 0) {
    tell(firstOther + (others == 1 ? " says" : " and " + std::to_string(others - 1) + " more say") +
         " other than " + firstFrame + " (" + namesOf(first->chunks) +
         ") about the meaning of colours; the painted frames say as " + firstFrame + " does");
  }
  return first->chunks;
}

}  // namespace

FrameForm formOf(const Options& options, const Inputs& inputs, const Observer& observer,
                 const std::function<void()>& beforeFile) {
  FrameForm form;
  form.bitDepth = options.bitDepth;
  form.compressionLevel = options.compressionLevel;
  form.color = carriedChunks(options, inputs.color, observer, beforeFile);
  if (options.background) {
    form.background =
        backdrop("--background", *options.background, inputs, inputs.target.scaled, beforeFile);
  }
  return form;
}

}  // namespace fluidymation
