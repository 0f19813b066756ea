#include "bench/results.hpp"

#include <benchmark/benchmark.h>
#include <hwy/highway.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>

namespace drape::bench {
namespace {

/// The quantile of sorted values, interpolated linearly. @param fraction of the values below it [-]
double quantile(const std::vector<double>& sorted, double fraction) {
  const double at = fraction * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(at);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (at - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

/// Three digits.
std::string shortNumber(double value) {
  const double size = std::abs(value);
  const int decimals = size >= 99.95 ? 0 : size >= 9.995 ? 1 : size >= 0.9995 ? 2 : 3;
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.*f", decimals, value);
  return text.data();
}

std::string boundText(const Row& row, const Statistics& statistics) {
  if (!row.bound) {
    return "";
  }
  const bool met = row.bound->holds(statistics.minimum) && row.bound->holds(statistics.median);
  return std::string(row.bound->side == Bound::Side::AtMost ? "<= " : ">= ") + shortNumber(row.bound->value) +
         (met ? " met" : " **missed**");
}

std::string processorName() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with("model name")) {
      return line.substr(line.find(':') + 2);
    }
  }
  return "unknown";
}

}  // namespace

Statistics statisticsOf(std::vector<double> values) {
  if (values.empty()) {
    return {};
  }
  std::sort(values.begin(), values.end());
  return {.minimum = values.front(),
          .median = quantile(values, 0.5),
          .low = quantile(values, 0.1),
          .high = quantile(values, 0.9),
          .count = static_cast<int>(values.size())};
}

double unitsPerSecond(std::string_view unit) {
  const std::string_view time = unit.substr(0, unit.find('/'));
  if (time == "s") {
    return 1.0;
  }
  if (time == "ms") {
    return 1e3;
  }
  if (time == "us") {
    return 1e6;
  }
  if (time == "ns") {
    return 1e9;
  }
  throw std::invalid_argument("not a unit of time: " + std::string(unit));
}

void Results::addRatios(const std::vector<Ratio>& ratios) {
  const auto find = [this](const std::string& name) {
    const auto found = std::find_if(lines.begin(), lines.end(),
                                    [&](const Line& line) { return line.row.group + "/" + line.row.name == name; });
    return found == lines.end() ? std::optional<Statistics>() : found->statistics;
  };
  for (const Ratio& ratio : ratios) {
    const auto over = find(ratio.numerator);
    const auto under = find(ratio.denominator);
    if (over && under) {
      lines.push_back({{ratio.group, ratio.name, "ratio", ratio.bound},
                       {.minimum = over->minimum / under->minimum, .median = over->median / under->median}});
    }
  }
}

std::string Results::markdown() const {
  std::ostringstream out;
  out << "| group | what | unit | minimum | median | 10 % to 90 % | target |\n|---|---|---|---|---|---|---|\n";
  for (const auto& [row, statistics] : lines) {
    out << "| " << row.group << " | " << row.name << " | " << row.unit << " | " << shortNumber(statistics.minimum)
        << " | " << shortNumber(statistics.median) << " | ";
    if (statistics.count > 1) {
      out << shortNumber(statistics.low) << " to " << shortNumber(statistics.high);
    }
    out << " | " << boundText(row, statistics) << " |\n";
  }
  return out.str();
}

std::string Results::json() const {
  nlohmann::json rows = nlohmann::json::array();
  for (const auto& [row, statistics] : lines) {
    nlohmann::json line{{"group", row.group},
                        {"name", row.name},
                        {"unit", row.unit},
                        {"minimum", statistics.minimum},
                        {"median", statistics.median}};
    if (statistics.count > 1) {
      line["low"] = statistics.low;
      line["high"] = statistics.high;
      line["repetitions"] = statistics.count;
    }
    if (row.bound) {
      line[row.bound->side == Bound::Side::AtMost ? "at_most" : "at_least"] = row.bound->value;
      line["met"] = row.bound->holds(statistics.minimum) && row.bound->holds(statistics.median);
    }
    rows.push_back(std::move(line));
  }
  const benchmark::CPUInfo& processor = benchmark::CPUInfo::Get();
  const nlohmann::json machine{{"processor", processorName()},
                               {"cores", processor.num_cpus},
                               {"megahertz", processor.cycles_per_second / 1e6},
                               {"instructions", hwy::TargetName(hwy::SupportedTargets() & -hwy::SupportedTargets())},
                               {"load", processor.load_avg}};
  return nlohmann::json{{"machine", machine}, {"results", rows}}.dump(2) + "\n";
}

}  // namespace drape::bench
