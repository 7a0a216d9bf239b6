#include "cli/tool.h"

#include <exception>
#include <new>
#include <stdexcept>
#include <string>

#include "cli/command_line.h"
#include "cli/progress.h"
#include "cli/values.h"
#include "fluidymation/core/error.h"

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

void paint(const CommandLine& line, const Streams& streams, const Engine& engine,
           const StopSignal& stopSignal) {
  Progress::Style style =
      streams.errIsTerminal ? Progress::Style::kTerminal : Progress::Style::kPlain;
  if (line.quiet) style = Progress::Style::kQuiet;
  Progress progress(streams.err, style);
  const Observer observer{[&](const std::string& text) { progress.note(text); },
                          [&](const FrameReport& report) { progress.frameDone(report); },
                          [&] { return stopSignal && stopSignal() != 0; },
                          [&](int frameCount) { progress.paintingBegins(frameCount); }};
  try {
    progress.readingBegins();
    engine(line.options, observer);
  } catch (...) {
    progress.finishLine();
    throw;
  }
  progress.allDone();
}

[[nodiscard]] ExitCode parseAndPaint(int argc, const char* const* argv, const Streams& streams,
                                     const Engine& engine, const StopSignal& stopSignal) {
  const CommandLine line = parseCommandLine(argc, argv);
  if (!line.information) {
    paint(line, streams, engine, stopSignal);
    return kDone;
  }
  streams.out << *line.information << std::flush;
  if (streams.out.good()) return kDone;
  throw Error("standard output cannot be written");
}

}  // namespace

int runTool(int argc, const char* const* argv, const Streams& streams, const Engine& engine,
            const StopSignal& stopSignal) noexcept {
  try {
    return parseAndPaint(argc, argv, streams, engine, stopSignal);
  } catch (const Interrupted& stop) {
    streams.err << "fluidymation: " + oneLine(stop.what()) + "\n" << std::flush;
    return kStoppedBySignal + (stopSignal ? stopSignal() : 0);
  } catch (const UsageError& error) {
    printError(streams, error.what());
    return kWrongUsage;
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
