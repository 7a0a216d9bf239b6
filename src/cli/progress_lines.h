#pragma once

#include <memory>
#include <ostream>

#include "cli/command_line.h"
#include "cli/run_listener.h"
#include "cli/run_place.h"

namespace fluidymation::cli {

/// Tells a program what happens, in whole lines of `format`, each flushed at once; null for
/// ProgressFormat::kHuman, see `Progress`.
///
/// kJson: of each frame written an object with
///   "frame"    its number in the animation, as in file names
///   "index"    its place in the sequence, in the order of painting, from 0
///   "count"    places up to the last frame to be painted
///   "seconds"  since the frame before was written
///   "layer"    its name, only where a shot is painted in layers; composited frames have none
///   "path"     the file; bytes that are not UTF-8 become U+FFFD
/// and before the first one, while the inputs are read, now and then an object with
///   "reading"  "film masks", "film movement", "target masks" or "target movement"
///   "done"     frames of these
///   "count"    of so many
/// in UTF-8 and, like all JSON, without control characters: a name cannot break a line.
///
/// kOpenJobDescription: "openjd_status: ", "openjd_progress: " with the percentage of the frames
/// this run has to paint, and "openjd_fail: "; Open Job Description's wiki, "How Jobs Are Run",
/// Stdout/Stderr Messages. Of several runs each has an equal part of the percentage.
[[nodiscard]] std::unique_ptr<RunListener> progressLines(ProgressFormat format, std::ostream& out,
                                                         const RunPlace& place = {});

}  // namespace fluidymation::cli
