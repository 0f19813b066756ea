#include "report/error_report.hpp"
#include "report/number_text.hpp"
#include "report/sections/cloth_with_reference.hpp"
#include "report/sections/method_curves.hpp"
#include "report/sections/section_scene.hpp"
#include "report/sections/sections.hpp"
#include "report/sections/time_limit.hpp"
#include "report/sections/work_plan.hpp"
#include "report/sections/work_precision_view.hpp"
#include "report/sections/work_rows.hpp"
#include "report/timing.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <optional>
#include <utility>

namespace drape::report::sections {
namespace {

constexpr double microseconds = 1e6;
constexpr double maxJitteredSeconds = 0.08;  ///< of a run that is repeated from jittered starts [s]

/// Time limits of the cells of a section.
struct Limits {
  double maxSeconds;       ///< of a run up to the last time; a slower setting is skipped [s]
  double repeatedSeconds;  ///< a longer run is not repeated, since disturbances of the clock are then negligible [s]
  double timedSeconds;     ///< shorter runs are repeated this long in each round [s]
};

Limits limitsOf(bool quick, const ClothWithReference& cloth) {
  if (quick) {
    // Tests check the results of a quick report, so these must not depend on the load of the machine.
    return {30.0, 0.05, 2e-3};
  }
  // Fabrics are stiff, and the implicit solvers run them without vector instructions. No method simulates a garment of
  // cotton in real time with full stiffness, so the garment has 100 ms for a frame.
  const double maxSeconds = cloth.resolution() == 0 ? 3.0 : cloth.material().isFabric() ? 0.25 : 0.08;
  return {maxSeconds, 0.02, 3e-3};
}

/// A method and its setting.
struct Entry {
  MethodCurve curve;
  std::string value;

  [[nodiscard]] std::vector<std::string> assignments() const {
    std::vector<std::string> all{"solver=" + curve.method};
    all.insert(all.end(), curve.fixed.begin(), curve.fixed.end());
    all.push_back(curve.varied + "=" + value);
    return all;
  }

