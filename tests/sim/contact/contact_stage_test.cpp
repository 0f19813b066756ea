#include "sim/contact/contact_stage.hpp"

#include "contact/contact_scene.hpp"
#include "sim/contact/bodies/world.hpp"
#include "sim/stepping/stepper.hpp"
#include "test_meshes.hpp"

#include <gtest/gtest.h>
#include <limits>

namespace drape::sim::contact {
namespace {

TEST(ContactStage, costsNothingAndChangesNothingWhileItIsOff) {
  const auto model = testing::pinnedSheet(5);
  ClothState state = testing::shaken(*model, 0.05, 1);
  const std::uint64_t before = stateHash(state);
  StepInputs inputs;
  const std::vector<BodyStep> none;
  inputs.bodies = &none;
  ContactStage stage;
  stage.begin({}, inputs, state);
  const ContactReport report = stage.resolve(*model, {}, {}, inputs, state);
  EXPECT_EQ(stateHash(state), before);
  EXPECT_EQ(stage.unresolved(), nullptr);
  EXPECT_EQ(report.bodySeconds, 0.0);
  EXPECT_EQ(report.selfSeconds, 0.0);
}

TEST(ContactStage, returnsForAClothThatDiverges) {
  const BodySurface ball = surfaceOf(SphereShape{0.3});
  const auto mesh = std::make_shared<const MeshShape>(
      MeshShape{ball.positions, ball.triangles, {ball.positions, ball.positions}, 0.1, true});
  for (const double far :
       {1e7, 1e9, 1e160, 1e300, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
    for (const bool position : {true, false}) {
      testing::ContactScene scene(testing::freeSheet(9, 1.0, Vec3(0.0, 0.31, 0.0)),
                                  {testing::bodyAt(mesh, Vec3::Zero()), testing::bodyAt(PlaneShape{}, Vec3::Zero()),
                                   testing::bodyAt(CapsuleShape{}, Vec3(0.3, 0.0, 0.3))},
                                  "verlet");
      scene.parameters.contact.self = SelfCollision::Hash;
      for (std::size_t v = 0; v < 40; ++v) {
        (position ? scene.state.positions : scene.state.velocities)[v] = Vec3(0.0, far, -far);
      }
      scene.step();
      EXPECT_FALSE(far > 1e100 && position && isFinite(scene.state) && scene.state.positions[0].norm() < 1.0);
    }
  }
}

/// The end of a step of a solver that has diverged, with the cloth in pieces of its own size.
TEST(ContactStage, leavesClothToASolverThatDivergesInsteadOfGuardingAllPairs) {
  const auto model = buildClothModel(testing::sheet(9), 0.1, MassLumping::Area, {0, 8});
  for (const auto& [speed, guards] : {std::pair{40.0, true}, std::pair{4000.0, false}}) {
    StepParameters parameters;
    parameters.timeStep = 1.0 / 300.0;
    parameters.contact.self = SelfCollision::Exact;
    ClothState state = stateAtRest(model->restPositions);
    ContactStage stage;
    stage.begin(parameters.contact, {}, state);
    testing::RandomVectors random(2);
    for (int v = 0; v < model->vertexCount(); ++v) {
      state.positions[v] += model->pinned[v] ? Vec3(Vec3::Zero()) : random.next(speed * parameters.timeStep);
    }
    const std::vector<Vec3> moved = state.positions;
    stage.resolve(*model, parameters, parameters.contact, {}, state);
    EXPECT_EQ(state.positions != moved, guards) << speed << " m/s";
    EXPECT_EQ(state.hasNoSelfIntersection, guards) << speed << " m/s";
  }
}

}  // namespace
}  // namespace drape::sim::contact
