#include "report/hardcases/cases.hpp"
#include "report/hardcases/momentum_kept.hpp"
#include "report/hardcases/watched_cloth.hpp"
#include "sim/forces/diagnostics.hpp"

#include <algorithm>
#include <cmath>

/// Cases of fabrics with an extreme start or motion.
namespace drape::report::hardcases {
namespace {

/// The kinetic and elastic energy [J].
double energyWithoutHeight(const WatchedCloth& watched) {
  const sim::Energy energy = sim::energyOf(watched.model(), watched.simulation().settings().step, watched.state());
  return energy.kinetic + energy.elastic;
}

/// Runs, and expects that damping leaves at most that share of the kinetic and elastic energy of the start.
void expectCalm(CaseTrial& trial, WatchedCloth& watched, double seconds, double share) {
  const double start = energyWithoutHeight(watched);
  watched.run(seconds);
  trial.expect("energy left", "of the start", energyWithoutHeight(watched) / start, share);
}

/// A vector with components from -1 to 1.
Vec3 randomVector(CaseNumbers& random) {
  const double x = random.next();
  const double y = random.next();
  const double z = random.next();
  return 2.0 * Vec3(x, y, z) - Vec3::Ones();
}

}  // namespace

void fabricFolded(CaseTrial& trial) {
  CaseCloth cloth = sheetCloth(trial.fabricSettings("cotton", {}), trial.pick(33, 13), Pinned::TwoCorners);
  cloth.start = cloth.mesh.positions;
  CaseNumbers random(24);
  for (Vec3& position : cloth.start) {
    // A fold that lies exactly in its plane would keep that plane by symmetry.
    position.y() += 1e-4 * random.next();
    position.x() = std::abs(position.x());
  }
  WatchedCloth watched(trial, cloth);
  watched.run(trial.pick(2.0, 0.5));
  trial.show("largest strain", "", largestStrain(watched.model(), watched.state()));
}

void fabricTurnedOver(CaseTrial& trial) {
  constexpr double share = 1e-3;
  constexpr double moved = 0.1;
  const int resolution = trial.pick(33, 13);
  const double cell = 1.0 / (resolution - 1);
  CaseCloth cloth = sheetCloth(trial.fabricSettings("cotton", {"gravity=0"}), resolution, Pinned::Nowhere);
  cloth.start = cloth.mesh.positions;
  CaseNumbers random(25);
  for (Vec3& position : cloth.start) {
    const double side = random.next() < 0.5 ? -1.5 : 1.5;
    const double along = random.next() < 0.5 ? -1.5 : 1.5;
    if (random.next() < moved) {
      position += cell * Vec3(side, 0.0, along);  // beyond its neighbours
    }
  }
  WatchedCloth watched(trial, cloth);
  expectCalm(trial, watched, 3.0, share);
  trial.show("largest strain", "", largestStrain(watched.model(), watched.state()));
}

void fabricCompressed(CaseTrial& trial) {
  constexpr double left = 0.3;
  const int resolution = trial.pick(33, 13);
  CaseCloth cloth = sheetCloth(trial.fabricSettings("canvas", {"gravity=0"}), resolution, Pinned::Nowhere);
  for (int v = 0; v < resolution * resolution; ++v) {
    if (v % resolution == 0 || v % resolution == resolution - 1) {
      cloth.pins.push_back(v);
    }
  }
  cloth.start = cloth.mesh.positions;
  CaseNumbers random(27);
  for (Vec3& position : cloth.start) {
    position.x() *= left;
    position.y() += std::abs(position.x()) < 0.99 * 0.5 * left ? 1e-3 * random.next() : 0.0;
  }
  WatchedCloth watched(trial, cloth);
  watched.run(trial.pick(2.0, 0.5));
  trial.show("largest strain", "", largestStrain(watched.model(), watched.state()));
}

void fabricDamped(CaseTrial& trial) {
  constexpr double limit = 1e-6;
  CaseCloth cloth = sheetCloth(trial.fabricSettings("denim", {"gravity=0", "precision=double",
                                                              "fabric.stretch_damping=1", "fabric.bend_damping=1"}),
                               trial.pick(33, 13), Pinned::Nowhere);
  const Vec3 spin(2.0, 6.0, 3.0);   // [1/s]
  const Vec3 drift(0.3, 0.4, 0.0);  // [m/s]
  CaseNumbers random(28);
  for (const Vec3& position : cloth.mesh.positions) {
    cloth.velocities.emplace_back(spin.cross(position) + drift + randomVector(random));
  }
  WatchedCloth watched(trial, cloth);
  expectMomentumKept(trial, watched, trial.pick(20, 5), limit);
}

void fabricViolentStart(CaseTrial& trial) {
  constexpr double fastest = 50.0;  // [m/s]
  constexpr double share = 1e-2;
  CaseCloth cloth = sheetCloth(trial.fabricSettings("denim", {}), trial.pick(33, 13), Pinned::TwoCorners);
  CaseNumbers random(30);
  for (std::size_t v = 0; v < cloth.mesh.positions.size(); ++v) {
    const bool pinned = std::find(cloth.pins.begin(), cloth.pins.end(), static_cast<int>(v)) != cloth.pins.end();
    const Vec3 velocity = fastest / std::sqrt(3.0) * randomVector(random);
    cloth.velocities.emplace_back(pinned ? Vec3::Zero().eval() : velocity);
  }
  WatchedCloth watched(trial, cloth);
  expectCalm(trial, watched, 3.0, share);
  trial.expect("largest strain", "", largestStrain(watched.model(), watched.state()), 0.3);
}

void fabricPinsTeleport(CaseTrial& trial) {
  WatchedCloth watched(trial, sheetCloth(trial.fabricSettings("cotton", {}), trial.pick(33, 13), Pinned::TwoCorners));
  watched.run(trial.pick(1.0, 0.2));
  watched.apply(session::MovePinsCommand{Vec3(0.6, 0.8, 0.0)});
  // The sheet may keep rotating about its pins, because damping does not slow rigid motion.
  expectCalm(trial, watched, 2.0, 1e-3);
  trial.expect("largest strain", "", largestStrain(watched.model(), watched.state()), 0.3);
}

}  // namespace drape::report::hardcases
