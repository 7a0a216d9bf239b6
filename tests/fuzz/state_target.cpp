// Any file as the state of a run, and painting goes on from it: whatever the decoder lets pass has
// to be harmless to the synthesis.
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "checkpoint/checkpoint_file.h"
#include "fluidymation/core/color.h"
#include "fluidymation/core/error.h"
#include "fluidymation/core/index.h"
#include "fluidymation/synthesis/pyramid.h"
#include "fluidymation/synthesis/synthesizer.h"
#include "fuzz_target.h"
#include "state_example.h"
#include "support/synthetic_scene.h"

namespace fluidymation::fuzz {
namespace {

constexpr float kBorderWidthPx = 3.0F;

/// What goes on from the states: made once, for it takes longer than a try.
class Scene {
 public:
  Scene() {
    target_.size = kStateLimits.target;
    target_.centre = {14.0F, 11.0F};
    target_.startRadiusPx = 4.0F;
    target_.frameCount = kStateLimits.targetFrames;
    options_.optIterations = {1};
    options_.patchmatchIterations = {1};
    for (int begin = 0; begin + kStateLimits.heldFrames <= kStateLimits.exemplarFrames; ++begin) {
      exemplars_.push_back(test::heldDiscExemplar(
          film(), begin, kStateLimits.heldFrames,
          coarsestLevel(kStateLimits.exemplar, kStateLimits.target), kBorderWidthPx, 1));
    }
  }

  /// Shows the state's picture once more, as a hold does, and paints the frame after it.
  void goOn(SynthesisState state) const {
    const int next = state.frame;
    if (next >= kStateLimits.targetFrames) return;
    Synthesizer synthesizer(exemplars_[at(state.filmBegin)], options_);
    GuideFrame held = target_.guides(next - 1);
    held.flow = Image<Vec2>(target_.size);
    synthesizer.restore(std::move(state), held);
    show(synthesizer.paint(held));
    show(synthesizer.paint(target_.guides(next)));
  }

 private:
  void show(const Image<Lab>& picture) const {
    require(picture.size() == target_.size, "a frame has the target's size");
    for (const Lab& color : picture) (void)encoder_(color);
  }
  [[nodiscard]] static test::GrowingDisc film() {
    test::GrowingDisc disc;
    disc.size = kStateLimits.exemplar;
    disc.centre = {12.0F, 10.0F};
    disc.startRadiusPx = 4.0F;
    disc.frameCount = kStateLimits.exemplarFrames;
    return disc;
  }

  SrgbByteEncoder encoder_;
  test::GrowingDisc target_;
  SynthesisOptions options_;
  std::vector<Exemplar> exemplars_;  ///< by the first frame that is held
};

}  // namespace
}  // namespace fluidymation::fuzz

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t byteCount) {
  using namespace fluidymation;
  static const fuzz::Scene scene;
  static const Fingerprint fingerprint = fuzz::stateFingerprint();
  const fuzz::MemoryFile file(data, byteCount);
  try {
    FoundCheckpoint found = readCheckpoint(file.path(), fingerprint, fuzz::kStateLimits);
    fuzz::require(found.checkpoint.has_value() == found.differs.empty(),
                  "a state is of this run or of one that differs");
    if (found.checkpoint) scene.goOn(std::move(found.checkpoint->synthesis));
  } catch (const Error& error) {
    fuzz::requireNaming(error.what(), file.path());
  }
  return 0;
}
