#include "fluidymation/pipeline.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "fluidymation/core/color.h"
#include "fluidymation/core/error.h"
#include "fluidymation/core/parallel.h"
#include "fluidymation/guides/guide_stream.h"
#include "fluidymation/io/png.h"
#include "fluidymation/option_ranges.h"
#include "fluidymation/synthesis/exemplar.h"
#include "fluidymation/synthesis/pyramid.h"
#include "fluidymation/synthesis/synthesizer.h"
#include "pipeline/flow_note.h"
#include "pipeline/guide_dump.h"
#include "pipeline/inputs.h"
#include "pipeline/memory.h"
#include "pipeline/nnf_dump.h"
#include "pipeline/outputs.h"
#include "pipeline/thread_count.h"

namespace fluidymation {
namespace {

/// @throws Interrupted when the caller wants no more.
void stopIfCancelled(const Observer& observer, int written, int count) {
  if (!observer.cancelled || !observer.cancelled()) return;
  throw Interrupted("interrupted; " + std::to_string(written) + " of " + std::to_string(count) +
                    " frames written");
}

void tellOfFlow(const Observer& observer, const std::string& option, int frameNumber,
                const GuideFrame& frame) {
  const std::optional<std::string> note = flowNote(option, frameNumber, frame.diffusion);
  if (note && observer.note) observer.note(*note);
}

/// @throws Error when no mask of the exemplar holds any material.
void requireMaterial(const Options& options, const GuideStream& guides) {
  if (guides.anyInside()) return;
  throw Error("--src-mask-path " + options.sourceMaskPath + ": all " +
              std::to_string(guides.frameCount()) +
              " masks are empty after smoothing with --blur-sigma; wanted some material, so "
              "check the masks or lower --blur-sigma");
}

/// The exemplar with its colours, which are all that is read of it after the masks.
/// @throws Interrupted, Error.
Exemplar readPictures(const Options& options, const Inputs& inputs, const Observer& observer) {
  const Size size = inputs.color.scaled;
  Exemplar exemplar(size, inputs.color.files.count(), coarsestLevel(size, inputs.target.scaled),
                    options.synthesis.borderWidthPx);
  for (int k = 0; k < exemplar.frameCount(); ++k) {
    stopIfCancelled(observer, 0, inputs.target.files.count());
    exemplar.setColor(k, toLab(readPicture(inputs.color, k)));
  }
  return exemplar;
}

/// Completes the exemplar by its guides, and dumps them where that is wanted.
/// @throws Interrupted, Error.
void addGuides(const Options& options, const Inputs& inputs, GuideStream& guides,
               const Observer& observer, Exemplar& exemplar) {
  for (int k = 0; k < exemplar.frameCount(); ++k) {
    stopIfCancelled(observer, 0, inputs.target.files.count());
    const GuideFrame frame = guides.next();
    const int number = inputs.color.files.numbers[static_cast<std::size_t>(k)];
    tellOfFlow(observer, "--src-mask-path " + options.sourceMaskPath, number, frame);
    exemplar.setGuides(k, frame);
    if (options.dumpGuidesDirectory) {
      dumpGuides(dumpFolder(options, "source"), number, frame);
    }
  }
  exemplar.finish(options.synthesis.extentUnit);
}

/// Straight alpha: painted and opaque inside the mask, fully transparent elsewhere.
Image<Rgba8> toOutput(const Image<Lab>& picture, const Mask& mask) {
  Image<Rgba8> output(picture.size());
  forEachRow(picture.height(), [&](int y) {
    for (int x = 0; x < picture.width(); ++x) {
      if (mask(x, y) == 0) continue;
      const Rgb color = toRgb(picture(x, y));
      output(x, y) = {toByte(color.r), toByte(color.g), toByte(color.b), 255};
    }
  });
  return output;
}

}  // namespace

void stylize(const Options& options, const Observer& observer) {
  using Clock = std::chrono::steady_clock;
  validate(options);
  const ThreadCount threads(options.threads);

  const Inputs inputs = openInputs(options, observer);
  const std::vector<std::string> outPaths = checkOutput(options, inputs);
  const int frameCount = inputs.target.files.count();
  const auto stopBeforeTheFirst = [&] { stopIfCancelled(observer, 0, frameCount); };

  // All files are read before anything is written, and only masks and colours are kept: a damaged
  // one must leave neither half a dump nor an empty folder.
  const MaskChannel sourceChannel = maskChannel(inputs.sourceMask, stopBeforeTheFirst);
  GuideStream sourceGuides(
      inputs.sourceMask.files.count(),
      [&](int frame) {
        stopBeforeTheFirst();
        return readMask(inputs.sourceMask, sourceChannel, frame);
      },
      GuideOptions{options.sourceMask, options.timeBlurSigmaFrames});
  requireMaterial(options, sourceGuides);
  MaskOptions targetMask = options.sourceMask;
  targetMask.blurSigmaPx = options.targetBlurSigmaPx.value_or(targetMask.blurSigmaPx);
  const std::int64_t otherBytes = bytesOfRun(sizeOfRun(options, inputs));
  const MaskReader readTarget =
      countingReader(inputs.target, maskChannel(inputs.target, stopBeforeTheFirst),
                     options.target.path, otherBytes);
  GuideStream guides(
      frameCount,
      [&](int frame) {
        stopBeforeTheFirst();
        return readTarget(frame);
      },
      GuideOptions{targetMask, options.timeBlurSigmaFrames, options.motionModel});
  Exemplar exemplar = readPictures(options, inputs, observer);
  createOutputFolders(options, outPaths);
  addGuides(options, inputs, sourceGuides, observer, exemplar);
  Synthesizer synthesizer(exemplar, options.synthesis);

  if (observer.paintingBegins) observer.paintingBegins(frameCount);
  for (int j = 0; j < frameCount; ++j) {
    stopIfCancelled(observer, j, frameCount);
    const auto i = static_cast<std::size_t>(j);
    const Clock::time_point start = Clock::now();
    const GuideFrame frame = guides.next();
    const int number = inputs.target.files.numbers[i];
    tellOfFlow(observer, "--target-path " + options.target.path, number, frame);
    const Image<Lab> picture = synthesizer.paint(frame);
    writePng(outPaths[i], toOutput(picture, frame.mask));
    if (options.dumpGuidesDirectory) {
      dumpGuides(dumpFolder(options, "target"), number, frame);
      dumpNearestNeighborField(dumpFolder(options, "target"), number, synthesizer.nnf(),
                               inputs.color.files.numbers, exemplar.level(0).size());
    }
    if (observer.frameDone) {
      const std::chrono::duration<double> spent = Clock::now() - start;
      observer.frameDone({j, frameCount, number, spent.count(), outPaths[i]});
    }
  }
}

}  // namespace fluidymation
