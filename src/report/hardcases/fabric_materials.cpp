#include "report/hardcases/cases.hpp"
#include "report/hardcases/run_strain.hpp"
#include "report/hardcases/watched_cloth.hpp"
#include "scene/grid_mesh.hpp"
#include "sim/fabric/fabric.hpp"

#include <algorithm>
#include <cmath>

/// Cases of extreme fabrics, meshes and steps.
namespace drape::report::hardcases {
namespace {

/// A level sheet of fabric with that layout, pinned along its first row.
CaseCloth fabricSheet(const settings::Settings& settings, const scene::GridLayout& layout) {
  CaseCloth cloth{scene::makeGrid(layout, scene::GridSource::Plane::Horizontal).cloth, {}, settings, {}, {}, {}, {}};
  for (int column = 0; column < layout.columns; ++column) {
    cloth.pins.push_back(layout.index(0, column));
  }
  return cloth;
}

}  // namespace

void fabricLongSteps(CaseTrial& trial) {
  for (const char* preset : {"denim", "cotton"}) {
    for (const char* step : {"time_step=1/60", "time_step=1/30"}) {
      WatchedCloth watched(trial,
                           sheetCloth(trial.fabricSettings(preset, {step}), trial.pick(33, 13), Pinned::TwoCorners));
      watched.run(trial.pick(2.0, 0.5));
      trial.show("largest strain", "", largestStrain(watched.model(), watched.state()));
    }
  }
}

void fabricSlivers(CaseTrial& trial) {
  constexpr double narrow = 1e-2;  // of a cell
  const int resolution = trial.pick(33, 13);
  CaseCloth cloth = sheetCloth(trial.fabricSettings("cotton", {}), resolution, Pinned::TwoCorners);
  // Every fourth column and row moves next to its neighbour: slivers, and tiny triangles where both meet.
  const double cell = 1.0 / (resolution - 1);
  for (int v = 0; v < resolution * resolution; ++v) {
    const Vec3 move((v % resolution) % 4 == 2 ? -1.0 : 0.0, 0.0, (v / resolution) % 4 == 2 ? -1.0 : 0.0);
    cloth.mesh.positions[v] += (1.0 - narrow) * cell * move;
  }
  WatchedCloth watched(trial, cloth);
  watched.run(trial.pick(2.0, 0.5));
  trial.expect("clamped triangles not counted", "", watched.model().fabric->slivers > 0 ? 0.0 : 1.0, 0.0);
  trial.show("clamped triangles", "", watched.model().fabric->slivers);
  trial.show("largest strain", "", largestStrain(watched.model(), watched.state()));
}

void fabricUnevenModuli(CaseTrial& trial) {
  constexpr double limit = 2.0;
  const CaseCloth cloth = sheetCloth(
      trial.fabricSettings("cotton", {"fabric.stretch_warp=1e5", "fabric.stretch_weft=10", "fabric.shear=5"}),
      trial.pick(33, 9), Pinned::TwoCorners);
  expectStrain(trial, cloth, trial.pick(1.0, 0.3), limit);
}

void fabricThinCells(CaseTrial& trial) {
  constexpr double side = 0.01;  // [m]
  const int fewer = trial.pick(4, 3);
  const int longer = trial.pick(50, 30);
  for (const char* preset : {"denim", "jersey"}) {
    for (const bool across : {false, true}) {
      const int more = longer * (fewer - 1) + 1;
      const scene::GridLayout layout{across ? more : fewer, across ? fewer : more, side, side};
      WatchedCloth watched(trial, fabricSheet(trial.fabricSettings(preset, {}), layout));
      watched.run(trial.pick(0.1, 0.05));
      trial.show("largest strain", "", largestStrain(watched.model(), watched.state()));
    }
  }
}

void fabricOverstretched(CaseTrial& trial) {
  constexpr double limit = 1.5;
  const CaseCloth cloth =
      sheetCloth(trial.fabricSettings("jersey", {"gravity=294"}), trial.pick(33, 13), Pinned::TopEdge);
  expectStrain(trial, cloth, trial.pick(1.0, 0.5), limit);
}

}  // namespace drape::report::hardcases
