#include "checkpoint/checkpoint_file.h"

#include <cstdio>

#include "fluidymation/core/error.h"
#include "io/input_file.h"

namespace fluidymation {
namespace {

/// No state is larger. One of another run may have more frames than this one, and is still to be
/// told in what it differs.
[[nodiscard]] std::int64_t mostBytes(const CheckpointLimits& limits) {
  constexpr std::int64_t kRecordBytes = 25;       // flag, digest, seconds
  constexpr std::int64_t kFileBytes = 20;         // number, digest
  constexpr std::int64_t kOptionBytes = 1 << 10;  // name and value: lists of 32 numbers at most
  constexpr std::int64_t kOtherBytes = 1 << 10;   // mark, version, box, digest
  return static_cast<std::int64_t>(kMostPixelBytes) * limits.target.width * limits.target.height +
         (kRecordBytes + kFileBytes * static_cast<std::int64_t>(kMostInputs)) *
             static_cast<std::int64_t>(kMostFrames) +
         kOptionBytes * static_cast<std::int64_t>(kMostOptions + kMostInputs) + kOtherBytes;
}

}  // namespace

std::vector<std::uint8_t> readWhole(const std::string& path, std::int64_t mostBytes,
                                    const std::string& wanted) {
  const InputFile input = openInput(path, wanted, mostBytes);
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
