#include "report/hardcases/cases.hpp"
#include "report/hardcases/contact_bodies.hpp"
#include "report/hardcases/contact_cloth.hpp"

#include <cmath>
#include <numbers>

/// Cases of contact in which gravity drives the cloth.
namespace drape::report::hardcases {
namespace {

using sim::contact::Body;
using sim::contact::BoxShape;
using sim::contact::CapsuleShape;
using sim::contact::PlaneShape;

constexpr double fastest = 10.0;  // [m/s]

Body ground() {
  return bodyAt("ground", PlaneShape{2.0}, Vec3::Zero());
}

/// A tube around the y axis whose radius changes linearly.
sim::ClothMesh tubeMesh(int around, int rows, double topRadius, double bottomRadius, double length) {
  std::vector<ProfilePoint> profile;
  for (int row = 0; row < rows; ++row) {
    const double share = static_cast<double>(row) / (rows - 1);
    profile.push_back({topRadius + share * (bottomRadius - topRadius), (0.5 - share) * length});
  }
  return revolved(profile, around, false);
}

}  // namespace

void contactSharp(CaseTrial& trial) {
  constexpr double height = 0.4;
  const settings::Settings settings = contactSettings(trial);
  const int resolution = trial.pick(25, 13);
  // Away from the centre, so that no vertex meets the tip and no edge the blade.
  const sim::ClothMesh sheet =
      placed(sheetMesh(resolution, 0.7, 0.7), Vec3(0.013, height + 0.1, 0.007), Vec3(0.0, 0.2, 0.0));
  const std::vector<Body> bodies{bodyAt("spike", spikeShape(0.05, height), Vec3::Zero()),
                                 bodyAt("blade", bladeShape(0.5, height, 0.04), Vec3::Zero())};
  for (const Body& body : bodies) {
    CaseCloth cloth = clothOf(settings, sheet);
    cloth.bodies = {body, ground()};
    ContactCloth watched(trial, cloth);
    watched.run(trial.pick(3.0, 0.6));
  }
}

void contactFiveSheets(CaseTrial& trial) {
  sim::ClothMesh mesh;
  for (int k = 0; k < 5; ++k) {
    append(mesh, placed(sheetMesh(trial.pick(17, 8), 0.5, 0.5), Vec3(0.02 * k, 0.05 + 0.06 * k, -0.01 * k),
                        Vec3(0.0, 0.4 * k, 0.0)));
  }
  CaseCloth cloth = clothOf(contactSettings(trial), mesh);
  cloth.bodies = {bodyAt("ground", PlaneShape{2.0}, Vec3::Zero()),
                  bodyAt("box", BoxShape{Vec3(0.12, 0.02, 0.12)}, Vec3(0.05, 0.02, 0.0))};
  ContactCloth watched(trial, cloth);
  watched.run(trial.pick(9.0, 1.0));
  if (!trial.shortForm()) {
    watched.expectRest(1.0);
  }
}

void contactSofa(CaseTrial& trial) {
  const sim::ClothMesh dress = placed(tubeMesh(trial.pick(40, 16), trial.pick(25, 10), 0.14, 0.28, 0.8),
                                      Vec3(0.02, 0.75, 0.12), Vec3(0.0, 0.0, 0.5 * std::numbers::pi));
  CaseCloth cloth = clothOf(contactSettings(trial), dress);
  cloth.bodies = {ground(), bodyAt("seat", BoxShape{Vec3(0.5, 0.1, 0.3)}, Vec3(0.0, 0.3, 0.1)),
                  bodyAt("back", BoxShape{Vec3(0.5, 0.25, 0.06)}, Vec3(0.0, 0.5, -0.25), Vec3(-0.15, 0.0, 0.0)),
                  bodyAt("left arm", BoxShape{Vec3(0.06, 0.2, 0.3)}, Vec3(-0.56, 0.4, 0.1)),
                  bodyAt("right arm", BoxShape{Vec3(0.06, 0.2, 0.3)}, Vec3(0.56, 0.4, 0.1))};
  ContactCloth watched(trial, cloth);
  watched.run(trial.pick(11.0, 1.0));
  if (!trial.shortForm()) {
    watched.expectRest(1.0);
  }
}

void contactTwoLayers(CaseTrial& trial) {
  const int around = trial.pick(40, 18);
  const int rows = trial.pick(21, 9);
  const double seconds = trial.pick(4.0, 1.0);
  sim::ClothMesh mesh = tubeMesh(around, rows, 0.14, 0.18, 0.5);
  append(mesh, tubeMesh(around, rows, 0.16, 0.21, 0.5));
  CaseCloth cloth = clothOf(contactSettings(trial), mesh);
  Body torso = movingBody("torso", CapsuleShape{0.12, 0.3}, {});
  // As fast in both forms: a slower torso would not touch the garment.
  constexpr double swing = 0.25;  // time from the middle to one side [s]
  for (int k = 0; k <= std::lround(seconds / swing); ++k) {
    const double side = k % 2 == 0 ? 0.0 : (k % 4 == 1 ? 1.0 : -1.0);
    torso.motion.keyframes.push_back({swing * k, Vec3(0.25 * side, 0.0, 0.0), Vec3(0.0, 2.5 * side, 0.3 * side)});
  }
  for (const int layer : {0, 1}) {
    for (int i = 0; i < around; ++i) {
      const int vertex = layer * around * rows + i;
      cloth.pins.push_back(vertex);
      torso.pins.push_back({vertex});
    }
  }
  cloth.bodies = {torso};
  ContactCloth watched(trial, cloth, fastest);
  watched.run(seconds);
  watched.watched().countEnergy();
  watched.run(trial.pick(2.0, 0.3));
}

void contactLongSteps(CaseTrial& trial) {
  const std::vector<const char*> stiffnesses{"10", "1000", "1e5"};
  for (const char* name : {"fold", "edge_drop"}) {
    for (const char* stiffness : stiffnesses) {
      scene::SceneDescription description = scene::openScene(name);
      description.settings =
          trial.changed(description.settings, {"time_step=1/60", "substeps=1", "self_collision=exact", "threads=1",
                                               std::string("stiffness=") + stiffness,
                                               std::string("grid.resolution=") + trial.pick("33", "11")});
      ContactCloth watched(trial, scene::buildScene(description, description.settings));
      watched.run(trial.pick(2.0, 0.8));
    }
  }
}

}  // namespace drape::report::hardcases
