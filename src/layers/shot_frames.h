#pragma once

#include <string>
#include <vector>

namespace fluidymation {

/// The frames of a layer by their own numbers.
struct LayerFrames {
  std::string name;
  std::vector<int> numbers;  ///< in the order of painting: ascending, or descending; at least one
};

/// The numbers of all frames that any layer has, ascending.
/// @throws Error naming two layers and a frame where one of them has a gap: nothing of a number
///   between its first and last that the other has.
[[nodiscard]] std::vector<int> shotFrames(const std::vector<LayerFrames>& layers);

/// Whether a layer is seen in the shot's frame of this number: it has no gaps there, so that its
/// first and last frame tell. In constant time, for sequences may have a million frames.
/// @param number  one of `shotFrames`.
[[nodiscard]] bool isSeen(const LayerFrames& layer, int number);

/// "layer bird: frames 1 to 12 of the shot's 1 to 24; it is not seen in the others", for each layer
/// that does not last as long as the shot.
[[nodiscard]] std::vector<std::string> notesOnLengths(const std::vector<LayerFrames>& layers,
                                                      const std::vector<int>& shot);

}  // namespace fluidymation
