#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "compositing/color_margin.h"
#include "compositing/over.h"
#include "fluidymation/core/error.h"
#include "fluidymation/core/index.h"
#include "fluidymation/core/version.h"
#include "fluidymation/io/atomic_file.h"
#include "fluidymation/io/color_chunks.h"
#include "fluidymation/io/digest.h"
#include "fluidymation/io/png.h"
#include "fluidymation/layers.h"
#include "layers/composited_frames.h"
#include "layers/layer_inputs.h"
#include "pipeline/backdrop.h"
#include "pipeline/existing_frames.h"
#include "pipeline/frame_replacement.h"
#include "pipeline/run_journal.h"
#include "pipeline/run_lock.h"
#include "pipeline/starting_point.h"
#include "pipeline/stopping.h"

namespace fluidymation {
namespace {

/// The painted frames of number `number`, from the lowest layer to the uppermost.
[[nodiscard]] std::vector<std::string> pathsOf(const LayeredShot& shot, const LayerInputs& layers,
                                               int number) {
  std::vector<std::string> paths;
  for (std::size_t i = 0; i < shot.layers.size(); ++i) {
    if (!isSeen(layers.frames[i], number)) continue;
    paths.push_back(FramePattern(shot.layers[i].options.outPath).path(number));
  }
  return paths;
}

/// One digest for each frame of the shot, of those of the layers' frames: how many layers there are
/// does not matter to who reads it.
[[nodiscard]] InputDigests digestsOfLayers(const LayeredShot& shot, const LayerInputs& layers,
                                           const std::function<void()>& beforeEach) {
  InputDigests digests{"layers", {}};
  for (const int number : layers.numbers) {
    std::string texts;
    for (const std::string& path : pathsOf(shot, layers, number)) {
      beforeEach();
      texts += digestOfFile(path).text();
    }
    digests.files.push_back({number, digestOf(texts.data(), texts.size())});
  }
  return digests;
}

[[nodiscard]] RunIdentity identityOf(const LayeredShot& shot, const LayerInputs& layers,
                                     const std::function<void()>& beforeEach) {
  RunIdentity run = compositedFrames(shot, layers);
  std::string names;
  for (const Layer& layer : shot.layers) names += (names.empty() ? "" : ",") + layer.name;
  run.fingerprint.version = version();
  run.fingerprint.options = {{"layers", names},
                             {"background", backgroundText(shot.background.value_or("none"))},
                             {"--bit-depth", shot.bitDepth == BitDepth::k16 ? "16" : "8"},
                             {"--compression-level", std::to_string(shot.compressionLevel)}};
  run.fingerprint.inputs.push_back(digestsOfLayers(shot, layers, beforeEach));
  if (layers.background) {
    run.fingerprint.inputs.push_back({kBackgroundOption, {{0, digestOfFile(*shot.background)}}});
  }
  return run;
}

/// As files hold it, with colours round the paint. @param rounded  a value in [0, 1] as a channel
/// of `Pixel`.
template <typename Pixel, typename Rounded>
[[nodiscard]] Image<Pixel> pixelsOf(const Image<Rgba>& canvas, const Rounded& rounded) {
  Image<Pixel> pixels(canvas.size());
  std::transform(canvas.begin(), canvas.end(), pixels.begin(), [&rounded](Rgba color) {
    const auto alpha = rounded(color.a);
    if (alpha == 0) return Pixel{};
    return Pixel{rounded(color.r), rounded(color.g), rounded(color.b), alpha};
  });
  spreadColors(pixels);
  return pixels;
}

/// What the lowest layer's files say about the meaning of colours. Tells of layers that say other.
[[nodiscard]] ColorChunks chunksOf(const LayeredShot& shot, const LayerInputs& layers,
                                   const Observer& observer) {
  std::optional<ColorChunks> lowest;
  for (std::size_t i = 0; i < shot.layers.size(); ++i) {
    const FramePattern frames(shot.layers[i].options.outPath);
    ColorChunks chunks = readColorChunks(frames.path(layers.frames[i].numbers.front())).chunks;
    if (!lowest) {
      lowest = std::move(chunks);
    } else if (chunks != *lowest && observer.note) {
      observer.note("layer " + shot.layers[i].name + ": its frames (" + namesOf(chunks) +
                    ") say other than those of layer " + shot.layers.front().name + " (" +
                    namesOf(*lowest) +
                    ") about the meaning of colours; the composited frames say as these do");
    }
  }
  return *lowest;
}

/// One frame of the shot as a file.
/// @param bottom   what lies under all layers.
/// @param content  of the file.
[[nodiscard]] std::vector<std::uint8_t> composite(const LayeredShot& shot,
                                                  const LayerInputs& layers, int number,
                                                  const Image<Rgba>& bottom,
                                                  const PngContent& content) {
  Image<Rgba> canvas = bottom.clone();
  for (const std::string& path : pathsOf(shot, layers, number)) {
    layOver(readPng(path, layers.size), canvas);
  }
  if (shot.bitDepth == BitDepth::k16) {
    return encodePng(pixelsOf<Rgba16>(canvas, to16Bits), shot.compressionLevel, content);
  }
  return encodePng(pixelsOf<Rgba8>(canvas, toByte), shot.compressionLevel, content);
}

/// Composites all frames; `stopping` knows how far it came.
void compositeAll(const LayeredShot& shot, const Observer& observer, const LayerInputs& layers,
                  Stopping& stopping) {
  const auto stopIfWanted = [&stopping] { stopping.check(); };
  const auto count = static_cast<int>(layers.numbers.size());
  // Digests first: a background that is replaced meanwhile is noticed when it is read.
  const RunIdentity run = identityOf(shot, layers, stopIfWanted);
  const Image<Rgba> bottom = bottomOf(shot, layers, stopIfWanted);
  const PngContent content{shot.background.has_value(), chunksOf(shot, layers, observer)};
  RunLock lock(run.files);
  lock.takeIfUsed();
  const StartingPoint start = wholeShot(layers);
  const FrameReplacement replacement(run, start.span,
                                     requireOwnFrames(shot.continuation, run, start, stopIfWanted),
                                     shot.continuation.waysOut);
  createFolder(run.files.folder());
  checkFolderWritable(run.files.folder());
  const std::string note = lock.take();
  if (!note.empty() && observer.note) observer.note(note);
  lock.setUnfinished(true);
  replacement.begin();
  // What it says of frames holds no longer; the hidden folder tells that they are a run's own.
  std::error_code ignored;
  std::filesystem::remove(run.files.manifest(), ignored);
  RunJournal journal(run, start.span, start, {{"--out-path", shot.outPath}}, shot.continuation);
  auto before = std::chrono::steady_clock::now();
  for (int j = 0; j < count; ++j) {
    stopping.check();
    const int number = layers.numbers[at(j)];
    const std::vector<std::uint8_t> file = composite(shot, layers, number, bottom, content);
    const Digest digest = digestOf(file.data(), file.size());
    replacement.beforeWriting(j, digest);
    writeAtomically(run.framePaths[at(j)], file);
    journal.frameWritten(j, digest, nullptr);
    stopping.setWritten(j + 1, count);
    const auto now = std::chrono::steady_clock::now();
    const std::chrono::duration<double> seconds = now - std::exchange(before, now);
    if (!observer.frameDone) continue;
    observer.frameDone({j, count, number, seconds.count(), run.framePaths[at(j)]});
  }
  journal.finish();
  replacement.finish();
  lock.setUnfinished(false);
}

}  // namespace

void compositeLayers(const LayeredShot& shot, const Observer& observer) {
  // Anew, though they have been checked: painting the layers may have taken days, and for so long
  // names and identities of all files would have been kept beside each layer's own.
  const LayerInputs layers = openLayers(shot);
  Stopping stopping(observer, static_cast<int>(layers.numbers.size()));
  try {
    compositeAll(shot, observer, layers, stopping);
  } catch (const Interrupted& stop) {
    throw Interrupted(std::string(stop.what()) + "; --resume keeps the layers and writes all",
                      true);
  }
}

}  // namespace fluidymation
