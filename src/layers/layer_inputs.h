#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "fluidymation/core/geometry.h"
#include "fluidymation/layers.h"
#include "layers/shot_frames.h"
#include "pipeline/inputs.h"

namespace fluidymation {

/// What the files of all layers tell of a shot, as far as headers and folders do.
struct LayerInputs {
  std::vector<Inputs> inputs;                ///< of each layer
  std::vector<LayerFrames> frames;           ///< likewise
  std::vector<int> numbers;                  ///< of the shot's frames
  Size size;                                 ///< of them all
  std::optional<BackgroundFile> background;  ///< of the shot, where it is a file
};

/// Finds all files and reads all headers.
/// @throws Faults of all layers; UsageError, also where there is no layer; Error where sizes or
/// numbers do not go together.
[[nodiscard]] LayerInputs openLayers(const LayeredShot& shot);

/// The layer whose film's bare surface is the background; none where that is something else.
/// @throws UsageError where it is named and not there.
[[nodiscard]] std::optional<std::size_t> layerOfBackground(const LayeredShot& shot);

/// What is under all layers, opaque; transparent where there is no background.
/// @param beforeFile  called before each file that is read; may throw to stop.
/// @throws UsageError, Error.
[[nodiscard]] Image<Rgba> bottomOf(const LayeredShot& shot, const LayerInputs& layers,
                                   const std::function<void()>& beforeFile);

}  // namespace fluidymation
