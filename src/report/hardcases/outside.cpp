#include "report/hardcases/attach_to.hpp"
#include "report/hardcases/cases.hpp"
#include "report/hardcases/watched_cloth.hpp"
#include "sim/forces/diagnostics.hpp"

#include <algorithm>

/// Cases of external actions on the cloth.
namespace drape::report::hardcases {
namespace {

Vec3 meanVelocity(const sim::ClothModel& model, const sim::ClothState& state) {
  Vec3 momentum = Vec3::Zero();
  for (std::size_t v = 0; v < state.velocities.size(); ++v) {
    momentum += model.vertexMass[v] * state.velocities[v];
  }
  return momentum / model.totalMass();
}

}  // namespace

void pinsTeleport(CaseTrial& trial) {
  constexpr double stretchLimit = 5.0;  // [%]
  WatchedCloth watched(
      trial, sheetCloth(trial.settings({"stiffness=5000", "damping=0.1"}), trial.pick(33, 17), Pinned::TwoCorners));
  watched.run(trial.pick(1.0, 0.2));
  watched.apply(session::MovePinsCommand{Vec3(6.0, 8.0, 0.0)});
  watched.run(2.0);
  trial.expect("stretch after 2 s", "%", 100.0 * sim::maxStretch(watched.model(), watched.state()), stretchLimit);
}

void storm(CaseTrial& trial) {
  constexpr double reversedLimit = 0.01;
  settings::Settings settings = trial.settings({"stiffness=1000", "drag=1", "lift=0.5"});
  settings.step.air.wind = Vec3(0.0, 0.0, 1e3);  // ten times the maximum of the setting
  const int resolution = trial.pick(33, 17);
  WatchedCloth free(trial, sheetCloth(settings, resolution, Pinned::Nowhere, 1.0, true), EnergyRule::WindFrame);
  const Vec3 wind = settings.step.air.wind;
  const auto steps = trial.pick(150, 40);
  for (int i = 0; i < steps; ++i) {
    free.step();
    const double along = (meanVelocity(free.model(), free.state()) - wind).dot(-wind) / wind.squaredNorm();
    trial.expect("relative velocity reversed", "of the wind", std::max(0.0, -along), reversedLimit);
  }
  WatchedCloth pinned(trial, sheetCloth(settings, resolution, Pinned::TwoCorners, 1.0, true), EnergyRule::NotCounted);
  pinned.run(trial.pick(1.0, 0.2));
  trial.show("stretch of pinned cloth", "", sim::maxStretch(pinned.model(), pinned.state()));
}

void thrown(CaseTrial& trial) {
  const int resolution = trial.pick(33, 17);
  WatchedCloth watched(
      trial, sheetCloth(trial.settings({"stiffness=1000", "attachment.stiffness=1e4", "attachment.max_force=100"}),
                        resolution, Pinned::TwoCorners));
  watched.run(trial.pick(0.3, 0.1));
  const settings::Settings& settings = watched.simulation().settings();
  const int vertex = (resolution / 2) * resolution + resolution / 2;
  const auto point = [&] { return watched.state().positions[vertex]; };
  const Vec3 velocity(60.0, 80.0, 0.0);  // [m/s]
  Vec3 target = point();
  watched.apply(attachTo(watched.model(), vertex, target));
  for (double time = 0.0; time < 0.1; time += settings.step.timeStep) {
    target += settings.step.timeStep * velocity;
    watched.apply(session::MoveAttachmentCommand{target});
    const Vec3 before = point();
    watched.step([&] { return settings.attachment.maxForce * (point() - before).norm(); });
  }
  watched.apply(session::DetachCommand{});
  watched.run(trial.pick(2.0, 0.5));
  trial.show("stretch at the end", "", sim::maxStretch(watched.model(), watched.state()));
}

}  // namespace drape::report::hardcases
