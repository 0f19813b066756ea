// Fast bodies and sheets do not pass through each other. Near a body contact substeps are at most 1/300 s long. 50 m/s
// in such a substep is as far as 10 m/s in a whole step of 1/60 s: 17 cm.
#include "contact/contact_scene.hpp"
#include "test_meshes.hpp"

#include <gtest/gtest.h>
#include <cmath>
#include <functional>
#include <numbers>

namespace drape::sim::contact {
namespace {

using testing::bodyAt;
using testing::ContactScene;
using testing::freeSheet;

/// Speed and step length.
struct Pace {
  double speed;     // [m/s]
  double timeStep;  // [s]
};
constexpr Pace inContactSubsteps{10.0, 1.0 / 60.0};
constexpr Pace inOneContactSubstep{50.0, 1.0 / 300.0};

/// A spike: four triangles with a common tip.
std::shared_ptr<const MeshShape> spike() {
  MeshShape mesh;
  mesh.positions = {
      {0.0, 0.3, 0.0}, {0.03, -0.3, 0.03}, {0.03, -0.3, -0.03}, {-0.03, -0.3, -0.03}, {-0.03, -0.3, 0.03}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}};
  return std::make_shared<const MeshShape>(std::move(mesh));
}

struct Thrown {
  const char* name;
  BodyShape shape;
};

/// Bodies of each kind, smaller than a triangle of the sheet or sharper than its edges.
std::vector<Thrown> thrownBodies() {
  return {{"sphere", SphereShape{0.04}},
          {"capsule", CapsuleShape{0.02, 0.15}},
          {"box", BoxShape{Vec3(0.05, 0.04, 0.06)}},
          {"spike", spike()}};
}

/// The surface of a shape as a deforming mesh; `at(time, point)` maps its points.
Body movingMesh(const BodyShape& shape, double seconds, double frameTime,
                const std::function<Vec3(double time, const Vec3& point)>& at) {
  const BodySurface surface = surfaceOf(shape);
  MeshShape moving{surface.positions, surface.triangles, {}, frameTime, false};
  for (int k = 0; k * frameTime < seconds + frameTime; ++k) {
    moving.frames.emplace_back();
    for (const Vec3& point : surface.positions) {
      moving.frames.back().push_back(at(k * frameTime, point));
    }
  }
  moving.positions = moving.frames.front();
  return bodyAt(std::make_shared<const MeshShape>(std::move(moving)), Vec3::Zero());
}

constexpr double throwDistance = 3.5;  // [m]

/// Uniform motion by keyframes; the body is at height 0 at half of the time.
Body flying(const BodyShape& shape, double speed, const Vec3& aim, const Vec3& rotation) {
  const double flight = throwDistance / speed;
  Body body = bodyAt(shape, Vec3::Zero());
  body.motion.keyframes.clear();
  for (int k = -20; k <= 20; ++k) {
    const double time = 0.5 * flight + 0.5 * flight * k / 2.0;
    body.motion.keyframes.push_back({time, aim + Vec3(0.0, speed * (time - 0.5 * flight), 0.0), rotation});
  }
  return body;
}

/// The same as a deforming mesh, slightly rotated.
Body flyingMesh(const BodyShape& shape, double speed, const Vec3& aim) {
  const Eigen::Quaterniond turn(Eigen::AngleAxisd(0.3, Vec3(0.6, 0.0, 0.8)));
  const double flight = throwDistance / speed;
  return movingMesh(shape, flight, 1.0 / 300.0, [=](double time, const Vec3& point) -> Vec3 {
    return aim + Vec3(0.0, speed * (time - 0.5 * flight), 0.0) + turn * point;
  });
}

/// Throws a body at a sheet in free space, and counts intersecting pairs at every step.
void throwThrough(const char* name, const Body& body, const Pace& pace) {
  const double flight = throwDistance / pace.speed;
  ContactScene scene(buildClothModel(testing::sheet(5), 0.1, MassLumping::Area, {}), {body}, "xpbd");
  scene.parameters.timeStep = pace.timeStep;
  scene.parameters.material.stiffness = 30.0;
  scene.parameters.gravity = 0.0;
  scene.run(flight, [&](const StepReport& report) {
    ASSERT_EQ(scene.pairs(0), 0) << name << " at " << scene.state.time << " s";
    EXPECT_EQ(report.contact.infeasible, 0) << name << " at " << scene.state.time << " s";
    EXPECT_EQ(report.contact.overlaps, 0) << name << " at " << scene.state.time << " s";
  });
  // The body has carried the sheet along.
  Eigen::AlignedBox3d box;
  for (const Vec3& position : scene.state.positions) {
    box.extend(position);
  }
  EXPECT_GT(box.max().y(), 0.25 * throwDistance) << name;
}

const std::array<Vec3, 3> aims{Vec3(0.55, 0.0, 0.60), Vec3(0.5, 0.0, 0.625), Vec3(0.5, 0.0, 0.5)};

TEST(FastMotion, noBodyPassesAFaceAnEdgeOrAVertex) {
  const Vec3 upright = Vec3::Zero();
  const Vec3 aslant(0.3, 0.5, 0.2);
  for (const Thrown& thrown : thrownBodies()) {
    for (const Vec3& aim : aims) {
      throwThrough(thrown.name, flying(thrown.shape, 50.0, aim, upright), inOneContactSubstep);
      throwThrough(thrown.name, flying(thrown.shape, 50.0, aim, aslant), inOneContactSubstep);
    }
    throwThrough(thrown.name, flying(thrown.shape, 10.0, aims[0], upright), inContactSubsteps);
  }
}

TEST(FastMotion, noRotatingBodyPasses) {
  for (const Thrown& thrown : thrownBodies()) {
    Body body = flying(thrown.shape, 50.0, aims[0], Vec3::Zero());
    body.motion.spin = Vec3(40.0, 0.0, 90.0);  // a third of a radian in a contact substep, more than 16 turns a second
    throwThrough(thrown.name, body, inOneContactSubstep);
  }
}

TEST(FastMotion, noDeformingMeshPasses) {
  for (const Thrown& thrown : thrownBodies()) {
    for (const Vec3& aim : aims) {
      throwThrough(thrown.name, flyingMesh(thrown.shape, 50.0, aim), inOneContactSubstep);
    }
    throwThrough(thrown.name, flyingMesh(thrown.shape, 10.0, aims[0]), inContactSubsteps);
  }
}

void throwSheet(const char* name, const Body& body, const Eigen::Quaterniond& turn, const Pace& pace) {
  ContactScene scene(freeSheet(9, 0.6, Vec3(0.0, 0.9, 0.0), turn), {body}, "xpbd");
  scene.parameters.timeStep = pace.timeStep;
  scene.parameters.material.stiffness = 100.0;
  for (Vec3& velocity : scene.state.velocities) {
    velocity = Vec3(0.0, -pace.speed, 0.0);
  }
  int contacts = 0;
  scene.run(5.0 / pace.speed, [&](const StepReport& report) {
    ASSERT_EQ(scene.pairs(0), 0) << name << " at " << scene.state.time << " s";
    EXPECT_EQ(report.contact.infeasible, 0) << name;
    contacts += report.contact.bodyContacts;
  });
  EXPECT_GT(contacts, 0) << name;
}

TEST(FastMotion, aSheetPassesNoKindOfBody) {
  testing::RandomVectors random(5);
  for (const Thrown& thrown : thrownBodies()) {
    for (int i = 0; i < 4; ++i) {
      const Vec3 axis = random.next(1.0);
      const Eigen::Quaterniond turn(Eigen::AngleAxisd(axis.norm(), axis.normalized()));
      const Body body = bodyAt(thrown.shape, Vec3::Zero(), random.next(1.0));
      throwSheet(thrown.name, body, turn, inOneContactSubstep);
      if (i == 0) {
        throwSheet(thrown.name, body, turn, inContactSubsteps);
      }
    }
  }
}

TEST(FastMotion, aSheetDoesNotPassAPlane) {
  for (const double slope : {0.0, 0.6}) {
    const Body plane = bodyAt(PlaneShape{}, Vec3::Zero(), Vec3(0.0, 0.0, slope));
    throwSheet("plane", plane, Eigen::Quaterniond(Eigen::AngleAxisd(0.4, Vec3::UnitX())), inOneContactSubstep);
  }
}

/// A bowl with a rim: concave, with a sharp corner all around.
MeshShape meshOfBowl() {
  ClothMesh sheet = testing::sheet(25);
  for (Vec3& position : sheet.positions) {
    position -= Vec3(0.5, 0.0, 0.5);
    const double far = position.norm();
    position.y() = far < 0.3 ? 2.0 * far * far - 0.18 : 0.5 * (0.3 - far);
  }
  return {sheet.positions, sheet.triangles, {}, 1.0, false};
}

TEST(FastMotion, aSheetDoesNotPassAConcaveMesh) {
  for (const Pace& pace : {inContactSubsteps, inOneContactSubstep}) {
    const Body body = bodyAt(std::make_shared<const MeshShape>(meshOfBowl()), Vec3::Zero());
    ContactScene scene(freeSheet(19, 0.7, Vec3(0.02, 0.4, 0.01)), {body}, "xpbd");
    scene.parameters.timeStep = pace.timeStep;
    scene.parameters.material.stiffness = 50.0;
    for (Vec3& velocity : scene.state.velocities) {
      velocity = pace.speed * Vec3(0.125, -1.0, 0.0);
    }
    int contacts = 0;
    scene.run(6.0 / pace.speed, [&](const StepReport& report) {
      ASSERT_EQ(scene.pairs(0), 0) << scene.state.time;
      EXPECT_EQ(report.contact.infeasible, 0);
      contacts = std::max(contacts, report.contact.bodyContacts);
    });
    EXPECT_GT(contacts, 100);
  }
}

/// A deforming mesh with a sheet that lies or falls on it.
/// @param strained it deforms so much in a contact substep that feasible vertices may be counted as infeasible
void collideWithDeforming(const char* name, const Body& body, double height, double fall, const Pace& pace,
                          double seconds, bool strained = false) {
  ContactScene scene(freeSheet(15, 0.7, Vec3(0.0, height, 0.0)), {body}, "xpbd");
  scene.parameters.timeStep = pace.timeStep;
  scene.parameters.material.stiffness = 50.0;
  for (Vec3& velocity : scene.state.velocities) {
    velocity.y() = -fall;
  }
  int contacts = 0;
  scene.run(seconds, [&](const StepReport& report) {
    ASSERT_EQ(scene.pairs(0), 0) << name << " at " << scene.state.time;
    EXPECT_TRUE(strained || report.contact.infeasible == 0) << name << " at " << scene.state.time;
    EXPECT_EQ(report.contact.overlaps, 0) << name << " at " << scene.state.time;
    contacts += report.contact.bodyContacts;
  });
  EXPECT_GT(contacts, 0) << name;
}

TEST(FastMotion, noExpandingOrOscillatingBallPasses) {
  for (const double period : {0.2, 0.04}) {  // [s] at most 2 and 10 m/s
    const Pace pace{0.0, period / 12.0};     // 1/60 and 1/300 s
    const auto wave = [=](double time) { return std::sin(2.0 * std::numbers::pi * time / period); };
    const Body swelling = movingMesh(SphereShape{0.2}, 0.6, period / 12.0, [&](double time, const Vec3& point) -> Vec3 {
      return (1.0 + 0.25 * wave(time)) * point;
    });
    const Body swaying = movingMesh(SphereShape{0.2}, 0.6, period / 12.0, [&](double time, const Vec3& point) -> Vec3 {
      return point + Vec3(0.06 * wave(time), 0.0, 0.0);
    });
    collideWithDeforming("swelling", swelling, 0.23, 0.0, pace, 2.0 * period);
    collideWithDeforming("swaying", swaying, 0.23, 0.0, pace, 2.0 * period);
    collideWithDeforming("swelling while the sheet falls", swelling, 0.4, 10.0, pace, 0.08);
  }
}

TEST(FastMotion, noSwingingRodPassesAsADeformingMesh) {
  // Its end moves at 50 m/s, 17 cm per contact substep.
  const double turning = 50.0 / 0.5;  // [rad/s]
  const Body rod = movingMesh(BoxShape{Vec3(0.01, 0.02, 0.5)}, 0.1, 1.0 / 300.0, [=](double time, const Vec3& point) {
    const Eigen::AngleAxisd turn(turning * time, Vec3::UnitX());
    return Vec3(Vec3(0.0, -0.1, -0.5) + turn * (Eigen::AngleAxisd(0.8, Vec3::UnitX()) * (point + Vec3(0.0, 0.0, 0.5))));
  });
  collideWithDeforming("rod", rod, 0.0, 0.0, inOneContactSubstep, 0.1, true);
}

}  // namespace
}  // namespace drape::sim::contact
