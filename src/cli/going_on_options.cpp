#include <string>

#include "cli/table_builder.h"
#include "fluidymation/checkpoint_share.h"

namespace fluidymation::cli {
namespace {

constexpr const char* kGoingOn = "Stopping and going on";

void setExisting(CommandLine& line, ExistingFrames existing) {
  if (line.options.continuation.existing != ExistingFrames::kOwn) {
    throw UsageError("--overwrite, --skip-existing: wanted one of them at most");
  }
  line.options.continuation.existing = existing;
}

}  // namespace

void addGoingOn(Table& table) {
  table.add(
      {"--resume", kGoingOn, "",
       "go on after the last frame that a stopped run has saved a\nstate of: the same bytes as "
       "without a stop\n(default off)",
       false,
       [](CommandLine& line, const std::string&) { line.options.continuation.resume = true; }});
  table.add(
      {"--restart", kGoingOn, "",
       "discard what a stopped run has left, and begin anew\n(default off)", false,
       [](CommandLine& line, const std::string&) { line.options.continuation.restart = true; }});
  table.add({"--overwrite", kGoingOn, "",
             "replace whatever has the name of a frame\n(default off: only what a run has painted, "
             "and is as it was)",
             false, [](CommandLine& line, const std::string&) {
               setExisting(line, ExistingFrames::kReplace);
             }});
  table.add({"--skip-existing", kGoingOn, "",
             "keep what has the name of a frame and paint the frames that\nare not there, as "
             "--render-frames does\n(default off)",
             false, [](CommandLine& line, const std::string&) {
               setExisting(line, ExistingFrames::kKeep);
             }});
  table.add({"--checkpoint-every", kGoingOn, "N",
             "frames from one saved state to the next\n(default as often as costs " +
                 numberText(100.0 * kCheckpointShare) + " % of the time; in " +
                 ranges::kCheckpointFrames.text() + ")",
             false,
             [](CommandLine& line, const std::string& value) {
               line.options.continuation.checkpointEvery =
                   parseInt("--checkpoint-every", value, ranges::kCheckpointFrames);
             },
             [](const CommandLine& line) -> std::optional<std::string> {
               const auto& every = line.options.continuation.checkpointEvery;
               return every ? std::optional<std::string>(std::to_string(*every)) : std::nullopt;
             }});
  table.add(
      {"--keep-states", kGoingOn, "",
       "keep all saved states, for --render-frames\n(default off: the last one, until all is "
       "painted)",
       false,
       [](CommandLine& line, const std::string&) { line.options.continuation.keepStates = true; },
       [](const CommandLine& line) { return flagText(line.options.continuation.keepStates); }});
  table.add({"--render-frames", kGoingOn, "A-B",
             "paint only these of the animation's frames, guided by all of\nthem; as in a full run "
             "where a state of the frame before A is\nsaved, else afresh\n(default all)",
             false, [](CommandLine& line, const std::string& value) {
               line.options.continuation.render = parseFrameNumbers("--render-frames", value);
             }});
  table.add(
      {"--verify", kGoingOn, "MANIFEST",
       "paint nothing; compare the frames beside a manifest,\nfluidymation.json, with what it "
       "says of them\n(default off)",
       false, [](CommandLine& line, const std::string& value) {
         if (value.empty()) {
           throw UsageError(shown("--verify", value) + ": wanted a manifest's name");
         }
         line.manifest = value;
       }});
}

}  // namespace fluidymation::cli
