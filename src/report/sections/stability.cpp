#include "sim/forces/stability.hpp"
#include "report/number_text.hpp"
#include "report/sections/section_scene.hpp"
#include "report/sections/sections.hpp"
#include "report/sections/stability_rule.hpp"
#include "report/sections/time_limit.hpp"
#include "report/trajectory.hpp"
#include "sim/forces/diagnostics.hpp"
#include "sim/measures/measures.hpp"
#include "sim/solvers/solver.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <map>
#include <memory>
#include <set>
#include <string_view>
#include <utility>

namespace drape::report::sections {
namespace {

/// The time limit of a cell [s]. The report is about `auto` before all, so its stiff and fine cloths get the seconds
/// that they need.
double maxSeconds(const ReportOptions& options, std::string_view method) {
  return options.quick ? 5.0 : method == "auto" ? 4.0 : 0.4;
}

int checkpointsOf(const ReportOptions& options) {
  return checkpointsIn(options.quick ? 0.5 : 1.0);
}

/// The cloth of some cells, and its motion with small steps.
class Ground {
 public:
  Ground(ReportOptions options, int resolution, std::string stiffness)
      : options_(std::move(options)), resolution_(resolution), stiffness_(std::move(stiffness)) {}

  const scene::Scene& scene() {
    if (scene_ == nullptr) {
      scene_ = gridScene("grid", resolution_, {"stiffness=" + stiffness_, "precision=double", "threads=1"});
    }
    return *scene_;
  }

  /// Verlet at half of its stability limit, to measure the amount of motion.
  const Trajectory& motion(const Watch& watch) {
    if (motion_ == nullptr) {
      settings::Settings settings = changedSettings(scene(), {"solver=verlet"});
      const double limit = 0.5 * sim::verletStepLimit(*scene().model, settings.step);
      settings.step.timeStep = checkpointInterval;
      settings.step.substeps = static_cast<int>(std::ceil(checkpointInterval / limit));
      motion_ = std::make_unique<Trajectory>(runTrajectory(scene(), settings, checkpointsOf(options_), watch));
    }
    return *motion_;
  }

  [[nodiscard]] int resolution() const { return resolution_; }

