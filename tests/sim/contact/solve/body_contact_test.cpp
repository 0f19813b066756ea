#include "contact/contact_scene.hpp"
#include "test_meshes.hpp"

#include "sim/contact/closest_features/closest_points.hpp"
#include "sim/forces/diagnostics.hpp"
#include "sim/motion/momentum.hpp"

#include <gtest/gtest.h>
#include <cmath>
#include <numbers>

namespace drape::sim::contact {
namespace {

using testing::bodyAt;
using testing::ContactScene;
using testing::freeSheet;

constexpr double degree = std::numbers::pi / 180.0;

/// A sheet at the contact offset on an inclined plane.
std::unique_ptr<ContactScene> onSlope(double slope, double staticFriction, double kineticFriction,
                                      const std::string& solver) {
  Body plane = bodyAt(PlaneShape{5.0}, Vec3::Zero(), Vec3(0.0, 0.0, -slope));
  plane.surface.staticFriction = staticFriction;
  plane.surface.kineticFriction = kineticFriction;
  const Eigen::Quaterniond turn(Eigen::AngleAxisd(-slope, Vec3::UnitZ()));
  const double height = plane.surface.thickness + 0.5 * ContactParameters{}.thickness;
  auto scene = std::make_unique<ContactScene>(freeSheet(6, 0.5, turn * Vec3(0.0, height, 0.0), turn),
                                              std::vector<Body>{plane}, solver);
  scene->parameters.timeStep = 1.0 / 100.0;
  scene->parameters.material.stiffness = 2.0;
  // One sweep loses momentum along the springs, which lie in the sheet, and none across. Friction would then hold it.
  scene->parameters.keepMomentum = true;
  return scene;
}

Vec3 meanVelocity(const ContactScene& scene) {
  return linearMomentum(scene.model(), scene.state) / scene.model().totalMass();
}

class BodyContactWithSolver : public ::testing::TestWithParam<const char*> {};

TEST_P(BodyContactWithSolver, holdsASheetOnASlopeBelowItsFrictionAngle) {
  const auto slope = onSlope(26.0 * degree, 0.5, 0.4, GetParam());  // arctan 0.5 is 26.57 degrees
  ContactScene& scene = *slope;
  const std::vector<Vec3> start = scene.state.positions;
  scene.run(1.0);
  for (std::size_t v = 0; v < start.size(); ++v) {
    EXPECT_LT((scene.state.positions[v] - start[v]).norm(), 1e-6);
  }
}

TEST_P(BodyContactWithSolver, letsASheetSlideWithTheAccelerationThatFrictionLeaves) {
  const double slope = 35.0 * degree;
  const auto sheet = onSlope(slope, 0.5, 0.4, GetParam());
  ContactScene& scene = *sheet;
  scene.run(0.1);  // until the slow slip at the start is over
  const Vec3 down(std::cos(slope), -std::sin(slope), 0.0);
  const double before = meanVelocity(scene).dot(down);
  scene.run(0.5);
  const double expected = 9.81 * (std::sin(slope) - 0.4 * std::cos(slope)) * 0.5;
  EXPECT_NEAR(meanVelocity(scene).dot(down) - before, expected, 2e-3 * expected);
  EXPECT_LT((meanVelocity(scene) - meanVelocity(scene).dot(down) * down).norm(), 1e-5 * expected);
}

TEST(BodyContact, holdsFineStiffClothOnASlopeInFloat) {
  // In float, rounding pulls each vertex along the cloth by as much as its weight does.
  const double slope = 25.0 * degree;
  Body plane = bodyAt(PlaneShape{5.0}, Vec3::Zero(), Vec3(0.0, 0.0, -slope));
  plane.surface.staticFriction = 0.5;  // arctan 0.5 is 26.57 degrees
  plane.surface.kineticFriction = 0.4;
  const Eigen::Quaterniond turn(Eigen::AngleAxisd(-slope, Vec3::UnitZ()));
  const double height = plane.surface.thickness + 0.5 * ContactParameters{}.thickness;
  ContactScene scene(freeSheet(17, 0.3, turn * Vec3(0.0, height, 0.0), turn), {plane}, "auto");
  scene.parameters.timeStep = 1.0 / 150.0;
  scene.parameters.material.stiffness = 5000.0;
  scene.parameters.precision = Precision::Float;
  const std::vector<Vec3> start = scene.state.positions;
  scene.run(0.5);
  for (std::size_t v = 0; v < start.size(); ++v) {
    EXPECT_LT((scene.state.positions[v] - start[v]).norm(), 1e-3);
  }
}

INSTANTIATE_TEST_SUITE_P(Solvers, BodyContactWithSolver,
                         ::testing::Values("one_iteration", "verlet", "xpbd", "pcg", "auto"),
                         [](const auto& solver) { return std::string(solver.param); });

TEST(BodyContact, restsOnASphereWithoutCreeping) {
  constexpr int n = 17;
  constexpr double size =
      0.35;  // [m] small enough to lie on the sphere: cloth that hangs free keeps folding for a long time
  Body sphere = bodyAt(SphereShape{0.3}, Vec3::Zero());
  ContactScene scene(freeSheet(n, size, Vec3(0.0, 0.31, 0.0)), {sphere}, "pcg");
  scene.parameters.timeStep = 1.0 / 150.0;
  scene.parameters.material.stiffness = 50.0;
  scene.parameters.material.damping = 0.02;
  scene.parameters.air.drag = 1.0;
  scene.run(11.0);
  const std::vector<Vec3> resting = scene.state.positions;
  double jitter = 0.0;
  scene.run(1.0, [&](const StepReport& report) {
    EXPECT_EQ(report.contact.infeasible, 0);
    for (std::size_t v = 0; v < resting.size(); ++v) {
      jitter = std::max(jitter, (scene.state.positions[v] - resting[v]).norm());
    }
  });
  EXPECT_LT(jitter, 1e-4 * size / (n - 1));
  EXPECT_EQ(scene.pairs(0), 0);
  EXPECT_GT(scene.state.positions[n * n / 2].y(), 0.3);
}

TEST(BodyContact, findsBodiesToWhichOtherBodiesMoveTheCloth) {
  // Balls that rise fast move vertices of a coarse sheet far beyond the predicted motion. Fixed knobs are far from the
  // predicted motion, but near the corrected one. Vertices between both are infeasible, which must be reported.
  std::vector<Body> bodies;
  for (const double x : {0.25, 0.5, 0.75}) {
    Body ball = bodyAt(SphereShape{0.03}, Vec3(x, -0.06, 0.5));
    ball.motion.keyframes.push_back({1.0 / 60.0, Vec3(x, 0.1, 0.5), Vec3::Zero()});
    bodies.push_back(ball);
    bodies.push_back(bodyAt(SphereShape{0.02}, Vec3(x + 0.125, 0.06, 0.5)));
  }
  ContactScene scene(buildClothModel(testing::sheet(5), 0.1, MassLumping::Area, {}), bodies, "xpbd");
  scene.parameters.timeStep = 1.0 / 60.0;
  scene.parameters.gravity = 0.0;
  int infeasible = 0;
  scene.run(0.5, [&](const StepReport& report) {
    int pairs = 0;
    for (std::size_t b = 0; b < bodies.size(); ++b) {
      pairs += scene.pairs(b);
    }
    infeasible += report.contact.infeasible;
    EXPECT_TRUE(pairs == 0 || report.contact.infeasible + report.contact.overlaps > 0) << scene.state.time;
  });
  EXPECT_GT(infeasible, 0);
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    EXPECT_EQ(scene.pairs(b), 0) << b;
  }
}

TEST(BodyContact, neverAddsKineticEnergyOnBodiesThatStandStill) {
  Body sphere = bodyAt(SphereShape{0.2}, Vec3(0.0, 0.2, 0.0));
  Body ground = bodyAt(PlaneShape{}, Vec3::Zero());
  ContactScene scene(freeSheet(13, 0.8, Vec3(0.05, 0.6, 0.02)), {sphere, ground}, "one_iteration");
  scene.parameters.timeStep = 1.0 / 100.0;
  int touched = 0;
  scene.run(1.5, [&](const StepReport& report) {
    touched += report.contact.bodyContacts > 0 ? 1 : 0;
    if (const ClothState* unresolved = scene.stepper().contact().unresolved()) {
      const double before = energyOf(scene.model(), scene.parameters, *unresolved).kinetic;
      EXPECT_LE(energyOf(scene.model(), scene.parameters, scene.state).kinetic, before * (1.0 + 1e-12));
    }
  });
  EXPECT_GT(touched, 50);
}

TEST(BodyContact, resolvesAnInitialOverlapSlowlyAndReportsIt) {
  Body sphere = bodyAt(SphereShape{0.3}, Vec3(0.0, -0.28, 0.0));
  ContactScene scene(freeSheet(9, 0.5, Vec3::Zero()), {sphere}, "one_iteration");
  scene.parameters.timeStep = 1.0 / 100.0;
  scene.parameters.gravity = 0.0;
  StepReport first;
  double fastest = 0.0;
  scene.run(0.5, [&](const StepReport& report) {
    first = scene.state.time < 0.015 ? report : first;
    for (const Vec3& velocity : scene.state.velocities) {
      fastest = std::max(fastest, velocity.norm());
    }
  });
  EXPECT_GT(first.contact.overlaps, 0);
  EXPECT_NEAR(first.contact.deepestOverlap, 0.02, 1e-9);
  EXPECT_LT(fastest, 0.5);
  EXPECT_EQ(scene.pairs(0), 0);
  EXPECT_EQ(scene.step().contact.overlaps, 0);
}

TEST(BodyContact, doesNotMovePins) {
  Body sphere = bodyAt(SphereShape{0.3}, Vec3(0.5, -0.5, 0.5));
  sphere.motion.keyframes.push_back({0.5, Vec3(0.5, 0.1, 0.5), Vec3::Zero()});
  ContactScene scene(testing::pinnedSheet(9), {sphere}, "one_iteration");
  const std::vector<Vec3> start = scene.state.positions;
  scene.run(0.5);
  EXPECT_EQ(scene.state.positions[0], start[0]);
  EXPECT_EQ(scene.state.positions[8], start[8]);
  EXPECT_EQ(scene.state.velocities[0], Vec3(0, 0, 0));
  EXPECT_EQ(scene.pairs(0), 0);
}

TEST(BodyContact, carriesClothAlongOnATurningTable) {
  Body table = bodyAt(BoxShape{Vec3(0.5, 0.05, 0.5)}, Vec3::Zero());
  table.motion.spin = Vec3(0.0, 2.0, 0.0);
  ContactScene scene(freeSheet(7, 0.4, Vec3(0.0, 0.055, 0.0)), {table}, "one_iteration");
  scene.parameters.timeStep = 1.0 / 100.0;
  scene.run(1.0);
  const std::size_t corner = 0;
  const Vec3 expected = Eigen::AngleAxisd(2.0, Vec3::UnitY()) * Vec3(-0.2, 0.0, -0.2);
  EXPECT_LT((scene.state.positions[corner] - expected - Vec3(0.0, 0.054, 0.0)).norm(), 0.03);
}

TEST(BodyContact, followsADeformingMesh) {
  const BodySurface box = surfaceOf(BoxShape{Vec3(0.3, 0.1, 0.3)});
  MeshShape mesh{box.positions, box.triangles, {}, 0.1, false};
  for (int k = 0; k < 6; ++k) {
    std::vector<Vec3> frame = box.positions;
    for (Vec3& position : frame) {
      position.y() += position.x() * 0.15 * k + 0.02 * k;
    }
    mesh.frames.push_back(frame);
  }
  mesh.positions = mesh.frames.front();
  ContactScene scene(freeSheet(11, 0.8, Vec3(0.0, 0.12, 0.0)),
                     {bodyAt(std::make_shared<const MeshShape>(mesh), Vec3::Zero())}, "one_iteration");
  scene.parameters.timeStep = 1.0 / 60.0;
  scene.run(1.0, [&](const StepReport& report) {
    ASSERT_EQ(scene.pairs(0), 0) << scene.state.time;
    EXPECT_EQ(report.contact.infeasible, 0) << scene.state.time;
  });
}

/// A ball that expands and shrinks, or oscillates, as a deforming mesh.
std::shared_ptr<const MeshShape> deformingBall(bool swells) {
  const BodySurface ball = surfaceOf(SphereShape{0.2});
  MeshShape mesh{ball.positions, ball.triangles, {}, 1.0 / 60.0, true};
  for (int k = 0; k < 12; ++k) {
    const double wave = std::sin(2.0 * std::numbers::pi * k / 12.0);
    std::vector<Vec3> frame = ball.positions;
    for (Vec3& position : frame) {
      position = swells ? Vec3((1.0 + 0.25 * wave) * position) : Vec3(position + Vec3(0.06 * wave, 0.0, 0.0));
    }
    mesh.frames.push_back(frame);
  }
  return std::make_shared<const MeshShape>(std::move(mesh));
}

/// A bowl with a rim: concave, with a sharp corner all around.
std::shared_ptr<const MeshShape> bowl() {
  ClothMesh sheet = testing::sheet(25);
  for (Vec3& position : sheet.positions) {
    position -= Vec3(0.5, 0.0, 0.5);
    const double far = position.norm();
    position.y() = far < 0.3 ? 2.0 * far * far - 0.18 : 0.5 * (0.3 - far);
  }
  return std::make_shared<const MeshShape>(MeshShape{sheet.positions, sheet.triangles, {}, 1.0, false});
}

TEST(BodyContact, continuesWithTheSameBitsFromACopiedStateOnAMesh) {
  const auto make = [] {
    return std::make_unique<ContactScene>(freeSheet(21, 0.7, Vec3(0.02, 0.15, 0.01)),
                                          std::vector<Body>{bodyAt(bowl(), Vec3::Zero())}, "one_iteration");
  };
  const auto first = make();
  first->parameters.timeStep = 1.0 / 100.0;
  first->run(0.3);
  // Cached data of the first one must not matter.
  const auto second = make();
  second->parameters.timeStep = first->parameters.timeStep;
  second->state = first->state;
  int contacts = 0;
  for (int i = 0; i < 20; ++i) {
    contacts += first->step().contact.bodyContacts;
    second->step();
    ASSERT_EQ(stateHash(first->state), stateHash(second->state)) << i;
  }
  EXPECT_GT(contacts, 1000);
}

TEST(BodyContact, givesTheSameBitsForAnyNumberOfThreads) {
  std::vector<std::uint64_t> hashes;
  for (const int threads : {1, 2, 5}) {
    ContactScene scene(
        freeSheet(34, 1.0, Vec3(0.0, 0.31, 0.0)),
        {bodyAt(SphereShape{0.3}, Vec3::Zero()), bodyAt(BoxShape{Vec3(0.1, 0.3, 0.1)}, Vec3(0.3, 0.0, 0.3)),
         bodyAt(deformingBall(true), Vec3(-0.3, 0.0, -0.3))},
        "one_iteration");
    scene.parameters.threads = threads;
    scene.run(0.4);
    hashes.push_back(stateHash(scene.state));
  }
  EXPECT_EQ(hashes[0], hashes[1]);
  EXPECT_EQ(hashes[0], hashes[2]);
}

}  // namespace
}  // namespace drape::sim::contact
