#include "report/number_text.hpp"
#include "report/sections/samples.hpp"
#include "report/sections/section_scene.hpp"
#include "report/sections/sections.hpp"
#include "report/sections/stable_substeps.hpp"
#include "report/timing.hpp"

#include <cmath>

namespace drape::report::sections {
namespace {

constexpr double microseconds = 1e6;
constexpr double milliseconds = 1e3;
constexpr double megabytes = 1e-6;
/// Assumed upper bound for the exponent of all times.
constexpr double cautiousExponent = 1.5;

/// Time limit of a cell [s]; larger grids are skipped.
double maxSeconds(const ReportOptions& options) {
  return options.quick ? 0.5 : 10.0;
}

/// The row of the same method on the next smaller grid; null when there is none.
const ReportRow* smaller(const ReportRows& rows, std::string_view method, int vertices) {
  const ReportRow* found = nullptr;
  for (const ReportRow& row : rows) {
    found = row.value("method", "") == method && row.value("vertices", 0) < vertices ? &row : found;
  }
  return found;
}

/// The expected duration of the set-up and the minimum number of steps, extrapolated from the smaller grid [s].
double expectedSeconds(const ReportRow& before, int vertices) {
  if (before.contains("skipped")) {
    return HUGE_VAL;
  }
  const double ratio = std::pow(vertices / numberIn(before, "vertices"), cautiousExponent);
  return ratio * numberIn(before, "seconds_at_least");
}

ReportRows measureGrowth(const sim::SolverInfo& solver, int resolution, const ReportOptions& options,
                         const CellContext& context) {
  constexpr int minSteps = 3;
  const auto scene = gridScene("grid", resolution,
                               {"solver=" + std::string(solver.name), "threads=" + std::to_string(options.threads)});
  const sim::ClothModel& model = *scene->model;
  ReportRow row{{"method", solver.name},
                {"resolution", resolution},
                {"vertices", model.vertexCount()},
                {"springs", model.springs.size()}};
  if (!context.own.empty() && context.own.front().contains("skipped")) {
    return context.own;
  }
  const ReportRow* before = smaller(context.section, solver.name, model.vertexCount());
  if (before != nullptr && expectedSeconds(*before, model.vertexCount()) > maxSeconds(options)) {
    row["skipped"] = "would take too long";
    return {row};
  }
  settings::Settings settings = scene->settings;
  settings.step.substeps = stableSubsteps(solver, *scene->model, settings.step);
  const TimingBudget budget{.seconds = options.quick ? 0.05 : 0.25, .minSteps = minSteps, .maxSteps = 1000};
  const StepTiming timing = timeSteps(*scene, settings, budget, context.checkStop);
  const double median = medianOf(timing.stepSeconds);
  row["substeps"] = settings.step.substeps;
  row["step_us"] = finiteOrNull(microseconds * median / settings.step.substeps);
  row["setup_ms"] = finiteOrNull(milliseconds * timing.setupSeconds);
  row["memory_mb"] = finiteOrNull(megabytes * timing.memoryBytes);
  row["finite"] = timing.finite;
  addSample(context.own, 0, "step_us", row);
  row["us_per_simulated_second"] =
      finiteOrNull(numberIn(row, "step_us") * settings.step.substeps / settings.step.timeStep);
  row["seconds_at_least"] = timing.setupSeconds + (minSteps + 1) * median;
  return {row};
}

SectionPlan plan(const ReportOptions& options) {
  SectionPlan plan;
  plan.rounds = options.quick ? 1 : 2;
  const std::vector<int> sizes = options.quick ? std::vector{17, 33} : std::vector{17, 33, 65, 129, 257};
  for (const int resolution : sizes) {
    for (const sim::SolverInfo& solver : sim::solverTable()) {
      plan.cells.push_back({std::string(solver.name) + " " + gridText(resolution), options.quick ? 0.1 : 0.8,
                            [&solver, resolution, options](const CellContext& context) {
                              return measureGrowth(solver, resolution, options, context);
                            }});
    }
  }
  return plan;
}

/// A value over the number of vertices, a curve for each method. Methods with more vertices for the value stand out.
Plot plotOf(const ReportRows& rows, const char* key, double factor, const std::string& title, const std::string& unit) {
  Plot plot{std::string("growth-") + key, title, {"vertices", Scale::Logarithmic}, {unit, Scale::Logarithmic}, {}};
  for (const ReportRow& row : rows) {
    const PlotPoint point{numberIn(row, "vertices"), factor * numberIn(row, key)};
    Curve& curve = curveLabelled(row.value("method", ""), plot);
    curve.points.push_back(point);
    if (point.y > 0.0) {
      curve.importance = point.x / point.y;
    }
  }
  return plot;
}

double exponentOf(const Curve& curve) {
  std::vector<double> vertices;
  std::vector<double> values;
  for (const PlotPoint& point : curve.points) {
    if (point.x > 0.0 && point.y > 0.0) {
      vertices.push_back(point.x);
      values.push_back(point.y);
    }
  }
  return fittedExponent(vertices, values);
}

TextTable exponents(const std::vector<Plot>& plots) {
  TextTable table{
      "Exponents b of value = a vertices^b, fitted", {"method", "substep", "frame", "set-up", "memory"}, {}};
  for (std::size_t i = 0; i < plots.front().curves.size(); ++i) {
    std::vector<std::string> fields{plots.front().curves[i].label};
    for (const Plot& plot : plots) {
      fields.push_back(text::figure(exponentOf(plot.curves[i]), 2));
    }
    table.rows.push_back(fields);
  }
  return table;
}

TextTable tableOf(const ReportRows& rows) {
  TextTable table{
      "Costs", {"method", "grid", "substeps", "substep [ms]", "frame [ms]", "set-up [ms]", "memory [MB]"}, {}};
  for (const ReportRow& row : rows) {
    table.rows.push_back({row.value("method", ""), gridText(row.value("resolution", 0)), figure(row, "substeps", 7),
                          row.value("skipped", text::figure(numberIn(row, "step_us") / milliseconds)), frameCost(row),
                          figure(row, "setup_ms"), figure(row, "memory_mb")});
  }
  return table;
}

std::vector<Block> show(const ReportOptions&, const ReportRows& rows) {
  if (rows.empty()) {
    return {};
  }
  const std::vector<Plot> plots{
      plotOf(rows, "step_us", 1.0 / milliseconds, "Time of a substep", "ms"),
      plotOf(rows, "us_per_simulated_second", msPerFrame(1.0), "Time of a frame of 1/60 s", "ms"),
      plotOf(rows, "setup_ms", 1.0, "Set-up before the first step", "ms"),
      plotOf(rows, "memory_mb", 1.0, "Memory of the solver", "MB")};
  std::vector<Block> blocks;
  blocks.emplace_back(Paragraph{
      "Every method with its default settings on the scene 'grid' with steps of 1/150 s. The explicit methods use as "
      "many substeps as stability needs. Set-up is the additional time of the first step. Memory is "
      "what "
      "was allocated for the solver until then. Grids that would take too long are left out."});
  blocks.insert(blocks.end(), plots.begin(), plots.end());
  blocks.emplace_back(exponents(plots));
  blocks.emplace_back(tableOf(rows));
  return blocks;
}

}  // namespace

Section growth() {
  return {"growth", "Growth with size", plan, show};
}

}  // namespace drape::report::sections
