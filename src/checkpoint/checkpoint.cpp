#include "checkpoint/checkpoint.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "fluidymation/core/error.h"

namespace fluidymation {
namespace {

constexpr std::array<std::uint8_t, 8> kMark = {'F', 'L', 'U', 'I', 'D', 'S', 'T', '\n'};
constexpr std::uint32_t kFormat = 3;
constexpr std::size_t kDigestBytes = std::tuple_size_v<decltype(Digest::bytes)>;

// What is known of a pixel, one byte each.
constexpr std::uint8_t kHasMatch = 1;
constexpr std::uint8_t kOwes = 2;
constexpr std::uint8_t kIsPainted = 4;
constexpr std::uint8_t kMostFlags = kHasMatch | kOwes | kIsPainted;

void write(const FrameRecords& frames, ByteWriter& bytes) {
  bytes.count(frames.size());
  for (const std::optional<FrameRecord>& frame : frames) {
    bytes.byte(frame ? 1 : 0);
    if (!frame) continue;
    bytes.digest(frame->digest);
    bytes.number(frame->seconds);
  }
}

[[nodiscard]] FrameRecords readFrames(const CheckpointLimits& limits, ByteReader& bytes) {
  constexpr double kLongestSeconds = 1e12;
  const std::size_t count = bytes.count(1, "the number of frames");
  if (count != static_cast<std::size_t>(limits.targetFrames)) {
    throw Error("it is damaged: it is of another number of frames");
  }
  FrameRecords frames(count);
  for (std::optional<FrameRecord>& frame : frames) {
    if (bytes.byte() == 0) continue;
    FrameRecord record;
    record.digest = bytes.digest();
    record.seconds = bytes.number(0.0, kLongestSeconds, "the time of a frame");
    frame = record;
  }
  return frames;
}

void write(const Match& match, ByteWriter& bytes) {
  bytes.words(std::array<std::uint32_t, 5>{ByteWriter::bitsOf(match.x), ByteWriter::bitsOf(match.y),
                                           static_cast<std::uint32_t>(match.frame),
                                           ByteWriter::bitsOf(match.rotation.cosine),
                                           ByteWriter::bitsOf(match.rotation.sine)});
}

/// @param filmBegin  the first frame of the film that was held.
[[nodiscard]] Match readMatch(const CheckpointLimits& limits, int filmBegin, ByteReader& bytes) {
  constexpr float kMarginPx = 8.0F;  // matches that were only enlarged may lie just outside
  constexpr float kTurnTolerance = 0.01F;
  const auto place = [&](int side) {
    return bytes.number(-kMarginPx, static_cast<float>(side) + kMarginPx, "the place of a match");
  };
  Match match;
  match.x = place(limits.exemplar.width);
  match.y = place(limits.exemplar.height);
  match.frame = bytes.number(filmBegin, filmBegin + limits.heldFrames - 1, "the frame of a match");
  match.rotation.cosine = bytes.number(-2.0F, 2.0F, "the rotation of a match");
  match.rotation.sine = bytes.number(-2.0F, 2.0F, "the rotation of a match");
  const Rotation& r = match.rotation;
  if (std::abs(r.cosine * r.cosine + r.sine * r.sine - 1.0F) > kTurnTolerance) {
    throw Error("it is damaged: the rotation of a match is out of range");
  }
  return match;
}

/// As a picture is where nothing was painted.
[[nodiscard]] bool isBlack(const Lab& color) {
  return color.l == 0.0F && color.a == 0.0F && color.b == 0.0F;
}

void write(const SynthesisState& state, ByteWriter& bytes) {
  for (const int number : {state.frame, state.size.width, state.size.height, state.box.beginX,
                           state.box.beginY, state.box.endX, state.box.endY, state.filmBegin}) {
    bytes.number(number);
  }
  for (std::size_t i = 0; i < state.nnf.pixelCount(); ++i) {
    const bool hasMatch = state.nnf.data()[i].exists();
    const bool owes = state.owed.data()[i] != 0.0F;
    const bool isPainted = !isBlack(state.picture.data()[i]);
    bytes.byte(static_cast<std::uint8_t>((hasMatch ? kHasMatch : 0) | (owes ? kOwes : 0) |
                                         (isPainted ? kIsPainted : 0)));
  }
  for (const Match& match : state.nnf) {
    if (match.exists()) write(match, bytes);
  }
  for (const float owed : state.owed) {
    if (owed != 0.0F) bytes.number(owed);
  }
  for (const Lab& color : state.picture) {
    if (isBlack(color)) continue;
    bytes.words(std::array<std::uint32_t, 3>{
        ByteWriter::bitsOf(color.l), ByteWriter::bitsOf(color.a), ByteWriter::bitsOf(color.b)});
  }
}

[[nodiscard]] Box readBox(Size size, ByteReader& bytes) {
  Box box;
  box.beginX = bytes.number(0, size.width, "the box");
  box.beginY = bytes.number(0, size.height, "the box");
  box.endX = bytes.number(box.beginX, size.width, "the box");
  box.endY = bytes.number(box.beginY, size.height, "the box");
  return box;
}

[[nodiscard]] SynthesisState readState(const CheckpointLimits& limits, ByteReader& bytes) {
  constexpr float kLargestOwedPx = 1e9F;
  constexpr float kLargestColor = 1e4F;  // far outside of every gamut
  SynthesisState state;
  state.frame = bytes.number(1, limits.targetFrames, "the frame");
  state.size.width = bytes.number(1, limits.target.width, "the size");
  state.size.height = bytes.number(1, limits.target.height, "the size");
  if (state.size != limits.target) throw Error("it is damaged: it is of another size");
  state.box = readBox(state.size, bytes);
  state.filmBegin =
      bytes.number(0, limits.exemplarFrames - limits.heldFrames, "the first frame held");
  const auto pixels = static_cast<std::size_t>(state.box.size().width) *
                      static_cast<std::size_t>(state.box.size().height);
  if (pixels > bytes.left()) throw Error("it is damaged: it ends too early");
  std::vector<std::uint8_t> known(pixels);
  for (std::uint8_t& flags : known) {
    flags = bytes.byte();
    if (flags > kMostFlags) throw Error("it is damaged: the flags of a pixel are out of range");
  }
  state.nnf = NearestNeighborField(state.box.size());
  state.owed = Image<float>(state.box.size());
  state.picture = Image<Lab>(state.box.size());
  for (std::size_t i = 0; i < pixels; ++i) {
    if ((known[i] & kHasMatch) != 0)
      state.nnf.data()[i] = readMatch(limits, state.filmBegin, bytes);
  }
  for (std::size_t i = 0; i < pixels; ++i) {
    if ((known[i] & kOwes) == 0) continue;
    state.owed.data()[i] = bytes.number(-kLargestOwedPx, kLargestOwedPx, "the movement owed");
  }
  const auto color = [&] { return bytes.number(-kLargestColor, kLargestColor, "a colour"); };
  for (std::size_t i = 0; i < pixels; ++i) {
    if ((known[i] & kIsPainted) == 0) continue;
    Lab& painted = state.picture.data()[i];
    painted.l = color();
    painted.a = color();
    painted.b = color();
  }
  return state;
}

}  // namespace

std::vector<std::uint8_t> encode(const Fingerprint& fingerprint, int begin,
                                 const FrameRecords& frames, const SynthesisState& synthesis) {
  ByteWriter bytes;
  bytes.reserve(kMostPixelBytes * synthesis.nnf.pixelCount());
  for (const std::uint8_t byte : kMark) bytes.byte(byte);
  bytes.number(kFormat);
  write(fingerprint, bytes);
  bytes.number(begin);
  write(frames, bytes);
  write(synthesis, bytes);
  bytes.digest(digestOf(bytes.bytes().data(), bytes.bytes().size()));
  return bytes.take();
}

std::optional<Checkpoint> decode(const std::vector<std::uint8_t>& bytes, const Fingerprint& now,
                                 const CheckpointLimits& limits, std::string& differs) {
  if (bytes.size() < kMark.size() + sizeof kFormat + kDigestBytes ||
      !std::equal(kMark.begin(), kMark.end(), bytes.begin())) {
    throw Error("it is no state of fluidymation, or damaged");
  }
  ByteReader reader(bytes.data() + kMark.size(), bytes.size() - kMark.size() - kDigestBytes);
  const std::uint32_t format = reader.unsignedNumber();
  ByteReader last(bytes.data() + bytes.size() - kDigestBytes, kDigestBytes);
  if (last.digest() != digestOf(bytes.data(), bytes.size() - kDigestBytes)) {
    throw Error("it is damaged: its digest is another one");
  }
  if (format != kFormat) {
    throw Error("it has format " + std::to_string(format) + "; wanted " + std::to_string(kFormat));
  }
  Checkpoint checkpoint;
  checkpoint.fingerprint = readFingerprint(reader);
  if (const std::optional<std::string> found = difference(checkpoint.fingerprint, now)) {
    differs = *found;
    return std::nullopt;
  }
  checkpoint.begin = reader.number(0, limits.targetFrames - 1, "the first frame");
  checkpoint.frames = readFrames(limits, reader);
  checkpoint.synthesis = readState(limits, reader);
  reader.requireEnd();
  for (int j = checkpoint.begin; j < checkpoint.next(); ++j) {
    if (!checkpoint.frames[static_cast<std::size_t>(j)]) {
      throw Error("it is damaged: it knows nothing of a frame before its own");
    }
  }
  return checkpoint;
}

}  // namespace fluidymation
