#pragma once

#include <map>
#include <optional>
#include <string>

#include "fluidymation/io/frame_pattern.h"

namespace fluidymation {

/// Where a run keeps what it knows of itself, beside its frames. All names begin with what the
/// frames' names have round their number, so that layers may share a folder:
/// "out/fluidymation.json" goes with "out/%05d.png", "out/rim_fluidymation.json" with
/// "out/rim_%05d.png". Patterns that differ in the number's place or width only, or in the ending,
/// have the same names: a run refuses the manifest of the other.
class RunFiles {
 public:
  explicit RunFiles(const FramePattern& frames);

  [[nodiscard]] const std::string& pattern() const { return frames_.text(); }
  [[nodiscard]] const std::string& folder() const { return folder_; }  ///< of the frames
  [[nodiscard]] const std::string& hiddenFolder() const { return hidden_; }
  [[nodiscard]] std::string manifest() const;
  [[nodiscard]] std::string times() const;
  [[nodiscard]] std::string lock() const;
  [[nodiscard]] std::string replaceableFrames() const;
  /// The state after frame `number` (the user's own).
  [[nodiscard]] std::string state(int number) const;

  /// Numbers and paths of all states that are there.
  [[nodiscard]] std::map<int, std::string> states() const;

  /// Whether a run with these files writes a file of that name into the frames' folder, or into the
  /// hidden one.
  [[nodiscard]] bool isFrameOrManifest(const std::string& name) const;
  [[nodiscard]] bool isHidden(const std::string& name) const;

 private:
  FramePattern frames_;
  std::string folder_;
  std::string hidden_;
  std::string stem_;
};

}  // namespace fluidymation
