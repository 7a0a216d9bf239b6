#pragma once

#include <optional>
#include <string>

#include "fluidymation/guides/guide_stream.h"
#include "fluidymation/options.h"
#include "fluidymation/pipeline.h"
#include "pipeline/film_window.h"
#include "pipeline/inputs.h"
#include "pipeline/memory.h"
#include "pipeline/stopping.h"

namespace fluidymation {

/// Which channel holds the masks of each sequence.
struct MaskChannels {
  MaskChannel source = MaskChannel::kBrightness;
  MaskChannel target = MaskChannel::kBrightness;
};

/// The guides of a run's two sequences, and how large the masks turned out to be.
class RunGuides {
 public:
  /// Reads all masks and given flows, and derives the flows that are not given.
  /// @param options  with a value for every width.
  /// @param folder   where what waits may be written.
  /// @throws Interrupted; UsageError as `requireMemory` and `requireMaterial` do; Error naming the
  ///   file.
  RunGuides(const Options& options, const Inputs& inputs, const MaskChannels& channels,
            const FilmWindow& window, const std::string& folder, const Stopping& stopping,
            const Observer& observer);

  [[nodiscard]] GuideStream& film() { return *film_; }
  [[nodiscard]] GuideStream& target() { return *target_; }

  /// With the mask pixels of both sequences.
  [[nodiscard]] const RunSize& size() const { return size_; }

 private:
  RunSize size_;
  std::optional<GuideStream> film_;
  std::optional<GuideStream> target_;
};

}  // namespace fluidymation
