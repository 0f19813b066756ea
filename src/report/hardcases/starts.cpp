#include "report/hardcases/cases.hpp"
#include "report/hardcases/watched_cloth.hpp"
#include "sim/forces/diagnostics.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

/// Cases with an extreme start.
namespace drape::report::hardcases {
namespace {

/// An upright tube whose springs have nearly equal lengths. It is not flat.
sim::ClothMesh tube(int around, int rows) {
  constexpr double radius = 0.2;  // [m]
  sim::ClothMesh mesh;
  const double edge = 2.0 * std::numbers::pi * radius / around;
  for (int row = 0; row < rows; ++row) {
    for (int i = 0; i < around; ++i) {
      const double angle = 2.0 * std::numbers::pi * i / around;
      mesh.positions.emplace_back(radius * std::cos(angle), edge * row, radius * std::sin(angle));
    }
  }
  for (int row = 0; row + 1 < rows; ++row) {
    for (int i = 0; i < around; ++i) {
      const int a = row * around + i;
      const int b = row * around + (i + 1) % around;
      mesh.triangles.push_back({a, a + around, b + around});
      mesh.triangles.push_back({a, b + around, b});
    }
  }
  return mesh;
}

/// Unfolds without gravity and measures how close the springs come to their rest lengths.
void unfold(CaseTrial& trial, const CaseCloth& cloth, double seconds) {
  constexpr double strainLimit = 1.0;  // [%]
  WatchedCloth watched(trial, cloth);
  watched.run(seconds);
  trial.expect("strain left", "%", 100.0 * largestStrain(watched.model(), watched.state()), strainLimit);
}

/// Mean ratio of the springs' lengths to their rest lengths [-].
double meanLengthRatio(const sim::ClothModel& model, const sim::ClothState& state) {
  double sum = 0.0;
  for (const sim::Spring& spring : model.springs) {
    sum += (state.positions[spring.b] - state.positions[spring.a]).norm() / spring.restLength;
  }
  return sum / static_cast<double>(model.springs.size());
}

}  // namespace

void randomStart(CaseTrial& trial) {
  CaseCloth cloth =
      sheetCloth(trial.settings({"stiffness=1000", "damping=0.1"}), trial.pick(33, 13), Pinned::TwoCorners);
  CaseNumbers random(1);
  cloth.start = cloth.mesh.positions;
  for (std::size_t v = 0; v < cloth.start.size(); ++v) {
    const double x = random.next() - 0.5;
    const double y = random.next() - 0.5;
    const double z = random.next() - 0.5;
    if (std::find(cloth.pins.begin(), cloth.pins.end(), static_cast<int>(v)) == cloth.pins.end()) {
      cloth.start[v] = Vec3(x, y, z);
    }
  }
  WatchedCloth watched(trial, cloth);
  const auto springsAndMotion = [&] {
    const sim::Energy energy = sim::energyOf(watched.model(), watched.simulation().settings().step, watched.state());
    return energy.kinetic + energy.elastic;
  };
  const double start = springsAndMotion();
  watched.run(5.0);
  trial.expect("energy left", "of the start", springsAndMotion() / start, 1e-3);
  trial.expect("largest strain", "", largestStrain(watched.model(), watched.state()), 0.3);
}

void flattened(CaseTrial& trial) {
  const int around = trial.pick(48, 16);
  const settings::Settings settings = trial.settings({"stiffness=1000", "damping=0.1", "gravity=0"});
  for (const bool line : {false, true}) {
    CaseCloth cloth{tube(around, around / 2), {}, settings, {}, {}, {}, {}};
    cloth.start = cloth.mesh.positions;
    for (Vec3& position : cloth.start) {
      position.z() = 0.0;
      position.x() = line ? 0.0 : position.x();
    }
    unfold(trial, cloth, trial.pick(10.0, 3.0));
  }
}

void onePoint(CaseTrial& trial) {
  constexpr double missingLimit = 10.0;  // [%]
  CaseCloth cloth =
      sheetCloth(trial.settings({"stiffness=1000", "damping=0.1", "gravity=0"}), trial.pick(33, 13), Pinned::Nowhere);
  cloth.start.assign(cloth.mesh.positions.size(), Vec3(0.0, 1.0, 0.0));
  const auto hashAfter = [&](double seconds) {
    WatchedCloth watched(trial, cloth);
    watched.run(seconds);
    return sim::stateHash(watched.state());
  };
  const std::uint64_t first = hashAfter(0.1);
  const std::uint64_t second = hashAfter(0.1);
  trial.expect("runs that differ", "", first == second ? 0.0 : 1.0, 0.0);
  trial.say(WatchedCloth(trial, cloth).simulation().message().english());
  WatchedCloth watched(trial, cloth);
  watched.run(trial.pick(5.0, 3.0));
  trial.expect("mean length missing", "%", 100.0 * (1.0 - meanLengthRatio(watched.model(), watched.state())),
               missingLimit);
  trial.show("largest strain", "", largestStrain(watched.model(), watched.state()));
}

void crushed(CaseTrial& trial) {
  constexpr double left = 0.01;
  CaseCloth cloth = sheetCloth(trial.settings({"stiffness=1000", "gravity=0"}), trial.pick(33, 17), Pinned::Nowhere);
  cloth.start = cloth.mesh.positions;
  for (Vec3& position : cloth.start) {
    position *= left;
  }
  WatchedCloth watched(trial, cloth);
  double widest = 0.0;
  for (int i = 0; i < trial.pick(10, 5); ++i) {
    watched.run(0.1);
    widest = std::max(widest, largestStrain(watched.model(), watched.state()));
  }
  trial.show("largest strain on the way", "", widest);
}

}  // namespace drape::report::hardcases
