#include "report/sections/budget_cloth.hpp"

#include "report/error_report.hpp"
#include "report/number_text.hpp"
#include "report/sections/section_scene.hpp"
#include "report/sections/set_ups.hpp"
#include "report/sections/time_limit.hpp"
#include "report/timing.hpp"
#include "settings/settings_table.hpp"
#include "sim/model/distances.hpp"
#include "sim/model/sim_error.hpp"
#include "sim/solvers/self_collision.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <limits>
#include <utility>
#include <variant>

namespace drape::report::sections {
namespace {

constexpr double microseconds = 1e6;
constexpr double milliseconds = 1e3;

/// The clock of a run: CPU time of this thread when the step has no others, otherwise the clock on the wall [s].
double now(int threads) {
  return threads == 1 ? threadSeconds()
                      : std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// A run and its cost.
struct TimedRun {
  Trajectory own;
  double perSecond = 0.0;  ///< computing time per simulated second, without the first step and its set-up [s]
};

/// Throws TooSlow when the run takes much longer than the most expensive one that is of interest.
TimedRun timedRun(const BudgetCloth& cloth, const settings::Settings& settings,
                  const std::function<void()>& checkStop) {
  constexpr double margin = 1.3;
  constexpr double setUp = 1.0;  // of the solver, and the first step [s]
  const int threads = settings.step.threads;
  const double duration = cloth.checkpoints * checkpointInterval;
  const double maxSeconds = setUp + margin * cloth.maxCost / milliseconds / frameSeconds * duration;
  const double begin = now(threads);
  double first = begin;  // the end of the first step
  double last = begin;
  bool started = false;
  Watch watch;
  watch.progress = [&](std::string_view, std::int64_t done, std::int64_t) {
    checkStop();
    last = now(threads);
    if (!started) {
      first = last;
      started = done >= 1;
    }
    if (last - begin > maxSeconds || last - first > maxSeconds - setUp) {
      throw TooSlow();
    }
  };
  TimedRun run{runTrajectory(*cloth.scene, settings, cloth.checkpoints, watch), 0.0};
  run.perSecond = (last - first) / std::max(settings.step.timeStep, duration - settings.step.timeStep);
  return run;
}

ReportRow emptyRow(const BudgetCloth& cloth, const MethodCurve& curve, const std::string& value) {
  std::string setting = curve.varied + "=" + value;
  for (const std::string& fixed : curve.fixed) {
    setting += " " + fixed;
  }
  const sim::ClothModel& model = *cloth.scene->model;
  return {{"kind", cloth.kind},
          {"scene", cloth.name},
          {"vertices", model.vertexCount()},
          {"triangles", model.triangles.size()},
          {"contact", contactText(*cloth.scene)},
          {"time", cloth.checkpoints * checkpointInterval},
          {"method", curve.method},
          {"curve", curve.label},
          {"setting", setting},
          {"us_per_simulated_second", nullptr},
          {"error_mean", nullptr},
          {"error_max", nullptr},
          {"error_of_diagonal", nullptr},
          {"motion_kept", nullptr},
          {"state", "too slow"},
          {"reference_step", nullptr},
          {"reference_difference", nullptr},
          {"noise_floor", nullptr}};
}

/// The states of work_precision, but cloth that hardly moves is not called frozen or exploded by its ratio of motions.
/// @param error mean distance from the reference, of the diagonal
const char* stateOf(bool finite, double error, double motionKept) {
  constexpr double visible = 1e-3;
  constexpr double frozen = 0.5;
  if (!finite || !(error <= 1.0)) {
    return "exploded";
  }
  return motionKept < frozen && error > visible ? "frozen" : "calm";
}

double valueAt(const std::vector<double>& values, int checkpoint) {
  const auto at = static_cast<std::size_t>(checkpoint);
  return at < values.size() ? values[at] : std::numeric_limits<double>::infinity();
}

/// Whether the reference is good enough at a checkpoint to measure errors by it.
bool isKnownAt(const ContactReference& known, int checkpoint, double diagonal) {
  constexpr double useful = 0.01;   // of the diagonal
  constexpr double alike = 2.0;     // in a chaotic motion, nothing is known better than two starts part
  constexpr double useless = 0.05;  // of the diagonal
  const double difference = valueAt(known.reference.differences, checkpoint);
  return difference <= useful * diagonal ||
         (difference <= alike * valueAt(known.parting, checkpoint) && difference <= useless * diagonal);
}

/// The last checkpoint from 0.1 s on at which the reference is good enough; without one, the last of all.
int lastKnown(const BudgetCloth& cloth) {
  constexpr int first = 3;
  const double diagonal = sim::diagonalOf(*cloth.scene->model);
  for (int checkpoint = cloth.checkpoints; checkpoint >= first; --checkpoint) {
    if (isKnownAt(*cloth.reference, checkpoint, diagonal)) {
      return checkpoint;
    }
  }
  return cloth.checkpoints;
}

/// Makes the reference on first use and writes how well it is known. Where it is not good enough at the end of the
/// motion, the errors count at an earlier time. False when it is of no use.
bool writeReference(BudgetCloth& cloth, const std::function<void()>& checkStop, ReportRow& row) {
  if (!cloth.reference) {
    cloth.reference =
        contactReference(*cloth.scene, cloth.scene->settings, cloth.checkpoints, cloth.referenceSeconds, checkStop);
    cloth.checkpoints = lastKnown(cloth);
  }
  const ContactReference& known = *cloth.reference;
  row["time"] = cloth.checkpoints * checkpointInterval;
  row["reference_step"] = known.reference.settings.step.timeStep;
  row["reference_difference"] = finiteOrNull(valueAt(known.reference.differences, cloth.checkpoints));
  row["noise_floor"] = finiteOrNull(valueAt(known.parting, cloth.checkpoints));
  return isKnownAt(known, cloth.checkpoints, sim::diagonalOf(*cloth.scene->model));
}

/// Writes state and errors of a run; without a usable reference, or of one that blew up, only the state.
void writeErrors(const BudgetCloth& cloth, const settings::Settings& settings, const Trajectory& own, bool known,
                 ReportRow& row) {
  const bool finite = own.checkpoints() == cloth.checkpoints;
  row["state"] = finite ? "no reference" : "exploded";
  if (!known || !finite) {
    return;
  }
  const Reference& reference = cloth.reference->reference;
  const ErrorReport report = compareWithReference(*cloth.scene->model, settings.step, own, reference);
  const auto summaries = summarise(*cloth.scene->model, own, reference, report, std::array{row["time"].get<double>()});
  const ErrorSummary summary = summaries.empty() ? ErrorSummary{} : summaries.front();
  row["state"] = stateOf(!summaries.empty(), summary.meanError / report.diagonal, summary.motionKept);
  row["error_mean"] = finiteOrNull(summary.meanError);
  row["error_of_diagonal"] = finiteOrNull(summary.meanError / report.diagonal);
  row["motion_kept"] = finiteOrNull(summary.motionKept);
  row["error_max"] = finiteOrNull(
      sim::largestDistance(own.states.back().positions,
                           reference.trajectory.states.at(static_cast<std::size_t>(cloth.checkpoints)).positions));
}

bool wasTooSlow(const ReportRows& section, const ReportRow& row) {
  return std::any_of(section.begin(), section.end(), [&](const ReportRow& other) {
    return other.value("scene", "") == row["scene"] && other.value("curve", "") == row["curve"] &&
           other.value("state", "") == "too slow";
  });
}

}  // namespace

std::shared_ptr<const scene::Scene> withSettledContact(const scene::Scene& scene,
                                                       const std::vector<std::string>& settings) {
  auto settled = std::make_shared<scene::Scene>(scene);
  settled->settings = changedSettings(scene, settings);
  sim::contact::ContactParameters& contact = settled->settings.step.contact;
  contact.self = sim::actingSelfCollision(contact.self, sim::findSolver(scene.settings.solver.name));
  return settled;
}

std::string contactText(const scene::Scene& scene) {
  const sim::contact::ContactParameters& contact = scene.settings.step.contact;
  const bool bodies = contact.bodies && !scene.bodies->empty();
  const bool self = contact.self != sim::contact::SelfCollision::Off;
  return bodies && self ? "bodies and itself" : bodies ? "bodies" : self ? "itself" : "off";
}

ReportRow measureBudgetSetting(BudgetCloth& cloth, const MethodCurve& curve, const std::string& value,
                               const CellContext& context) {
  constexpr double shortRun = 0.03;  // [s]; repeated, since the clock disturbs it
  ReportRow row = emptyRow(cloth, curve, value);
  if (wasTooSlow(context.section, row)) {
    return row;
  }
  std::vector<std::string> assignments{"solver=" + curve.method, curve.varied + "=" + value};
  assignments.insert(assignments.end(), curve.fixed.begin(), curve.fixed.end());
  const settings::Settings settings = changedSettings(*cloth.scene, assignments);
  const bool known = writeReference(cloth, context.checkStop, row);
  try {
    const TimedRun run = timedRun(cloth, settings, context.checkStop);
    writeErrors(cloth, settings, run.own, known, row);
    std::vector<double> costs{run.perSecond};
    while (run.perSecond < shortRun && costs.size() < 3) {
      costs.push_back(timedRun(cloth, settings, context.checkStop).perSecond);
    }
    row["us_per_simulated_second"] = finiteOrNull(microseconds * medianOf(costs));
  } catch (const TooSlow&) {
    row["state"] = "too slow";
  } catch (const sim::SimError&) {
    row["state"] = "exploded";
  }
  return row;
}

}  // namespace drape::report::sections
