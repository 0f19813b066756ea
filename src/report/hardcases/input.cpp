#include "io/mesh_import.hpp"
#include "messages/sim_error_text.hpp"
#include "report/hardcases/cases.hpp"
#include "report/hardcases/watched_cloth.hpp"

#include <algorithm>
#include <cmath>

/// Cases of invalid meshes and requests. Every defect must be reported, and the remaining cloth must move.
namespace drape::report::hardcases {
namespace {

/// A level sheet without texture coordinates, in which each triangle has its own vertices: every corner is duplicated.
io::RawMesh sheetOfLooseTriangles(const CaseTrial& trial, int resolution) {
  const sim::ClothMesh sheet = sheetCloth(trial.settings({}), resolution, Pinned::Nowhere).mesh;
  io::RawMesh raw;
  for (const Triangle& triangle : sheet.triangles) {
    const auto first = static_cast<int>(raw.positions.size());
    for (const int v : triangle) {
      raw.positions.push_back(sheet.positions[v]);
    }
    raw.triangles.push_back({first, first + 1, first + 2});
  }
  return raw;
}

void addTriangle(io::RawMesh& raw, const Vec3& a, const Vec3& b, const Vec3& c) {
  const auto first = static_cast<int>(raw.positions.size());
  raw.positions.insert(raw.positions.end(), {a, b, c});
  raw.triangles.push_back({first, first + 1, first + 2});
}

/// Imports the mesh, checks that its summary reports all defects, and lets it fall from its first vertex.
void importAndRun(CaseTrial& trial, const io::RawMesh& raw, const std::vector<std::string>& toTell, double seconds) {
  const io::ImportedMesh mesh = io::weldMesh(raw, "case.obj", {});
  std::string told;
  for (const std::string& warning : mesh.summary.warnings) {
    told += (told.empty() ? "" : " ") + warning;
  }
  const auto untold = std::count_if(toTell.begin(), toTell.end(),
                                    [&](const std::string& words) { return told.find(words) == std::string::npos; });
  trial.expect("faults not told", "", static_cast<double>(untold), 0.0);
  trial.say(told);
  WatchedCloth watched(trial, {mesh.cloth, {0}, trial.settings({"stiffness=1000"}), {}, {}, {}, {}});
  watched.run(seconds);
}

}  // namespace

void degenerateTriangles(CaseTrial& trial) {
  io::RawMesh raw = sheetOfLooseTriangles(trial, trial.pick(17, 9));
  const Vec3 corner = raw.positions.back();
  addTriangle(raw, corner, corner + Vec3(1.0, 0.0, 0.0), corner + Vec3(0.5, 0.0, 1e-5));  // a sliver
  addTriangle(raw, corner, corner + Vec3(0.0, 0.0, 0.3), corner + Vec3(0.0, 0.0, 0.6));   // on a line
  addTriangle(raw, corner, corner, corner + Vec3(0.2, 0.0, 0.0));                         // two corners at one place
  importAndRun(trial, raw, {"no area"}, trial.pick(2.0, 0.5));
}

void looseMesh(CaseTrial& trial) {
  io::RawMesh raw = sheetOfLooseTriangles(trial, trial.pick(17, 9));
  const Vec3 a = raw.positions[0];
  const Vec3 b = raw.positions[1];
  raw.positions.emplace_back(3.0, 0.0, 0.0);  // without a face
  addTriangle(raw, a, b, 0.5 * (a + b) + Vec3(0.0, 0.1, 0.0));
  addTriangle(raw, a, b, 0.5 * (a + b) - Vec3(0.0, 0.1, 0.0));
  addTriangle(raw, Vec3(2.0, 0.0, 0.0), Vec3(2.1, 0.0, 0.0), Vec3(2.0, 0.0, 0.1));  // a separate piece
  importAndRun(trial, raw, {"to no face", "more than two faces", "separate pieces"}, trial.pick(2.0, 0.5));
}

void nothingThere(CaseTrial& trial) {
  int untold = 0;
  const auto seconds = trial.pick(1.0, 0.3);
  const int resolution = trial.pick(17, 9);

  CaseCloth cloth = sheetCloth(trial.settings({"stiffness=0"}), resolution, Pinned::TwoCorners);
  WatchedCloth dust(trial, cloth);
  dust.run(seconds);
  const double fall = 0.5 * cloth.settings.step.gravity * seconds * seconds;
  const auto middle = static_cast<std::size_t>(resolution * resolution / 2);
  const double fallen = cloth.mesh.positions[middle].y() - dust.state().positions[middle].y();
  trial.expect("fall without stiffness off by", "%", 100.0 * std::abs(fallen / fall - 1.0), 5.0);

  WatchedCloth weightless(trial, sheetCloth(trial.settings({"stiffness=1000"}), resolution, Pinned::TwoCorners));
  weightless.apply(session::SetSettingCommand{"mass", 0.0});
  untold += weightless.simulation().message().empty() ? 1 : 0;
  trial.say("Mass 0: " + weightless.simulation().message().english());
  weightless.run(seconds);
  try {
    static_cast<void>(sim::buildClothModel(cloth.mesh, 0.0, sim::MassLumping::Uniform, {}));
    ++untold;
  } catch (const sim::ClothModelError& error) {
    trial.say(messages::inWords(error).english());
  }

  CaseCloth doubled = sheetCloth(trial.settings({"stiffness=1000"}), resolution, Pinned::TwoCorners);
  doubled.mesh.positions.push_back(doubled.mesh.positions.back());
  const auto last = static_cast<int>(doubled.mesh.positions.size()) - 1;
  doubled.mesh.triangles.push_back({last - 1, last, 0});
  WatchedCloth(trial, doubled).run(seconds);
  trial.expect("requests refused without a word", "", untold, 0.0);
}

}  // namespace drape::report::hardcases
