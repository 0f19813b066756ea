#include "report/sections/work_precision_view.hpp"

#include "report/number_text.hpp"
#include "report/sections/method_curves.hpp"
#include "report/sections/pareto.hpp"
#include "report/sections/set_ups.hpp"
#include "report/sections/work_rows.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace drape::report::sections {
namespace {

constexpr double millimetres = 1e3;

/// The rows of each diagram.
std::map<WorkClothAt, ReportRows> byCloth(const ReportRows& rows) {
  std::map<WorkClothAt, ReportRows> cloths;
  for (const ReportRow& row : rows) {
    cloths[workClothAt(row)].push_back(row);
  }
  return cloths;
}

std::string titleOf(const WorkClothAt& cloth) {
  return titleOf(cloth.first) + ", after " + text::figure(cloth.second) + " s";
}

std::string fileOf(const WorkClothAt& clothAt) {
  const auto& [cloth, time] = clothAt;
  std::string name = "work-" + cloth.scene + "-" + (cloth.resolution == 0 ? "mesh" : std::to_string(cloth.resolution)) +
                     "-" + (cloth.isFabric ? cloth.material : text::figure(cloth.stiffness, 6)) + "-" +
                     std::to_string(std::lround(1000.0 * time)) + "ms";
  std::replace_if(
      name.begin(), name.end(), [](char c) { return c == '.' || c == '+' || c == '/' || c == ' '; }, '_');
  return name;
}

std::string nameOf(const ReportRow& row) {
  return row.value("method", "") + " " + row.value("setting", "");
}

/// The rows on the front, by ascending cost. Frozen and exploded ones do not count.
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
  PlotPoint point{msPerFrame(numberIn(row, "us_per_simulated_second")), millimetres * numberIn(row, "error_mean")};
  point.note = nameOf(row) + ": " + text::figure(point.y) + " mm, " + text::figure(point.x) + " ms a frame, " + state;
  point.low = millimetres * numberIn(row, "error_low");
  point.high = millimetres * numberIn(row, "error_high");
  if (state == "exploded") {
    point.low = point.high = std::numeric_limits<double>::quiet_NaN();
    point.y = std::numeric_limits<double>::infinity();
    point.mark = Mark::Cross;
  } else if (state == "frozen") {
    point.mark = Mark::Hollow;
  }
  return point;
}

/// A line at the error due to jitter of the start, or due to the reference when that is larger.
void addFloor(const ReportRows& rows, Plot& plot) {
  Curve floor{"noise floor", {}, CurveStyle::Level};
  for (const ReportRow& row : rows) {
    const double height = std::fmax(numberIn(row, "noise_floor"), numberIn(row, "reference_difference"));
    floor.points.push_back({msPerFrame(numberIn(row, "us_per_simulated_second")), millimetres * height});
  }
  plot.curves.push_back(floor);
}

Plot plotOf(const WorkClothAt& cloth, const ReportRows& rows) {
  Plot plot{fileOf(cloth),
            titleOf(cloth),
            {"time per frame of 1/60 s [ms]", Scale::Logarithmic},
            {"mean error [mm]", Scale::Logarithmic},
            {}};
  for (const ReportRow& row : rows) {
    curveLabelled(row.value("curve", ""), plot).points.push_back(pointOf(row));
  }
  Curve front{"Pareto front", {}, CurveStyle::Front};
  for (const ReportRow& row : frontOf(rows)) {
    front.points.push_back(pointOf(row));
    // Curves with a larger part of the front stand out.
    curveLabelled(row.value("curve", ""), plot).importance += 1.0;
  }
  plot.curves.push_back(front);
  addFloor(rows, plot);
  return plot;
}

TextTable tableOf(const std::string& title, const ReportRows& rows) {
  TextTable table{
      title,
      {"method", "setting", "ms a frame", "mean error [mm]", "rms error [mm]", "eps", "S", "motion kept", "state"},
      {}};
  for (const ReportRow& row : rows) {
    table.rows.push_back({row.value("method", ""), row.value("setting", ""), frameCost(row),
                          text::figure(millimetres * numberIn(row, "error_mean")),
                          text::figure(millimetres * numberIn(row, "error_rms")), figure(row, "eps"), figure(row, "S"),
                          figure(row, "motion_kept"), row.value("state", "")});
  }
  return table;
}

