#include "fabrics/presets.hpp"
#include "report/validation/cases.hpp"
#include "report/validation/closed_forms.hpp"
#include "report/validation/test_motion.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace drape::report::validation {
namespace {

constexpr double earth = 9.81;  // [m/s^2]

constexpr double side = 0.2;  // [m]

/// A square sheet.
TestSheet freeSheet(const CaseMesh& mesh) {
  return testSheet({.length = side, .width = side, .along = mesh.resolution, .across = mesh.resolution}, mesh.kind);
}

std::shared_ptr<const sim::ClothModel> freeCloth(const TestSheet& sheet) {
  const fabrics::Preset& cotton = *fabrics::findPreset("cotton");
  return clothOf(sheet, cotton.material, cotton.density, {});
}

constexpr double staticFriction = 0.5;
constexpr double kineticFriction = 0.4;

/// A sheet that lies at rest on a plane, which descends along x by this slope.
TestMotion sheetOnIncline(double slope, const CaseMesh& mesh) {
  const TestSheet sheet = freeSheet(mesh);
  sim::StepParameters parameters;
  parameters.gravity = earth;
  sim::contact::Body plane;
  plane.name = "incline";
  plane.shape = sim::contact::PlaneShape{};
  plane.motion.keyframes = {{.rotation = {0.0, 0.0, -std::atan(slope)}}};
  plane.surface.staticFriction = staticFriction;
  plane.surface.kineticFriction = kineticFriction;
  const sim::contact::Pose pose = sim::contact::poseAt(plane.motion, 0.0);
  const double offset = plane.surface.thickness + 0.5 * parameters.contact.thickness;
  std::vector<Vec3> start;
  for (const Vec3& rest : sheet.mesh.positions) {
    start.push_back(pose.toWorld(rest + Vec3(0.0, offset, 0.0)));
  }
  TestMotion motion(freeCloth(sheet), mesh.subject, parameters, start, mesh.stop);
  motion.add(plane);
  return motion;
}

}  // namespace

/// Searches the slope from which on the sheet slides.
Comparison inclineSticks(const CaseMesh& mesh) {
  // Above 5 mm/s it slides at g cos(a) (mu_s - mu_k), 0.9 m/s^2. It begins more slowly with `auto`, whose contacts keep
  // the static coefficient up to that speed.
  constexpr double seconds = 0.4;
  constexpr double slow = 0.02;  // [m/s]
  double low = 0.9 * staticFriction;
  double high = 1.1 * staticFriction;
  constexpr int halvings = 8;
  for (int i = 0; i < halvings; ++i) {
    const double middle = 0.5 * (low + high);
    TestMotion motion = sheetOnIncline(middle, mesh);
    motion.run(seconds);
    (motion.velocity().norm() > slow ? high : low) = middle;
  }
  return {.measured = 0.5 * (low + high), .exact = staticFriction};
}

Comparison inclineSlides(const CaseMesh& mesh) {
  constexpr double slope = 0.6;
  constexpr double settled = 0.1;  // [s]
  constexpr double seconds = 0.3;
  TestMotion motion = sheetOnIncline(slope, mesh);
  motion.run(settled);
  const double from = motion.velocity().norm();
  const double since = motion.state().time;
  motion.run(seconds);
  return {.measured = (motion.velocity().norm() - from) / (motion.state().time - since),
          .exact = slidingAcceleration(slope, kineticFriction, earth)};
}

namespace {

constexpr double dragCoefficient = 1.2;

struct Fall {
  double distance = 0.0;  // [m]
  double speed = 0.0;     // [m/s]
};

/// A horizontal sheet after a fall from rest, of this many times its terminal speed over g.
Fall fallOf(double times, const CaseMesh& mesh, const TerminalFall& closed) {
  const TestSheet sheet = freeSheet(mesh);
  sim::StepParameters parameters;
  parameters.gravity = earth;
  parameters.air.drag = dragCoefficient;
  parameters.timeStep = closed.speed / earth / 50.0;
  TestMotion motion(freeCloth(sheet), mesh.subject, parameters, sheet.mesh.positions, mesh.stop);
  const Vec3 start = motion.centre();
  motion.run(times * closed.speed / earth);
  return {.distance = (motion.centre() - start).norm(), .speed = motion.velocity().norm()};
}

TerminalFall closedFall() {
  const double density = fabrics::findPreset("cotton")->density;
  const double air = sim::AirParameters{}.density;
  return {.speed = terminalSpeed(density, air, dragCoefficient, earth),
          .gravity = earth,
          .inertia = 1.0 + addedMassOfSquare(air, side) / density};
}

}  // namespace

