#include "report/error_report.hpp"
#include "report/number_text.hpp"
#include "report/sections/section_scene.hpp"
#include "report/sections/sections.hpp"
#include "report/sections/table2_starts.hpp"
#include "report/sections/table2_view.hpp"
#include "sim/measures/measures.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace drape::report::sections {
namespace {

constexpr int checkpoints = 25;

/// Sources of energy loss.
struct Losses {
  const char* name;
  std::vector<std::string> settings;
};

const std::vector<Losses>& losses() {
  static const std::vector<Losses> all{{"none", {"damping=0", "drag=0", "lift=0"}},
                                       {"damping", {"damping=0.01", "drag=0", "lift=0"}},
                                       {"damping and air", {"damping=0.01", "drag=0.5", "lift=0.3"}}};
  return all;
}

/// A cloth of the table.
struct Case {
  Table2Start start;
  Losses losses;
  std::string mass;       // [kg]
  std::string stiffness;  // [N/m]
  int resolution;

  [[nodiscard]] std::string key() const {
    return start.name + ", " + gridText(resolution) + ", " + mass + " kg, " + stiffness + " N/m, " + losses.name;
  }

  [[nodiscard]] std::vector<std::string> settings() const {
    std::vector<std::string> all{std::string("time_step=") + paperStep, "mass=" + mass, "stiffness=" + stiffness,
                                 "precision=double", "threads=1"};
    all.insert(all.end(), losses.settings.begin(), losses.settings.end());
    return all;
  }
};

ReportRow emptyRow(const Case& one, const scene::Scene& scene, const std::string& method, bool restarted) {
  const sim::StepParameters& step = scene.settings.step;
  return {{"start", one.start.name},
          {"losses", one.losses.name},
          {"damping", step.material.damping},
          {"drag", step.air.drag},
          {"lift", step.air.lift},
          {"mass", scene.model->totalMass()},
          {"stiffness", step.material.stiffness},
          {"resolution", one.resolution},
          {"polygons", scene.model->triangles.size()},
          {"method", method},
          {"mode", restarted ? "restarted" : "free-running"}};
}

/// eps and S at the checkpoints of both runs, with extremes and means.
void writeMeasures(const ErrorReport& report, ReportRow& row) {
  int within = 0;
  double epsMost = 0.0;
  double epsSum = 0.0;
  double cosineLeast = 1.0;
  double cosineSum = 0.0;
  row["eps"] = ReportRow::array();
  row["S"] = ReportRow::array();
  for (const CheckpointReport& at : report.checkpoints) {
    row["eps"].push_back(finiteOrNull(at.displacement.eps));
    row["S"].push_back(finiteOrNull(at.displacement.squaredCosine));
    within += at.displacement.eps <= paperLargestEps ? 1 : 0;
    epsMost = std::max(epsMost, at.displacement.eps);
    epsSum += at.displacement.eps;
    cosineLeast = std::min(cosineLeast, at.displacement.squaredCosine);
    cosineSum += at.displacement.squaredCosine;
  }
  const auto count = static_cast<double>(report.checkpoints.size());
  const double none = std::numeric_limits<double>::quiet_NaN();
  // Without a finite reference there is no eps.
  const bool any = !report.checkpoints.empty() && std::isfinite(epsSum);
  row["checkpoints"] = report.checkpoints.size();
  row["checkpoints_within_paper"] = within;
  row["eps_max"] = finiteOrNull(any ? epsMost : none);
  row["eps_mean"] = finiteOrNull(epsSum / count);
  row["S_min"] = finiteOrNull(any ? cosineLeast : none);
  row["S_mean"] = finiteOrNull(any ? cosineSum / count : none);
}

/// The error of the paper's reference at its last checkpoint, against Verlet with the same step, which is of second
/// order and nearly exact here [m].
double referenceError(const scene::Scene& scene, const Trajectory& reference, const Watch& watch) {
  const settings::Settings settings =
      changedSettings(scene, {"solver=verlet", std::string("time_step=") + paperReferenceStep});
  const Trajectory exact = runTrajectory(scene, settings, reference.checkpoints(), watch);
  return exact.checkpoints() == reference.checkpoints()
             ? sim::meanDistance(exact.states.back().positions, reference.states.back().positions)
             : std::numeric_limits<double>::quiet_NaN();
}

ReportRows measureCase(const Case& one, const CellContext& context) {
  const auto scene = buildStart(one.start, one.resolution, one.settings(), context.checkStop);
  Watch watch;
  watch.progress = [&context](std::string_view, std::int64_t, std::int64_t) { context.checkStop(); };
  Reference reference;
  reference.settings = paperReferenceSettings(*scene);
  reference.trajectory = runTrajectory(*scene, reference.settings, checkpoints, watch);
  reference.trusted = reference.trajectory.checkpoints();
  const double referenceOff = referenceError(*scene, reference.trajectory, watch);
  ReportRows rows;
  for (const std::string method : {"one_iteration", "pcg"}) {
    const settings::Settings settings = changedSettings(*scene, {"solver=" + method});
    for (const bool restarted : {false, true}) {
      const Trajectory own = restarted ? runRestarted(*scene, settings, reference.trajectory, watch)
                                       : runTrajectory(*scene, settings, checkpoints, watch);
      ReportRow row = emptyRow(one, *scene, method, restarted);
      writeMeasures(compareWithReference(*scene->model, settings.step, own, reference), row);
      row["reference_checkpoints"] = reference.trajectory.checkpoints();
      row["reference_error_mean"] = finiteOrNull(referenceOff);
      rows.push_back(row);
    }
  }
  return rows;
}

const Table2Start& startOf(const std::string& name) {
  return *std::find_if(table2Starts().begin(), table2Starts().end(),
                       [&](const Table2Start& start) { return start.name == name; });
}

std::vector<Case> quickCases() {
  std::vector<Case> cases;
  for (const char* start : {"flat, two corners", "swinging, edge", "free fall"}) {
    cases.push_back({startOf(start), losses().front(), "0.1", "10", 17});
  }
  return cases;
}

/// The paper's stiffness, 10 N/m, for all starts, and stiffer springs for two of them.
std::vector<Case> allCases() {
  std::vector<Case> cases;
  for (const int resolution : {17, 33}) {
    for (const char* mass : {"0.05", "0.1"}) {
      for (const Table2Start& start : table2Starts()) {
        for (const Losses& loss : losses()) {
          if (start.name != "free fall" || loss.name == losses().front().name) {
            cases.push_back({start, loss, mass, "10", resolution});
          }
        }
      }
    }
    for (const char* stiffness : {"100", "1000"}) {
      for (const char* start : {"flat, two corners", "swinging, edge"}) {
        cases.push_back({startOf(start), losses().front(), "0.1", stiffness, resolution});
      }
    }
  }
  return cases;
}

SectionPlan plan(const ReportOptions& options) {
  SectionPlan plan;
  for (const Case& one : options.quick ? quickCases() : allCases()) {
    const double springs = 3.0 * one.resolution * one.resolution;
    const double weight = 7e-4 * springs * (one.start.swing > 0.0 ? 1.5 : 1.0);
    plan.cells.push_back({one.key(), weight, [one](const CellContext& context) { return measureCase(one, context); }});
  }
  return plan;
}

}  // namespace

Section table2() {
  return {"table2", "Displacement errors (the paper's Table 2, Figs. 7 and 8)", plan, showTable2};
}

}  // namespace drape::report::sections
