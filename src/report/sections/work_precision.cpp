#include "report/error_report.hpp"
#include "report/number_text.hpp"
#include "report/sections/method_curves.hpp"
#include "report/sections/section_scene.hpp"
#include "report/sections/sections.hpp"
#include "report/sections/work_precision_view.hpp"
#include "report/timing.hpp"
#include "sim/error.hpp"

#include <array>
#include <memory>
#include <utility>

namespace drape {
namespace {

constexpr std::array judgedTimes{0.2, 0.5};  // [s]
constexpr int checkpoints = 15;              // up to the last of these
constexpr std::array stepsTo{30, 75};        // of 1/150 s, up to each of them

/// What all methods are held against on one cloth; made when the first of them needs it.
class Ground {
 public:
  Ground(ReportOptions options, int resolution, std::string stiffness)
      : options_(std::move(options)), resolution_(resolution), stiffness_(std::move(stiffness)) {}

  const Scene& scene() {
    if (scene_ == nullptr) {
      scene_ = gridScene(options_.scene, resolution_,
                         {"time_step=1/150", "stiffness=" + stiffness_, "precision=double", "threads=1"});
    }
    return *scene_;
  }

  /// Null when small steps come to no end here.
  const Reference* reference(const std::function<void()>& mayStop) {
    if (!tried_) {
      ConvergenceTolerance tolerance;
      tolerance.absolute = options_.quick ? 1e-5 : 1e-6;
      tolerance.mostWork = options_.quick ? 1e8 : 5e8;
      const auto watch = [&mayStop](std::string_view, std::int64_t, std::int64_t) { mayStop(); };
      try {
        reference_ = std::make_unique<Reference>(
            convergedReference(scene(), convergedSettings(scene().settings), checkpoints, tolerance, watch));
      } catch (const InputError&) {
        reference_ = nullptr;
      }
      tried_ = true;
    }
    return reference_.get();
  }

  [[nodiscard]] int resolution() const { return resolution_; }
  [[nodiscard]] const std::string& stiffness() const { return stiffness_; }

 private:
  ReportOptions options_;
  int resolution_;
  std::string stiffness_;
  std::shared_ptr<const Scene> scene_;
  std::unique_ptr<Reference> reference_;
  bool tried_ = false;
};

/// A method with its setting.
struct Entry {
  MethodCurve curve;
  std::string value;

  [[nodiscard]] std::vector<std::string> assignments() const {
    std::vector<std::string> all{"solver=" + curve.method};
    all.insert(all.end(), curve.fixed.begin(), curve.fixed.end());
    all.push_back(curve.varied + "=" + value);
    return all;
  }

