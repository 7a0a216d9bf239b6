#pragma once

#include <cstdint>

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
  explicit Random(const RandomKey& key)
      : Random(ofPass(key.seed, key.frame, key.level, key.pass).at(key.x, key.y)) {}

  /// What the numbers of all pixels of one pass have in common: `ofPass(...).at(x, y)` are those of
  /// the key with all six.
  [[nodiscard]] static Random ofPass(std::uint64_t seed, int frame, int level, int pass) {
    Random random;
    random.state_ = mix(seed);
    return random.with(frame).with(level).with(pass);
  }
  [[nodiscard]] Random at(int x, int y) const { return with(x).with(y); }

  [[nodiscard]] std::uint64_t next64() {
    state_ += kGamma;
    return mix(state_);
  }
  [[nodiscard]] std::uint32_t next() { return static_cast<std::uint32_t>(next64() >> 32U); }

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
  Random() = default;
  [[nodiscard]] Random with(int part) const {
    Random random;
    random.state_ = mix(state_ + kGamma + static_cast<std::uint32_t>(part));
    return random;
  }

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
