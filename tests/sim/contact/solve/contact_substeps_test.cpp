// Steps that need contact substeps.
#include "contact/contact_scene.hpp"
#include "sim/forces/diagnostics.hpp"
#include "sim/measures/measures.hpp"
#include "test_meshes.hpp"

#include <gtest/gtest.h>
#include <algorithm>

namespace drape::sim::contact {
namespace {

/// A free sheet at that height above the centre of a ball of 0.3 m, in steps of 1/60 s.
testing::ContactScene sheetOverBall(const std::string& solver, double height = 0.4) {
  ClothMesh mesh = testing::sheet(13);
  for (Vec3& position : mesh.positions) {
    position += Vec3(-0.5, height, -0.5);
  }
  const Body ball = testing::bodyAt(SphereShape{0.3}, Vec3::Zero());
  testing::ContactScene scene(buildClothModel(mesh, 0.15, MassLumping::Area, {}), {ball}, solver);
  scene.parameters.timeStep = 1.0 / 60.0;
  return scene;
}

TEST(ContactSubsteps, letNoSolverGainEnergyOnABallInLongSteps) {
  for (const char* solver : {"newton", "pcg", "xpbd", "vbd", "local_global", "one_iteration", "auto"}) {
    testing::ContactScene scene = sheetOverBall(solver);
    const double start = energyOf(scene.model(), scene.parameters, scene.state).total();
    double largest = start;
    double longest = 0.0;
    scene.run(1.0, [&](const StepReport&) {
      largest = std::max(largest, energyOf(scene.model(), scene.parameters, scene.state).total());
      longest = std::max(longest, maxStretch(scene.model(), scene.state));
    });
    EXPECT_LT(largest, start + 0.05) << solver << " [J]";
    EXPECT_LT(longest, 0.4) << solver;
    EXPECT_EQ(scene.pairs(0), 0) << solver;
  }
}

TEST(ContactSubsteps, haveABoundedLengthAndShareTheSolverSubsteps) {
  for (const auto& [timeStep, contactSubsteps] :
       {std::pair(1.0 / 60.0, 5), {1.0 / 150.0, 2}, {1.0 / 300.0, 1}, {1e-3, 1}}) {
    constexpr double near = 0.307;  // near, but too far for contact within the step
    testing::ContactScene scene = sheetOverBall("xpbd", near);
    scene.parameters.timeStep = timeStep;
    scene.parameters.substeps = 10;
    scene.step();
    EXPECT_EQ(scene.stepper().contactSubsteps(), contactSubsteps) << timeStep;
    EXPECT_EQ(scene.state.time, timeStep);
    // In free fall only the length of the solver substeps matters: all are equal, 10 per step.
    testing::ContactScene alone = sheetOverBall("xpbd", near);
    alone.parameters = scene.parameters;
    alone.parameters.contact.bodies = false;
    alone.step();
    EXPECT_EQ(alone.stepper().contactSubsteps(), 1);
    EXPECT_LT((alone.state.positions[0] - scene.state.positions[0]).norm(), 1e-6) << timeStep;
  }
}

TEST(ContactSubsteps, areTakenOnlyNearABody) {
  for (const char* solver : {"xpbd", "auto"}) {
    testing::ContactScene scene = sheetOverBall(solver, 0.5);
    scene.step();
    EXPECT_EQ(scene.stepper().contactSubsteps(), 1) << solver;
    for (Vec3& velocity : scene.state.velocities) {
      velocity.y() = -20.0;  // 0.33 m in a step
    }
    scene.step();
    EXPECT_GE(scene.stepper().contactSubsteps(), 5) << solver;
  }
}

}  // namespace
}  // namespace drape::sim::contact