/// The names of the solvers with vector instructions.
std::string fastMethods() {
  std::string names;
  for (const sim::SolverInfo& solver : sim::solverTable()) {
    if (hasVectorLoops(solver)) {
      names += (names.empty() ? "" : ", ") + std::string(solver.name);
    }
  }
  return names;
}

bool hasErrors(const ReportRows& rows) {
  return std::any_of(rows.begin(), rows.end(), [](const ReportRow& row) { return !row["error_mean"].is_null(); });
}

/// @param rows of one cloth at one time, at least one
std::string referenceText(const ReportRows& rows) {
  const auto known = std::find_if(rows.begin(), rows.end(),
                                  [](const ReportRow& one) { return !one["reference_difference"].is_null(); });
  const ReportRow& row = known == rows.end() ? rows.front() : *known;
  if (!hasErrors(rows)) {
    return "Small steps did not converge on this cloth: the last halving still moved it by " +
           text::figure(millimetres * numberIn(row, "reference_difference")) + " mm, so there is no reference.";
  }
  std::string text = "The last halving of the reference's step moved it by " +
                     text::figure(millimetres * numberIn(row, "reference_difference")) + " mm here";
  text += row.value("trusted", false) ? ". " : ", which is above the tolerance: smaller errors are meaningless. ";
  text += "A jitter of the start by up to 0.001 mm moves it by " +
          text::figure(millimetres * numberIn(row, "noise_floor")) + " mm.";
  const auto slow = std::count_if(rows.begin(), rows.end(),
                                  [](const ReportRow& one) { return one.value("state", "") == "too slow"; });
  return slow == 0 ? text
                   : text + " " + std::to_string(slow) + " settings would have taken too long and were left out.";
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

std::vector<Block> showWorkPrecision(const ReportOptions& options, const ReportRows& rows) {
  std::vector<Block> blocks;
  blocks.emplace_back(Paragraph{
      "Mean distance from the converged motion over the time of one thread per frame of 1/60 s. Steps are "
      "1/150 s, in double unless the name of a curve says float. The set-up of the solver is not included (see the "
      "section on growth). Times are medians of repeats that alternate between the methods. A hollow mark is frozen: "
      "it "
      "kept less than half of the reference's motion. A cross at the upper edge exploded: it was not finite, moved "
      "more "
      "than twice as much as the reference, or is farther from it than the length of the cloth. Vector instructions "
      "run " +
      fastMethods() +
      "; XPBD in float only. The others use plain loops over the same springs. Fabrics have the density and the "
      "damping of their preset, and their full stretch stiffness. auto, verlet and explicit_euler use vector "
      "instructions for them. Their damping acts once in a step, so even an exact solver keeps the error of that in "
      "steps of "
      "1/150 s; in the reference it acts in each of its short steps."});
  blocks.emplace_back(Paragraph{
      "When a jitter of the start by up to 0.001 mm grows a hundredfold, the motion is chaotic. Each setting is then "
      "run "
      "from five jittered starts too, and a band shows the range of their errors. The dashed line "
      "is the distance due to jitter alone; errors below it are meaningless. Settings that would take "
      "too "
      "long are skipped, and the curve ends."});
  std::string scenes = "The scenes:";
  for (const SetUp& setUp : comparedSetUps(options.scene)) {
    scenes += (scenes.ends_with(':') ? " '" : "; '") + setUp.name + "' is " + setUp.help;
  }
  blocks.emplace_back(Paragraph{scenes + "."});
  for (const auto& [cloth, own] : byCloth(rows)) {
    if (!hasErrors(own)) {
      blocks.emplace_back(Paragraph{titleOf(cloth) + ": " + referenceText(own)});
      continue;
    }
    blocks.emplace_back(plotOf(cloth, own));
    blocks.emplace_back(Paragraph{referenceText(own)});
    blocks.emplace_back(tableOf("Pareto front: " + titleOf(cloth), frontOf(own)));
  }
  for (const auto& [cloth, own] : byCloth(rows)) {
    TextTable table = tableOf("All: " + titleOf(cloth), own);
    table.folded = true;
    blocks.emplace_back(std::move(table));
  }
  return blocks;
}

}  // namespace drape::report::sections
