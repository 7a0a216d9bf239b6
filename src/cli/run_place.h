#pragma once

#include <string>

namespace fluidymation::cli {

/// Which of several runs of one command a run is; the default is one alone.
struct RunPlace {
  std::string layer;         ///< its name; empty where it is none
  bool isComposite = false;  ///< whether layers are laid over each other: nothing is painted
  int index = 0;             ///< from 0
  int count = 1;

  /// "layer horse (1 of 2): ", "composite: ", or empty.
  [[nodiscard]] std::string label() const {
    if (isComposite) return "composite: ";
    if (layer.empty()) return "";
    // The last run is the composite's.
    return "layer " + layer + " (" + std::to_string(index + 1) + " of " +
           std::to_string(count - 1) + "): ";
  }
};

}  // namespace fluidymation::cli
