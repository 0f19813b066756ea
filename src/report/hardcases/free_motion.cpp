#include "report/hardcases/cases.hpp"
#include "report/hardcases/momentum_kept.hpp"
#include "report/hardcases/watched_cloth.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

/// Cases of free cloth.
namespace drape::report::hardcases {
namespace {

Vec3 middleOf(const std::vector<Vec3>& positions) {
  return std::accumulate(positions.begin(), positions.end(), Vec3(Vec3::Zero())) /
         static_cast<double>(positions.size());
}

}  // namespace

void freeFall(CaseTrial& trial) {
  constexpr double limit = 1e-6;  // [m]
  const CaseCloth cloth = sheetCloth(trial.settings({"stiffness=1000", "damping=0.1", "precision=double"}),
                                     trial.pick(33, 17), Pinned::Nowhere);
  WatchedCloth watched(trial, cloth);
  watched.run(trial.pick(2.0, 1.0));
  const std::vector<Vec3>& rest = watched.model().restPositions;
  const Vec3 fall = middleOf(watched.state().positions) - middleOf(rest);
  double largest = 0.0;
  for (std::size_t v = 0; v < rest.size(); ++v) {
    largest = std::max(largest, (watched.state().positions[v] - rest[v] - fall).norm());
  }
  trial.expect("shape changed by", "m", largest, limit);
  trial.show("fallen", "m", fall.norm());
}

void spinning(CaseTrial& trial) {
  constexpr double limit = 1e-6;
  CaseCloth cloth = sheetCloth(trial.settings({"stiffness=1000", "gravity=0", "precision=double"}), trial.pick(33, 17),
                               Pinned::Nowhere);
  const Vec3 spin(2.0, 6.0, 3.0);   // [1/s]
  const Vec3 drift(0.3, 0.4, 0.0);  // [m/s]
  for (const Vec3& position : cloth.mesh.positions) {
    cloth.velocities.emplace_back(spin.cross(position) + drift);
  }
  WatchedCloth watched(trial, cloth);
  expectMomentumKept(trial, watched, trial.pick(100, 20), limit);
}

}  // namespace drape::report::hardcases
