#include "layers/shot_frames.h"

#include <algorithm>
#include <set>

#include "fluidymation/core/error.h"

namespace fluidymation {
namespace {

[[nodiscard]] std::string spanText(int first, int last) {
  return first == last ? std::to_string(first)
                       : std::to_string(first) + " to " + std::to_string(last);
}

/// @param own  numbers of `layer`, ascending.
/// @throws Error where it lacks a frame of `other` between its own first and last.
void requireNoGaps(const LayerFrames& layer, const std::vector<int>& own,
                   const LayerFrames& other) {
  for (const int number : other.numbers) {
    if (own.empty() || number < own.front() || number > own.back()) continue;
    if (std::binary_search(own.begin(), own.end(), number)) continue;
    throw Error("layer " + layer.name + ": has frames " + spanText(own.front(), own.back()) +
                " but no frame " + std::to_string(number) + ", which layer " + other.name +
                " has; wanted the same steps, see --target-speed and --target-range");
  }
}

}  // namespace

std::vector<int> shotFrames(const std::vector<LayerFrames>& layers) {
  std::set<int> numbers;
  for (const LayerFrames& layer : layers) {
    std::vector<int> own = layer.numbers;
    std::sort(own.begin(), own.end());
    for (const LayerFrames& other : layers) requireNoGaps(layer, own, other);
    numbers.insert(own.begin(), own.end());
  }
  return {numbers.begin(), numbers.end()};
}

bool isSeen(const LayerFrames& layer, int number) {
  const auto [first, last] = std::minmax(layer.numbers.front(), layer.numbers.back());
  return number >= first && number <= last;
}

std::vector<std::string> notesOnLengths(const std::vector<LayerFrames>& layers,
                                        const std::vector<int>& shot) {
  std::vector<std::string> notes;
  for (const LayerFrames& layer : layers) {
    if (layer.numbers.empty() || layer.numbers.size() == shot.size()) continue;
    const auto [first, last] = std::minmax_element(layer.numbers.begin(), layer.numbers.end());
    notes.push_back("layer " + layer.name + ": frames " + spanText(*first, *last) +
                    " of the shot's " + spanText(shot.front(), shot.back()) +
                    "; it is not seen in the others");
  }
  return notes;
}

}  // namespace fluidymation
