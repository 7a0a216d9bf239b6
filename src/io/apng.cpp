#include "fluidymation/io/apng.h"

#include <zlib.h>

#include <array>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

#include "fluidymation/io/atomic_file.h"

namespace fluidymation {
namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr std::size_t kSignatureBytes = 8;
constexpr std::size_t kNumberBytes = 4;
constexpr std::size_t kNameBytes = 4;

/// Big endian, as all numbers of a PNG file.
void append(Bytes& bytes, std::uint32_t value) {
  for (const unsigned shift : {24U, 16U, 8U, 0U}) {
    bytes.push_back(static_cast<std::uint8_t>(value >> shift));
  }
}

void append16(Bytes& bytes, std::uint32_t value) {
  bytes.push_back(static_cast<std::uint8_t>(value >> 8U));
  bytes.push_back(static_cast<std::uint8_t>(value));
}

[[nodiscard]] std::uint32_t numberAt(const Bytes& bytes, std::size_t place) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < kNumberBytes; ++i) value = value << 8U | bytes[place + i];
  return value;
}

void writeChunk(const ByteSink& sink, const char* name, const Bytes& data) {
  Bytes chunk;
  append(chunk, static_cast<std::uint32_t>(data.size()));
  chunk.insert(chunk.end(), name, name + kNameBytes);
  chunk.insert(chunk.end(), data.begin(), data.end());
  const auto checked = static_cast<uInt>(kNameBytes + data.size());
  append(chunk, static_cast<std::uint32_t>(
                    crc32(crc32(0, nullptr, 0), chunk.data() + kNumberBytes, checked)));
  sink(chunk.data(), chunk.size());
}

/// The data of all chunks of that name in a file of our own encoder, one after the other.
[[nodiscard]] Bytes dataOf(const Bytes& file, const char* name) {
  Bytes data;
  std::size_t place = kSignatureBytes;
  while (place < file.size()) {
    const std::size_t length = numberAt(file, place);
    const std::size_t begin = place + kNumberBytes + kNameBytes;
    if (std::memcmp(&file[place + kNumberBytes], name, kNameBytes) == 0) {
      const auto first = file.begin() + static_cast<std::ptrdiff_t>(begin);
      data.insert(data.end(), first, first + static_cast<std::ptrdiff_t>(length));
    }
    place = begin + length + kNumberBytes;  // behind the check sum
  }
  return data;
}

/// fcTL: the picture replaces the one before it whole.
[[nodiscard]] Bytes frameControl(std::uint32_t sequence, Size size, int framesPerSecond) {
  Bytes data;
  append(data, sequence);
  append(data, static_cast<std::uint32_t>(size.width));
  append(data, static_cast<std::uint32_t>(size.height));
  append(data, 0);  // x and y of its corner
  append(data, 0);
  append16(data, 1);  // shown for 1 / framesPerSecond seconds
  append16(data, static_cast<std::uint32_t>(framesPerSecond));
  data.push_back(0);  // and left as it is
  data.push_back(0);  // no blending
  return data;
}

}  // namespace

void writeAnimatedPng(const std::string& path, int frameCount, int framesPerSecond,
                      const std::function<Image<Rgba8>(int frame)>& frame) {
  assert(frameCount >= 1);
  constexpr int kCompression = 6;  // a file to be sent about; frames of it are small
  writeAtomically(path, [&](const ByteSink& sink) {
    Size size;
    std::uint32_t sequence = 0;  // counts fcTL and fdAT chunks together
    for (int i = 0; i < frameCount; ++i) {
      const Image<Rgba8> picture = frame(i);
      const Bytes file = encodePng(picture, kCompression);
      if (i == 0) {
        size = picture.size();
        sink(file.data(), kSignatureBytes);
        writeChunk(sink, "IHDR", dataOf(file, "IHDR"));
        Bytes animation;
        append(animation, static_cast<std::uint32_t>(frameCount));
        append(animation, 0);  // for ever
        writeChunk(sink, "acTL", animation);
      }
      assert(picture.size() == size);
      writeChunk(sink, "fcTL", frameControl(sequence++, size, framesPerSecond));
      Bytes data;
      if (i > 0) append(data, sequence++);
      const Bytes pixels = dataOf(file, "IDAT");
      data.insert(data.end(), pixels.begin(), pixels.end());
      writeChunk(sink, i == 0 ? "IDAT" : "fdAT", data);
    }
    writeChunk(sink, "IEND", {});
  });
}

}  // namespace fluidymation
