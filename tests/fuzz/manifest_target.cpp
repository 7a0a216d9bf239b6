// Any file as a manifest, and frames are checked against it.
#include <cstdint>
#include <string>

#include "checkpoint/manifest.h"
#include "fluidymation/core/error.h"
#include "fluidymation/verify.h"
#include "fuzz_target.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t byteCount) {
  using namespace fluidymation;
  const fuzz::MemoryFile file(data, byteCount);
  try {
    const Manifest manifest = readManifest(file.path());
    fuzz::require(isOf(manifest, manifest.fingerprint), "a manifest is of its own run");
    const std::vector<std::uint8_t> bytes = encode(manifest);
    const fuzz::MemoryFile copy(bytes.data(), bytes.size());
    const Manifest back = readManifest(copy.path());
    fuzz::require(isOf(back, manifest.fingerprint), "a manifest comes back as it was");
    fuzz::require(back.frames.size() == manifest.frames.size(), "all its frames come back");
    const Verification found = verify(file.path());
    fuzz::require(found.frames == static_cast<int>(manifest.frames.size()),
                  "all frames of a manifest are checked");
  } catch (const Error& error) {
    fuzz::requireNaming(error.what(), file.path());
  }
  return 0;
}