Comparison terminalVelocity(const CaseMesh& mesh) {
  const TerminalFall closed = closedFall();
  const double times = 6.0 * closed.inertia;  // the speed is then 1 - 1e-5 of the terminal one
  return {.measured = fallOf(times, mesh, closed).speed, .exact = closed.speed};
}

Comparison fallDistance(const CaseMesh& mesh) {
  const TerminalFall closed = closedFall();
  return {.measured = fallOf(1.0, mesh, closed).distance, .exact = closed.distance(closed.speed / earth)};
}

namespace {

constexpr double chord = 0.2;  // [m]

/// A stiff strip, as long as four chords. Its chord is along x at rest.
/// @param froude sqrt(density / (density of the air times the chord))  @param tilt about its length at the start [rad]
TestMotion fallingStrip(double froude, double tilt, const CaseMesh& mesh) {
  constexpr double bending = 0.005;  // [N m]
  sim::StepParameters parameters;
  parameters.gravity = earth;
  // Measured on falling plates: the drag coefficient is 1.4 - cos 2a.
  parameters.air.drag = 2.4;
  parameters.air.edgeDrag = 0.4;
  parameters.air.lift = 1.0;
  const double density = froude * froude * parameters.air.density * chord;
  const TestSheet sheet = testSheet(
      {.length = chord, .width = 4.0 * chord, .along = mesh.resolution, .across = 2 * mesh.resolution}, mesh.kind);
  std::vector<Vec3> start;
  for (const Vec3& rest : sheet.mesh.positions) {
    start.emplace_back(Eigen::AngleAxisd(tilt, Vec3::UnitZ()) * rest);
  }
  return {clothOf(sheet, stiffSheet(bending), density, {}), mesh.subject, parameters, start, mesh.stop};
}

/// The unit vector along the chord in the middle of the strip.
Vec3 chordOf(const TestMotion& motion, const CaseMesh& mesh) {
  const int columns = mesh.resolution + 1;
  const int first = mesh.resolution * columns;
  const std::vector<Vec3>& positions = motion.state().positions;
  return (positions[first + mesh.resolution] - positions[first]).normalized();
}

/// Whether a falling strip turns by two and a half revolutions about its length within 40 sqrt(chord / g). A strip that
/// flutters turns by less than half of one.
bool tumbles(double froude, double tilt, const CaseMesh& mesh) {
  constexpr double enough = 2.5 * 2.0 * std::numbers::pi;
  TestMotion motion = fallingStrip(froude, tilt, mesh);
  const double end = 40.0 * std::sqrt(chord / earth);
  double turned = 0.0;
  double low = 0.0;
  double high = 0.0;
  Vec3 before = chordOf(motion, mesh);
  while (motion.state().time < end && high - low < enough) {
    motion.step();
    const Vec3 now = chordOf(motion, mesh);
    turned += std::atan2(before.x() * now.y() - before.y() * now.x(), before.dot(now));
    low = std::min(low, turned);
    high = std::max(high, turned);
    before = now;
  }
  return high - low >= enough;
}

}  // namespace

/// The motion near the transition is irregular, so falls at many Froude numbers count. The result is the lowest number
/// plus the width of their range times the share of falls that do not tumble.
Comparison froudeOfTumbling(const CaseMesh& mesh) {
  constexpr double published = 0.67;
  constexpr double lowest = 0.4;
  constexpr double interval = 0.05;
  constexpr int count = 12;
  constexpr std::array tilts{0.3, 0.5, 0.8};  // [rad]
  int others = 0;
  for (int i = 0; i < count; ++i) {
    for (const double tilt : tilts) {
      others += tumbles(lowest + (i + 0.5) * interval, tilt, mesh) ? 0 : 1;
    }
  }
  return {.measured = lowest + interval * others / static_cast<double>(tilts.size()), .exact = published};
}

}  // namespace drape::report::validation
