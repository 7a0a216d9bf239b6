#include "fluidymation/io/flow_file.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <system_error>
#include <vector>

#include "fluidymation/core/error.h"
#include "fluidymation/core/text.h"
#include "fluidymation/io/atomic_file.h"
#include "fluidymation/io/png.h"
#include "io/input_file.h"
#include "io/little_endian.h"

namespace fluidymation {
namespace {

constexpr std::array<std::uint8_t, 4> kFlowMagic = {'P', 'I', 'E', 'H'};
constexpr std::array<std::uint8_t, 4> kPngMagic = {0x89, 'P', 'N', 'G'};
constexpr std::size_t kHeaderBytes = 12;  // magic, width, height
constexpr std::size_t kVectorBytes = 8;
constexpr const char* kWanted = "a Middlebury .flo file or a 16-bit RGB PNG file";

/// "50 36 20 31"
[[nodiscard]] std::string hexText(const std::uint8_t* bytes, std::size_t count) {
  constexpr const char* kDigits = "0123456789ABCDEF";
  std::string text;
  for (std::size_t i = 0; i < count; ++i) {
    if (i > 0) text += ' ';
    text += kDigits[bytes[i] >> 4U];
    text += kDigits[bytes[i] & 0xFU];
  }
  return text;
}

/// @param kind  what the file is as far as known, for the message.
void readBytes(const InputFile& input, std::uint8_t* bytes, std::size_t count,
               const std::string& path, const char* kind) {
  errno = 0;
  if (std::fread(bytes, 1, count, input.file.get()) == count) return;
  if (std::ferror(input.file.get()) != 0) {
    throw Error(path + ": cannot be read (" + std::generic_category().message(errno) + ")");
  }
  throw Error(path + ": damaged " + kind + " (it ends too early)");
}

/// A flow file and what its first bytes say.
struct FlowInput {
  InputFile input;
  bool isPng = false;
  Size size;  ///< of a .flo file
};

/// Opens the file and checks all that is told without its vectors, before anything is allocated.
[[nodiscard]] FlowInput openFlow(const std::string& path) {
  FlowInput flow;
  flow.input = openInput(path, kWanted, kMaxImageFileBytes);
  std::array<std::uint8_t, kHeaderBytes> header{};
  const auto present = static_cast<std::size_t>(
      std::min(flow.input.byteCount, static_cast<std::int64_t>(header.size())));
  readBytes(flow.input, header.data(), present, path, "flow file");
  const auto beginsWith = [&](const std::array<std::uint8_t, 4>& magic) {
    return present >= magic.size() && std::memcmp(header.data(), magic.data(), magic.size()) == 0;
  };
  flow.isPng = beginsWith(kPngMagic);
  if (flow.isPng) return flow;
  if (!beginsWith(kFlowMagic)) {
    throw Error(path + ": is no flow file (it begins with the bytes " +
                hexText(header.data(), std::min<std::size_t>(present, 4)) + "); wanted " + kWanted);
  }
  if (present < header.size())
    throw Error(path + ": damaged .flo file (it ends within the header)");

  const auto width = std::int64_t{static_cast<std::int32_t>(littleEndian(header.data() + 4))};
  const auto height = std::int64_t{static_cast<std::int32_t>(littleEndian(header.data() + 8))};
  if (width < 1 || height < 1 || width > kMaxImageSidePx || height > kMaxImageSidePx ||
      width * height > kMaxImagePixels) {
    throw Error(path + ": claims " + sizeText(width, height) + " pixels; wanted 1 to " +
                std::to_string(kMaxImageSidePx) + " a side and at most " +
                std::to_string(kMaxImagePixels / 1'000'000) + " million in all");
  }
  const std::int64_t wantedBytes = static_cast<std::int64_t>(kHeaderBytes) +
                                   static_cast<std::int64_t>(kVectorBytes) * width * height;
  if (flow.input.byteCount != wantedBytes) {
    throw Error(path + ": damaged .flo file (" + std::to_string(flow.input.byteCount) +
                " bytes; its " + sizeText(width, height) + " pixels take " +
                std::to_string(wantedBytes) + ")");
  }
  flow.size = {static_cast<int>(width), static_cast<int>(height)};
  return flow;
}

void requireSize(Size found, Size expected, const std::string& path) {
  if (found == expected) return;
  throw Error(path + ": changed while being read (" + sizeText(expected) +
              " pixels at first, then " + sizeText(found) + ")");
}

/// Middlebury's rule: what is no number or 1e9 and more is unknown.
[[nodiscard]] bool isKnown(float component) {
  constexpr float kUnknownPx = 1e9F;
  return std::abs(component) < kUnknownPx;  // false for NaN
}

[[nodiscard]] Vec2 vectorOf(const std::uint8_t* bytes, int x, int y, const std::string& path) {
  const Vec2 v{littleEndianFloat(bytes), littleEndianFloat(bytes + 4)};
  if (!isKnown(v.x) || !isKnown(v.y)) return {};
  if (std::abs(v.x) <= kMaxFlowPx && std::abs(v.y) <= kMaxFlowPx) return v;
  throw Error(path + ": pixel " + std::to_string(x) + ", " + std::to_string(y) + " moves by " +
              std::to_string(std::lround(v.x)) + ", " + std::to_string(std::lround(v.y)) +
              " px; wanted at most " + std::to_string(std::lround(kMaxFlowPx)) +
              ", or 1e9 and more where unknown");
}

[[nodiscard]] Image<Vec2> readKitti(const std::string& path, Size expected) {
  constexpr float kZero = 32768.0F;
  constexpr float kStepsPerPx = 64.0F;
  const Image<Rgb16> stored = readRgb16(path, expected);
  Image<Vec2> flow(stored.size());
  std::transform(stored.begin(), stored.end(), flow.begin(), [](const Rgb16& p) {
    if (p.b == 0) return Vec2{};
    return Vec2{(static_cast<float>(p.r) - kZero) / kStepsPerPx,
                (static_cast<float>(p.g) - kZero) / kStepsPerPx};
  });
  return flow;
}

}  // namespace

Size readFlowSize(const std::string& path) {
  const FlowInput flow = openFlow(path);
  return flow.isPng ? readRgb16Size(path) : flow.size;
}

Image<Vec2> readFlow(const std::string& path, Size expected) {
  const FlowInput input = openFlow(path);
  if (input.isPng) return readKitti(path, expected);
  requireSize(input.size, expected, path);
  Image<Vec2> flow(input.size);
  std::vector<std::uint8_t> row(kVectorBytes * static_cast<std::size_t>(flow.width()));
  for (int y = 0; y < flow.height(); ++y) {
    readBytes(input.input, row.data(), row.size(), path, ".flo file");
    for (int x = 0; x < flow.width(); ++x) {
      flow(x, y) = vectorOf(row.data() + kVectorBytes * static_cast<std::size_t>(x), x, y, path);
    }
  }
  return flow;
}

void writeFlow(const std::string& path, const Image<Vec2>& flow) {
  writeAtomically(path, [&](const ByteSink& sink) {
    std::vector<std::uint8_t> bytes(kFlowMagic.begin(), kFlowMagic.end());
    appendLittleEndian(bytes, static_cast<std::uint32_t>(flow.width()));
    appendLittleEndian(bytes, static_cast<std::uint32_t>(flow.height()));
    sink(bytes.data(), bytes.size());
    for (int y = 0; y < flow.height(); ++y) {
      bytes.clear();
      for (int x = 0; x < flow.width(); ++x) {
        appendLittleEndian(bytes, flow(x, y).x);
        appendLittleEndian(bytes, flow(x, y).y);
      }
      sink(bytes.data(), bytes.size());
    }
  });
}

}  // namespace fluidymation
