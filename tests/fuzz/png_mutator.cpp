// How libFuzzer changes PNG files: chunks get right lengths and check sums again, and pixels are
// unpacked before they are changed and packed after. Else hardly a try would get past the check
// sums.
#include <zlib.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <random>
#include <string>
#include <vector>

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t maxSize);

namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr std::size_t kSignatureBytes = 8;
constexpr std::size_t kFrameBytes = 12;         // length, name, check sum of a chunk
constexpr std::size_t kMostPixelBytes = 65536;  // unpacked

struct Chunk {
  Bytes name;  ///< four bytes
  Bytes data;
};

[[nodiscard]] std::uint32_t bigEndian(const std::uint8_t* bytes) {
  return (std::uint32_t{bytes[0]} << 24U) | (std::uint32_t{bytes[1]} << 16U) |
         (std::uint32_t{bytes[2]} << 8U) | std::uint32_t{bytes[3]};
}

void appendBigEndian(Bytes& bytes, std::size_t value) {
  for (unsigned shift = 32; shift > 0; shift -= 8) {
    bytes.push_back(static_cast<std::uint8_t>((value >> (shift - 8)) & 0xFFU));
  }
}

/// As many chunks as there are; the last one may be cut short.
[[nodiscard]] std::vector<Chunk> split(const std::uint8_t* data, std::size_t size) {
  std::vector<Chunk> chunks;
  for (std::size_t at = kSignatureBytes; at + kFrameBytes <= size;) {
    const std::size_t length = std::min<std::size_t>(bigEndian(data + at), size - at - kFrameBytes);
    const std::uint8_t* const name = data + at + 4;
    chunks.push_back({{name, name + 4}, {name + 4, name + 4 + length}});
    at += length + kFrameBytes;
  }
  return chunks;
}

[[nodiscard]] Bytes join(const std::uint8_t* signature, const std::vector<Chunk>& chunks) {
  Bytes file(signature, signature + kSignatureBytes);
  for (const Chunk& chunk : chunks) {
    appendBigEndian(file, chunk.data.size());
    const std::size_t begin = file.size();
    file.insert(file.end(), chunk.name.begin(), chunk.name.end());
    file.insert(file.end(), chunk.data.begin(), chunk.data.end());
    appendBigEndian(file, crc32(0, file.data() + begin, static_cast<uInt>(file.size() - begin)));
  }
  return file;
}

/// Changes `bytes`, which may grow by `room`.
void mutate(Bytes& bytes, std::size_t room) {
  const std::size_t size = bytes.size();
  bytes.resize(size + room);
  bytes.resize(LLVMFuzzerMutate(bytes.data(), size, bytes.size()));
}

/// Unpacks the pixels, changes and packs them; they end up in the first IDAT chunk.
void mutatePixels(std::vector<Chunk>& chunks) {
  Bytes packed;
  Chunk* first = nullptr;
  for (Chunk& chunk : chunks) {
    if (std::memcmp(chunk.name.data(), "IDAT", 4) != 0) continue;
    packed.insert(packed.end(), chunk.data.begin(), chunk.data.end());
    chunk.data.clear();
    if (first == nullptr) first = &chunk;
  }
  if (first == nullptr) return;
  Bytes pixels(kMostPixelBytes);
  uLongf count = pixels.size();
  (void)uncompress(pixels.data(), &count, packed.data(), packed.size());  // as far as it goes
  pixels.resize(std::min<std::size_t>(count, kMostPixelBytes));
  mutate(pixels, 64);
  first->data.resize(compressBound(pixels.size()));
  uLongf length = first->data.size();
  (void)compress(first->data.data(), &length, pixels.data(), pixels.size());
  first->data.resize(length);
}

}  // namespace

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t maxSize, unsigned seed) {
  std::minstd_rand random(seed);
  const auto oneIn = [&](unsigned n) { return random() % n == 0; };
  if (size < kSignatureBytes || oneIn(8)) return LLVMFuzzerMutate(data, size, maxSize);
  std::vector<Chunk> chunks = split(data, size);
  if (chunks.empty()) return LLVMFuzzerMutate(data, size, maxSize);
  if (oneIn(3)) {
    mutatePixels(chunks);
  } else if (oneIn(6)) {
    chunks.insert(chunks.begin() + static_cast<std::ptrdiff_t>(random() % (chunks.size() + 1)),
                  chunks[random() % chunks.size()]);
  } else if (oneIn(6)) {
    chunks.erase(chunks.begin() + static_cast<std::ptrdiff_t>(random() % chunks.size()));
  } else if (oneIn(8)) {
    Bytes& name = chunks[random() % chunks.size()].name;
    mutate(name, 0);
    name.resize(4);
  } else {
    mutate(chunks[random() % chunks.size()].data, 16);
  }
  const Bytes file = join(data, chunks);
  const std::size_t kept = std::min(file.size(), maxSize);
  std::copy_n(file.begin(), kept, data);
  return kept;
}
