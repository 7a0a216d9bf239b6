#pragma once

#include <functional>
#include <string>
#include <vector>

namespace fluidymation {

/// What has become of the frames that a manifest tells of.
struct Verification {
  int frames = 0;  ///< that the manifest tells of
  /// One line for each file that is missing, changed or not in the manifest though its name is one
  /// of the pattern, and one where frames are still to be painted. Empty: all is as it was painted.
  std::vector<std::string> faults;
};

/// Checks the frames beside a manifest against it, byte for byte.
/// @param beforeEach  called before each frame that is read; may throw to stop.
/// @throws Error naming the manifest when it cannot be read or is none.
[[nodiscard]] Verification verify(const std::string& manifestPath,
                                  const std::function<void()>& beforeEach = {});

}  // namespace fluidymation
