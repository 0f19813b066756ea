#include "report/hardcases/attach_to.hpp"
#include "report/hardcases/cases.hpp"
#include "report/hardcases/contact_bodies.hpp"
#include "report/hardcases/contact_cloth.hpp"

#include <cmath>
#include <numbers>

/// Cases of contact in which moving bodies or the mouse drive the cloth.
namespace drape::report::hardcases {
namespace {

using sim::contact::Body;
using sim::contact::BoxShape;
using sim::contact::CapsuleShape;
using sim::contact::Keyframe;
using sim::contact::PlaneShape;
using sim::contact::SphereShape;

/// Pins a vertex to a body.
void carry(CaseCloth& cloth, Body& body, int vertex) {
  cloth.pins.push_back(vertex);
  body.pins.push_back({vertex});
}

/// A bar that holds an end of a sheet at x = side * 0.4 m. It turns about the x axis and moves inwards.
Body turningBar(double side, double turns, double seconds) {
  constexpr double quarter = 0.5 * std::numbers::pi;  // lays the capsule along z
  const double angle = side * 2.0 * std::numbers::pi * turns;
  return movingBody(side < 0.0 ? "left bar" : "right bar", CapsuleShape{0.01, 0.15},
                    {{0.0, Vec3(0.44 * side, 0.0, 0.0), Vec3(quarter, 0.0, 0.0)},
                     {seconds, Vec3(0.34 * side, 0.0, 0.0), Vec3(quarter + angle, 0.0, 0.0)}});
}

}  // namespace

void contactTwisted(CaseTrial& trial) {
  constexpr double width = 0.8;
  const double turns = trial.pick(5.0, 1.0);  // of each bar
  const double seconds = trial.pick(5.0, 0.8);
  CaseCloth cloth = clothOf(contactSettings(trial), sheetMesh(trial.pick(17, 11), width, 0.3));
  cloth.bodies = {turningBar(-1.0, turns, seconds), turningBar(1.0, turns, seconds)};
  for (std::size_t v = 0; v < cloth.mesh.positions.size(); ++v) {
    const double x = cloth.mesh.positions[v].x();
    if (std::abs(std::abs(x) - 0.5 * width) < 1e-6) {
      carry(cloth, cloth.bodies[x > 0.0 ? 1 : 0], static_cast<int>(v));
    }
  }
  ContactCloth watched(trial, cloth, 20.0);
  watched.run(seconds);
  watched.watched().countEnergy();
  watched.run(trial.pick(1.0, 0.3));
  trial.show("stretch at the end", "", largestStrain(watched.watched().model(), watched.watched().state()));
}

void contactRing(CaseTrial& trial) {
  constexpr double side = 0.8;
  constexpr double height = 0.06;  // of the sheet above the ring
  const double seconds = trial.pick(2.5, 1.5);
  const int resolution = trial.pick(33, 17);
  CaseCloth cloth = clothOf(contactSettings(trial), placed(sheetMesh(resolution, side, side), Vec3(0.0, height, 0.0)));
  const double below = height - 0.04;
  Body puller =
      movingBody("puller", SphereShape{0.02}, {{0.0, Vec3(0.0, below, 0.0)}, {seconds, Vec3(0.0, below - 0.9, 0.0)}});
  constexpr double grip = 0.06;  // radius around its centre [m]
  for (std::size_t v = 0; v < cloth.mesh.positions.size(); ++v) {
    if ((cloth.mesh.positions[v] - Vec3(0.0, height, 0.0)).norm() < grip) {
      carry(cloth, puller, static_cast<int>(v));
    }
  }
  cloth.bodies = {puller, bodyAt("ring", torusShape(0.16, 0.03), Vec3::Zero())};
  ContactCloth watched(trial, cloth, 30.0);
  watched.run(seconds);
  watched.watched().countEnergy();
  watched.run(trial.pick(1.0, 0.3));
}

void contactVice(CaseTrial& trial) {
  constexpr double open = 0.9;      // [m]
  constexpr double closed = 0.004;  // the thickness of the cloth [m]
  constexpr double half = 0.05;     // of the height of the upper jaw [m]
  const Vec3 slanted(1.65, 0.1, 0.0);
  CaseCloth cloth =
      clothOf(contactSettings(trial), placed(sheetMesh(trial.pick(25, 11), 0.6, 0.6), Vec3(0.0, 0.36, 0.0), slanted));
  const auto jaw = [&](double time, double gap) { return Keyframe{time, Vec3(0.0, gap + half, 0.0), Vec3::Zero()}; };
  cloth.bodies = {bodyAt("lower jaw", PlaneShape{2.0}, Vec3::Zero()),
                  movingBody("upper jaw", BoxShape{Vec3(0.7, half, 0.7)},
                             {jaw(0.0, open), jaw(0.6, open), jaw(1.2, closed), jaw(1.6, closed), jaw(2.1, open)})};
  ContactCloth watched(trial, cloth, 20.0);
  watched.run(1.0);
  watched.allowPairs(true);
  watched.run(1.1);
  watched.allowPairs(false);
  watched.watched().countEnergy();
  watched.run(trial.pick(7.0, 0.5));
  if (!trial.shortForm()) {
    watched.expectRest(1.0);
  }
}

void contactCrumpled(CaseTrial& trial) {
  constexpr double side = 0.6;
  constexpr double frameTime = 0.1;
  constexpr double start = 0.45;
  constexpr double end = 0.15;
  const int frames = trial.pick(15, 6);
  std::vector<double> radii;
  for (int k = 0; k <= frames; ++k) {
    radii.push_back(start + (end - start) * k / frames);
  }
  for (int k = 0; k < 3; ++k) {
    radii.push_back(end);
  }
  CaseCloth cloth = clothOf(contactSettings(trial), sheetMesh(trial.pick(25, 11), side, side));
  cloth.bodies = {bodyAt("sphere", hollowSphereShape(radii, frameTime), Vec3::Zero())};
  ContactCloth watched(trial, cloth, 20.0);
  watched.run(frameTime * frames);
  watched.watched().countEnergy();
  watched.run(trial.pick(2.0, 0.3));
}

void contactDragged(CaseTrial& trial) {
  constexpr double grip = 3.0;      // time between two grips [s]
  constexpr double change = 0.15;   // time between two targets [s]
  constexpr double fastest = 12.0;  // of the mouse [m/s]
  const int resolution = trial.pick(25, 13);
  CaseCloth cloth = clothOf(contactSettings(trial), placed(sheetMesh(resolution, 0.8, 0.8), Vec3(0.0, 0.65, 0.0)));
  cloth.bodies = {bodyAt("ground", PlaneShape{2.0}, Vec3::Zero()),
                  bodyAt("sphere", SphereShape{0.2}, Vec3(0.0, 0.25, 0.0))};
  ContactCloth contact(trial, cloth);
  WatchedCloth& watched = contact.watched();
  const settings::Settings& settings = watched.simulation().settings();
  const double timeStep = settings.step.timeStep;
  CaseNumbers random(43);
  int vertex = 0;
  Vec3 target = Vec3::Zero();
  Vec3 aim = Vec3::Zero();
  const auto stepsIn = [&](double seconds) { return std::lround(seconds / timeStep); };
  const long steps = stepsIn(trial.pick(60.0, 2.0));
  for (long i = 0; i < steps; ++i) {
    if (i % stepsIn(grip) == 0) {
      vertex = static_cast<int>(random.next() * watched.model().vertexCount());
      target = watched.state().positions[vertex];
      watched.apply(session::DetachCommand{});
      watched.apply(attachTo(watched.model(), vertex, target));
    }
    if (i % stepsIn(change) == 0) {
      const double x = 1.6 * random.next() - 0.8;
      const double y = 1.2 * random.next();
      const double z = 1.6 * random.next() - 0.8;
      aim = Vec3(x, y, z);
    }
    const Vec3 way = aim - target;
    target += std::min(1.0, fastest * timeStep / std::max(way.norm(), 1e-12)) * way;
    watched.apply(session::MoveAttachmentCommand{target});
    const Vec3 before = watched.state().positions[vertex];
    contact.step([&] { return settings.attachment.maxForce * (watched.state().positions[vertex] - before).norm(); });
  }
}

}  // namespace drape::report::hardcases
