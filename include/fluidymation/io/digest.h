#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

namespace fluidymation {

/// What tells contents apart: XXH3 with 128 bits. Against accidents: whoever wants to forge two
/// contents of one digest can.
struct Digest {
  std::array<std::uint8_t, 16> bytes{};

  friend bool operator==(const Digest& a, const Digest& b) { return a.bytes == b.bytes; }
  friend bool operator!=(const Digest& a, const Digest& b) { return !(a == b); }

  /// 32 hexadecimal digits, as `xxh128sum` prints them.
  [[nodiscard]] std::string text() const;

  /// The reverse; nothing for anything else.
  [[nodiscard]] static std::optional<Digest> parse(const std::string& text);
};

[[nodiscard]] Digest digestOf(const void* data, std::size_t byteCount);

/// Of a file's contents. @throws Error naming the file and the system's reason.
[[nodiscard]] Digest digestOfFile(const std::string& path);

}  // namespace fluidymation
