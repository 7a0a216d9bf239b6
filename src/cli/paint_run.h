#pragma once

#include <functional>

#include "cli/command_line.h"
#include "cli/run_place.h"
#include "cli/streams.h"
#include "fluidymation/pipeline.h"

namespace fluidymation::cli {

/// The engine behind the tool: `stylize`, or a test's stand-in.
using Engine = std::function<void(const Options&, const Observer&)>;

/// Runs the engine and tells of it as `line` wants: progress, notes, preview.
/// @param place  of the run, where it is one of several.
/// @throws what the engine throws; Error where the preview cannot be written.
void paintRun(const CommandLine& line, const RunPlace& place, const Streams& streams,
              const Engine& engine, const StopSignal& stopSignal);

}  // namespace fluidymation::cli
