#include "report/number_text.hpp"
#include "report/sections/section_scene.hpp"
#include "report/sections/sections.hpp"
#include "report/sections/set_ups.hpp"
#include "report/sections/stretch_limit_view.hpp"
#include "report/sections/time_limit.hpp"
#include "report/sections/work_material.hpp"
#include "sim/fabric/fabric.hpp"
#include "sim/forces/diagnostics.hpp"
#include "sim/measures/measures.hpp"
#include "sim/model/distances.hpp"
#include "sim/stepping/stepper.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <numeric>
#include <optional>
#include <utility>

namespace drape::report::sections {
namespace {

constexpr double timeStep = 1.0 / 150.0;
constexpr double movedTime = 0.5;  // at which the moving cloth is compared [s]
constexpr double freeTime = 1.5;   // after which the cloth is brought to rest [s]
/// So small that the limit alone decides how far the stiffness is lowered [millions of evaluations per second].
constexpr double smallBudget = 1.0;
constexpr double framesPerSecond = 60.0;
constexpr double microseconds = 1e6;

/// A run of `auto`.
struct LimitedRun {
  std::vector<Vec3> moved;       ///< positions at movedTime [m]
  std::vector<Vec3> rest;        ///< positions at the end [m]
  double movedCost = 0.0;        ///< CPU time per frame until movedTime [us]
  double laterCost = 0.0;        ///< the same from then until freeTime [us]
  double lowestStiffness = 1.0;  ///< factor on the stretch moduli [-]
  double restStiffness = 1.0;    ///< the same at the end [-]
  double largestStrain = 0.0;    ///< of strainsAlongYarns [-]
  double restStrain = 0.0;       ///< the same at the end [-]
  double restSpeed = 0.0;        ///< the largest of a vertex [m/s]
};

/// The largest speed of a vertex [m/s].
double speedOf(const sim::ClothState& state) {
  return std::accumulate(state.velocities.begin(), state.velocities.end(), 0.0,
                         [](double max, const Vec3& velocity) { return std::max(max, velocity.norm()); });
}

/// Brings the cloth to rest sooner: sets all velocities to zero whenever the kinetic energy begins to fall (dynamic
/// relaxation with kinetic damping).
class Relaxation {
 public:
  void act(const sim::ClothModel& model, sim::ClothState& state) {
    double energy = sim::kineticEnergy(model, state);
    if (energy < last_) {
      std::fill(state.velocities.begin(), state.velocities.end(), Vec3(Vec3::Zero()));
      energy = 0.0;
    }
    last_ = energy;
  }

 private:
  double last_ = 0.0;  // [J]
};

LimitedRun runLimited(const scene::Scene& scene, const sim::adaptive::AutoOptions& options, double seconds,
                      const std::function<void()>& checkStop) {
  sim::StepParameters parameters = scene.settings.step;
  parameters.automatic = options;
  Relaxation relaxation;
  sim::Stepper stepper(scene.settings.solver.name);
  sim::ClothState state = scene.start;
  LimitedRun run;
  const auto stepsIn = [](double time) { return static_cast<int>(std::lround(time / timeStep)); };
  for (int step = 1; step <= stepsIn(seconds); ++step) {
    checkStop();
    const double begin = threadSeconds();
    const sim::StepReport report = stepper.step(*scene.model, parameters, {}, state);
    if (step > 1 && step <= stepsIn(freeTime)) {  // the first step sets the solver up
      (step <= stepsIn(movedTime) ? run.movedCost : run.laterCost) += threadSeconds() - begin;
    }
    run.restStiffness = report.choice ? report.choice->stiffnessScale : 1.0;
    run.lowestStiffness = std::min(run.lowestStiffness, run.restStiffness);
    run.restStrain = sim::fabric::strainsAlongYarns(*scene.model, state.positions).front();
    run.largestStrain = std::max(run.largestStrain, run.restStrain);
    if (step == stepsIn(movedTime)) {
      run.moved = state.positions;
    }
    run.restSpeed = speedOf(state);
    if (step > stepsIn(freeTime)) {
      relaxation.act(*scene.model, state);
    }
  }
  run.movedCost *= microseconds / framesPerSecond / movedTime;
  run.laterCost *= microseconds / framesPerSecond / (freeTime - movedTime);
  run.rest = state.positions;
  return run;
}

/// A cloth in a preset, with its run at full stiffness and the default budget, which is made on first use.
class StretchGround {
 public:
  StretchGround(std::string name, int resolution, std::string preset, double seconds)
      : name_(std::move(name)), resolution_(resolution), preset_(std::move(preset)), seconds_(seconds) {}

