#include <optional>
#include <string>
#include <utility>

#include "cli/table_builder.h"

namespace fluidymation::cli {
namespace {

constexpr const char* kSequences = "Sequences";

using Sequence = SequenceOptions& (*)(CommandLine&);

/// "--src-range 10-80x2": what start, frames and speed say otherwise, and no frame less.
void addRange(Table& table, const char* name, const char* what, Sequence sequenceOf) {
  const std::string option = name;
  Spec spec{option,
            kSequences,
            "A-BxS",
            std::string(what) + "\n(default off; not in the thesis)",
            false,
            [option, sequenceOf](CommandLine& line, const std::string& value) {
              const FrameRange range = parseFrameRange(option, value);
              SequenceOptions& sequence = sequenceOf(line);
              sequence.start = range.first;
              sequence.frames = range.frames;
              sequence.speed = range.step;
              sequence.complete = true;
            }};
  spec.text = [sequenceOf](const CommandLine& line) -> std::optional<std::string> {
    CommandLine copy = line;
    const SequenceOptions& sequence = sequenceOf(copy);
    if (!sequence.complete) return std::nullopt;
    return frameRangeText({sequence.start, sequence.frames, sequence.speed});
  };
  table.add(std::move(spec));
}

[[nodiscard]] SequenceOptions& source(CommandLine& line) { return line.options.source; }
[[nodiscard]] SequenceOptions& target(CommandLine& line) { return line.options.target; }

[[nodiscard]] bool sourceHasNoRange(const CommandLine& line) {
  return !line.options.source.complete;
}
[[nodiscard]] bool targetHasNoRange(const CommandLine& line) {
  return !line.options.target.complete;
}

}  // namespace

void addSequences(Table& table) {
  addRange(table, "--src-range",
           "frames A to B of the exemplar, every S-th, e.g. 10-80x2, all\nof which must be there; "
           "80-10 is backwards; instead of start,\nframes and speed",
           source);
  table.integer("--src-start", kSequences, "number of the exemplar's first frame", "",
                ranges::kFrameNumbers, "thesis §4.5",
                [](CommandLine& c) -> int& { return source(c).start; });
  table.writtenOnlyWhere(sourceHasNoRange);
  table.integer("--src-frames", kSequences, "frames of the exemplar, at most", "frames",
                ranges::kFrameCounts, "thesis §4.5",
                [](CommandLine& c) -> int& { return source(c).frames; });
  table.writtenOnlyWhere(sourceHasNoRange);
  table.integer(
      "--src-speed", kSequences, "from number to number; negative plays backwards", "",
      ranges::kSpeeds, "thesis §4.5", [](CommandLine& c) -> int& { return source(c).speed; },
      false);
  table.writtenOnlyWhere(sourceHasNoRange);
  table.real("--src-scale", kSequences, "scaling of the exemplar and its masks", "",
             ranges::kScales, "thesis §4.5",
             [](CommandLine& c) -> double& { return source(c).scale; });
  table.integer("--src-window", kSequences,
                "frames of the exemplar in memory at a time, moving on in it\nwith the animation; "
                "for films that do not fit; 0 is all",
                "frames", ranges::kWindowFrameCounts, "paper §5",
                [](CommandLine& c) -> int& { return c.options.sourceWindowFrames; });
  addRange(table, "--target-range", "the same for the animation", target);
  table.integer("--target-start", kSequences, "number of the animation's first frame", "",
                ranges::kFrameNumbers, "thesis §4.5",
                [](CommandLine& c) -> int& { return target(c).start; });
  table.writtenOnlyWhere(targetHasNoRange);
  table.integer("--target-frames", kSequences, "frames to paint, at most", "frames",
                ranges::kFrameCounts, "thesis §4.5",
                [](CommandLine& c) -> int& { return target(c).frames; });
  table.writtenOnlyWhere(targetHasNoRange);
  table.integer(
      "--target-speed", kSequences, "from number to number; negative plays backwards", "",
      ranges::kSpeeds, "thesis §4.5", [](CommandLine& c) -> int& { return target(c).speed; },
      false);
  table.writtenOnlyWhere(targetHasNoRange);
  table.real("--target-scale", kSequences, "scaling of the animation", "", ranges::kScales,
             "thesis §4.5", [](CommandLine& c) -> double& { return target(c).scale; });
}

}  // namespace fluidymation::cli
