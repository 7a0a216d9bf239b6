#include "footage/film_findings.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <functional>

#include "fluidymation/core/index.h"
#include "fluidymation/core/text.h"
#include "guides/components.h"
#include "inspect/numbers.h"

namespace fluidymation {
namespace {

constexpr float kShakePx = 1.0F;
/// From this share of the threshold on, a change of light shifts outlines.
constexpr float kDriftShare = 1.0F / 8.0F;
constexpr double kLighterShare = 0.01;  // of the pixels inside

[[nodiscard]] float lengthOf(Lab color) {
  return std::sqrt(color.l * color.l + color.a * color.a + color.b * color.b);
}

[[nodiscard]] double shareOf(std::int64_t pixels, Size size) {
  return static_cast<double>(pixels) / (static_cast<double>(size.width) * size.height);
}

[[nodiscard]] std::vector<int> numbersOf(const std::vector<FrameFindings>& frames,
                                         const std::function<bool(const FrameFindings&)>& isMeant) {
  std::vector<int> numbers;
  for (const FrameFindings& frame : frames) {
    if (isMeant(frame)) numbers.push_back(frame.number);
  }
  return numbers;
}

void addShake(const FilmFindings& film, std::vector<std::string>& warnings) {
  const auto offset = [](const FrameFindings& f) {
    return f.offsetPx ? length(*f.offsetPx) : 0.0F;
  };
  const std::vector<int> shaken =
      numbersOf(film.frames, [&](const FrameFindings& frame) { return offset(frame) > kShakePx; });
  if (shaken.empty()) return;
  const FrameFindings& worst =
      *std::max_element(film.frames.begin(), film.frames.end(),
                        [&](const auto& a, const auto& b) { return offset(a) < offset(b); });
  warnings.push_back("camera: moved by more than 1 px in " + frameListText(shaken) + ", in frame " +
                     std::to_string(worst.number) + " by " + fixedText(worst.offsetPx->x, 1) + "," +
                     fixedText(worst.offsetPx->y, 1) +
                     " px since the bare surface was taken; edges on the surface count as paint "
                     "then: fix the camera, or steady the film first (ffmpeg's vidstabtransform, "
                     "Blender's 2D stabilization)");
}

void addLight(const FilmFindings& film, std::vector<std::string>& warnings) {
  const auto drift = [](const FrameFindings& f) {
    return f.lightDrift ? lengthOf(*f.lightDrift) : 0.0F;
  };
  const std::vector<int> drifted = numbersOf(film.frames, [&](const FrameFindings& frame) {
    return drift(frame) > kDriftShare * film.threshold;
  });
  if (drifted.empty()) return;
  const FrameFindings& worst =
      *std::max_element(film.frames.begin(), film.frames.end(),
                        [&](const auto& a, const auto& b) { return drift(a) < drift(b); });
  warnings.push_back(
      "light: in " + frameListText(drifted) +
      " the unpainted surface has another colour, in frame " + std::to_string(worst.number) +
      " by " + fixedText(drift(worst), 1) + " (lightness " + fixedText(worst.lightDrift->l, 1) +
      ") of the threshold's " + fixedText(film.threshold, 1) +
      "; outlines shift with it: fix exposure and white balance, keep daylight out, or even the "
      "film out first (ffmpeg's deflicker)");
}

void addEmptyAndWhole(const FilmFindings& film, std::vector<std::string>& warnings) {
  const std::vector<FrameFindings>& frames = film.frames;
  const auto isPainted = [](const FrameFindings& frame) { return frame.inside > 0; };
  const auto begin = std::find_if(frames.begin(), frames.end(), isPainted);
  if (begin == frames.end()) {
    warnings.push_back("nothing found: no frame differs from the bare surface by " +
                       fixedText(film.threshold, 1) +
                       " or more in a large enough part; lower --threshold or --smallest-part, or "
                       "check --bare");
    return;
  }
  const std::vector<int> empty = numbersOf(
      {begin, frames.end()}, [&](const FrameFindings& frame) { return !isPainted(frame); });
  if (!empty.empty()) {
    warnings.push_back("nothing found in " + frameListText(empty) +
                       ", though paint was there before; look at them");
  }
  const std::vector<int> whole = numbersOf(
      frames, [&](const FrameFindings& frame) { return isWhole(frame.inside, film.size); });
  if (!whole.empty()) {
    warnings.push_back("all is inside in " + frameListText(whole) +
                       ": the light changed, the camera moved, or no surface is left bare; raise "
                       "--threshold, or leave these frames out (--src-frames)");
  }
  const std::vector<int> touching = numbersOf(frames, [&](const FrameFindings& frame) {
    return frame.touchesBorder && !isWhole(frame.inside, film.size);
  });
  if (!touching.empty()) {
    warnings.push_back("the mask touches the picture's border in " + frameListText(touching) +
                       ": there the paint has no edge to learn from; film wider, or leave these "
                       "frames out (--src-frames)");
  }
}

/// Bare islands that never were painted look like paint that was there from the beginning.
void addIslands(const FilmFindings& film, const Mask& everPainted,
                std::vector<std::string>& warnings) {
  if (!film.surfaceIsFirstFrame) return;
  Mask unpainted(everPainted.size());
  std::transform(everPainted.begin(), everPainted.end(), unpainted.begin(),
                 [](std::uint8_t m) { return static_cast<std::uint8_t>(m == 0 ? 1 : 0); });
  const Components parts = findComponents(unpainted);
  std::vector<std::int64_t> sizes(at(parts.count), 0);
  std::vector<bool> atBorder(at(parts.count), false);
  std::vector<Pixel> places(at(parts.count));
  for (int y = 0; y < unpainted.height(); ++y) {
    for (int x = 0; x < unpainted.width(); ++x) {
      const int label = parts.label(x, y);
      if (label < 0) continue;
      if (++sizes[at(label)] == 1) places[at(label)] = {x, y};
      if (x == 0 || y == 0 || x == unpainted.width() - 1 || y == unpainted.height() - 1) {
        atBorder[at(label)] = true;
      }
    }
  }
  std::int64_t enclosed = 0;
  std::size_t largest = 0;
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    if (atBorder[i] || sizes[i] < film.smallestHolePx) continue;
    if (enclosed == 0 || sizes[i] > sizes[largest]) largest = i;
    enclosed += sizes[i];
  }
  if (enclosed == 0) return;
  warnings.push_back(
      "bare surface: " + std::to_string(enclosed) +
      " px within the paint are never painted, the "
      "largest part of them from " +
      std::to_string(places[largest].x) + "," + std::to_string(places[largest].y) +
      " down; was paint there when the film began? Then give the surface without it (--bare), or "
      "say where it was (--bare-paint)");
}

void addLighter(const FilmFindings& film, std::vector<std::string>& warnings) {
  std::int64_t lighter = 0;
  std::int64_t inside = 0;
  for (const FrameFindings& frame : film.frames) {
    lighter += frame.lighterPixels;
    inside += frame.inside;
  }
  const double share =
      inside == 0 ? 0.0 : static_cast<double>(lighter) / static_cast<double>(inside);
  if (share < kLighterShare) return;
  warnings.push_back("matte: " + percentText(share) +
                     " of the paint is lighter than the bare surface, which multiplying cannot "
                     "give; it is left as light as the surface");
}

}  // namespace

