#include "pipeline/memory.h"

#include <algorithm>
#include <cmath>

#include "fluidymation/synthesis/lanes.h"
#include "fluidymation/synthesis/patchmatch.h"
#include "fluidymation/synthesis/pyramid.h"

namespace fluidymation {
namespace {

// Bytes per pixel and frame of the exemplar.
constexpr double kLevelBytes = sizeof(Lanes) + sizeof(Segment) + sizeof(std::uint32_t);
constexpr double kPyramidFactor = 4.0 / 3.0;   // 1 + 1/4 + 1/16 + ...
constexpr double kAccumulatedBytes = 16.0;     // acc+ and acc-, or while reading the stream's own
constexpr double kFilteredMapBytes = 8.0;      // an occurrence map with its filters' buffer
constexpr double kMapBytes = 4.0;              // one without: the changes of a thread's tile
constexpr double kCandidateGrowthBytes = 4.0;  // a list that grows is there twice for a moment

// Bytes per pixel of one frame at work. For the exemplar: the picture as RGBA, as RGB and scaled,
// its guides and their levels. For the target: guides, levels, picture and the matches of this
// frame and the last one. Measured peaks of whole runs on 2000x1500 px, two threads: 233 bytes per
// target pixel besides what its masks keep; 206, 261 and 321 per exemplar pixel with 1, 2 and 3
// frames, for which this gives 205, 282 and 359.
constexpr double kReadingBytes = 128.0;
constexpr double kPaintingBytes = 256.0;
// Of these, per pixel as stored, while a frame is decoded: as RGBA and as RGB, or as RGBA and
// 16-bit rows. It counts on its own where a frame is scaled down.
constexpr double kDecodingBytes = 28.0;
constexpr double kPackedMaskBytes = 1.0 / 8.0;

double pixels(Size size) { return static_cast<double>(size.width) * size.height; }

/// While the flow of a sequence is computed: the distances of all frames that the temporal
/// smoothing sees from one, and the guides of that one.
double flowBytes(Size size, int frames, float sigmaFrames) {
  constexpr double kReachSigmas = 3.0;
  const double window = 2.0 * std::ceil(kReachSigmas * static_cast<double>(sigmaFrames)) + 1.0;
  return pixels(size) * (kReadingBytes + sizeof(float) * std::min<double>(frames, window));
}

/// While a frame is read that may be larger than what it is scaled to.
double readingBytes(const RunSize& run) {
  const double surplus = std::max(0.0, pixels(run.largestStored) - pixels(run.exemplar));
  return pixels(run.exemplar) * kReadingBytes + surplus * kDecodingBytes;
}

/// Most tiles of a target that are searched at a time.
int tileCount(Size size) {
  const auto along = [](int length) { return (length + kTileSidePx - 1) / kTileSidePx; };
  return along(size.width) * along(size.height);
}

/// Maps of the finest level's first look and of the search, which leaves the finest level out
/// unless it is the only one. They do not exist at the same time.
double occurrenceBytes(const RunSize& run) {
  const bool finestIsSearched = coarsestLevel(run.exemplar, run.target) == 0;
  const Size searched = finestIsSearched ? run.target : halvedSize(run.target);
  const int workers = std::min(run.threads, tileCount(searched));
  const double search = kFilteredMapBytes + kMapBytes * workers;
  return std::max(kFilteredMapBytes, (finestIsSearched ? 1.0 : 0.25) * search);
}

}  // namespace

std::int64_t bytesOfRun(const RunSize& run) {
  const double perExemplarPixel = kPyramidFactor * kLevelBytes + kAccumulatedBytes +
                                  kCandidateGrowthBytes + occurrenceBytes(run);
  const double exemplar = pixels(run.exemplar) * run.exemplarFrames * perExemplarPixel;
  const double frame =
      std::max({readingBytes(run), pixels(run.target) * kPaintingBytes,
                flowBytes(run.exemplar, run.exemplarFrames, run.timeBlurSigmaFrames),
                flowBytes(run.target, run.targetFrames, run.timeBlurSigmaFrames)});
  const double masks = pixels(run.target) * run.targetFrames * kPackedMaskBytes;
  return static_cast<std::int64_t>(exemplar + frame + masks);
}

std::string gibibytes(std::int64_t bytes) {
  constexpr std::int64_t kGibibyte = std::int64_t{1} << 30;
  const std::int64_t tenths = (10 * bytes + kGibibyte - 1) / kGibibyte;
  return std::to_string(tenths / 10) + "." + std::to_string(tenths % 10) + " GiB";
}

}  // namespace fluidymation
