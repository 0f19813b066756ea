#include "report/hardcases/watched_cloth.hpp"

#include "sim/forces/diagnostics.hpp"
#include "sim/measures/measures.hpp"
#include "sim/solvers/solver.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace drape::report::hardcases {
namespace {

constexpr double farAway = 1e5;    // [m]
constexpr double gainLimit = 1.0;  // [% of the scale]
constexpr double percent = 100.0;

std::shared_ptr<const scene::Scene> withStableSubsteps(const std::shared_ptr<const scene::Scene>& scene) {
  auto copy = std::make_shared<scene::Scene>(*scene);
  copy->settings.step.substeps = stableSubsteps(*scene->model, scene->settings);
  return copy;
}

}  // namespace

std::shared_ptr<const scene::Scene> sceneOf(const CaseCloth& cloth) {
  auto scene = std::make_shared<scene::Scene>();
  scene->description.name = "hard case";
  scene->settings = cloth.settings;
  scene->model = modelOf(cloth);
  scene->bodies = std::make_shared<const std::vector<sim::contact::Body>>(cloth.bodies);
  scene->start = sim::stateAtRest(cloth.start.empty() ? cloth.mesh.positions : cloth.start);
  if (!cloth.velocities.empty()) {
    scene->start.velocities = cloth.velocities;
  }
  return scene;
}

WatchedCloth::WatchedCloth(CaseTrial& trial, const CaseCloth& cloth, EnergyRule rule)
    : WatchedCloth(trial, sceneOf(cloth), rule) {}

WatchedCloth::WatchedCloth(CaseTrial& trial, const std::shared_ptr<const scene::Scene>& scene, EnergyRule rule)
    : trial_(trial), rule_(rule), simulation_(withStableSubsteps(scene)) {
  simulation_.setProgressCallback([&trial] { trial.tick(); });
  const sim::SolverInfo* solver = sim::findSolver(simulation_.settings().solver.name);
  if (solver->warning != nullptr) {
    if (const auto warning = solver->warning(model(), simulation_.settings().step)) {
      trial_.warn(*warning);
    }
  }
  startEnergyCount();
}

void WatchedCloth::step(const std::function<double()>& work) {
  trial_.tick();
  simulation_.step();
  allowed_ += work ? work() : 0.0;
  watch();
}

void WatchedCloth::run(double seconds) {
  const auto steps = std::lround(seconds / simulation_.settings().step.timeStep);
  for (long i = 0; i < steps; ++i) {
    step();
  }
}

void WatchedCloth::apply(const session::Command& command) {
  simulation_.apply(command);
  if (std::holds_alternative<session::SetSettingCommand>(command) ||
      std::holds_alternative<session::MovePinsCommand>(command)) {
    keepStable();
    startEnergyCount();
  }
}

void WatchedCloth::countEnergy() {
  rule_ = EnergyRule::Counted;
  startEnergyCount();
}

void WatchedCloth::keepStable() {
  const int needed = stableSubsteps(model(), simulation_.settings());
  if (needed > simulation_.settings().step.substeps) {
    simulation_.apply(session::SetSettingCommand{"substeps", needed});
  }
}

double WatchedCloth::energy() const {
  if (rule_ != EnergyRule::WindFrame) {
    return sim::energyOf(model(), simulation_.settings().step, state()).total();
  }
  sim::ClothState against = state();
  for (Vec3& velocity : against.velocities) {
    velocity -= simulation_.settings().step.air.wind;
  }
  return sim::energyOf(model(), simulation_.settings().step, against).total();
}

void WatchedCloth::startEnergyCount() {
  const sim::StepParameters& parameters = simulation_.settings().step;
  const sim::Energy now = sim::energyOf(model(), parameters, state());
  startEnergy_ = energy();
  allowed_ = 0.0;
  scale_ = model().totalMass() * parameters.gravity * sim::diagonalOf(model()) + startEnergy_ - now.potential;
}

void WatchedCloth::watch() {
  if (simulation_.blewUp()) {
    throw CaseEnded{"The state was no longer finite after " + std::to_string(state().time) + " s."};
  }
  const auto& positions = state().positions;
  const double maxDistance = std::accumulate(positions.begin(), positions.end(), 0.0, [](double max, const Vec3& x) {
    return std::max(max, x.lpNorm<Eigen::Infinity>());
  });
  trial_.expect("max distance", "m", maxDistance, farAway);
  if (rule_ != EnergyRule::NotCounted) {
    const double gained = percent * (energy() - startEnergy_ - allowed_) / scale_;
    trial_.expect("energy gained", "%", gained < 0.0 ? 0.0 : gained, gainLimit);
  }
  if (maxDistance > farAway) {
    throw CaseEnded{"Its coordinates exceed the limit after " + std::to_string(state().time) + " s."};
  }
}

double largestStrain(const sim::ClothModel& model, const sim::ClothState& state) {
  double largest = 0.0;
  for (const sim::Spring& spring : model.springs) {
    if (spring.restLength > 0.0) {
      const double length = (state.positions[spring.b] - state.positions[spring.a]).norm();
      largest = std::max(largest, std::abs(length / spring.restLength - 1.0));
    }
  }
  return largest;
}

double largestSpeed(const sim::ClothState& state) {
  return std::accumulate(state.velocities.begin(), state.velocities.end(), 0.0,
                         [](double max, const Vec3& v) { return std::max(max, v.norm()); });
}

}  // namespace drape::report::hardcases
