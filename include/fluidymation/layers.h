#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "fluidymation/options.h"
#include "fluidymation/pipeline.h"

namespace fluidymation {

/// A part of a shot that is painted by a run of its own, with its own exemplar.
struct Layer {
  std::string name;  ///< for messages; names differ
  Options options;   ///< all of its run: `outPath` is where its own frames are written
};

/// A shot painted in layers, which meet by their frames' numbers: frame 7 shows what each of them
/// has as its own frame 7.
struct LayeredShot {
  /// From the lowest to the uppermost; at least one. The masks of their animations have one size,
  /// once they are scaled: that of the shot's frames.
  std::vector<Layer> layers;
  std::string outPath;  ///< pattern of the composited frames
  /// What they are laid over: a colour, a PNG file, "exemplar" for the bare surface of the lowest
  /// layer's film, "exemplar:NAME" for that of another one's. None: the frames stay transparent.
  std::optional<std::string> background;
  ContinuationOptions continuation;  ///< of the composited frames: what may be replaced
  BitDepth bitDepth = BitDepth::k8;  ///< of the composited frames
  int compressionLevel = kDefaultCompression;
};

/// Checks all that can be wrong before anything is painted, as far as headers and folders tell:
/// options and inputs of every layer, that their frames have one size, that none of them has gaps
/// where others go on, that the background is there, that no file that is written replaces one
/// that is read, and no composited frame a picture that somebody else has made.
/// @param observer  is told which layers do not last as long as the shot.
/// @throws Error, UsageError, Faults, naming the layer; UsageError where there is none.
void checkLayers(const LayeredShot& shot, const Observer& observer);

/// Lays the painted frames of all layers over each other and over the background, and writes them
/// with a manifest of their own: of sRGB-encoded values, each pixel by its straight alpha (Porter
/// and Duff's `over`). With a background the files have no alpha; without one, transparent pixels
/// near the paint have its colours, as those of any run; about the meaning of colours they say what
/// the lowest layer's do. One frame of one layer is in memory at a time.
/// Looks at all inputs once more, as `checkLayers` does; the painted frames must be there.
/// @param observer  `frameDone`, `cancelled` and `note` are used.
/// @throws Interrupted when `observer.cancelled` asked for it; Error naming the file, also where a
///   painted frame has another size; what `checkLayers` throws for inputs.
void compositeLayers(const LayeredShot& shot, const Observer& observer);

/// Does `step`, whose faults then say which layer they belong to.
/// @throws what `step` throws: Error, UsageError, Faults and Interrupted with the layer's name.
void inLayer(const std::string& name, const std::function<void()>& step);

}  // namespace fluidymation
