#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/config_file.h"

namespace fluidymation::cli {

/// What a file of layers holds.
struct LayeredConfig {
  struct Section {
    std::string name;   ///< of the layer
    std::string place;  ///< "shot.toml: line 3", for messages
    std::vector<ConfigEntry> entries;
  };

  std::vector<ConfigEntry> entries;  ///< above the first layer: for the shot and all of its layers
  std::optional<std::string> background;  ///< of the shot, see `LayeredShot`; not among `entries`
  std::vector<Section> layers;            ///< in the file's order; at least one
};

/// Reads a file of layers: lines as in other config files, then a section for each layer, which
/// begins with a line `[layer.NAME]`. Names consist of letters, digits, '-' and '_': folders are
/// called so.
/// @param table  of the painter's options.
/// @throws Error naming the file where it cannot be read; UsageError naming file and line where a
///   section is none, or a name comes twice, or an option is unknown, given twice, without a value,
///   or in the wrong part; UsageError where there is no layer.
[[nodiscard]] LayeredConfig readLayeredConfig(const std::string& path,
                                              const std::vector<Spec>& table);

}  // namespace fluidymation::cli