  ReportRow measure(double limit, const std::function<void()>& checkStop) {
    prepare(checkStop);
    sim::adaptive::AutoOptions options = scene_->settings.step.automatic;
    options.strainLimit = limit;
    options.costBudget = smallBudget;
    const LimitedRun run = runLimited(*scene_, options, seconds_, checkStop);
    return {{"scene", name_},
            {"resolution", resolutionJson(resolution_)},
            {"material", preset_},
            {"strain_limit", limit},
            {"us_per_frame", run.movedCost},
            {"us_per_frame_later", run.laterCost},
            {"stiffness_lowest", run.lowestStiffness},
            {"stiffness_rest", run.restStiffness},
            {"moved_mean", finiteOrNull(sim::meanDistance(run.moved, full_->moved))},
            {"moved_max", finiteOrNull(sim::largestDistance(run.moved, full_->moved))},
            {"noise_moved", finiteOrNull(sim::meanDistance(jittered_->moved, full_->moved))},
            {"rest_mean", finiteOrNull(sim::meanDistance(run.rest, full_->rest))},
            {"rest_max", finiteOrNull(sim::largestDistance(run.rest, full_->rest))},
            {"noise_rest", finiteOrNull(sim::meanDistance(jittered_->rest, full_->rest))},
            {"strain_largest", finiteOrNull(run.largestStrain)},
            {"strain_rest", finiteOrNull(run.restStrain)},
            {"strain_largest_full", finiteOrNull(full_->largestStrain)},
            {"speed_rest", finiteOrNull(run.restSpeed)}};
  }

 private:
  void prepare(const std::function<void()>& checkStop) {
    if (full_) {
      return;
    }
    std::vector<std::string> settings = fabricOf(preset_).settings;
    settings.insert(settings.end(), {"solver=auto", "time_step=1/150", "substeps=1", "precision=float", "threads=1",
                                     "drag=1", "lift=0"});
    SetUp setUp{"corners", "", "grid"};
    setUp.corners = {"top_left", "top_right", "bottom_left", "bottom_right"};
    scene_ = buildSetUp(resolution_ == 0 ? comparedSetUps(name_).at(0) : setUp, resolution_, settings);
    constexpr double jitter = 1e-6;  // [m]
    const sim::adaptive::AutoOptions& options = scene_->settings.step.automatic;
    const LimitedRun full = runLimited(*scene_, options, seconds_, checkStop);
    jittered_ = runLimited(*jittered(*scene_, jitter, 1), options, seconds_, checkStop);
    full_ = full;
  }

  std::string name_;
  int resolution_;
  std::string preset_;
  double seconds_;  // [s]
  std::shared_ptr<const scene::Scene> scene_;
  std::optional<LimitedRun> full_;
  std::optional<LimitedRun> jittered_;
};

void addCells(const std::string& name, int resolution, bool quick, SectionPlan& plan) {
  const std::vector<std::string> presets = quick
                                               ? std::vector<std::string>{"cotton"}
                                               : std::vector<std::string>{"silk", "cotton", "linen", "denim", "jersey"};
  for (const std::string& preset : presets) {
    const auto ground = std::make_shared<StretchGround>(name, resolution, preset, quick ? freeTime : 3.5);
    for (const double limit : quick ? std::vector<double>{0.0, 0.01} : std::vector<double>{0.0, 0.003, 0.01, 0.03}) {
      plan.cells.push_back(
          {fmt::format("{} {} {}", name, preset, limit), quick ? 0.5 : 2.0,
           [=](const CellContext& context) -> ReportRows { return {ground->measure(limit, context.checkStop)}; }});
    }
  }
}

SectionPlan plan(const ReportOptions& options) {
  constexpr int resolution = 33;
  SectionPlan plan;
  addCells("corners", resolution, options.quick, plan);
  if (!options.quick) {
    addCells("tshirt", 0, options.quick, plan);
  }
  return plan;
}

}  // namespace

Section stretchLimit() {
  return {"stretch_limit", "Error of a lowered stretch stiffness", plan, showStretchLimit};
}

}  // namespace drape::report::sections