 private:
  ReportOptions options_;
  int resolution_;
  std::string stiffness_;
  std::shared_ptr<const scene::Scene> scene_;
  std::unique_ptr<Trajectory> motion_;
};

/// The largest rise of the total energy above its start value after any step, in units of m g D.
double energyGain(const scene::Scene& scene, const sim::StepParameters& parameters, const Trajectory& run) {
  const sim::ClothModel& model = *scene.model;
  const double unit = model.totalMass() * parameters.gravity * sim::diagonalOf(model);
  return (run.largestEnergy - sim::energyOf(model, parameters, run.states.front()).total()) / unit;
}

double motionKeptOf(const sim::ClothModel& model, const Trajectory& own, const Trajectory& reference) {
  sim::MotionKept kept;
  for (std::size_t k = 1; k < std::min(own.states.size(), reference.states.size()); ++k) {
    kept.add(model, {own.states[k - 1].positions, own.states[k].positions, reference.states[k - 1].positions,
                     reference.states[k].positions});
  }
  return kept.value();
}

/// The row of the same cloth and method with a longer step that was too slow; null when there is none. A shorter step
/// takes at least as long.
const ReportRow* slowWithLongerSteps(const ReportRows& rows, const ReportRow& row) {
  const auto found = std::find_if(rows.begin(), rows.end(), [&row](const ReportRow& other) {
    const auto same = [&](const char* key) { return other.value(key, ReportRow()) == row[key]; };
    return same("method") && same("resolution") && same("stiffness") && other.value("state", "") == "too slow" &&
           numberIn(other, "step") > numberIn(row, "step");
  });
  return found == rows.end() ? nullptr : &*found;
}

ReportRows measureCell(Ground& ground, const std::string& method, const std::string& timeStep,
                       const ReportOptions& options, const CellContext& context) {
  Watch patient;
  patient.progress = [&context](std::string_view, std::int64_t, std::int64_t) { context.checkStop(); };
  const Trajectory& reference = ground.motion(patient);
  // A solve with more iterations would exceed the time limit, which is checked only between steps. The default cost
  // budget of `auto` takes seconds.
  const settings::Settings settings = changedSettings(
      ground.scene(), {"solver=" + method, "time_step=" + timeStep, "max_iterations=100", "auto.cost=50"});
  ReportRow row{{"method", method},
                {"resolution", ground.resolution()},
                {"stiffness", settings.step.material.stiffness},
                {"step", settings.step.timeStep}};
  if (const ReportRow* slow = slowWithLongerSteps(context.section, row)) {
    row["state"] = "too slow";
    row["seconds_at_least"] = slow->value("seconds_at_least", maxSeconds(options, method));
    return {row};
  }
  const TimeLimit timeLimit(context.checkStop, maxSeconds(options, method));
  double share = 0.0;  // of the run that is done
  Watch watch;
  watch.progress = [&](std::string_view, std::int64_t done, std::int64_t total) {
    share = static_cast<double>(done) / static_cast<double>(total);
    timeLimit.check();
  };
  watch.energyPeak = true;
  try {
    const Trajectory own = runTrajectory(ground.scene(), settings, checkpointsOf(options), watch);
    const StabilityFigures figures{own.finite, energyGain(ground.scene(), settings.step, own),
                                   motionKeptOf(*ground.scene().model, own, reference)};
    row["state"] = stabilityState(figures);
    row["energy_gain"] = finiteOrNull(figures.energyGain);
    row["motion_kept"] = finiteOrNull(figures.motionKept);
  } catch (const TooSlow&) {
    row["state"] = "too slow";
    row["seconds_at_least"] = share > 0.0 ? timeLimit.spent() / share : maxSeconds(options, method);
  }
  return {row};
}

/// The words, separated by blanks.
std::string keyOf(std::initializer_list<std::string_view> words) {
  std::string key;
  for (const std::string_view word : words) {
    key += key.empty() ? "" : " ";
    key += word;
  }
  return key;
}

SectionPlan plan(const ReportOptions& options) {
  using Words = std::vector<std::string>;
  const std::vector<int> sizes = options.quick ? std::vector{17} : std::vector{17, 33, 65};
  const Words stiffnesses = options.quick ? Words{"10", "1000"} : Words{"10", "100", "1000", "10000", "100000"};
  const Words steps =
      options.quick ? Words{"1/30", "1/150"} : Words{"1/30", "1/60", "1/150", "1/300", "1/600", "1/1200"};
  SectionPlan plan;
  for (const int resolution : sizes) {
    for (const std::string& stiffness : stiffnesses) {
      const auto ground = std::make_shared<Ground>(options, resolution, stiffness);
      for (const sim::SolverInfo& solver : sim::solverTable()) {
        for (const std::string& step : steps) {
          const std::string method(solver.name);
          plan.cells.push_back({keyOf({method, gridText(resolution), stiffness, "N/m", step, "s"}),
                                options.quick ? 0.05 : 1e-4 * resolution * resolution, [=](const CellContext& context) {
                                  return measureCell(*ground, method, step, options, context);
                                }});
        }
      }
    }
  }
  return plan;
}

const std::vector<MapState>& states() {
  static const std::vector<MapState> all{{"calm", "C", Tone::Good},     {"rattles", "R", Tone::Doubtful},
                                         {"explodes", "X", Tone::Bad},  {"frozen", "F", Tone::Dull},
                                         {"too slow", "-", Tone::None}, {"not measured", "", Tone::None}};
  return all;
}

int indexOf(const std::string& state) {
  const auto found =
      std::find_if(states().begin(), states().end(), [&](const MapState& known) { return known.name == state; });
  return static_cast<int>(std::min<std::ptrdiff_t>(found - states().begin(), std::ssize(states()) - 1));
}

/// A method's map: a row per cloth, a column per step, the longest first.
StateMap mapOf(const std::string& method, const ReportRows& rows) {
  StateMap map{"stability-" + method, method, "time step", {}, {}, states()};
  std::set<double, std::greater<>> steps;
  std::map<std::pair<int, double>, std::map<double, std::string>> cloths;
  for (const ReportRow& row : rows) {
    if (row.value("method", "") == method) {
      steps.insert(numberIn(row, "step"));
      cloths[{row.value("resolution", 0), numberIn(row, "stiffness")}][numberIn(row, "step")] = row.value("state", "");
    }
  }
  for (const double step : steps) {
    map.columns.push_back(stepText(step));
  }
  for (const auto& [cloth, own] : cloths) {
    StateMap::Row line{gridText(cloth.first) + ", " + text::figure(cloth.second, 6) + " N/m", {}};
    for (const double step : steps) {
      const auto found = own.find(step);
      line.cells.push_back(indexOf(found == own.end() ? "" : found->second));
    }
    map.rows.push_back(line);
  }
  return map;
}

/// The paper's claim, compared with the cells of its method.
std::string claimText(const ReportRows& rows) {
  std::map<std::string, int> counts;
  int all = 0;
  std::string first;
  for (const ReportRow& row : rows) {
    const std::string state = row.value("state", "");
    if (row.value("method", "") == "one_iteration") {
      ++counts[state];
      ++all;
      if (first.empty() && (state == "rattles" || state == "explodes")) {
        first = gridText(row.value("resolution", 0)) + " with " + figure(row, "stiffness", 6) + " N/m at " +
                stepText(numberIn(row, "step"));
      }
    }
  }
  std::string text = "The paper claims sufficient stability at large steps. Of " + std::to_string(all) +
                     " cloths and steps tried here with one_iteration " + std::to_string(counts["calm"]) +
                     " are calm, " + std::to_string(counts["rattles"]) + " rattle, " +
                     std::to_string(counts["explodes"]) + " explode and " + std::to_string(counts["frozen"]) +
                     " are frozen";
  return text + (first.empty() ? ". For these the claim holds." : "; the first unstable one is " + first + ".");
}

/// Names the cells of `auto` whose state is unknown because they take too long.
std::string slowText(const ReportRows& rows) {
  int all = 0;
  int slow = 0;
  std::map<std::string, std::string> cloths;
  for (const ReportRow& row : rows) {
    if (row.value("method", "") != "auto") {
      continue;
    }
    ++all;
    if (row.value("state", "") == "too slow") {
      ++slow;
      std::string& text =
          cloths[gridText(row.value("resolution", 0)) + " with " + figure(row, "stiffness", 6) + " N/m"];
      text += (text.empty() ? " at " : ", ") + stepText(numberIn(row, "step")) + " (about " +
              figure(row, "seconds_at_least", 2) + " s)";
    }
  }
  std::string text = "Of the " + std::to_string(all) + " cells of auto " + std::to_string(slow) +
                     (slow == 1 ? " is" : " are") + " unknown because the run would take too long";
  for (const auto& [cloth, steps] : cloths) {
    text += (text.ends_with("long") ? ": " : "; ") + cloth + steps;
  }
  return text + ".";
}

std::vector<Block> show(const ReportOptions& options, const ReportRows& rows) {
  std::vector<Block> blocks;
  blocks.emplace_back(Paragraph{
      "The scene 'grid' (flat, at rest, two pinned corners, no damping, no air) with every method's default settings. "
      "This cloth gets no external energy. Explodes: the state is not finite, or the energy after a step has risen by "
      "more "
      "than " +
      text::figure(explodingGain) +
      " m g D above its start value, with D the diagonal of the cloth. Rattles: by more than " +
      text::figure(rattlingGain) + " m g D. Frozen: it keeps less than " + text::figure(frozenMotion) +
      " of the motion that Verlet has at half of its stability limit. Calm: none of these. Too slow: given up after " +
      text::figure(maxSeconds(options, "")) + " s, with auto after " + text::figure(maxSeconds(options, "auto")) +
      " s."});
  blocks.emplace_back(Paragraph{claimText(rows)});
  blocks.emplace_back(Paragraph{slowText(rows)});
  std::vector<std::string> methods;
  for (const ReportRow& row : rows) {
    const std::string method = row.value("method", "");
    if (std::find(methods.begin(), methods.end(), method) == methods.end()) {
      methods.push_back(method);
      blocks.emplace_back(mapOf(method, rows));
    }
  }
  return blocks;
}

}  // namespace

Section stability() {
  return {"stability", "Stability", plan, show};
}

}  // namespace drape::report::sections
