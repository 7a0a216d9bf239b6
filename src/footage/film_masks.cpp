#include "fluidymation/film_masks.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "fluidymation/core/error.h"
#include "fluidymation/core/index.h"
#include "fluidymation/io/png.h"
#include "footage/bare_picture.h"
#include "footage/camera_tracker.h"
#include "footage/difference_histogram.h"
#include "footage/film_difference.h"
#include "footage/film_findings.h"
#include "footage/film_mask_files.h"
#include "footage/light_meter.h"
#include "footage/mask_cleaning.h"
#include "footage/matte.h"
#include "footage/outline_sheet.h"
#include "inspect/numbers.h"
#include "pipeline/thread_count.h"

namespace fluidymation {
namespace {

/// Reads frames; asks before each whether to go on.
class FilmReader {
 public:
  FilmReader(const FilmMaskFiles& files, const std::function<bool()>& cancelled)
      : files_(files), cancelled_(cancelled) {}

  [[nodiscard]] Image<Rgb> frame(int i) const {
    if (cancelled_ && cancelled_()) {
      throw Interrupted("interrupted; " + std::to_string(masksWritten) + " of " +
                        std::to_string(files_.film.count()) + " masks are written");
    }
    return readColor(files_.film.paths[at(i)], files_.size);
  }

  int masksWritten = 0;

