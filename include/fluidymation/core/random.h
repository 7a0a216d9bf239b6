#pragma once

#include <cstdint>
#include <initializer_list>

namespace fluidymation {

/// Identifies a place in the computation. Equal place, equal numbers: neither thread nor tile nor
/// order enters.
struct RandomKey {
  std::uint64_t seed = 0;
  int frame = 0;
  int level = 0;
  int pass = 0;
  int x = 0;
  int y = 0;
};

/// Counter-based random numbers: the n-th number is a hash of (key, n). The finalizer is that of
/// SplitMix64 (Steele et al. 2014).
class Random {
 public:
  explicit Random(const RandomKey& key) {
    state_ = mix(key.seed);
    for (const int part : {key.frame, key.level, key.pass, key.x, key.y}) {
      state_ = mix(state_ + kGamma + static_cast<std::uint32_t>(part));
    }
  }

  [[nodiscard]] std::uint32_t next() {
    state_ += kGamma;
    return static_cast<std::uint32_t>(mix(state_) >> 32U);
  }

  /// Uniform in low..high, both included.
  [[nodiscard]] int uniform(int low, int high) {
    const auto range = static_cast<std::uint64_t>(static_cast<std::int64_t>(high) - low + 1);
    return low + static_cast<int>((next() * range) >> 32U);
  }

  /// Uniform in [0, count).
  [[nodiscard]] std::uint64_t below(std::uint64_t count) {
    const std::uint64_t high = next();
    const std::uint64_t low = next();
    return ((high << 32U) | low) % count;
  }

 private:
  static constexpr std::uint64_t kGamma =
      0x9E3779B97F4A7C15ULL;  // odd, close to 2^64 / golden ratio

  static std::uint64_t mix(std::uint64_t z) {
    z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9ULL;
    z = (z ^ (z >> 27U)) * 0x94D049BB133111EBULL;
    return z ^ (z >> 31U);
  }

  std::uint64_t state_ = 0;
};

}  // namespace fluidymation
