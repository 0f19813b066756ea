#include "report/comparison.hpp"

#include "messages/error.hpp"
#include "report/number_text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <string_view>
#include <utility>

namespace drape::report {
namespace {

using Json = nlohmann::ordered_json;

/// Keys of the times with repeats. Sections have some of them.
constexpr std::array timed{"us_per_simulated_second", "update_ms", "step_us"};
constexpr std::array exact{"error_mean", "eps_max", "energy_gain"};
constexpr std::array wordKeys{"state"};

/// A row's cell and its index among the rows of the cell.
using Place = std::pair<std::string, int>;

std::map<Place, Json> placed(const Json& rows) {
  std::map<Place, Json> result;
  std::map<std::string, int> counts;
  for (const Json& row : rows) {
    const std::string cell = row.value("cell", "");
    result[{cell, counts[cell]++}] = row;
  }
  return result;
}

/// The time of a row to which its samples belong; null when it has none.
const char* timeOf(const Json& row) {
  const auto found = std::find_if(timed.begin(), timed.end(), [&](const char* key) { return row.contains(key); });
  return found == timed.end() || !row.contains("samples") ? nullptr : *found;
}

std::pair<double, double> rangeOf(const Json& samples) {
  const auto [lowest, highest] = std::minmax_element(samples.begin(), samples.end());
  return {lowest->get<double>(), highest->get<double>()};
}

class Comparer {
 public:
  Comparer(const Json& older, const Json& newer) : older_(older), newer_(newer) {
    result_["commit"] = older["machine"].value("commit", "");
    result_["date"] = older["machine"].value("date", "");
    result_["times_compared"] = older["machine"].value("cpu", "") == newer["machine"].value("cpu", "");
    result_["compared"] = 0;
    result_["not_compared"] = 0;
    result_["moved"] = Json::array();
  }

  void compare(const std::string& section) {
    if (!older_.contains(section) || !older_[section].is_array()) {
      return;
    }
    const auto before = placed(older_[section]);
    for (const auto& [place, row] : placed(newer_[section])) {
      const auto found = before.find(place);
      if (found != before.end()) {
        compareRows(section, place, found->second, row);
      }
    }
  }

  [[nodiscard]] Json take() { return std::move(result_); }

 private:
  void compareRows(const std::string& section, const Place& place, const Json& before, const Json& after) {
    if (before.value("state", "") == "too slow" || after.value("state", "") == "too slow") {
      return;  // progress within a time limit says nothing about the method
    }
    const char* time = timeOf(after);
    if (time != nullptr && result_["times_compared"].get<bool>()) {
      compareTimes(section, place, time, before, after);
    }
    for (const char* key : exact) {
      if (before.contains(key) && after.contains(key)) {
        compareFigures(section, place, key, before[key], after[key]);
      }
    }
    for (const char* key : wordKeys) {
      if (before.contains(key) && after.contains(key)) {
        count("compared");
        if (before[key] != after[key]) {
          move(section, place, key, before[key], after[key], "other");
        }
      }
    }
  }

  void compareTimes(const std::string& section, const Place& place, const char* key, const Json& before,
                    const Json& after) {
    const Json was = before.value("samples", Json::array());
    const Json& now = after["samples"];
    if (was.size() < 2 || now.size() < 2) {
      count("not_compared");
      return;
    }
    count("compared");
    const auto [minBefore, maxBefore] = rangeOf(was);
    const auto [minNow, maxNow] = rangeOf(now);
    const double change = numberIn(after, key) / numberIn(before, key) - 1.0;
    const bool apart = minNow > maxBefore || maxNow < minBefore;
    if (apart && std::abs(change) > timeTolerance) {
      move(section, place, key, before[key], after[key], change > 0.0 ? "slower" : "faster");
    }
  }

  void compareFigures(const std::string& section, const Place& place, const char* key, const Json& before,
                      const Json& after) {
    count("compared");
    if (!before.is_number() || !after.is_number()) {
      if (before.is_number() != after.is_number()) {
        move(section, place, key, before, after, "other");
      }
      return;
    }
    const double change = after.get<double>() - before.get<double>();
    if (std::abs(change) > errorTolerance * std::abs(before.get<double>())) {
      move(section, place, key, before, after, change > 0.0 ? "worse" : "better");
    }
  }

  void count(const char* key) { result_[key] = result_[key].get<int>() + 1; }

  void move(const std::string& section, const Place& place, const char* key, const Json& before, const Json& after,
            const char* verdict) {
    result_["moved"].push_back({{"section", section},
                                {"cell", place.first},
                                {"row", place.second},
                                {"figure", key},
                                {"before", before},
                                {"after", after},
                                {"verdict", verdict}});
  }

  const Json& older_;
  const Json& newer_;
  Json result_;
};

std::string textOf(const Json& value) {
  return value.is_string() ? value.get<std::string>() : value.is_number() ? text::figure(value.get<double>(), 4) : "-";
}

std::string changeOf(const Json& row) {
  if (!row["before"].is_number() || !row["after"].is_number()) {
    return "-";
  }
  constexpr double percent = 100.0;
  const double change = percent * (row["after"].get<double>() / row["before"].get<double>() - 1.0);
  return (change > 0.0 ? "+" : "") + text::figure(change) + " %";
}

std::string summaryText(const Json& comparison) {
  std::map<std::string, int> verdicts;
  for (const Json& row : comparison["moved"]) {
    verdicts[row.value("verdict", "")] += 1;
  }
  std::string text = "Compared with the report of " + comparison.value("date", "") + ", commit " +
                     comparison.value("commit", "") + ": of " + std::to_string(comparison.value("compared", 0)) +
                     " figures " + std::to_string(comparison["moved"].size()) + " changed beyond noise";
  for (const auto& [verdict, count] : verdicts) {
    text += ", " + std::to_string(count) + " " + verdict;
  }
  text += ". " + std::to_string(comparison.value("not_compared", 0)) + " times have no repeats and were not compared.";
  return comparison.value("times_compared", true)
             ? text
             : text + " It was made on another processor, so times were not compared.";
}

}  // namespace

Json compareReports(const Json& older, const Report& report) {
  const Json newer = reportJson(report);
  Comparer comparer(older, newer);
  for (const Section& section : sectionTable()) {
    if (section.plan != nullptr) {
      comparer.compare(std::string(section.name));
    }
  }
  return comparer.take();
}

std::vector<Block> showComparison(const Json& comparison) {
  TextTable table{"Changes", {"section", "cell", "figure", "before", "after", "change", "verdict"}, {}};
  for (const Json& row : comparison["moved"]) {
    table.rows.push_back(
        {row.value("section", ""),
         row.value("cell", "") + (row.value("row", 0) > 0 ? " #" + std::to_string(row.value("row", 0) + 1) : ""),
         row.value("figure", ""), textOf(row["before"]), textOf(row["after"]), changeOf(row),
         row.value("verdict", "")});
  }
  std::vector<Block> blocks{Paragraph{summaryText(comparison)}};
  if (!table.rows.empty()) {
    blocks.emplace_back(std::move(table));
  }
  return blocks;
}

}  // namespace drape::report
