#include "report/hardcases/cases.hpp"
#include "report/hardcases/run_strain.hpp"
#include "report/hardcases/watched_cloth.hpp"
#include "report/number_text.hpp"
#include "settings/settings_table.hpp"
#include "sim/forces/diagnostics.hpp"
#include "sim/measures/measures.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

/// Cases of extreme materials.
namespace drape::report::hardcases {

void unevenSprings(CaseTrial& trial) {
  constexpr double stiffer = 1e5;
  CaseCloth cloth = sheetCloth(trial.settings({"stiffness=10"}), trial.pick(33, 9), Pinned::TwoCorners);
  CaseNumbers random(5);
  cloth.stiffness.resize(modelOf(cloth)->springs.size());
  std::generate(cloth.stiffness.begin(), cloth.stiffness.end(), [&] { return random.next() < 0.5 ? stiffer : 1.0; });
  WatchedCloth watched(trial, cloth);
  watched.run(trial.pick(1.0, 0.2));
  trial.show("largest strain", "", sim::maxStretch(watched.model(), watched.state()));
}

void unevenMasses(CaseTrial& trial) {
  constexpr double heavier = 1e5;
  constexpr double limit = 2.0;
  CaseCloth cloth = sheetCloth(trial.settings({"stiffness=1e5"}), trial.pick(33, 9), Pinned::TwoCorners);
  CaseNumbers random(6);
  const auto even = modelOf(cloth);
  cloth.masses = even->vertexMass;
  for (double& mass : cloth.masses) {
    mass *= random.next() < 0.1 ? heavier : 1.0;
  }
  expectStrain(trial, cloth, trial.pick(1.0, 0.3), limit);
}

void fineAndStiff(CaseTrial& trial) {
  // The finer sheet, whose steps cost eight times as much, is measured while the first tension wave runs through it.
  using Sizes = std::vector<std::pair<int, double>>;  // with the simulated time [s]
  for (const auto& [size, seconds] : trial.pick<Sizes>({{129, 0.2}, {257, 0.04}}, {{129, 0.02}})) {
    WatchedCloth watched(trial, sheetCloth(trial.settings({"stiffness=1e5"}), size, Pinned::TwoCorners));
    const double strain = maxStrainOfRun(watched, seconds);
    trial.show("largest strain at " + gridText(size), "", strain);
  }
}

void heavyGravity(CaseTrial& trial) {
  WatchedCloth watched(
      trial, sheetCloth(trial.settings({"stiffness=1000", "gravity=981"}), trial.pick(33, 17), Pinned::TwoCorners));
  trial.show("largest strain", "", maxStrainOfRun(watched, trial.pick(1.0, 0.5)));
}

void scales(CaseTrial& trial) {
  constexpr double limit = 1.0;  // [% of the diagonal]
  const double seconds = trial.pick(0.5, 0.3);
  std::vector<Vec3> first;
  for (const double size : {1.0, 1e-3, 1e3}) {
    // The same motion has lengths scaled by s and times scaled by sqrt(s), with the same mass: k / s.
    const double slower = std::sqrt(size);
    settings::Settings settings = trial.settings({"precision=double"});
    settings.step.timeStep = slower / 600.0;
    settings.step.material.stiffness = 100.0 / size;
    WatchedCloth watched(trial, sheetCloth(settings, trial.pick(17, 9), Pinned::TwoCorners, size));
    watched.run(seconds * slower);
    std::vector<Vec3> positions = watched.state().positions;
    std::for_each(positions.begin(), positions.end(), [&](Vec3& position) { position /= size; });
    first = first.empty() ? positions : first;
    const double diagonal = std::sqrt(2.0);
    trial.expect("difference between scales", "% of the diagonal",
                 100.0 * sim::meanDistance(first, positions) / diagonal, limit);
  }
}

}  // namespace drape::report::hardcases
