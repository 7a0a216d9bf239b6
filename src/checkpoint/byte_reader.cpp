#include "checkpoint/byte_reader.h"

#include <algorithm>
#include <cstring>

#include "fluidymation/core/error.h"
#include "io/little_endian.h"

namespace fluidymation {
namespace {

/// Written so that no number that is none passes.
template <typename T>
[[nodiscard]] T within(T value, T low, T high, const char* what) {
  if (value >= low && value <= high) return value;
  throw Error(std::string("it is damaged: ") + what + " is out of range");
}

}  // namespace

std::uint32_t ByteReader::unsignedNumber() { return littleEndian(take(4)); }

int ByteReader::number(int low, int high, const char* what) {
  return within(static_cast<std::int32_t>(unsignedNumber()), low, high, what);
}

float ByteReader::number(float low, float high, const char* what) {
  return within(littleEndianFloat(take(4)), low, high, what);
}

double ByteReader::number(double low, double high, const char* what) {
  const std::uint64_t lower = unsignedNumber();
  const std::uint64_t bits = lower | (std::uint64_t{unsignedNumber()} << 32U);
  double value = 0.0;
  std::memcpy(&value, &bits, sizeof value);
  return within(value, low, high, what);
}

std::size_t ByteReader::count(std::size_t leastBytes, const char* what) {
  const std::size_t value = unsignedNumber();
  return within(value, std::size_t{0}, left() / leastBytes, what);
}

std::string ByteReader::text(const char* what) {
  const std::size_t length = count(1, what);
  const std::uint8_t* const begin = take(length);
  return {begin, begin + length};
}

Digest ByteReader::digest() {
  Digest digest;
  std::copy_n(take(digest.bytes.size()), digest.bytes.size(), digest.bytes.begin());
  return digest;
}

void ByteReader::requireEnd() const {
  if (left() != 0) throw Error("it is damaged: bytes follow its end");
}

const std::uint8_t* ByteReader::take(std::size_t byteCount) {
  if (byteCount > left()) throw Error("it is damaged: it ends too early");
  const std::uint8_t* const begin = next_;
  next_ += byteCount;
  return begin;
}

}  // namespace fluidymation