 private:
  const FilmMaskFiles& files_;
  const std::function<bool()>& cancelled_;
};

struct Surface {
  Image<Rgb> picture;
  std::string origin;
};

/// @throws Error where paint covers all of it.
[[nodiscard]] Surface bareSurface(const FilmMaskOptions& options, const FilmMaskFiles& files,
                                  const FilmReader& film) {
  Surface surface;
  if (options.barePath) {
    surface = {readColor(*options.barePath, files.size), *options.barePath};
  } else {
    std::vector<Image<Rgb>> first;
    const int count = std::min(options.bareFrames, files.film.count());
    first.reserve(at(count));
    for (int i = 0; i < count; ++i) first.push_back(film.frame(i));
    const std::vector<int> numbers(files.film.numbers.begin(), files.film.numbers.begin() + count);
    surface = {medianPicture(first), (count > 1 ? "median of " : "") + frameListText(numbers)};
  }
  if (!options.barePaintPath) return surface;
  const MaskChannel channel =
      hasTransparency(*options.barePaintPath) ? MaskChannel::kAlpha : MaskChannel::kBrightness;
  std::optional<Image<Rgb>> filled =
      withoutPaint(surface.picture, readCoverage(*options.barePaintPath, channel, files.size));
  if (!filled) {
    throw Error(*options.barePaintPath +
                ": leaves no pixel of the surface bare; wanted a mask of the paint only");
  }
  return {std::move(*filled), surface.origin + ", filled in under " + *options.barePaintPath};
}

[[nodiscard]] float chosenThreshold(const FilmMaskOptions& options, int frameCount,
                                    const FilmReader& film, const Image<Lab>& bare) {
  if (options.threshold) return *options.threshold;
  DifferenceHistogram histogram;
  for (int i = 0; i < frameCount; ++i) {
    const Image<Lab> frame = toLab(film.frame(i));
    histogram.add(filmDifference(frame, bare, options.grainSigmaPx),
                  grainLevel(frame, bare, options.grainSigmaPx));
  }
  return histogram.automaticThreshold();
}

[[nodiscard]] Mask maskAbove(const Image<float>& difference, float threshold) {
  Mask mask(difference.size());
  std::transform(difference.begin(), difference.end(), mask.begin(), [threshold](float d) {
    return static_cast<std::uint8_t>(d >= threshold ? 1 : 0);
  });
  return mask;
}

[[nodiscard]] Image<float> hardCoverage(const Mask& mask) {
  Image<float> coverage(mask.size());
  std::transform(mask.begin(), mask.end(), coverage.begin(),
                 [](std::uint8_t m) { return m != 0 ? 1.0F : 0.0F; });
  return coverage;
}

void writeMask(const std::string& path, const Image<float>& coverage) {
  Image<std::uint8_t> bytes(coverage.size());
  std::transform(coverage.begin(), coverage.end(), bytes.begin(), toByte);
  writeGrayPng(path, bytes);
}

[[nodiscard]] bool touchesBorder(const Mask& mask) {
  for (int y = 0; y < mask.height(); ++y) {
    const bool wholeRow = y == 0 || y == mask.height() - 1;
    const int step = wholeRow ? 1 : std::max(1, mask.width() - 1);
    for (int x = 0; x < mask.width(); x += step) {
      if (mask(x, y) != 0) return true;
    }
  }
  return false;
}

/// Pixels of parts or holes that are small enough to be dirt.
[[nodiscard]] int smallest(std::optional<int> given, Size size) {
  if (given) return *given;
  return static_cast<int>(std::lround(kSmallestShare * size.width * size.height));
}

}  // namespace

FilmMaskOptions::FilmMaskOptions() { film.frames = static_cast<int>(ranges::kFrameCounts.high); }

FilmMasks maskFilm(const FilmMaskOptions& options, const std::function<bool()>& cancelled) {
  const FilmMaskFiles files = openFilm(options);
  const ThreadCount threads(options.threads);
  createFolders(options);
  FilmReader film(files, cancelled);
  const int count = files.film.count();
  const Surface surface = bareSurface(options, files, film);
  const Image<Lab> bare = toLab(surface.picture);

  FilmFindings findings;
  findings.size = files.size;
  findings.threshold = chosenThreshold(options, count, film, bare);
  findings.thresholdOrigin = options.threshold ? "as given" : "chosen by the whole film";
  findings.surface = surface.origin;
  findings.surfaceIsFirstFrame = !options.barePath && !options.barePaintPath;
  findings.smallestHolePx = smallest(options.smallestHolePx, files.size);

  const CameraTracker camera(bare);
  LightMeter light(bare);
  OutlineSheet sheet(count);
  Mask everPainted(files.size);
  for (int i = 0; i < count; ++i) {
    const Image<Rgb> frame = film.frame(i);
    const Image<Lab> colors = toLab(frame);
    const Image<float> difference = filmDifference(colors, bare, options.grainSigmaPx);
    const Mask mask =
        cleanedMask(maskAbove(difference, findings.threshold),
                    smallest(options.smallestPartPx, files.size), findings.smallestHolePx);
    const Image<float> coverage =
        options.soft ? softCoverage(difference, findings.threshold, mask) : hardCoverage(mask);
    FrameFindings seen;
    seen.number = files.film.numbers[at(i)];
    seen.inside = static_cast<std::int64_t>(countInside(mask));
    seen.touchesBorder = touchesBorder(mask);
    seen.offsetPx = camera.offsetOf(colors);
    light.add(colors);
    if (options.mattePath) {
      const Matte matte = multiplyMatte(frame, surface.picture, coverage);
      seen.lighterPixels = matte.lighter;
      writePng(files.mattes[at(i)], matte.picture);
    }
    writeMask(files.masks[at(i)], coverage);
    ++film.masksWritten;
    if (options.sheetPath) sheet.add(i, frame, mask);
    if (!isWhole(seen.inside, files.size)) {
      for (std::size_t p = 0; p < mask.pixelCount(); ++p) everPainted.data()[p] |= mask.data()[p];
    }
    findings.frames.push_back(seen);
  }
  if (options.sheetPath) sheet.write(*options.sheetPath);
  const std::vector<Lab> drifts = light.drift(everPainted);
  for (std::size_t i = 0; i < drifts.size(); ++i) findings.frames[i].lightDrift = drifts[i];
  return {count, findings.threshold, filmReport(findings), filmWarnings(findings, everPainted)};
}

}  // namespace fluidymation
