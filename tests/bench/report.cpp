#include "bench/report.h"

#include <algorithm>
#include <iomanip>
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

bool counted(const std::vector<Cost>& costs) {
  return std::all_of(costs.begin(), costs.end(),
                     [](const Cost& cost) { return cost.counts && cost.counts->distances > 0; });
}

Row headerOf(bool withCounts) {
  Row header = {"case", "stage", "level", "median_ms", "min_ms", "max_ms", "us_cores_per_px"};
  if (withCounts) {
    header.insert(header.end(), {"distances_per_s", "samples_per_distance"});
  }
  return header;
}

Row rowOf(const std::string& caseName, const StageOfLevel& stage, const std::vector<Cost>& costs,
          double maskPixels, bool withCounts) {
  const std::vector<double> milliseconds =
      each(costs, [](const Cost& c) { return c.wallSeconds * kMillisecondsPerSecond; });
  const auto [least, most] = std::minmax_element(milliseconds.begin(), milliseconds.end());
  const double cpuSeconds = median(each(costs, [](const Cost& c) { return c.cpuSeconds; }));
  Row row = {caseName,
             nameOf(stage.stage),
             stage.level == kNoLevel ? "all" : std::to_string(stage.level),
             fixed(median(milliseconds), 2),
             fixed(*least, 2),
             fixed(*most, 2),
             fixed(cpuSeconds * kMicrosecondsPerSecond / maskPixels, 3)};
  if (withCounts && counted(costs)) {
    const auto perSecond = [](const Cost& c) {
      return static_cast<double>(c.counts->distances) / c.wallSeconds;
    };
    const auto samples = [](const Cost& c) {
      return static_cast<double>(c.counts->samples) / static_cast<double>(c.counts->distances);
    };
    row.push_back(fixed(median(each(costs, perSecond)), 0));
    row.push_back(fixed(median(each(costs, samples)), 2));
  } else if (withCounts) {
    row.insert(row.end(), 2, "-");
  }
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
          {"target", benchmarkCase.target + ", " +
                         sizeText(loaded.targetMasks.front().coverage.size()) + ", " +
                         fixed(measurement.maskPixels, 0) + " px inside, mean of frames 2 to " +
                         std::to_string(loaded.targetMasks.size())},
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
                std::optional<Stage> only, Format format) {
  const bool withCounts = std::any_of(measurement.costs.begin(), measurement.costs.end(),
                                      [](const auto& entry) { return counted(entry.second); });
  std::vector<Row> rows = {headerOf(withCounts)};
  for (const auto& [stage, costs] : measurement.costs) {
    if (only && stage.stage != *only) continue;
    rows.push_back(rowOf(caseName, stage, costs, measurement.maskPixels, withCounts));
  }
  format == Format::kTsv ? printTsv(out, rows) : printTable(out, rows);
}

}  // namespace fluidymation::bench
