#include "cli/tool.h"

#include <exception>
#include <new>
#include <stdexcept>
#include <string>

#include "cli/command_line.h"
#include "cli/painter_syntax.h"
#include "cli/resume_command.h"
#include "cli/subcommand.h"
#include "cli/values.h"
#include "fluidymation/core/error.h"
#include "fluidymation/verify.h"

namespace fluidymation::cli {
namespace {

void printError(const Streams& streams, const std::string& message) {
  streams.err << "fluidymation: error: " + oneLine(message) + "\n" << std::flush;
}

/// Written as it is: there may be no memory left to build a message in.
void printOutOfMemory(const Streams& streams) {
  streams.err << "fluidymation: error: out of memory; smaller frames (--src-scale, "
                 "--target-scale) or fewer (--src-frames) need less\n"
              << std::flush;
}

/// Says in which frames the disk differs from the manifest. @return  kFailed where it does.
[[nodiscard]] ExitCode verifyFrames(const std::string& manifest, const Streams& streams,
                                    const StopSignal& stopSignal) {
  const Verification found = verify(manifest, [&stopSignal] {
    if (stopSignal && stopSignal() != 0)
      throw Interrupted("interrupted; frames are left unchecked");
  });
  for (const std::string& fault : found.faults) streams.out << oneLine(fault) + "\n";
  if (found.faults.empty()) {
    streams.out << oneLine(manifest) + ": " + std::to_string(found.frames) +
                       (found.frames == 1 ? " frame is" : " frames are") + " as painted\n";
  }
  requireWritten(streams);
  return found.faults.empty() ? kDone : kFailed;
}

[[nodiscard]] ExitCode parseAndPaint(int argc, const char* const* argv, const Streams& streams,
                                     const Engine& engine, const StopSignal& stopSignal) {
  if (const Subcommand* const command = chosenSubcommand(argc, argv)) {
    return command->run(argc - 1, argv + 1, streams, stopSignal);
  }
  const CommandLine line = parseCommandLine(painterSyntax(), argc, argv);
  if (line.manifest) return verifyFrames(*line.manifest, streams, stopSignal);
  if (!line.information) {
    paintRun(line, {}, streams, engine, stopSignal);
    return kDone;
  }
  streams.out << *line.information;
  requireWritten(streams);
  return kDone;
}

}  // namespace

int runTool(int argc, const char* const* argv, const Streams& streams, const Engine& engine,
            const StopSignal& stopSignal) noexcept {
  try {
    return parseAndPaint(argc, argv, streams, engine, stopSignal);
  } catch (const Interrupted& stop) {
    streams.err << "fluidymation: " + oneLine(stop.what()) + "\n";
    if (stop.canResume()) {
      streams.err << "fluidymation: go on with: " + oneLine(resumeCommand(argc, argv)) + "\n";
    }
    streams.err << std::flush;
    return kStoppedBySignal + (stopSignal ? stopSignal() : 0);
  } catch (const UsageError& error) {
    printError(streams, error.what());
    return kWrongUsage;
  } catch (const Faults& faults) {
    for (const std::string& line : faults.lines()) printError(streams, line);
  } catch (const Error& error) {
    printError(streams, error.what());
  } catch (const std::bad_alloc&) {
    printOutOfMemory(streams);
  } catch (const std::length_error&) {  // a vector of more than any memory could hold
    printOutOfMemory(streams);
  } catch (const std::exception& error) {
    printError(streams, std::string("internal error: ") + error.what());
  }
  return kFailed;
}

}  // namespace fluidymation::cli
