#include "report/hardcases/cases.hpp"
#include "report/hardcases/watched_cloth.hpp"
#include "sim/forces/diagnostics.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

/// Cases of cloth that should come to rest and stay there.
namespace drape::report::hardcases {
namespace {

/// The angular velocity of a cloth about a point [1/s]: L = I omega.
Vec3 turning(const sim::ClothModel& model, const sim::ClothState& state, const Vec3& about) {
  Mat3 inertia = Mat3::Zero();
  Vec3 momentum = Vec3::Zero();
  for (std::size_t v = 0; v < state.positions.size(); ++v) {
    const Vec3 arm = state.positions[v] - about;
    inertia += model.vertexMass[v] * (arm.squaredNorm() * Mat3::Identity() - arm * arm.transpose());
    momentum += model.vertexMass[v] * arm.cross(state.velocities[v]);
  }
  return inertia.ldlt().solve(momentum);
}

/// The mass-weighted root mean square speed [m/s].
double rmsSpeed(const sim::ClothModel& model, const sim::ClothState& state) {
  double sum = 0.0;
  for (std::size_t v = 0; v < state.velocities.size(); ++v) {
    sum += model.vertexMass[v] * state.velocities[v].squaredNorm();
  }
  return std::sqrt(sum / model.totalMass());
}

constexpr double speedLimit = 1e-3;  // [m/s]

/// At the end of the run: the speed and the oscillation of each vertex.
void expectRest(CaseTrial& trial, WatchedCloth& watched, double seconds) {
  constexpr double jitterLimit = 1e-4;  // share of an edge
  std::vector<Vec3> low = watched.state().positions;
  std::vector<Vec3> high = low;
  const auto steps = std::lround(seconds / watched.simulation().settings().step.timeStep);
  for (long i = 0; i < steps; ++i) {
    watched.step();
    trial.expect("speed at rest", "m/s", largestSpeed(watched.state()), speedLimit);
    for (std::size_t v = 0; v < low.size(); ++v) {
      low[v] = low[v].cwiseMin(watched.state().positions[v]);
      high[v] = high[v].cwiseMax(watched.state().positions[v]);
    }
  }
  double jitter = 0.0;
  for (std::size_t v = 0; v < low.size(); ++v) {
    jitter = std::max(jitter, (high[v] - low[v]).norm());
  }
  trial.expect("jitter", "of an edge", jitter / sim::meanEdge(watched.model()), jitterLimit);
}

}  // namespace

void oneCorner(CaseTrial& trial) {
  constexpr double turningLimit = 0.01;  // [1/s]
  const CaseCloth cloth =
      sheetCloth(trial.settings({"stiffness=1000", "damping=0.03"}), trial.pick(33, 9), Pinned::OneCorner);
  WatchedCloth watched(trial, cloth);
  watched.run(trial.pick(60.0, 40.0));
  const Vec3 pin = watched.state().positions[cloth.pins.front()];
  trial.expect("turning about its pin", "1/s", std::abs(turning(watched.model(), watched.state(), pin).y()),
               turningLimit);
  // Folded cloth creeps for a long time, since springs alone do not resist bending. Single vertices are not checked.
  trial.expect("speed at rest", "m/s", rmsSpeed(watched.model(), watched.state()), speedLimit);
}

void largeAtRest(CaseTrial& trial) {
  const CaseCloth cloth =
      sheetCloth(trial.settings({"stiffness=1000", "damping=0.03"}), trial.pick(100, 17), Pinned::TopEdge, 1.0, true);
  WatchedCloth watched(trial, cloth);
  watched.run(trial.pick(59.0, 9.5));
  expectRest(trial, watched, trial.pick(1.0, 0.5));
}

}  // namespace drape::report::hardcases
