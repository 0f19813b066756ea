#include "report/sections/work_precision_view.hpp"

#include "report/number_text.hpp"
#include "report/sections/pareto.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>

namespace drape {
namespace {

constexpr double millimetres = 1e3;

/// What one diagram shows: scene, resolution, stiffness, time.
using Setup = std::tuple<std::string, int, double, double>;

std::map<Setup, ReportRows> bySetup(const ReportRows& rows) {
  std::map<Setup, ReportRows> setups;
  for (const ReportRow& row : rows) {
    const Setup setup{row.value("scene", ""), row.value("resolution", 0), numberIn(row, "stiffness"),
                      numberIn(row, "time")};
    setups[setup].push_back(row);
  }
  return setups;
}

std::string titleOf(const Setup& setup) {
  const auto& [scene, resolution, stiffness, time] = setup;
  return scene + ", " + gridText(resolution) + ", " + figure(stiffness) + " N/m, after " + figure(time) + " s";
}

std::string fileOf(const Setup& setup) {
  const auto& [scene, resolution, stiffness, time] = setup;
  std::string name = "work-" + std::to_string(resolution) + "-" + figure(stiffness, 6) + "-" +
                     std::to_string(std::lround(1000.0 * time)) + "ms";
  std::replace_if(
      name.begin(), name.end(), [](char c) { return c == '.' || c == '+'; }, '_');
  return name;
}

std::string nameOf(const ReportRow& row) {
  return row.value("method", "") + " " + row.value("setting", "");
}

/// The rows on the front, by ascending cost. What is frozen or exploded has no place there.
ReportRows frontOf(const ReportRows& rows) {
  ReportRows calm;
  std::vector<CostAndError> entries;
  for (const ReportRow& row : rows) {
    if (row.value("state", "") == "calm") {
      calm.push_back(row);
      entries.push_back({numberIn(row, "us_per_simulated_second"), numberIn(row, "error_mean")});
    }
  }
  ReportRows front;
  for (const std::size_t i : paretoFront(entries)) {
    front.push_back(calm[i]);
  }
  return front;
}

PlotPoint pointOf(const ReportRow& row) {
  const std::string state = row.value("state", "");
  PlotPoint point{numberIn(row, "us_per_simulated_second"), millimetres * numberIn(row, "error_mean")};
  point.note = nameOf(row) + ": " + figure(point.y) + " mm, " + figure(point.x) + " us, " + state;
  if (state == "exploded") {
    point.y = std::numeric_limits<double>::infinity();
    point.mark = Mark::Cross;
  } else if (state == "frozen") {
    point.mark = Mark::Hollow;
  }
  return point;
}

Plot plotOf(const Setup& setup, const ReportRows& rows) {
  Plot plot{fileOf(setup),
            titleOf(setup),
            {"time for a simulated second [us]", Scale::Logarithmic},
            {"mean error [mm]", Scale::Logarithmic},
            {}};
  std::map<std::string, std::size_t> places;
  for (const ReportRow& row : rows) {
    const auto [place, isNew] = places.emplace(row.value("curve", ""), plot.curves.size());
    if (isNew) {
      plot.curves.push_back({place->first, {}});
    }
    plot.curves[place->second].points.push_back(pointOf(row));
  }
  Curve front{"Pareto front", {}, CurveStyle::Front};
  for (const ReportRow& row : frontOf(rows)) {
    front.points.push_back(pointOf(row));
  }
  plot.curves.push_back(front);
  return plot;
}

TextTable tableOf(const std::string& title, const ReportRows& rows) {
  TextTable table{title,
                  {"method", "setting", "us a simulated second", "mean error [mm]", "rms error [mm]", "eps", "S",
                   "motion kept", "state"},
                  {}};
  for (const ReportRow& row : rows) {
    table.rows.push_back({row.value("method", ""), row.value("setting", ""), figure(row, "us_per_simulated_second"),
                          figure(millimetres * numberIn(row, "error_mean")),
                          figure(millimetres * numberIn(row, "error_rms")), figure(row, "eps"), figure(row, "S"),
                          figure(row, "motion_kept"), row.value("state", "")});
  }
  return table;
}

std::string referenceText(const ReportRows& rows) {
  const ReportRow& row = rows.front();
  return "The last halving of the reference's step moved it by " +
         figure(millimetres * numberIn(row, "reference_difference")) + " mm here" +
         (row.value("trusted", false) ? "." : ", which is too much to be trusted: errors of this size mean nothing.");
}

}  // namespace

std::string stateOf(bool finite, const ErrorSummary& summary, double diagonal) {
  constexpr double wild = 2.0;
  constexpr double frozen = 0.5;
  if (!finite || !(summary.motionKept <= wild) || !(summary.meanError <= diagonal)) {
    return "exploded";
  }
  return summary.motionKept < frozen ? "frozen" : "calm";
}

std::vector<Block> showWorkPrecision(const ReportOptions&, const ReportRows& rows) {
  std::vector<Block> blocks;
  blocks.emplace_back(Paragraph{
      "Mean distance from the converged motion against the time that one thread needs for a simulated second, "
      "steps of 1/150 s in double, the set-up of the solver apart. Times are medians of repeats that alternate "
      "between the methods. A hollow mark is frozen: it kept less than half of the reference's motion. A cross "
      "at the upper edge exploded: it was not finite, moved more than twice as much as the reference, or went "
      "further from it than the cloth is long."});
  for (const auto& [setup, own] : bySetup(rows)) {
    blocks.emplace_back(plotOf(setup, own));
    blocks.emplace_back(Paragraph{referenceText(own)});
    blocks.emplace_back(tableOf("Pareto front: " + titleOf(setup), frontOf(own)));
  }
  for (const auto& [setup, own] : bySetup(rows)) {
    blocks.emplace_back(tableOf("All: " + titleOf(setup), own));
  }
  return blocks;
}

}  // namespace drape
