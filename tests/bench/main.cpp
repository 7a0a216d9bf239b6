#include <omp.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <exception>
#include <iostream>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "bench/benchmark_case.h"
#include "bench/machine.h"
#include "bench/measure.h"
#include "bench/report.h"

namespace {

using namespace fluidymation::bench;

struct Arguments {
  std::vector<std::string> cases;  ///< all where none is given
  std::string stage;               ///< empty: all
  Format format = Format::kTable;
  int threads = 1;
  int repetitions = 5;
  int frames = 6;
  double scale = 1.0;
  std::string samples = FLUIDYMATION_SAMPLES;
};

void addOptions(CLI::App& app, Arguments& arguments) {
  std::vector<std::string> caseNames;
  for (const BenchmarkCase& one : benchmarkCases()) caseNames.push_back(one.name);
  std::vector<std::string> stageNames;
  for (const TimedStage stage : allStages()) stageNames.push_back(nameOf(stage));
  const std::map<std::string, Format> formats = {{"table", Format::kTable}, {"tsv", Format::kTsv}};
  constexpr int kMost = 1000;  // catches slips

  app.add_option("--case", arguments.cases, "Only this case; may be repeated (default: all)")
      ->check(CLI::IsMember(caseNames));
  app.add_option("--stage", arguments.stage, "Only the rows of this stage; all are still run")
      ->check(CLI::IsMember(stageNames));
  app.add_option("--threads", arguments.threads, "Threads of the engine")
      ->check(CLI::Range(1, kMost))
      ->capture_default_str();
  app.add_option("--repetitions", arguments.repetitions, "How often a case is painted")
      ->check(CLI::Range(1, kMost))
      ->capture_default_str();
  app.add_option("--frames", arguments.frames, "Frames of the target; the first is not counted")
      ->check(CLI::Range(2, kMost))
      ->capture_default_str();
  app.add_option("--scale", arguments.scale, "Factor of the case's sizes")
      ->check(CLI::Range(0.1, 8.0))
      ->capture_default_str();
  app.add_option("--samples", arguments.samples, "Folder with source/ and target-mask/")
      ->capture_default_str();
  app.add_option("--format", arguments.format, "table or tsv")
      ->transform(CLI::CheckedTransformer(formats, CLI::ignore_case))
      ->option_text("NAME");
}

bool isWanted(const Arguments& arguments, const BenchmarkCase& one) {
  return arguments.cases.empty() || std::find(arguments.cases.begin(), arguments.cases.end(),
                                              one.name) != arguments.cases.end();
}

std::optional<TimedStage> wantedStage(const Arguments& arguments) {
  for (const TimedStage stage : allStages()) {
    if (nameOf(stage) == arguments.stage) return stage;
  }
  return std::nullopt;
}

void run(const Arguments& arguments) {
  omp_set_num_threads(arguments.threads);
  printFacts(std::cout, factsOfMachine(arguments.threads), arguments.format);
  for (const BenchmarkCase& one : benchmarkCases()) {
    if (!isWanted(arguments, one)) continue;
    const LoadedCase loaded = load(one, arguments.samples, arguments.frames, arguments.scale);
    const Measurement measurement = measure(loaded, arguments.repetitions);
    if (arguments.format == Format::kTable) std::cout << '\n';
    printFacts(std::cout, factsOfCase(one, loaded, measurement), arguments.format);
    printCosts(std::cout, one.name, measurement, wantedStage(arguments), arguments.format);
    std::cout << std::flush;
  }
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Times the stages of a frame, and whole frames, on the bundled samples.");
  Arguments arguments;
  addOptions(app, arguments);
  CLI11_PARSE(app, argc, argv);
  try {
    run(arguments);
  } catch (const std::exception& failure) {
    std::cerr << "fluidymation_bench: error: " << failure.what() << '\n';
    return 1;
  }
  return 0;
}
