// Contacts that `auto` resolves in its substeps.
#include "contact/contact_scene.hpp"
#include "sim/forces/diagnostics.hpp"
#include "test_meshes.hpp"

#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace drape::sim::contact {
namespace {

/// A free sheet at that height above a ball of 0.3 m, in steps of 1/150 s.
testing::ContactScene sheetOnBall(int n, double height, const Vec3& ballVelocity = Vec3::Zero()) {
  ClothMesh mesh = testing::sheet(n);
  for (Vec3& position : mesh.positions) {
    position += Vec3(-0.47, height, -0.52);
  }
  Body ball = testing::bodyAt(SphereShape{0.3}, Vec3::Zero());
  // The motion is at rest at the first and the last keyframe, and uniform between the others.
  ball.motion.keyframes.clear();
  for (const double time : {-20.0, -10.0, 10.0, 20.0}) {
    ball.motion.keyframes.push_back({time, time * ballVelocity, Vec3::Zero()});
  }
  testing::ContactScene scene(buildClothModel(mesh, 0.15, MassLumping::Area, {}), {ball}, "auto");
  scene.parameters.timeStep = 1.0 / 150.0;
  scene.parameters.material.stiffness = 3000.0;
  scene.parameters.material.damping = 0.003;
  for (Vec3& velocity : scene.state.velocities) {
    velocity = ballVelocity;
  }
  return scene;
}

TEST(SubstepContacts, leaveLittleToContactAtTheEndOfAStep) {
  testing::ContactScene scene = sheetOnBall(25, 0.32);
  double added = 0.0;  // [J]
  int contacts = 0;
  scene.run(1.0, [&](const StepReport& report) {
    contacts = std::max(contacts, report.contact.bodyContacts);
    if (const ClothState* unresolved = scene.stepper().contact().unresolved()) {
      added += std::abs(energyOf(scene.model(), scene.parameters, scene.state).total() -
                        energyOf(scene.model(), scene.parameters, *unresolved).total());
    }
    EXPECT_EQ(scene.pairs(0), 0);
  });
  EXPECT_GT(contacts, 50);
  EXPECT_LT(added, 0.02 * 0.15 * 9.81);  // 2 % of a fall by the sheet's length
}

TEST(SubstepContacts, needNoMoreContactSubstepsForStifferCloth) {
  for (const double stiffness : {10.0, 1e3, 1e5}) {
    testing::ContactScene scene = sheetOnBall(17, 0.305);
    scene.parameters.material.stiffness = stiffness;
    scene.step();
    EXPECT_EQ(scene.stepper().contactSubsteps(), 2) << stiffness;
  }
}

TEST(SubstepContacts, haveTheirTimeInTheReport) {
  testing::ContactScene high = sheetOnBall(25, 0.6);
  EXPECT_EQ(high.step().substepContactSeconds, 0.0) << "nothing is near";
  testing::ContactScene low = sheetOnBall(25, 0.32);
  StepReport last;
  low.run(0.3, [&](const StepReport& report) { last = report; });
  EXPECT_GT(last.substepContactSeconds, 0.0);
  EXPECT_EQ(last.secondsOfContact(), last.contact.bodySeconds + last.contact.selfSeconds + last.substepContactSeconds);
}

TEST(SubstepContacts, haveTheSameBitsForAnyNumberOfThreadsAndFromACopiedState) {
  testing::ContactScene one = sheetOnBall(65, 0.32);
  testing::ContactScene three = sheetOnBall(65, 0.32);
  three.parameters.threads = 3;
  one.parameters.contact.self = three.parameters.contact.self = SelfCollision::Hash;
  one.run(0.4);
  three.run(0.4);
  EXPECT_EQ(one.state.positions, three.state.positions);
  EXPECT_EQ(one.state.velocities, three.state.velocities);
  testing::ContactScene later = sheetOnBall(65, 0.32);  // with an unused stepper
  later.parameters = one.parameters;
  later.state = one.state;
  one.run(0.1);
  later.run(0.1);
  EXPECT_EQ(one.state.positions, later.state.positions);
}

TEST(SubstepContacts, areTheSameOnABodyThatMovesAtConstantVelocity) {
  const Vec3 velocity(0.7, 0.2, -0.4);
  testing::ContactScene still = sheetOnBall(17, 0.31);
  testing::ContactScene moving = sheetOnBall(17, 0.31, velocity);
  constexpr double seconds = 0.2;
  still.run(seconds);
  moving.run(seconds);
  double maxDifference = 0.0;
  for (std::size_t v = 0; v < still.state.positions.size(); ++v) {
    maxDifference =
        std::max(maxDifference, (moving.state.positions[v] - seconds * velocity - still.state.positions[v]).norm());
  }
  EXPECT_LT(maxDifference, 1e-4);
}

TEST(SubstepContacts, keepTwoLayersOfStiffClothApart) {
  // A sheet pinned along its middle: both halves swing down and hit each other.
  ClothMesh mesh = testing::sheet(17);
  std::vector<int> pins;
  for (int row = 0; row < 17; ++row) {
    pins.push_back(17 * row + 8);
  }
  testing::ContactScene scene(buildClothModel(mesh, 0.1, MassLumping::Uniform, pins), {}, "auto");
  scene.parameters.contact.self = SelfCollision::Hash;
  scene.parameters.material.stiffness = 2000.0;
  scene.parameters.material.damping = 0.001;
  scene.parameters.timeStep = 1.0 / 150.0;
  const double start = energyOf(scene.model(), scene.parameters, scene.state).total();
  double highest = start;
  int contacts = 0;
  scene.run(2.0, [&](const StepReport& report) {
    highest = std::max(highest, energyOf(scene.model(), scene.parameters, scene.state).total());
    contacts = std::max(contacts, report.contact.selfContacts);
  });
  EXPECT_GT(contacts, 20);
  EXPECT_LT(highest, start + 0.01);  // [J]; a fall by its own length releases 1 J
}

TEST(SubstepContacts, letNoTrianglesIntersectWhenASheetFallsOnItsEdgeAndFolds) {
  for (const double timeStep : {1.0 / 300.0, 1.0 / 60.0}) {
    const Eigen::Quaterniond upright(Eigen::AngleAxisd(93.0 * std::numbers::pi / 180.0, Vec3::UnitX()));
    testing::ContactScene scene(testing::freeSheet(25, 0.8, Vec3(0.0, 0.5, 0.0), upright),
                                {testing::bodyAt(PlaneShape{2.0}, Vec3::Zero())}, "auto");
    scene.parameters.contact.self = SelfCollision::Hash;
    scene.parameters.material.stiffness = 150.0;
    scene.parameters.material.damping = 0.02;
    scene.parameters.timeStep = timeStep;
    int contacts = 0;
    std::size_t pairs = 0;
    scene.run(1.0, [&](const StepReport& report) {
      contacts = std::max(contacts, report.contact.selfContacts);
      pairs = std::max(pairs, intersection::intersectingPairs({scene.state.positions, scene.model().triangles}).size());
    });
    EXPECT_GT(contacts, 20) << timeStep;
    EXPECT_EQ(pairs, 0U) << timeStep;
  }
}

}  // namespace
}  // namespace drape::sim::contact
