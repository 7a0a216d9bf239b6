#include "pipeline/memory.h"

#include <algorithm>
#include <cstdint>

#include "fluidymation/core/color.h"
#include "fluidymation/guides/backward_motion.h"
#include "fluidymation/guides/flow_average.h"
#include "fluidymation/guides/gaussian.h"
#include "fluidymation/io/png.h"
#include "fluidymation/synthesis/bidirectional_painter.h"
#include "fluidymation/synthesis/exemplar.h"
#include "fluidymation/synthesis/nnf.h"
#include "fluidymation/synthesis/patchmatch.h"
#include "fluidymation/synthesis/pyramid.h"
#include "fluidymation/synthesis/shape_rules.h"
#include "fluidymation/synthesis/texel.h"
#include "pipeline/frame_line.h"

namespace fluidymation {
namespace {

// Bytes per pixel and frame of the exemplar.
constexpr double kDirectionBytes = 4.0;
constexpr double kLevelBytes = kDirectionBytes + sizeof(Segment) + sizeof(std::uint32_t);
constexpr double kExtentBytes = sizeof(Vec2);  // on all levels, until the last frame is read
constexpr double kPyramidFactor = 4.0 / 3.0;   // 1 + 1/4 + 1/16 + ...
constexpr double kAccumulatedBytes = 16.0;     // acc+ and acc-
constexpr double kMapBytes = 4.0;  // an occurrence map; a group of frames of a tile's changes
constexpr double kCandidateGrowthBytes = 4.0;  // a list that grows is there twice for a moment

// Of each frame of the exemplar that is held, its colours by depth (`DepthColors`): on so many
// levels at most (5 * 2^14 px are more than is read) 64 distances, each with its mean and, of one
// level at a time, its sums.
constexpr double kDepthColorBytes = 64.0 * (14.0 * sizeof(Lab) + 4.0 * sizeof(std::int64_t));

// Bytes per pixel of one frame at work. While its guides are made: masks, distances, flows and
// directions of this frame and the last one, and the solver that spreads flow or normals over the
// inside, which at worst is everything. Then for the exemplar the picture as RGBA, as RGB and
// scaled, its guides and their levels; for the target guides, levels, picture and the matches of
// this frame and the last one.
//
// Measured: the solver takes 204 to 208 bytes per pixel of a nearly full mask, at four sizes.
// Whole runs with such masks, by one thread, peak at 0.60 to 0.78 of what this gives: exemplars of
// 2000x1500 px and 1 or 3 frames, 600x450 and 30, 300x225 and 50, targets of 1000x750 and 600x450.
constexpr double kGuideBytes = 72.0;
constexpr double kSolverBytes = 216.0;
constexpr double kReadingBytes = 128.0;
constexpr double kPaintingBytes = 226.0;  // the guides round the mask only
// Of these, per pixel as stored, while a frame is decoded: as RGBA and as RGB, or as RGBA and
// 16-bit rows. It counts on its own where a frame is scaled down.
constexpr double kDecodingBytes = 28.0;
// And while the picture is painted, with --seam-blending 0 or not: the steps wanted across seams,
// and the changes they make; with --change-blending twice, the second time beside the colours voted
// for the old matches and the mask of what has changed; then, with --detail-restoration 0 or not,
// both bands of its detail, and of a mask and of a channel the values and two blurs, and a blur
// that is half done.
constexpr double kSeamBytes = 3.0 * 16.0;
constexpr double kBandBytes = 2.0 * sizeof(Lab) + 7.0 * sizeof(float);
constexpr double kChangeBytes = sizeof(Lab) + sizeof(std::uint8_t);
constexpr double kPictureBytes =
    std::max(kSeamBytes + kChangeBytes, kBandBytes + sizeof(std::uint8_t));
// The same of a frame of the film, with its picture, its mask and distances, whole and cut out.
constexpr double kFilmDetailBytes =
    kBandBytes + sizeof(Lab) + 2.0 * (sizeof(std::uint8_t) + sizeof(float));

// Of a frame that waits for its turn: its mask, and per mask pixel its flow, every so many frames
// the motion still to come, and of anti-aliased masks the outline, with at most two crossings a
// pixel.
constexpr double kPackedMaskBytes = 1.0 / 8.0;
constexpr double kWaitingPixelBytes =
    sizeof(Vec2) * (1.0 + 1.0 / BackwardMotion::kStoredEvery) + 2.0 * sizeof(std::uint16_t);
// Per mask pixel of a frame, the motion still to come of the frames that are next.
constexpr double kBackwardBytes = sizeof(Vec2) * (BackwardMotion::kStoredEvery + 2.0);
// Of each frame of the target: paths to read and to write with their numbers, digests, and where
// it waits.
constexpr double kFrameBytes = 2048.0;

// What rules that are not the thesis' add per pixel: to a level of the exemplar distances that its
// edge guide does not tell and one list of all mask pixels; to a frame at work the blurred mask, on
// all levels; to the flow's average a mask and a flow for every frame of its window.
constexpr double kDistanceBytes = sizeof(float);
constexpr double kAllPixelsBytes = sizeof(std::uint32_t);
constexpr double kShapeBytes = 12.0;
// Where ages may be compared, per pixel of a frame at work: its ages, those that are carried on
// with their mask, and of the exemplar the number of each pixel's part.
constexpr double kAgeBytes = 4.0 + 4.0 + 1.0 + 4.0;
constexpr double kAveragedBytes = sizeof(std::uint8_t) + sizeof(Vec2);

// What is needed to go on after a frame, matches, movement owed and picture; its file marks each
// pixel too.
constexpr double kStateBytes = sizeof(Match) + sizeof(float) + sizeof(Lab);
constexpr double kStateFileBytes = kStateBytes + sizeof(std::uint8_t);
// Per pixel of a frame being written: its picture, mask and coverage, the pixels of the file, and
// the file, which compression hardly makes larger than they are, twice while it grows; then its
// state and the state's file.
constexpr double kWritingBytes =
    sizeof(Lab) + sizeof(std::uint8_t) + sizeof(float) + kStateBytes + kStateFileBytes;
constexpr double kFilesPerWriting = 3.0;
// Where transparent pixels get colours: their distances from the paint, and those at its edge.
constexpr double kMarginBytes = sizeof(std::uint8_t) + 2.0 * sizeof(Pixel);
// What is kept of the frame written last, in case that the next one looks alike: pixels and file;
// and its state, in case that the run is stopped.
constexpr double kWrittenBytes = kStateBytes;
constexpr double kFilesWritten = 2.0;
// Per pixel of the exemplar while its bare surface is found: sums and counts, a picture as RGBA
// and RGB, its mask; then sums and counts, and what is known, filled, shading and result.
constexpr double kBareSurfaceBytes =
    sizeof(Rgb) + sizeof(float) + std::max(28.0 + 2.0 * sizeof(float), 6.0 * sizeof(Rgb));
// What is added where frames are dumped: all their guides, their matches, and these as files hold
// them.
constexpr double kDumpingBytes = kGuideBytes + sizeof(Match) + 20.0;

// Per pixel of a painting that waits for the frames after it: guides, and twice, as painted first
// and as revised, its state; for the dump all guides once more.
constexpr double kGuidesKeptBytes = sizeof(std::uint8_t) + 4.0 * sizeof(float) + 4.0 * sizeof(Vec2);
constexpr double kPaintingKeptBytes = kGuidesKeptBytes + 2.0 * kStateBytes;

// The program with its libraries, and what does not grow with the pictures.
constexpr double kProgramBytes = 16.0 * (1 << 20);

// Per pixel of a given flow as stored: the rows of an interlaced PNG file, its samples, the
// vectors, and these half scaled.
constexpr double kFlowReadingBytes = 8.0 + 6.0 + 8.0 + 8.0;

double pixels(Size size) { return static_cast<double>(size.width) * size.height; }

/// A sequence, as far as its guides are concerned.
struct GuidedSequence {
  Size size;
  int frames;
  double maskPixels;  ///< the most of a frame
  Size given;         ///< size of a given flow as stored, 0x0 where the flow is derived
};

GuidedSequence exemplarOf(const RunSize& run) {
  return {run.exemplar, run.exemplarFrames, static_cast<double>(run.exemplarMaskPixels),
          run.exemplarFlow};
}

GuidedSequence targetOf(const RunSize& run) {
  return {run.target, run.targetFrames, static_cast<double>(run.targetMaskPixels), run.targetFlow};
}

/// What waits in memory while the frames of a sequence are asked for.
double waitingBytes(const GuidedSequence& sequence) {
  const double all = sequence.frames * (pixels(sequence.size) * kPackedMaskBytes +
                                        sequence.maskPixels * kWaitingPixelBytes);
  return std::min(all, static_cast<double>(kWaitingBytes)) + sequence.maskPixels * kBackwardBytes;
}

/// Before anything is painted: the flow of a sequence, with the distances of all frames that the
/// temporal smoothing sees from one, and then its average, with all flows that it sees from one; or
/// the given flow being read.
double flowBytes(const GuidedSequence& sequence, const RunSize& run) {
  const double frame = pixels(sequence.size);
  if (pixels(sequence.given) > 0.0) {
    return frame * kGuideBytes + pixels(sequence.given) * kFlowReadingBytes;
  }
  const auto window = [&sequence](int reach) {
    return std::min<double>(sequence.frames, 2.0 * reach + 1.0);
  };
  return std::max(
      frame * (kGuideBytes + sizeof(float) * window(gaussianReach(run.timeBlurSigmaFrames))) +
          sequence.maskPixels * kSolverBytes,
      frame * (kGuideBytes + kAveragedBytes * window(flowAverageReach(run.flowBlurSigmaFrames))));
}

/// Bytes per pixel of a level of the exemplar that its rules ask for.
double ruleBytes(const ShapeRules& rules) {
  return (edgeGuideTellsDistance(rules) ? 0.0 : kDistanceBytes) +
         (rules.hardSegments ? 0.0 : kAllPixelsBytes);
}

/// Frames of the film that are held at a time.
int heldFrames(const RunSize& run) {
  return run.heldFrames == 0 ? run.exemplarFrames : std::min(run.heldFrames, run.exemplarFrames);
}

/// The texels of the exemplar on all levels, with their margins.
double texelBytes(const RunSize& run) {
  constexpr int kMarginsPx = 2 * ExemplarLevel::kMarginPx;
  double texels = 0.0;
  Size size = run.exemplar;
  for (int level = coarsestLevel(run.exemplar, run.target); level >= 0; --level) {
    texels += pixels({size.width + kMarginsPx, size.height + kMarginsPx});
    size = halvedSize(size);
  }
  return texels * heldFrames(run) * sizeof(Texel);
}

/// While a frame is decoded: what it takes beyond the size that it is scaled to.
double decodingBytes(const RunSize& run, Size scaled) {
  return std::max(0.0, pixels(run.largestStored) - pixels(scaled)) * kDecodingBytes;
}

/// Most tiles of a target that are searched at a time.
int tileCount(Size size) {
  const auto along = [](int length) { return (length + kTileSidePx - 1) / kTileSidePx; };
  return along(size.width) * along(size.height);
}

/// The maps of the search, per pixel and frame of the exemplar: of occurrence on all levels that
/// are searched, of a tile's changes on those where matches are drawn.
double occurrenceBytes(const RunSize& run) {
  const bool isOnlyLevel = coarsestLevel(run.exemplar, run.target) == 0;
  const bool finestIsSearched = run.finestLevel != FinestLevel::kUpscaled || isOnlyLevel;
  const bool finestDraws = run.finestLevel == FinestLevel::kSearched || isOnlyLevel;
  const int workers =
      std::min(run.threads, tileCount(finestDraws ? run.target : halvedSize(run.target)));
  const double ofChanges =
      kMapBytes / UseChanges::framesPerGroup(heldFrames(run), run.occRadiusFrames);
  const auto levelsFrom = [](bool finest) {
    return finest ? kPyramidFactor : kPyramidFactor / 4.0;
  };
  return levelsFrom(finestIsSearched) * kMapBytes + levelsFrom(finestDraws) * ofChanges * workers;
}

/// Paintings kept at most, where frames are painted in both directions of time: of a window, the
/// frame before it, and one that is being copied.
double windowBytes(const RunSize& run) {
  if (run.temporalCoherence == TemporalCoherence::kForward) return 0.0;
  const int window = std::min(kWindowFrames, run.targetFrames);
  return pixels(run.target) *
         ((window + 2) * kPaintingKeptBytes + (run.dumps ? window * kGuidesKeptBytes : 0.0));
}

}  // namespace

std::int64_t bytesOfRun(const RunSize& run) {
  const GuidedSequence film = exemplarOf(run);
  const GuidedSequence target = targetOf(run);
  // Both sequences wait while the exemplar is read, and at most that before and after
  const double waiting = waitingBytes(film) + waitingBytes(target);
  const double flow =
      std::max({decodingBytes(run, {}), flowBytes(film, run), flowBytes(target, run)});

  const bool moves = heldFrames(run) < run.exemplarFrames;  // through the film
  const double exemplarVolume = pixels(run.exemplar) * heldFrames(run);
  const double exemplar =
      texelBytes(run) + exemplarVolume * (kPyramidFactor * (kLevelBytes + ruleBytes(run.shape)) +
                                          kAccumulatedBytes + kCandidateGrowthBytes);
  const double ownBytes = (run.shape.guide == ShapeGuide::kBlurredMask ? kShapeBytes : 0.0) +
                          (run.mayCompareAges ? kAgeBytes : 0.0);
  const auto guiding = [ownBytes](const GuidedSequence& sequence) {
    return pixels(sequence.size) * (kGuideBytes + ownBytes) + sequence.maskPixels * kSolverBytes;
  };
  const double filmFrame = std::max(
      pixels(run.exemplar) * kReadingBytes + decodingBytes(run, run.exemplar), guiding(film));
  const double reading =
      exemplar + (moves ? 0.0 : exemplarVolume * kPyramidFactor * kExtentBytes) + filmFrame;
  const double searching = pixels(run.target) * (kPaintingBytes + kPictureBytes + ownBytes) +
                           pixels(run.exemplar) * kFilmDetailBytes;
  const double pixelBytes = run.bitDepth == BitDepth::k8 ? sizeof(Rgba8) : sizeof(Rgba16);
  const double writing = pixels(run.target) * (kWritingBytes + kFilesPerWriting * pixelBytes +
                                               (run.hasBackground ? 0.0 : kMarginBytes) +
                                               (run.dumps ? kDumpingBytes : 0.0));
  const bool sideBySide = shareThreads(run.threads).beside() > 0;
  // A frame that the film moves on to is read where else one is searched
  const double atWork = moves ? std::max(searching, filmFrame) : searching;
  const double painting = exemplar + exemplarVolume * occurrenceBytes(run) +
                          heldFrames(run) * kDepthColorBytes + windowBytes(run) +
                          pixels(run.target) * (kWrittenBytes + kFilesWritten * pixelBytes) +
                          (sideBySide ? guiding(target) + atWork + writing
                                      : std::max({guiding(target), atWork, writing}));

  // As colours, and as the pixels of a file
  const double background =
      run.hasBackground ? pixels(run.target) * (sizeof(Rgb) + pixelBytes) : 0.0;
  // Made before any mask is read; scaled or cut from a surface that is of no use any more
  const double surfacing = run.hasBareSurface ? pixels(run.exemplar) * kBareSurfaceBytes +
                                                    decodingBytes(run, run.exemplar)
                                              : 0.0;
  return static_cast<std::int64_t>(kProgramBytes + background + run.targetFrames * kFrameBytes +
                                   waiting + std::max({flow, reading, painting, surfacing}));
}

std::string memoryText(std::int64_t bytes) {
  constexpr std::int64_t kMebibyte = std::int64_t{1} << 20;
  constexpr std::int64_t kGibibyte = kMebibyte << 10;
  if (bytes < kGibibyte) return std::to_string((bytes + kMebibyte - 1) / kMebibyte) + " MiB";
  // What no machine has is said in whole ones, that tenths do not overflow
  if (bytes > kGibibyte << 20) return std::to_string(bytes / kGibibyte) + " GiB";
  const std::int64_t tenths = (10 * bytes + kGibibyte - 1) / kGibibyte;
  return std::to_string(tenths / 10) + "." + std::to_string(tenths % 10) + " GiB";
}

}  // namespace fluidymation
