// Steps that are too long for contact at their end alone.
#include "contact/meeting.hpp"
#include "sim/diagnostics.hpp"
#include "sim/measures.hpp"
#include "test_meshes.hpp"

#include <gtest/gtest.h>
#include <algorithm>

namespace drape {
namespace {

/// A free sheet so high above the middle of a ball of 0.3 m, in steps of 1/60 s.
testing::Meeting sheetOverBall(const std::string& solver, double height = 0.4) {
  ClothMesh mesh = testing::sheet(13);
  for (Vec3& position : mesh.positions) {
    position += Vec3(-0.5, height, -0.5);
  }
  const Body ball = testing::bodyAt(SphereShape{0.3}, Vec3::Zero());
  testing::Meeting meeting(buildClothModel(mesh, 0.15, MassLumping::Area, {}), {ball}, solver);
  meeting.parameters.timeStep = 1.0 / 60.0;
  return meeting;
}

TEST(Rounds, letNoSolverGainEnergyOnABallInLongSteps) {
  for (const char* solver : {"newton", "pcg", "xpbd", "vbd", "local_global", "one_iteration", "auto"}) {
    testing::Meeting meeting = sheetOverBall(solver);
    const double start = energyOf(meeting.model(), meeting.parameters, meeting.state).total();
    double most = start;
    double longest = 0.0;
    meeting.run(1.0, [&](const StepReport&) {
      most = std::max(most, energyOf(meeting.model(), meeting.parameters, meeting.state).total());
      longest = std::max(longest, maxStretch(meeting.model(), meeting.state));
    });
    EXPECT_LT(most, start + 0.05) << solver << " [J]";
    EXPECT_LT(longest, 0.4) << solver;
    EXPECT_EQ(meeting.pairs(0), 0) << solver;
  }
}

TEST(Rounds, areAsManyAsKeepThemShortAndShareTheSubsteps) {
  for (const auto& [timeStep, rounds] : {std::pair(1.0 / 60.0, 5), {1.0 / 150.0, 2}, {1.0 / 300.0, 1}, {1e-3, 1}}) {
    constexpr double near = 0.307;  // and yet too far to contact within the step
    testing::Meeting meeting = sheetOverBall("xpbd", near);
    meeting.parameters.timeStep = timeStep;
    meeting.parameters.substeps = 10;
    meeting.step();
    EXPECT_EQ(meeting.stepper().contactSubsteps(), rounds) << timeStep;
    EXPECT_EQ(meeting.state.time, timeStep);
    // In free fall nothing depends on the rounds but how long the substeps are: all are as long, 10 to a step.
    testing::Meeting alone = sheetOverBall("xpbd", near);
    alone.parameters = meeting.parameters;
    alone.parameters.contact.bodies = false;
    alone.step();
    EXPECT_EQ(alone.stepper().contactSubsteps(), 1);
    EXPECT_LT((alone.state.positions[0] - meeting.state.positions[0]).norm(), 1e-6) << timeStep;
  }
}

TEST(Rounds, areTakenOnlyWhereABodyIsNear) {
  for (const char* solver : {"xpbd", "auto"}) {
    testing::Meeting meeting = sheetOverBall(solver, 0.5);
    meeting.step();
    EXPECT_EQ(meeting.stepper().contactSubsteps(), 1) << solver;
    for (Vec3& velocity : meeting.state.velocities) {
      velocity.y() = -20.0;  // 0.33 m in a step
    }
    meeting.step();
    EXPECT_GE(meeting.stepper().contactSubsteps(), 5) << solver;
  }
}

}  // namespace
}  // namespace drape
