#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "support/small_scene.h"

namespace fluidymation::test {

/// The manifest of the frames that a `SmallScene` paints by default.
inline constexpr const char* kManifest = "out/fluidymation.json";

/// Whether a scene's folder holds these frames and this manifest, and nothing else: as if the run
/// had never been stopped.
[[nodiscard]] inline ::testing::AssertionResult isFinished(const SmallScene& scene,
                                                           const SmallScene::Painting& frames,
                                                           const Bytes& manifest) {
  if (filesOf(scene.file("out")) != frames) {
    return ::testing::AssertionFailure() << "frames differ";
  }
  if (scene.read(kManifest) != manifest) {
    return ::testing::AssertionFailure() << "the manifest differs";
  }
  if (scene.names("out/.fluidymation") != std::vector<std::string>{"times.json"}) {
    return ::testing::AssertionFailure() << "something is left over";
  }
  return ::testing::AssertionSuccess();
}

}  // namespace fluidymation::test
