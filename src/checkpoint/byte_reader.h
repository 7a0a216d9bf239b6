#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "fluidymation/io/digest.h"

namespace fluidymation {

/// Takes apart what a ByteWriter has put together. Nothing is read beyond the end, and nothing is
/// allocated for what is not there.
/// All functions throw Error, without a file's name, when the bytes end too early or hold a number
/// that is out of its range.
class ByteReader {
 public:
  /// The bytes must outlive the reader.
  ByteReader(const std::uint8_t* bytes, std::size_t byteCount)
      : next_(bytes), end_(bytes + byteCount) {}

  [[nodiscard]] std::uint8_t byte() { return *take(1); }
  [[nodiscard]] std::uint32_t unsignedNumber();
  /// @param what  names the number in the message.
  [[nodiscard]] int number(int low, int high, const char* what);
  /// Finite, and in [low, high].
  [[nodiscard]] float number(float low, float high, const char* what);
  [[nodiscard]] double number(double low, double high, const char* what);
  /// How many items follow, each of at least `leastBytes` bytes: so many have to be left.
  [[nodiscard]] std::size_t count(std::size_t leastBytes, const char* what);
  [[nodiscard]] std::string text(const char* what);
  [[nodiscard]] Digest digest();
  [[nodiscard]] std::size_t left() const { return static_cast<std::size_t>(end_ - next_); }

  /// @throws Error unless everything is read.
  void requireEnd() const;

 private:
  const std::uint8_t* take(std::size_t byteCount);

  const std::uint8_t* next_;
  const std::uint8_t* end_;
};

}  // namespace fluidymation
