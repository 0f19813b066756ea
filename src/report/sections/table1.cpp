#include "report/number_text.hpp"
#include "report/sections/collision_run.hpp"
#include "report/sections/paper_times.hpp"
#include "report/sections/samples.hpp"
#include "report/sections/section_scene.hpp"
#include "report/sections/sections.hpp"
#include "report/timing.hpp"

#include <cmath>
#include <map>

namespace drape::report::sections {
namespace {

constexpr double milliseconds = 1e3;
constexpr double nanoseconds = 1e9;
constexpr int smallestFitted = 65;
/// With fewer steps a 99th percentile would be their maximum.
constexpr std::size_t minForPercentile = 200;

/// The largest grids with a measurement of self-collision, in a quick and in a full report.
constexpr int largestFoldedQuickly = 33;
constexpr int largestFolded = 65;

/// The mean duration of self-collision per step [ms], over two seconds in which a sheet folds onto itself.
double measureSelfCollision(int resolution, const std::string& precision, const ReportOptions& options,
                            const CellContext& context) {
  if (resolution > (options.quick ? largestFoldedQuickly : largestFolded)) {
    return NAN;
  }
  const auto scene = gridScene("fold", resolution,
                               {"solver=one_iteration", "self_collision=hash", "precision=" + precision,
                                "threads=" + std::to_string(options.threads)});
  return milliseconds * runCollision(*scene, 2.0, 0, context.checkStop).selfSeconds;
}

ReportRows measureUpdate(int resolution, const std::string& precision, const ReportOptions& options,
                         const CellContext& context) {
  const auto scene =
      gridScene("grid", resolution,
                {"solver=one_iteration", "precision=" + precision, "threads=" + std::to_string(options.threads)});
  const TimingBudget budget{.seconds = options.quick ? 0.1 : 1.0, .minSteps = 3, .maxSteps = 5000};
  const StepTiming timing = timeSteps(*scene, scene->settings, budget, context.checkStop);
  const sim::ClothModel& model = *scene->model;
  const double median = medianOf(timing.stepSeconds);
  const bool enough = timing.stepSeconds.size() >= minForPercentile;
  ReportRow row{{"resolution", resolution},
                {"precision", precision},
                {"vertices", model.vertexCount()},
                {"springs", model.springs.size()},
                {"triangles", model.triangles.size()},
                {"steps", timing.stepSeconds.size()},
                {"update_ms", finiteOrNull(milliseconds * median)},
                {"update_ms_p99", finiteOrNull(enough ? milliseconds * quantileOf(timing.stepSeconds, 0.99) : NAN)},
                {"ns_per_spring", finiteOrNull(nanoseconds * median / static_cast<double>(model.springs.size()))},
                {"self_collision_ms", finiteOrNull(measureSelfCollision(resolution, precision, options, context))},
                {"finite", timing.finite}};
  for (const PaperTimes& paper : paperTimes) {
    if (paper.resolution == resolution) {
      row["paper_update_ms"] = paper.update;
      row["paper_self_collision_ms"] = paper.selfCollision;
    }
  }
  addSample(context.own, 0, "update_ms", row);
  return {row};
}

SectionPlan plan(const ReportOptions& options) {
  SectionPlan plan;
  plan.rounds = options.quick ? 2 : 3;
  for (const int resolution : {17, 33, 65, 129, 257, 513, 1025}) {
    if (options.quick && resolution > 257) {
      break;
    }
    for (const std::string precision : {"float", "double"}) {
      const double building = 3e-6 * resolution * resolution;
      plan.cells.push_back(
          {gridText(resolution) + " " + precision, (options.quick ? 0.1 : 1.0) + building,
           [=](const CellContext& context) { return measureUpdate(resolution, precision, options, context); }});
    }
  }
  return plan;
}

TextTable tableOf(const ReportRows& rows) {
  TextTable table{"Time of a frame update (one step of one_iteration)",
                  {"grid", "numbers", "vertices", "springs", "triangles", "median [ms]", "99 % [ms]", "paper [ms]",
                   "ns per spring", "self-collision [ms]", "paper's [ms]"},
                  {}};
  for (const ReportRow& row : rows) {
    table.rows.push_back({gridText(row.value("resolution", 0)), row.value("precision", ""), figure(row, "vertices", 7),
                          figure(row, "springs", 7), figure(row, "triangles", 7), figure(row, "update_ms"),
                          figure(row, "update_ms_p99"), figure(row, "paper_update_ms"), figure(row, "ns_per_spring"),
                          figure(row, "self_collision_ms"), figure(row, "paper_self_collision_ms")});
  }
  return table;
}

/// Springs and times [s] of grids that are so large that the constant cost of a step is negligible.
struct Growth {
  std::vector<double> springs;
  std::vector<double> times;
};

std::map<std::string, Growth> growthOf(const ReportRows& rows, int smallest) {
  std::map<std::string, Growth> growth;
  for (const ReportRow& row : rows) {
    const double time = numberIn(row, "update_ms");
    if (row.value("resolution", 0) >= smallest && time > 0.0) {
      Growth& entry = growth[row.value("precision", "")];
      entry.springs.push_back(numberIn(row, "springs"));
      entry.times.push_back(time);
    }
  }
  return growth;
}

Plot plotOf(const ReportRows& rows) {
  Plot plot{"table1", "Time of a frame update", {"springs", Scale::Logarithmic}, {"ms", Scale::Logarithmic}, {}};
  for (const auto& [precision, growth] : growthOf(rows, 0)) {
    Curve curve{precision, {}};
    for (std::size_t i = 0; i < growth.springs.size(); ++i) {
      curve.points.push_back({growth.springs[i], growth.times[i]});
    }
    plot.curves.push_back(curve);
  }
  return plot;
}

std::vector<Block> show(const ReportOptions& options, const ReportRows& rows) {
  std::vector<Block> blocks;
  blocks.emplace_back(Paragraph{
      "One sweep per step of 1/150 s on the scene 'grid', with " + std::to_string(options.threads) +
      (options.threads == 1 ? " thread" : " threads") +
      ". The median of single steps, timed as the viewer takes them; the 99th percentile for at least " +
      std::to_string(minForPercentile) +
      " steps. Self-collision is the paper's scheme (hash) on a sheet of the same size that folds onto itself (scene "
      "'fold'), the mean over the steps of two seconds. The paper's values are from a machine of its time."});
  blocks.emplace_back(tableOf(rows));
  for (const auto& [precision, growth] : growthOf(rows, smallestFitted)) {
    if (growth.springs.size() > 1) {
      blocks.emplace_back(Paragraph{"In " + precision + " the time grows as the number of springs to the power " +
                                    text::figure(fittedExponent(growth.springs, growth.times)) + " from " +
                                    gridText(smallestFitted) + " on (1 is proportional)."});
    }
  }
  blocks.emplace_back(plotOf(rows));
  return blocks;
}

}  // namespace

Section table1() {
  return {"table1", "Frame update (the paper's Table 1)", plan, show};
}

}  // namespace drape::report::sections
