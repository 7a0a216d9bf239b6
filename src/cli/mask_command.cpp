#include "cli/mask_command.h"

#include <algorithm>
#include <functional>
#include <iterator>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/command_line.h"
#include "cli/command_syntax.h"
#include "cli/option_table.h"
#include "cli/values.h"
#include "fluidymation/core/error.h"
#include "fluidymation/film_masks.h"

namespace fluidymation::cli {
namespace {

constexpr const char* kFiles = "Inputs and outputs";
constexpr const char* kMasks = "Masks";
constexpr const char* kMatte = "Matte";

/// What the command's own options set.
struct MaskRequest {
  FilmMaskOptions options;
  bool wantsMatte = false;
  bool framesAreGiven = false;
};

[[nodiscard]] Spec valueSpec(
    const char* name, const char* group, const char* valueName, const std::string& help,
    std::function<void(const std::string& option, const std::string&)> set) {
  const std::string option = name;
  return {option,
          group,
          valueName,
          help,
          false,
          [option, set = std::move(set)](CommandLine&, const std::string& value) {
            if (value.empty()) throw UsageError(shown(option, value) + ": wanted a value");
            set(option, value);
          }};
}

/// The painter's options for its film, which also know folders; all frames where no number is
/// given.
[[nodiscard]] std::vector<Spec> fileSpecs(MaskRequest& request) {
  std::vector<Spec> specs;
  for (Spec& spec : optionTable()) {
    if (spec.name == "--src-path") {
      spec.help = "frames of the film, PNG: pattern or folder\n(required)";
    } else if (spec.name == "--out-path") {
      spec.help = "masks to write, PNG, numbered as --src-path\n(required)";
    } else if (spec.name == "--src-frames") {
      spec.help = "frames, at most\n(default all; in " + ranges::kFrameCounts.text() + ")";
      spec.apply = [&request, set = spec.apply](CommandLine& line, const std::string& value) {
        set(line, value);
        request.framesAreGiven = true;
      };
    } else if (spec.name != "--src-range" && spec.name != "--src-start") {
      continue;
    }
    spec.group = kFiles;
    specs.push_back(std::move(spec));
  }
  specs.push_back(
      {"--overwrite", kFiles, "", "replace masks and mattes that are there already\n(default off)",
       false, [&request](CommandLine&, const std::string&) { request.options.overwrite = true; }});
  specs.push_back(valueSpec("--sheet", kFiles, "FILE",
                            "PNG with the masks' outlines over some frames, to check\n"
                            "(default off)",
                            [&request](const std::string&, const std::string& value) {
                              request.options.sheetPath = value;
                            }));
  return specs;
}

[[nodiscard]] std::vector<Spec> surfaceSpecs(FilmMaskOptions& options) {
  std::vector<Spec> specs;
  specs.push_back(valueSpec(
      "--bare", kMasks, "FILE",
      "picture of the surface without paint, from the same place\n"
      "(default the film's first frames)",
      [&options](const std::string&, const std::string& value) { options.barePath = value; }));
  specs.push_back(valueSpec("--bare-frames", kMasks, "N",
                            "first frames without paint, whose median is the surface;\nmore have "
                            "less grain\n(default 1; in " +
                                ranges::kBareFrames.text() + ")",
                            [&options](const std::string& option, const std::string& value) {
                              options.bareFrames = parseInt(option, value, ranges::kBareFrames);
                            }));
  specs.push_back(valueSpec(
      "--bare-paint", kMasks, "FILE",
      "mask of paint that lies on the bare surface already, where\n"
      "it is filled in from around\n(default off)",
      [&options](const std::string&, const std::string& value) { options.barePaintPath = value; }));
  return specs;
}

[[nodiscard]] std::vector<Spec> maskSpecs(FilmMaskOptions& options) {
  std::vector<Spec> specs;
  specs.push_back(valueSpec(
      "--threshold", kMasks, "auto|X",
      "difference in CIELAB from which on a pixel is paint; lower\nfinds paler paint\n(default "
      "auto: Otsu's, of the whole film; in " +
          ranges::kDifferences.text() + ")",
      [&options](const std::string& option, const std::string& value) {
        options.threshold.reset();
        if (value == "auto") return;
        options.threshold = parseFloat(option, value, ranges::kDifferences);
      }));
  specs.push_back(valueSpec("--grain-sigma", kMasks, "X",
                            "what differs is averaged so far; more for grainy film\n(default " +
                                numberText(options.grainSigmaPx) + " px; in " +
                                ranges::kSigmasPx.text() + ")",
                            [&options](const std::string& option, const std::string& value) {
                              options.grainSigmaPx = parseFloat(option, value, ranges::kSigmasPx);
                            }));
  const std::string share = "\n(default " + numberText(kSmallestShare) + " of the picture; in " +
                            ranges::kPartSizesPx.text() + ")";
  specs.push_back(
      valueSpec("--smallest-part", kMasks, "N", "parts of fewer pixels are specks" + share,
                [&options](const std::string& option, const std::string& value) {
                  options.smallestPartPx = parseInt(option, value, ranges::kPartSizesPx);
                }));
  specs.push_back(
      valueSpec("--smallest-hole", kMasks, "N", "holes of fewer pixels are filled" + share,
                [&options](const std::string& option, const std::string& value) {
                  options.smallestHolePx = parseInt(option, value, ranges::kPartSizesPx);
                }));
  specs.push_back({"--soft", kMasks, "", "anti-aliased masks\n(default black and white)", false,
                   [&options](CommandLine&, const std::string&) { options.soft = true; }});
  return specs;
}

[[nodiscard]] std::vector<Spec> matteSpecs(MaskRequest& request) {
  std::vector<Spec> specs;
  specs.push_back(valueSpec("--matte", kMatte, "multiply",
                            "also write the paint without its surface, to be multiplied\n"
                            "over another one\n(default off)",
                            [&request](const std::string& option, const std::string& value) {
                              if (value != "multiply") {
                                throw UsageError(shown(option, value) + ": wanted multiply");
                              }
                              request.wantsMatte = true;
                            }));
  specs.push_back(valueSpec("--matte-path", kMatte, "PATTERN",
                            "where to: RGBA, straight alpha, numbered as --src-path\n(required "
                            "with --matte)",
                            [&request](const std::string& option, const std::string& value) {
                              checkOutputPattern(option, value);
                              request.options.mattePath = value;
                            }));
  return specs;
}

[[nodiscard]] CommandSyntax maskSyntax(MaskRequest& request) {
  std::vector<Spec> table = fileSpecs(request);
  const auto append = [&table](std::vector<Spec> specs) {
    std::move(specs.begin(), specs.end(), std::back_inserter(table));
  };
  append(surfaceSpecs(request.options));
  append(maskSpecs(request.options));
  append(matteSpecs(request));
  for (Spec& spec : optionTable()) {
    if (spec.name == "--threads" || spec.name == "--quiet") table.push_back(std::move(spec));
  }
  return {"fluidymation mask",
          "Makes the masks of an exemplar from its film: paint is where the colours differ from\n"
          "the bare surface's. Says what is wrong with the film, and what to do.\n",
          std::move(table)};
}

}  // namespace

ExitCode maskCommand(int argc, const char* const* argv, const Streams& streams,
                     const StopSignal& stopSignal) {
  MaskRequest request;
  const CommandLine line = parseCommandLine(maskSyntax(request), argc, argv);
  if (line.information) {
    streams.out << *line.information;
    requireWritten(streams);
    return kDone;
  }
  if (request.wantsMatte != request.options.mattePath.has_value()) {
    throw UsageError("--matte, --matte-path: wanted both or neither");
  }
  const int allFrames = request.options.film.frames;
  request.options.film = line.options.source;
  if (!request.framesAreGiven && !line.options.source.complete) {
    request.options.film.frames = allFrames;
  }
  request.options.maskPath = line.options.outPath;
  request.options.threads = line.options.threads;
  const FilmMasks masks =
      maskFilm(request.options, [&] { return stopSignal && stopSignal() != 0; });
  if (line.quiet) return kDone;
  for (const std::string& warning : masks.warnings) {
    streams.err << "fluidymation: warning: " + oneLine(warning) + "\n";
  }
  streams.err << std::flush;
  for (const std::string& text : masks.report) streams.out << oneLine(text) + "\n";
  requireWritten(streams);
  return kDone;
}

}  // namespace fluidymation::cli
