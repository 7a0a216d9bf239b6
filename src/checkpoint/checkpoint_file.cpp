#include "checkpoint/checkpoint_file.h"

#include "fluidymation/core/error.h"
#include "io/input_file.h"

namespace fluidymation {
namespace {

/// No state is larger: the field takes 25 bytes a pixel, all else is small.
[[nodiscard]] std::int64_t mostBytes(const CheckpointLimits& limits) {
  constexpr std::int64_t kPixelBytes = 32;
  constexpr std::int64_t kOtherBytes = 256 << 20;
  return kPixelBytes * limits.target.width * limits.target.height + kOtherBytes;
}

}  // namespace

std::vector<std::uint8_t> readWhole(const std::string& path, std::int64_t mostBytes,
                                    const std::string& wanted) {
  const InputFile input = openInput(path, wanted);
  if (input.byteCount > mostBytes) {
    throw Error(path + ": has " + std::to_string(input.byteCount) + " bytes; wanted " + wanted +
                " of at most " + std::to_string(mostBytes));
  }
  std::vector<std::uint8_t> bytes(static_cast<std::size_t>(input.byteCount));
  if (std::fread(bytes.data(), 1, bytes.size(), input.file.get()) != bytes.size()) {
    throw Error(path + ": cannot be read to its end");
  }
  return bytes;
}

FoundCheckpoint readCheckpoint(const std::string& path, const Fingerprint& now,
                               const CheckpointLimits& limits) {
  const std::vector<std::uint8_t> bytes =
      readWhole(path, mostBytes(limits), "a state of fluidymation");
  FoundCheckpoint found;
  try {
    found.checkpoint = decode(bytes, now, limits, found.differs);
  } catch (const Error& error) {
    throw Error(path + ": " + error.what());
  }
  return found;
}

}  // namespace fluidymation
