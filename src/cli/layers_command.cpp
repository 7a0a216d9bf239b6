#include "cli/layers_command.h"

#include <cstddef>
#include <filesystem>
#include <set>
#include <utility>

#include "cli/apply_options.h"
#include "cli/command_syntax.h"
#include "cli/input_folders.h"
#include "cli/layered_config.h"
#include "cli/paint_run.h"
#include "cli/values.h"
#include "fluidymation/core/error.h"
#include "fluidymation/io/frame_pattern.h"

namespace fluidymation::cli {
namespace {

/// Options of the command itself; all others stand in the file.
[[nodiscard]] CommandSyntax layersSyntax() {
  const std::set<std::string> ofCommand = {"--resume",     "--restart",  "--overwrite", "--threads",
                                           "--max-memory", "--progress", "--quiet"};
  std::vector<Spec> table;
  for (Spec& spec : optionTable()) {
    if (ofCommand.count(spec.name) > 0) table.push_back(std::move(spec));
  }
  return {"fluidymation layers",
          "Paints a shot in layers, each with its own masks, exemplar and options, and lays them\n"
          "over each other. SHOT.toml holds lines as --config reads them: first out-path, for the\n"
          "composited frames, background (a colour, a PNG file, exemplar: the bare surface of the\n"
          "lowest layer's film, or exemplar:NAME), and what all layers share; then [layer.NAME]\n"
          "before the options of each layer, the lowest first. Each is painted into a folder\n"
          "layers/NAME beside the composited frames, as a run of its own.\n",
          std::move(table), "SHOT.toml"};
}

/// Instead of those of `ContinuationOptions`, which layers lack.
constexpr const char* kWaysOut =
    "--overwrite to replace, or another out-path above the first layer";

/// What the command line says about every run.
void applyCommandLine(const CommandLine& told, CommandLine& line) {
  const ContinuationOptions& continuation = told.options.continuation;
  line.options.continuation.resume = continuation.resume;
  line.options.continuation.restart = continuation.restart;
  line.options.continuation.existing = continuation.existing;
  line.options.continuation.waysOut = kWaysOut;
  if (told.threadsAreGiven) line.options.threads = told.options.threads;
  if (told.options.maxMemoryBytes) line.options.maxMemoryBytes = told.options.maxMemoryBytes;
  if (told.progressIsGiven) line.progress = told.progress;
  line.quiet = line.quiet || told.quiet;
}

/// Threads are the machine's unless the file says more.
[[nodiscard]] CommandLine beginning(const CommandLine& told) {
  CommandLine line;
  line.options.threads = told.options.threads;
  return line;
}

/// "shot/layers/horse/%05d.png" for "shot/%05d.png".
[[nodiscard]] std::string layerPath(const std::string& outPath, const std::string& name) {
  const std::filesystem::path frames(outPath);
  return (frames.parent_path() / "layers" / name / frames.filename()).string();
}

/// One layer's run.
[[nodiscard]] CommandLine lineOf(const LayeredConfig& config, const LayeredConfig::Section& layer,
                                 const std::vector<Spec>& table, const CommandLine& told) {
  CommandLine line = beginning(told);
  Names given = applyEntries(config.entries, table, line);
  const Names own = applyEntries(layer.entries, table, line);
  given.insert(own.begin(), own.end());
  applyCommandLine(told, line);
  inLayer(layer.name, [&] {
    requireOptions(table, given);
    resolveFolders(given, line.options);
  });
  return line;
}

/// Where it is stopped, layers before it are finished: then the shot can be gone on with, whatever
/// this layer has saved.
void paintLayer(const ShotRequest& request, std::size_t index, const Streams& streams,
                const StopSignal& stopSignal) {
  const std::vector<Layer>& layers = request.shot.layers;
  const RunPlace place{layers[index].name, false, static_cast<int>(index),
                       static_cast<int>(layers.size()) + 1};
  try {
    inLayer(layers[index].name,
            [&] { paintRun(request.lines[index], place, streams, stylize, stopSignal); });
  } catch (const Interrupted& stop) {
    throw Interrupted(stop.what(), stop.canResume() || index > 0);
  }
}

}  // namespace

ShotRequest shotOf(const std::string& path, const CommandLine& told) {
  const std::vector<Spec> table = optionTable();
  const LayeredConfig config = readLayeredConfig(path, table);
  ShotRequest request;
  request.composite = beginning(told);
  const Names given = applyEntries(config.entries, table, request.composite);
  if (given.count("--out-path") == 0) {
    throw UsageError(path + ": out-path: required, but not given above the first layer");
  }
  applyCommandLine(told, request.composite);
  LayeredShot& shot = request.shot;
  shot.background = config.background;
  shot.continuation = request.composite.options.continuation;
  shot.bitDepth = request.composite.options.bitDepth;
  shot.compressionLevel = request.composite.options.compressionLevel;
  for (const LayeredConfig::Section& section : config.layers) {
    CommandLine line = lineOf(config, section, table, told);
    // A folder has become a pattern; all layers have the same one.
    if (shot.outPath.empty()) shot.outPath = line.options.outPath;
    line.options.outPath = layerPath(shot.outPath, section.name);
    shot.layers.push_back({section.name, line.options});
    request.lines.push_back(std::move(line));
  }
  return request;
}

ExitCode layersCommand(int argc, const char* const* argv, const Streams& streams,
                       const StopSignal& stopSignal) {
  const CommandLine told = parseCommandLine(layersSyntax(), argc, argv);
  if (told.information) {
    streams.out << *told.information;
    requireWritten(streams);
    return kDone;
  }
  const ShotRequest request = shotOf(*told.operand, told);
  const auto isCancelled = [&] { return stopSignal && stopSignal() != 0; };
  const auto note = [&](const std::string& text) {
    if (!request.composite.quiet) {
      streams.err << noteLine(text) << std::flush;
    }
  };
  checkLayers(request.shot, {note, {}, isCancelled, {}, {}});
  const std::size_t count = request.shot.layers.size();
  for (std::size_t i = 0; i < count; ++i) paintLayer(request, i, streams, stopSignal);
  const Engine composite = [&](const Options&, const Observer& observer) {
    compositeLayers(request.shot, observer);
  };
  const RunPlace place{"", true, static_cast<int>(count), static_cast<int>(count) + 1};
  paintRun(request.composite, place, streams, composite, stopSignal);
  return kDone;
}

}  // namespace fluidymation::cli
