#include "bench/report.h"

#include <algorithm>
#include <iomanip>
#include <iterator>
#include <ostream>
#include <sstream>

#include "fluidymation/core/text.h"

namespace fluidymation::bench {
namespace {

constexpr double kMillisecondsPerSecond = 1e3;
constexpr double kMicrosecondsPerSecond = 1e6;

using Row = std::vector<std::string>;

std::string fixed(double value, int digits) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(digits) << value;
  return text.str();
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t middle = values.size() / 2;
  return values.size() % 2 == 1 ? values[middle] : (values[middle - 1] + values[middle]) / 2.0;
}

template <typename Value>
std::vector<double> each(const std::vector<Cost>& costs, const Value& value) {
  std::vector<double> values;
  for (const Cost& cost : costs) values.push_back(value(cost));
  return values;
}

/// Whether it is a search that compared anything.
bool counted(const std::vector<Cost>& costs) {
  return std::all_of(costs.begin(), costs.end(),
                     [](const Cost& cost) { return cost.distances > 0.0; });
}

/// Median, least and most of a repetition.
Row spread(std::vector<double> values, int digits) {
  std::sort(values.begin(), values.end());
  return {fixed(median(values), digits), fixed(values.front(), digits),
          fixed(values.back(), digits)};
}

Row rowOf(const std::string& caseName, const StageOfLevel& stage, const std::vector<Cost>& costs,
          double maskPixels) {
  Row row = {caseName, nameOf(stage.stage),
             stage.level == kNoLevel ? "all" : std::to_string(stage.level)};
  const auto append = [&row](const Row& more) { row.insert(row.end(), more.begin(), more.end()); };
  const auto milliseconds = [](const Cost& c) { return c.wallSeconds * kMillisecondsPerSecond; };
  const auto microsecondsPerPixel = [&](const Cost& c) {
    return c.cpuSeconds * kMicrosecondsPerSecond / maskPixels;
  };
  append(spread(each(costs, milliseconds), 2));
  append(spread(each(costs, microsecondsPerPixel), 3));
  if (!counted(costs)) {
    append({"-", "-", "-"});
    return row;
  }
  // Counts are the same in all repetitions, times are not.
  const Cost& any = costs.front();
  const auto perSecond = [](const Cost& c) { return c.distances / c.cpuSeconds; };
  append({fixed(median(each(costs, perSecond)), 0), fixed(any.samples / any.distances, 2),
          fixed(any.distances / maskPixels, 2)});
  return row;
}

void printTsv(std::ostream& out, const std::vector<Row>& rows) {
  for (const Row& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) out << (i == 0 ? "" : "\t") << row[i];
    out << '\n';
  }
}

void printTable(std::ostream& out, const std::vector<Row>& rows) {
  constexpr std::size_t kNameColumns = 2;  // to the left; numbers to the right
  std::vector<std::size_t> widths(rows.front().size());
  for (const Row& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  }
  for (const Row& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      out << (i == 0 ? "" : "  ") << (i < kNameColumns ? std::left : std::right)
          << std::setw(static_cast<int>(widths[i])) << row[i];
    }
    out << '\n';
  }
}

}  // namespace

Facts factsOfCase(const BenchmarkCase& benchmarkCase, const LoadedCase& loaded,
                  const Measurement& measurement) {
  const Exemplar& exemplar = loaded.exemplar;
  return {{"case", benchmarkCase.name},
          {"exemplar", benchmarkCase.exemplar + ", " + sizeText(exemplar.level(0).size()) + "x" +
                           std::to_string(exemplar.frameCount())},
          {"target", benchmarkCase.target + ", " + sizeText(loaded.targetSize) + ", " +
                         fixed(measurement.maskPixels, 0) + " px inside, mean of frames 2 to " +
                         std::to_string(loaded.targetFiles.size())},
          {"paper's table 2", benchmarkCase.paperRow + ", " +
                                  std::to_string(benchmarkCase.paperMaskPixels) + " px inside, " +
                                  fixed(benchmarkCase.paperSeconds, 2) + " s a frame"}};
}

void printFacts(std::ostream& out, const Facts& facts, Format format) {
  constexpr int kNameWidth = 17;
  for (const auto& [name, value] : facts) {
    if (format == Format::kTsv) {
      out << "# " << name << '\t' << value << '\n';
    } else {
      out << std::left << std::setw(kNameWidth) << name << value << '\n';
    }
  }
}

void printCosts(std::ostream& out, const std::string& caseName, const Measurement& measurement,
                std::optional<TimedStage> only, Format format) {
  const char* const columns =
      "case stage level median_ms min_ms max_ms us_cores_per_px min_us max_us "
      "distances_per_cpu_s samples_per_distance distances_per_px";
  std::istringstream names(columns);
  std::vector<Row> rows = {Row(std::istream_iterator<std::string>(names), {})};
  for (const auto& [stage, costs] : measurement.costs) {
    if (only && stage.stage != *only) continue;
    rows.push_back(rowOf(caseName, stage, costs, measurement.maskPixels));
  }
  format == Format::kTsv ? printTsv(out, rows) : printTable(out, rows);
}

}  // namespace fluidymation::bench
