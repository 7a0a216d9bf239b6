// How libFuzzer changes states: mostly with the right digest at the end, else hardly a try would
// get past it.
#include <cstdint>

#include "state_example.h"

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t maxSize);

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t maxSize, unsigned seed) {
  constexpr unsigned kSpoiled = 16;  // one in so many keeps a wrong digest
  const std::size_t changed = LLVMFuzzerMutate(data, size, maxSize);
  if (seed % kSpoiled != 0) fluidymation::fuzz::forgeDigest(data, changed);
  return changed;
}
