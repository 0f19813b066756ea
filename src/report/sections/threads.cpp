#include "report/number_text.hpp"
#include "report/sections/samples.hpp"
#include "report/sections/section_scene.hpp"
#include "report/sections/sections.hpp"
#include "report/timing.hpp"

#include <algorithm>
#include <set>
#include <thread>

namespace drape::report::sections {
namespace {

constexpr double milliseconds = 1e3;  // in us

constexpr double microseconds = 1e6;

/// 1, 2, 4 ... up to the number of processors, which is included; at least 1 and 2.
std::vector<int> threadCounts() {
  const int cores = std::max(2, static_cast<int>(std::thread::hardware_concurrency()));
  std::vector<int> counts;
  for (int count = 1; count < cores; count *= 2) {
    counts.push_back(count);
  }
  counts.push_back(cores);
  return counts;
}

ReportRows measureThreads(const std::string& method, int resolution, int threads, bool quick,
                          const CellContext& context) {
  const auto scene =
      gridScene("grid", resolution, {"solver=" + method, "precision=float", "threads=" + std::to_string(threads)});
  settings::Settings settings = scene->settings;
  const TimingBudget budget{.seconds = quick ? 0.03 : 0.2, .minSteps = 3, .maxSteps = 2000};
  const StepTiming timing = timeSteps(*scene, settings, budget, context.checkStop);
  ReportRow row{{"method", method},
                {"resolution", resolution},
                {"vertices", scene->model->vertexCount()},
                {"threads", threads},
                {"step_us", finiteOrNull(microseconds * medianOf(timing.stepSeconds))},
                {"finite", timing.finite}};
  addSample(context.own, 0, "step_us", row);
  return {row};
}

SectionPlan plan(const ReportOptions& options) {
  SectionPlan plan;
  plan.rounds = options.quick ? 2 : 3;
  const std::vector<int> sizes = options.quick ? std::vector{33, 129} : std::vector{17, 33, 65, 129, 257, 513};
  for (const char* method : {"one_iteration", "xpbd"}) {
    for (const int resolution : sizes) {
      for (const int threads : threadCounts()) {
        plan.cells.push_back({std::string(method) + " " + gridText(resolution) + " " + std::to_string(threads),
                              (options.quick ? 0.04 : 0.25) + 4e-6 * resolution * resolution,
                              [=, quick = options.quick](const CellContext& context) {
                                return measureThreads(method, resolution, threads, quick, context);
                              }});
      }
    }
  }
  return plan;
}

/// The time of the same method and size with one thread; not a number when there is none.
double aloneTime(const ReportRows& rows, const ReportRow& like) {
  for (const ReportRow& row : rows) {
    if (row["method"] == like["method"] && row["resolution"] == like["resolution"] && row.value("threads", 0) == 1) {
      return numberIn(row, "step_us");
    }
  }
  return numberIn({}, "");
}

/// Curves of one method: over the size with a curve per number of threads, or over the threads with a curve per size.
Plot plotOf(const ReportRows& rows, const std::string& method, bool overSize) {
  Plot plot{"threads-" + method + (overSize ? "-time" : "-speedup"),
            method + (overSize ? ": time of a step" : ": speed-up over one thread"),
            {overSize ? "vertices" : "threads", overSize ? Scale::Logarithmic : Scale::Linear},
            {overSize ? "ms" : "speed-up", overSize ? Scale::Logarithmic : Scale::Linear},
            {}};
  for (const ReportRow& row : rows) {
    if (row.value("method", "") != method) {
      continue;
    }
    const int key = row.value(overSize ? "threads" : "resolution", 0);
    const std::string label = overSize ? std::to_string(key) + (key == 1 ? " thread" : " threads") : gridText(key);
    const double time = numberIn(row, "step_us");
    curveLabelled(label, plot)
        .points.push_back(overSize ? PlotPoint{numberIn(row, "vertices"), time / milliseconds}
                                   : PlotPoint{numberIn(row, "threads"), aloneTime(rows, row) / time});
  }
  return plot;
}

std::vector<Block> show(const ReportOptions&, const ReportRows& rows) {
  std::vector<Block> blocks;
  blocks.emplace_back(Paragraph{
      "Time of a step of 1/150 s on the scene 'grid' in float, by the wall clock, over the number of threads. The "
      "result is bit-identical for any number. Threads that wait for each other can only be timed on "
      "an idle machine."});
  std::set<std::string> methods;
  TextTable table{"Times", {"method", "grid", "threads", "step [ms]", "speed-up"}, {}};
  for (const ReportRow& row : rows) {
    methods.insert(row.value("method", ""));
    table.rows.push_back({row.value("method", ""), gridText(row.value("resolution", 0)), figure(row, "threads"),
                          text::figure(numberIn(row, "step_us") / milliseconds),
                          text::figure(aloneTime(rows, row) / numberIn(row, "step_us"))});
  }
  for (const std::string& method : methods) {
    blocks.emplace_back(plotOf(rows, method, true));
    blocks.emplace_back(plotOf(rows, method, false));
  }
  blocks.emplace_back(table);
  return blocks;
}

}  // namespace

Section threads() {
  return {"threads", "Threads and size", plan, show};
}

}  // namespace drape::report::sections