bool isWhole(std::int64_t inside, Size size) { return shareOf(inside, size) >= kWholeShare; }

std::vector<std::string> filmReport(const FilmFindings& film) {
  const std::vector<FrameFindings>& frames = film.frames;
  const auto smaller = [](const auto& a, const auto& b) { return a.inside < b.inside; };
  const auto least = std::min_element(frames.begin(), frames.end(), smaller);
  const auto most = std::max_element(frames.begin(), frames.end(), smaller);
  std::vector<std::string> report = {
      "film: " + sizeText(film.size) + ", " + std::to_string(frames.size()) +
          (frames.size() == 1 ? " frame" : " frames"),
      "bare surface: " + film.surface,
      "threshold: " + fixedText(film.threshold, 1) + ", " + film.thresholdOrigin,
      "inside: " + percentText(shareOf(least->inside, film.size)) + " (frame " +
          std::to_string(least->number) + ") to " + percentText(shareOf(most->inside, film.size)) +
          " (frame " + std::to_string(most->number) + ")"};
  const auto begin = std::find_if(frames.begin(), frames.end(),
                                  [](const FrameFindings& frame) { return frame.inside > 0; });
  if (begin != frames.begin() && begin != frames.end()) {
    report.push_back("paint begins in frame " + std::to_string(begin->number) +
                     ": paint with --src-start " + std::to_string(begin->number));
  }
  return report;
}

std::vector<std::string> filmWarnings(const FilmFindings& film, const Mask& everPainted) {
  std::vector<std::string> warnings;
  addEmptyAndWhole(film, warnings);
  addIslands(film, everPainted, warnings);
  addShake(film, warnings);
  addLight(film, warnings);
  addLighter(film, warnings);
  return warnings;
}

std::string frameListText(const std::vector<int>& numbers) {
  assert(!numbers.empty());
  constexpr std::size_t kMostRuns = 6;
  std::string text = numbers.size() == 1 ? "frame " : "frames ";
  std::size_t runs = 0;
  for (std::size_t begin = 0; begin < numbers.size(); ++runs) {
    if (runs == kMostRuns) return text + " and " + std::to_string(numbers.size() - begin) + " more";
    std::size_t end = begin + 1;
    while (end < numbers.size() && numbers[end] == numbers[end - 1] + 1) ++end;
    text += (runs == 0 ? "" : ", ") + std::to_string(numbers[begin]);
    if (end - begin > 1) text += " to " + std::to_string(numbers[end - 1]);
    begin = end;
  }
  return text;
}

}  // namespace fluidymation
