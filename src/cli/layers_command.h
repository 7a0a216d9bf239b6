#pragma once

#include <string>
#include <vector>

#include "cli/command_line.h"
#include "cli/streams.h"
#include "fluidymation/layers.h"

namespace fluidymation::cli {

/// A shot as its file and the command line have it.
struct ShotRequest {
  LayeredShot shot;
  std::vector<CommandLine> lines;  ///< of each layer's run
  CommandLine composite;           ///< how to tell of the run that lays them over each other
};

/// The shot of a file.
/// @param told  what the command line says, which prevails over the file.
/// @throws UsageError, Error naming file and line, or the layer.
[[nodiscard]] ShotRequest shotOf(const std::string& path, const CommandLine& told);

/// `fluidymation layers`: paints every layer of a shot by a run of its own, then lays their frames
/// over each other. @throws UsageError, Error, Interrupted.
ExitCode layersCommand(int argc, const char* const* argv, const Streams& streams,
                       const StopSignal& stopSignal);

}  // namespace fluidymation::cli