  /// "substeps=4 iterations=1": what the user would set besides the solver.
  [[nodiscard]] std::string setting() const {
    std::string text = curve.varied + "=" + value;
    for (const std::string& fixed : curve.fixed) {
      text += " " + fixed;
    }
    return text;
  }
};

/// Wall-clock time of the whole run up to each judged time, for a simulated second [us], the mean of as many runs as a
/// clock needs to be exact. The solver has been set up before.
std::array<double, judgedTimes.size()> timedRun(const Scene& scene, const Settings& settings, double leastSeconds,
                                                const std::function<void()>& mayStop) {
  constexpr double microseconds = 1e6;
  Stepper stepper(settings.solver.name);
  ClothState state = scene.start;
  stepper.step(*scene.model, settings.step, {}, state);
  std::array<double, judgedTimes.size()> spent{};
  int runs = 0;
  for (double all = 0.0; all < leastSeconds || runs == 0; ++runs) {
    state = scene.start;
    double seconds = 0.0;
    int step = 0;
    for (std::size_t k = 0; k < judgedTimes.size(); ++k) {
      for (; step < stepsTo[k]; ++step) {
        mayStop();
        seconds += secondsOf([&] { stepper.step(*scene.model, settings.step, {}, state); });
      }
      spent[k] += seconds;
    }
    all += seconds;
  }
  for (std::size_t k = 0; k < spent.size(); ++k) {
    spent[k] *= microseconds / judgedTimes[k] / runs;
  }
  return spent;
}

/// The row of a setting at a time, before anything is known of it.
ReportRow emptyRow(Ground& ground, const Entry& entry, const Settings& settings, double time) {
  return {{"scene", ground.scene().description.name},
          {"resolution", ground.resolution()},
          {"stiffness", settings.step.stiffness},
          {"time", time},
          {"method", entry.curve.method},
          {"curve", entry.curve.label},
          {"setting", entry.setting()},
          {"us_per_simulated_second", nullptr},
          {"samples", ReportRow::array()},
          {"error_mean", nullptr},
          {"error_rms", nullptr},
          {"eps", nullptr},
          {"S", nullptr},
          {"motion_kept", nullptr},
          {"state", "no reference"},
          {"reference_difference", nullptr},
          {"trusted", false}};
}

/// Writes the errors at the row's time into it.
void judgeRow(const Scene& scene, const Trajectory& own, const Reference& reference, const ErrorReport& report,
              ReportRow& row) {
  const std::array time{row["time"].get<double>()};
  const int checkpoint = checkpointsIn(time[0]);
  const auto summaries = summarise(*scene.model, own, reference, report, time);
  const bool reached = own.checkpoints() >= checkpoint && !summaries.empty();
  const ErrorSummary summary = reached ? summaries.front() : ErrorSummary{};
  if (reached) {
    row["error_mean"] = finiteOrNull(summary.meanError);
    row["error_rms"] = finiteOrNull(summary.rmsError);
    row["eps"] = finiteOrNull(summary.meanEps);
    row["S"] = finiteOrNull(summary.meanSquaredCosine);
    row["motion_kept"] = finiteOrNull(summary.motionKept);
  }
  row["state"] = stateOf(reached, summary, report.diagonal);
  if (checkpoint < static_cast<int>(reference.differences.size())) {
    row["reference_difference"] = finiteOrNull(reference.differences[static_cast<std::size_t>(checkpoint)]);
  }
  row["trusted"] = reference.trusted >= checkpoint;
}

/// Errors at the judged times, without what they cost.
ReportRows judgedRows(Ground& ground, const Entry& entry, const Settings& settings,
                      const std::function<void()>& mayStop) {
  ReportRows rows;
  for (const double time : judgedTimes) {
    rows.push_back(emptyRow(ground, entry, settings, time));
  }
  if (const Reference* reference = ground.reference(mayStop)) {
    Watch watch;
    watch.progress = [&mayStop](std::string_view, std::int64_t, std::int64_t) { mayStop(); };
    const Trajectory own = runTrajectory(ground.scene(), settings, checkpoints, watch);
    const ErrorReport report = judge(*ground.scene().model, settings.step, own, *reference);
    for (ReportRow& row : rows) {
      judgeRow(ground.scene(), own, *reference, report, row);
    }
  }
  return rows;
}

/// Whether a run took so long that what disturbs the clock does not matter, and repeats would only cost time.
bool isLong(const ReportRows& rows) {
  constexpr double longRun = 1e6;  // [us]
  const ReportRow& last = rows.back();
  return numberIn(last, "us_per_simulated_second") * numberIn(last, "time") > longRun;
}

ReportRows measureEntry(Ground& ground, const Entry& entry, bool quick, const CellContext& context) {
  const Settings settings = changedSettings(ground.scene(), entry.assignments());
  ReportRows rows = context.own.empty() ? judgedRows(ground, entry, settings, context.mayStop) : context.own;
  if (isLong(rows)) {
    return rows;
  }
  const auto times = timedRun(ground.scene(), settings, quick ? 2e-3 : 2e-2, context.mayStop);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    rows[k]["samples"].push_back(times.at(k));
    rows[k]["us_per_simulated_second"] = medianOf(rows[k]["samples"].get<std::vector<double>>());
  }
  return rows;
}

SectionPlan plan(const ReportOptions& options) {
  SectionPlan plan;
  plan.rounds = options.quick ? 3 : 5;
  const std::vector<int> sizes = options.quick ? std::vector{17} : std::vector{17, 33};
  const std::vector<std::string> stiffnesses =
      options.quick ? std::vector<std::string>{"10"} : std::vector<std::string>{"10", "1000"};
  for (const int resolution : sizes) {
    for (const std::string& stiffness : stiffnesses) {
      const auto ground = std::make_shared<Ground>(options, resolution, stiffness);
      for (const MethodCurve& curve : methodCurves()) {
        for (const std::string& value : options.quick ? curve.quick : curve.values) {
          const Entry entry{curve, value};
          plan.cells.push_back(
              {gridText(resolution) + " " + stiffness + " N/m, " + curve.method + " " + entry.setting(),
               options.quick ? 0.1 : 0.3, [=, quick = options.quick](const CellContext& context) {
                 return measureEntry(*ground, entry, quick, context);
               }});
        }
      }
    }
  }
  return plan;
}

}  // namespace

Section sections::workPrecision() {
  return {"work_precision", "Error against work", plan, showWorkPrecision};
}

}  // namespace drape
