#pragma once

#include <string>
#include <vector>

namespace fluidymation {

/// The frames of a layer by their own numbers, in the order in which they are painted.
struct LayerFrames {
  std::string name;
  std::vector<int> numbers;
};

/// The numbers of all frames that any layer has, ascending.
/// @throws Error naming two layers and a frame where one of them has a gap: nothing of a number
///   between its first and last that the other has.
[[nodiscard]] std::vector<int> shotFrames(const std::vector<LayerFrames>& layers);

/// "layer bird: frames 1 to 12 of the shot's 1 to 24; it is not seen in the others", for each layer
/// that does not last as long as the shot.
[[nodiscard]] std::vector<std::string> notesOnLengths(const std::vector<LayerFrames>& layers,
                                                      const std::vector<int>& shot);

}  // namespace fluidymation