  /// "substeps=4 iterations=1": the user's settings besides the solver.
  [[nodiscard]] std::string setting() const {
    std::string text = curve.varied + "=" + value;
    for (const std::string& fixed : curve.fixed) {
      text += " " + fixed;
    }
    return text;
  }
};

/// CPU time of the whole run up to each measured time, per simulated second [us], the mean of as many runs as the clock
/// needs. The solver's set-up is not included.
std::array<double, measuredTimes.size()> timedRun(const scene::Scene& scene, const settings::Settings& settings,
                                                  double minSeconds, const std::function<void()>& checkStop) {
  sim::Stepper stepper(settings.solver.name);
  sim::ClothState state = scene.start;
  stepper.step(*scene.model, settings.step, {}, state);
  std::array<double, measuredTimes.size()> spent{};
  int runs = 0;
  for (double all = 0.0; all < minSeconds || runs == 0; ++runs) {
    state = scene.start;
    double seconds = 0.0;
    int step = 0;
    for (std::size_t k = 0; k < measuredTimes.size(); ++k) {
      for (; step < stepsToMeasured[k]; ++step) {
        checkStop();
        const double begin = threadSeconds();
        stepper.step(*scene.model, settings.step, {}, state);
        seconds += threadSeconds() - begin;
      }
      spent[k] += seconds;
    }
    all += seconds;
  }
  for (std::size_t k = 0; k < spent.size(); ++k) {
    spent[k] *= microseconds / measuredTimes[k] / runs;
  }
  return spent;
}

/// The row of a setting at a time, before any result.
ReportRow emptyRow(ClothWithReference& cloth, const Entry& entry, double time) {
  return {{"scene", cloth.name()},
          {"resolution", resolutionJson(cloth.resolution())},
          {"material", cloth.material().name},
          {"stiffness", cloth.material().isFabric() ? ReportRow(nullptr) : ReportRow(*cloth.material().stiffness)},
          {"time", time},
          {"method", entry.curve.method},
          {"curve", entry.curve.label},
          {"setting", entry.setting()},
          {"us_per_simulated_second", nullptr},
          {"samples", ReportRow::array()},
          {"error_mean", nullptr},
          {"error_rms", nullptr},
          {"error_of_diagonal", nullptr},
          {"error_median", nullptr},
          {"error_low", nullptr},
          {"error_high", nullptr},
          {"seeds", 0},
          {"eps", nullptr},
          {"S", nullptr},
          {"motion_kept", nullptr},
          {"state", "no reference"},
          {"reference_difference", nullptr},
          {"noise_floor", nullptr},
          {"trusted", false}};
}

/// The result of a run at a measured time; empty when it did not reach it.
std::optional<ErrorSummary> summaryAt(const scene::Scene& scene, const Trajectory& own, const Reference& reference,
                                      const ErrorReport& report, double time) {
  const auto summaries = summarise(*scene.model, own, reference, report, std::array{time});
  return own.checkpoints() >= checkpointsIn(time) && !summaries.empty() ? std::optional(summaries.front())
                                                                        : std::nullopt;
}

/// A run of a setting, from the original start (seed 0) or a jittered one, compared with the reference.
struct MeasuredRun {
  Trajectory own;
  ErrorReport report;
};

MeasuredRun measuredRun(ClothWithReference& cloth, const settings::Settings& settings, const Reference& reference,
                        int seed, const TimeLimit& timeLimit) {
  const scene::Scene& scene = seed == 0 ? cloth.scene() : cloth.jitteredScene(seed);
  MeasuredRun run{runTrajectory(scene, settings, measuredCheckpoints, timeLimit.watch()), {}};
  run.report = compareWithReference(*scene.model, settings.step, run.own, reference);
  return run;
}

/// The same; empty when it takes too long.
std::optional<MeasuredRun> runInTime(ClothWithReference& cloth, const settings::Settings& settings,
                                     const Reference& reference, int seed, const TimeLimit& timeLimit) {
  try {
    return measuredRun(cloth, settings, reference, seed, timeLimit);
  } catch (const TooSlow&) {
    return std::nullopt;
  }
}

/// Writes the quality of the reference at the row's time. Returns whether it is sufficient for any comparison.
bool writeReference(const Reference& reference, double diagonal, ReportRow& row) {
  constexpr double useful = 0.01;  // of the diagonal
  const int checkpoint = checkpointsIn(row["time"]);
  row["trusted"] = reference.trusted >= checkpoint;
  if (checkpoint >= static_cast<int>(reference.differences.size())) {
    return false;
  }
  const double difference = reference.differences[checkpoint];
  row["reference_difference"] = finiteOrNull(difference);
  return difference <= useful * diagonal;
}

/// Writes the errors of the run from the original start.
void writeErrors(const scene::Scene& scene, const MeasuredRun& run, const Reference& reference, ReportRow& row) {
  if (!writeReference(reference, run.report.diagonal, row)) {
    return;
  }
  const auto summary = summaryAt(scene, run.own, reference, run.report, row["time"]);
  row["state"] = stateOf(summary.has_value(), summary.value_or(ErrorSummary{}), run.report.diagonal);
  if (summary) {
    row["error_mean"] = finiteOrNull(summary->meanError);
    row["error_rms"] = finiteOrNull(summary->rmsError);
    row["error_of_diagonal"] = finiteOrNull(summary->meanError / run.report.diagonal);
    row["eps"] = finiteOrNull(summary->meanEps);
    row["S"] = finiteOrNull(summary->meanSquaredCosine);
    row["motion_kept"] = finiteOrNull(summary->motionKept);
  }
}

/// Also runs from jittered starts, and writes the range of the errors and the median of all starts. `error_mean`
/// remains that of the original start, which another report reproduces to the last bit. Each run has the time limit for
/// itself. Only the run from the original start makes a setting too slow; if another one is, there is no range.
void writeSpread(ClothWithReference& cloth, const settings::Settings& settings, const Reference& reference,
                 const std::function<void()>& checkStop, double maxSeconds, ReportRows& rows) {
  std::vector<std::vector<double>> errors(rows.size());
  for (int seed = 1; seed <= seedCount; ++seed) {
    const TimeLimit timeLimit(checkStop, maxSeconds);
    const std::optional<MeasuredRun> run = runInTime(cloth, settings, reference, seed, timeLimit);
    if (!run) {
      return;
    }
    for (std::size_t k = 0; k < rows.size(); ++k) {
      const auto summary = summaryAt(cloth.jitteredScene(seed), run->own, reference, run->report, rows[k]["time"]);
      if (summary && std::isfinite(summary->meanError)) {
        errors[k].push_back(summary->meanError);
      }
    }
  }
  for (std::size_t k = 0; k < rows.size(); ++k) {
    if (errors[k].size() == static_cast<std::size_t>(seedCount)) {
      rows[k]["error_low"] = *std::min_element(errors[k].begin(), errors[k].end());
      rows[k]["error_high"] = *std::max_element(errors[k].begin(), errors[k].end());
      rows[k]["seeds"] = errors[k].size();
      errors[k].push_back(numberIn(rows[k], "error_mean"));
      rows[k]["error_median"] = finiteOrNull(medianOf(errors[k]));
    }
  }
}

bool isChaotic(const ReportRows& rows) {
  return std::any_of(rows.begin(), rows.end(), [](const ReportRow& row) {
    return row["noise_floor"].is_null() || numberIn(row, "noise_floor") > chaoticFloor;
  });
}

/// Errors at the measured times, without costs.
ReportRows measuredRows(ClothWithReference& cloth, const Entry& entry, const settings::Settings& settings,
                        const Limits& limits, const std::function<void()>& checkStop) {
  ReportRows rows;
  for (const double time : measuredTimes) {
    rows.push_back(emptyRow(cloth, entry, time));
  }
  const Reference* reference = cloth.reference(checkStop);
  if (reference == nullptr) {
    return rows;
  }
  for (ReportRow& row : rows) {
    row["noise_floor"] = finiteOrNull(cloth.noiseFloor(checkpointsIn(row["time"]), checkStop));
  }
  try {
    const TimeLimit timeLimit(checkStop, limits.maxSeconds);
    const MeasuredRun run = measuredRun(cloth, settings, *reference, 0, timeLimit);
    const double spent = timeLimit.spent();
    for (ReportRow& row : rows) {
      writeErrors(cloth.scene(), run, *reference, row);
    }
    // Rounding in float is accidental, too.
    const bool isAccidental = isChaotic(rows) || settings.step.precision == sim::Precision::Float;
    if (isAccidental && spent < maxJitteredSeconds) {
      writeSpread(cloth, settings, *reference, checkStop, limits.maxSeconds, rows);
    }
  } catch (const TooSlow&) {
    for (ReportRow& row : rows) {
      row["state"] = "too slow";
    }
  }
  return rows;
}

/// The expected duration of a run [s], from the previous one on its curve: proportional to the number of substeps,
/// sweeps or iterations, otherwise equal. 0 for the first of a curve.
double expectedSeconds(ClothWithReference& cloth, const Entry& entry, const ReportRows& section) {
  double seconds = 0.0;
  const WorkCloth own = workClothOf(emptyRow(cloth, entry, measuredTimes.back()));
  for (const ReportRow& row : section) {
    if (row.value("curve", "") == entry.curve.label && workClothOf(row) == own) {
      const bool slow = row.value("state", "") == "too slow";
      seconds = slow ? HUGE_VAL : numberIn(row, "us_per_simulated_second") * measuredTimes.back() / microseconds;
    }
  }
  const auto& values = entry.curve.values;
  const auto place = std::find(values.begin(), values.end(), entry.value);
  const bool counted =
      entry.curve.varied == "substeps" || entry.curve.varied == "sweeps" || entry.curve.varied == "iterations";
  const bool first = place == values.begin() || place == values.end();
  const double growth = counted && !first ? std::stod(*place) / std::stod(*(place - 1)) : 1.0;
  return growth * seconds;
}

ReportRows measureEntry(ClothWithReference& cloth, const Entry& entry, bool quick, const CellContext& context) {
  const Limits limits = limitsOf(quick, cloth);
  const settings::Settings settings = changedSettings(cloth.scene(), entry.assignments());
  ReportRows rows = context.own;
  if (rows.empty() && expectedSeconds(cloth, entry, context.section) > limits.maxSeconds) {
    for (const double time : measuredTimes) {
      rows.push_back(emptyRow(cloth, entry, time));
      rows.back()["state"] = "too slow";
    }
  } else if (rows.empty()) {
    rows = measuredRows(cloth, entry, settings, limits, context.checkStop);
  }
  const double last = numberIn(rows.back(), "us_per_simulated_second") * measuredTimes.back() / microseconds;
  // The damping of a fabric takes long once it exploded.
  const bool exploded = cloth.material().isFabric() && rows.back()["state"] == "exploded";
  if (rows.back()["state"] == "too slow" || exploded || last > limits.repeatedSeconds) {
    return rows;
  }
  const auto times = timedRun(cloth.scene(), settings, limits.timedSeconds, context.checkStop);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    rows[k]["samples"].push_back(times.at(k));
    rows[k]["us_per_simulated_second"] = medianOf(rows[k]["samples"].get<std::vector<double>>());
  }
  return rows;
}

void addCells(const SetUp& setUp, const ComparedCloth& plan, bool quick, std::vector<Cell>& cells) {
  const auto cloth = std::make_shared<ClothWithReference>(setUp, plan.resolution, plan.material, quick);
  const std::string name = setUp.name + " " + sizeText(plan.resolution) + " " + plan.material.title;
  // The durations of cells vary widely; these are about their means.
  const double weight = quick ? 0.03 : plan.material.isFabric() ? 0.1 : 0.045;
  for (const MethodCurve& curve : methodCurves()) {
    if (!isMeasuredOn(plan, curve)) {
      continue;
    }
    for (const std::string& value : valuesOn(plan, curve, quick)) {
      const Entry entry{curve, value};
      cells.push_back({name + ", " + curve.method + " " + entry.setting(), weight,
                       [=](const CellContext& context) { return measureEntry(*cloth, entry, quick, context); }});
    }
  }
}

SectionPlan plan(const ReportOptions& options) {
  SectionPlan plan;
  plan.rounds = 3;
  const std::vector<SetUp> setUps = comparedSetUps(options.scene);
  for (const SetUp& setUp : setUps) {
    const bool isFirst = setUp.name == setUps.front().name;
    for (const ComparedCloth& cloth : comparedCloths(setUp, isFirst, options.quick)) {
      addCells(setUp, cloth, options.quick, plan.cells);
    }
  }
  return plan;
}

}  // namespace

Section workPrecision() {
  return {"work_precision", "Error against cost", plan, showWorkPrecision};
}

}  // namespace drape::report::sections
