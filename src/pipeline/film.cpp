#include "pipeline/film.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>

#include "fluidymation/core/color.h"
#include "fluidymation/core/error.h"
#include "fluidymation/core/index.h"
#include "fluidymation/option_ranges.h"
#include "fluidymation/synthesis/film_extents.h"
#include "fluidymation/synthesis/pyramid.h"
#include "pipeline/flow_note.h"
#include "pipeline/guide_dump.h"
#include "pipeline/outputs.h"

namespace fluidymation {
namespace {

/// The most frames without material in a row.
int longestGap(const GuideStream& guides) {
  int longest = 0;
  int gap = 0;
  for (int k = 0; k < guides.frameCount(); ++k) {
    gap = guides.isEmpty(k) ? gap + 1 : 0;
    longest = std::max(longest, gap);
  }
  return longest;
}

}  // namespace

Film::Film(const Options& options, const Inputs& inputs, const FilmWindow& window, int begin,
           const Stopping& stopping)
    : options_(options),
      inputs_(inputs),
      stopping_(stopping),
      isWhole_(window.isWhole()),
      exemplar_(inputs.color.scaled, window.heldFrames(),
                coarsestLevel(inputs.color.scaled, inputs.target.scaled), *options.borderWidthPx,
                options.synthesis.shape) {
  exemplar_.advance(begin);
}

bool Film::holds(int frame) const {
  return frame >= exemplar_.firstFrame() && frame < exemplar_.firstFrame() + exemplar_.frameCount();
}

void Film::readPictures() {
  for (int k = 0; k < inputs_.color.files.count(); ++k) {
    stopping_.check();
    const Image<Rgb> picture = readPicture(inputs_.color, k);
    if (holds(k)) exemplar_.setColor(k - exemplar_.firstFrame(), toLab(picture));
  }
}

GuideFrame Film::nextGuides() {
  stopping_.check();
  GuideFrame frame = guides_->next();
  if (withAges_) frame.age = ages_.next(frame.mask);
  return frame;
}

void Film::readGuides(GuideStream& guides, bool withAges, const Observer& observer) {
  guides_ = &guides;
  withAges_ = withAges;
  FilmExtents extents;
  for (int k = 0; k < guides.frameCount(); ++k) {
    const GuideFrame frame = nextGuides();
    const int number = inputs_.color.files.numbers[at(k)];
    const std::optional<std::string> note =
        flowNote("--src-mask-path " + options_.sourceMaskPath, number, frame.diffusion);
    if (note && observer.note) observer.note(*note);
    if (isWhole_) {
      exemplar_.setGuides(k, frame);
    } else {
      extents.add(frame);
    }
    if (options_.dumpGuidesDirectory) dumpGuides(dumpFolder(options_, "source"), number, frame);
  }
  if (!isWhole_) {
    exemplar_.setExtentScale(extents.scale(options_.synthesis.extentUnit));
    guides.rewind();
    ages_ = {};
    guidesGiven_ = 0;
    fillGuides(exemplar_.firstFrame());
  }
  exemplar_.finish(options_.synthesis.extentUnit);
}

void Film::fillGuides(int from) {
  for (; guidesGiven_ < exemplar_.firstFrame() + exemplar_.frameCount(); ++guidesGiven_) {
    const GuideFrame frame = nextGuides();
    if (guidesGiven_ >= from) exemplar_.setGuides(guidesGiven_ - exemplar_.firstFrame(), frame);
  }
}

void Film::advanceTo(int begin) {
  if (begin <= exemplar_.firstFrame()) return;
  const int heldSoFar = exemplar_.firstFrame() + exemplar_.frameCount();
  exemplar_.advance(begin - exemplar_.firstFrame());
  const int from = std::max(begin, heldSoFar);
  for (int k = from; k < begin + exemplar_.frameCount(); ++k) {
    stopping_.check();
    exemplar_.setColor(k - begin, toLab(readPicture(inputs_.color, k)));
  }
  fillGuides(from);
  exemplar_.finish(options_.synthesis.extentUnit);
}

void requireMaterial(const Options& options, const FilmWindow& window, const GuideStream& guides) {
  if (!guides.anyInside()) {
    throw Error("--src-mask-path " + options.sourceMaskPath + ": all " +
                std::to_string(guides.frameCount()) +
                " masks are empty after smoothing with --blur-sigma " +
                numberText(*options.blurSigmaPx) +
                ", given, found or set by --preset; wanted some material, so check the masks or "
                "lower --blur-sigma");
  }
  const int gap = longestGap(guides);
  if (gap < window.heldFrames()) return;
  throw UsageError("--src-window " + std::to_string(window.heldFrames()) + ": " +
                   std::to_string(gap) + " masks in a row of --src-mask-path " +
                   options.sourceMaskPath +
                   " are empty after smoothing, and a window without material paints nothing; "
                   "wanted at least " +
                   std::to_string(gap + 1) + ", or --src-range without these frames");
}

}  // namespace fluidymation
