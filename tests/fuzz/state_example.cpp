#include "state_example.h"

#include <algorithm>
#include <cmath>

namespace fluidymation::fuzz {
namespace {

[[nodiscard]] SynthesisState synthesisState() {
  SynthesisState state;
  state.frame = 2;
  state.size = kStateLimits.target;
  state.box = {6, 4, 20, 16};
  state.filmBegin = 1;
  state.nnf = NearestNeighborField(state.box.size());
  state.owed = Image<float>(state.box.size());
  state.picture = Image<Lab>(state.box.size());
  for (std::size_t i = 0; i < state.nnf.pixelCount(); i += 7) {
    const float angleRad = 0.1F * static_cast<float>(i);
    state.nnf.data()[i] = {0.25F * static_cast<float>(i % 90), 17.5F, 1 + static_cast<int>(i % 3),
                           Rotation{std::cos(angleRad), std::sin(angleRad)}};
    if (i % 2 == 0) state.owed.data()[i] = 0.5F - 0.01F * static_cast<float>(i);
    state.picture.data()[i] = {0.25F * static_cast<float>(i), 12.0F, -7.5F};
  }
  return state;
}

}  // namespace

Fingerprint stateFingerprint() {
  Fingerprint fingerprint;
  fingerprint.version = "0.1.0";
  fingerprint.options = {{"--lambda", "2"}, {"--seed", "0"}};
  fingerprint.inputs = {{"--src-path", {{1, digestOf("a", 1)}, {2, digestOf("b", 1)}}}};
  return fingerprint;
}

std::vector<std::uint8_t> encodedState() {
  const FrameRecords frames = {
      FrameRecord{digestOf("x", 1), 0.5}, FrameRecord{digestOf("y", 1), 0.25}, {}, {}};
  return encode(stateFingerprint(), 0, frames, synthesisState());
}

void forgeDigest(std::uint8_t* bytes, std::size_t byteCount) {
  constexpr std::size_t kDigestBytes = 16;
  if (byteCount < kDigestBytes) return;
  const Digest digest = digestOf(bytes, byteCount - kDigestBytes);
  std::copy(digest.bytes.begin(), digest.bytes.end(), bytes + byteCount - kDigestBytes);
}

}  // namespace fluidymation::fuzz
