#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fluidymation/options.h"

namespace fluidymation {

/// A look by its name: sets everything that shapes the picture, whatever was set before. Paths,
/// numbering, scales, seed and threads stay as they are.
struct Preset {
  const char* name;
  void (*apply)(Options& options);
};

/// All of them; the first one is the default.
[[nodiscard]] const std::vector<Preset>& presets();

/// Nothing where none has this name.
[[nodiscard]] std::optional<Preset> findPreset(const std::string& name);

[[nodiscard]] std::vector<std::string> presetNames();

/// The defaults.
void applyStandardPreset(Options& options);

/// The defaults with more of the film's fine detail, in larger pieces; flickers more
/// (docs/looks.md).
void applyCrispPreset(Options& options);

/// The defaults with less flicker and softer paint, in about twice the time (docs/looks.md).
void applyCalmPreset(Options& options);

/// Sets everything that shapes the picture to the thesis' own rules and numbers (§4.5), whatever
/// the defaults have become since. Paths, numbering, scales, seed and threads stay as they are.
void applyThesisPreset(Options& options);

/// The same for the paper: table 1 and the rules of P§3 and its appendix A; what it leaves open is
/// as in the thesis. Its widths are pixels of targets of 500 to 1000 px a side.
void applyPaperPreset(Options& options);

}  // namespace fluidymation
