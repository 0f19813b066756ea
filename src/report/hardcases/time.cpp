#include "report/hardcases/cases.hpp"
#include "report/hardcases/watched_cloth.hpp"
#include "session/pacer.hpp"
#include "sim/forces/diagnostics.hpp"

#include <algorithm>
#include <cmath>

/// Cases of frame times and time steps.
namespace drape::report::hardcases {
namespace {

/// Takes that number of steps as a viewer with these frame times does.
template <typename FrameTime>
std::uint64_t hashAfter(CaseTrial& trial, const CaseCloth& cloth, int steps, FrameTime&& frameTime) {
  WatchedCloth watched(trial, cloth);
  session::Pacer pacer;
  int taken = 0;
  while (taken < steps) {
    pacer.collect(frameTime(), 1.0);
    while (taken < steps && pacer.takeStep(watched.simulation().settings().step.timeStep)) {
      watched.step();
      ++taken;
    }
  }
  return sim::stateHash(watched.state());
}

}  // namespace

void randomFrames(CaseTrial& trial) {
  constexpr double shortest = 0.001;  // [s]
  constexpr double longest = 0.1;     // [s]
  const CaseCloth cloth = sheetCloth(trial.settings({"stiffness=1000"}), trial.pick(33, 17), Pinned::TwoCorners);
  const int steps = trial.pick(450, 60);
  CaseNumbers random(11);
  const auto uneven = hashAfter(trial, cloth, steps, [&] { return shortest + (longest - shortest) * random.next(); });
  const auto even = hashAfter(trial, cloth, steps, [] { return 1.0 / 60.0; });
  trial.expect("hashes that differ", "", uneven == even ? 0.0 : 1.0, 0.0);
}

void changedWhileRunning(CaseTrial& trial) {
  constexpr double jumpLimit = 1.0;  // edges
  WatchedCloth watched(
      trial, sheetCloth(trial.settings({"stiffness=1000", "damping=0.05"}), trial.pick(33, 17), Pinned::TwoCorners));
  const auto jump = [&](const session::Command& command) {
    watched.apply(command);
    const sim::ClothState before = watched.state();
    watched.step();
    const double h = watched.simulation().settings().step.timeStep;
    double largest = 0.0;
    for (std::size_t v = 0; v < before.positions.size(); ++v) {
      const Vec3 expected = before.positions[v] + h * before.velocities[v];
      largest = std::max(largest, (watched.state().positions[v] - expected).norm());
    }
    trial.expect("jump", "edges", largest / sim::meanEdge(watched.model()), jumpLimit);
    watched.run(0.1);
  };
  watched.run(trial.pick(2.0, 1.0));
  jump(session::SetSettingCommand{"stiffness", 1e5});
  jump(session::SetSettingCommand{"time_step", 1.0 / 60.0});
  jump(session::SetSettingCommand{"stiffness", 1e3});
  jump(session::SetSettingCommand{"time_step", 1.0 / 300.0});
}

void longSteps(CaseTrial& trial) {
  for (const char* step : {"time_step=1/30", "time_step=1/24", "time_step=1/15"}) {
    WatchedCloth watched(trial,
                         sheetCloth(trial.settings({"stiffness=1000", step}), trial.pick(33, 17), Pinned::TwoCorners));
    watched.run(trial.pick(2.0, 0.5));
  }
}

}  // namespace drape::report::hardcases
