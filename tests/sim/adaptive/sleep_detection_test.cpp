#include "sim/adaptive/sleep_detection.hpp"

#include "fabric_cloths.hpp"
#include "sim/adaptive/tuning.hpp"
#include "sim/contact/bodies/body.hpp"
#include "sim/forces/stability.hpp"
#include "sim/measures/measures.hpp"
#include "sim/stepping/stepper.hpp"
#include "test_meshes.hpp"

#include <gtest/gtest.h>
#include <cmath>
#include <functional>
#include <vector>

namespace drape::sim::adaptive {
namespace {

/// A sheet of that size [m] that hangs from its upper edge.
std::shared_ptr<const ClothModel> hangingSheet(double size) {
  ClothMesh mesh = testing::sheet(5);
  for (Vec3& position : mesh.positions) {
    position = size * Vec3(position.x(), -position.z(), 0.0);
  }
  return buildClothModel(mesh, 0.1, MassLumping::Uniform, {0, 1, 2, 3, 4});
}

/// Parameters with which the sheet comes to rest within some seconds.
StepParameters dampedParameters() {
  StepParameters parameters;
  parameters.material.stiffness = 200.0;
  parameters.material.damping = 0.03;
  parameters.air.drag = 1.0;
  return parameters;
}

class Sleeping : public ::testing::Test {
 protected:
  /// Takes so many steps and returns in how many of them the cloth slept.
  int sleepingSteps(int steps) {
    int sleeping = 0;
    for (int step = 0; step < steps; ++step) {
      sleeping += stepper.step(*model, parameters, inputs, state).choice.value().sleeping ? 1 : 0;
    }
    return sleeping;
  }

  /// Takes steps until the sheet sleeps.
  void settle() {
    for (int second = 0; second < 120 && sleepingSteps(1) == 0; ++second) {
      sleepingSteps(150);
    }
    ASSERT_EQ(sleepingSteps(10), 10) << "it does not come to rest";
  }

  /// Makes a horizontal plane at that height [m] the only body.
  void placeGround(double height) {
    ground.shape = contact::PlaneShape{};
    bodies.assign(1, contact::BodyStep{});
    bodies.front().body = &ground;
    bodies.front().start.position.y() = bodies.front().end.position.y() = height;
    inputs.bodies = &bodies;
  }

  std::shared_ptr<const ClothModel> model = hangingSheet(1.0);
  contact::Body ground;
  std::vector<contact::BodyStep> bodies;
  StepParameters parameters = dampedParameters();
  StepInputs inputs;
  ClothState state = stateAtRest(model->restPositions);
  Stepper stepper{"auto"};
};

TEST_F(Sleeping, leavesClothAtRestInPlace) {
  settle();
  const auto hash = stateHash(state);
  const double time = state.time;
  EXPECT_EQ(sleepingSteps(150), 150);
  EXPECT_EQ(stateHash(state), hash) << "to the last bit";
  EXPECT_NEAR(state.time, time + 1.0, 1e-9) << "time goes on";
}

TEST_F(Sleeping, isNearTheConvergedEquilibrium) {
  settle();
  ClothState exact = state;
  Stepper verlet("verlet");
  StepParameters fine = parameters;
  fine.substeps = static_cast<int>(std::ceil(2.0 * fine.timeStep / verletStepLimit(*model, fine)));
  for (int step = 0; step < 600; ++step) {
    verlet.step(*model, fine, {}, exact);
  }
  EXPECT_LT(meanDistance(state.positions, exact.positions), 0.1 * parameters.automatic.errorTolerance);
}

TEST_F(Sleeping, endsWhenAnythingChanges) {
  settle();
  const ClothState atRest = state;
  const std::vector<std::pair<const char*, std::function<void()>>> changes{
      {"gravity", [&] { parameters.gravity *= 1.0 + 1e-9; }},
      {"stiffness", [&] { parameters.material.stiffness += 1e-3; }},
      {"wind", [&] { parameters.air.wind.x() = 1e-6; }},
      {"a pin that moves", [&] { state.positions[0].x() += 1e-6; }},
      {"a vertex that is pushed", [&] { state.velocities[12].z() = 1e-6; }},
      {"a pin let go", [&] { model = withPins(*model, std::vector<bool>(25, false)); }},
      {"mass", [&] { model = withMass(*model, 0.11, MassLumping::Uniform); }},
      {"an attachment", [&] {
         inputs.attachment = Attachment{{0, Vec3::Constant(1.0 / 3.0), Vec3::Zero()}, {1.0, 1.0}};
       }}};
  for (const auto& [what, change] : changes) {
    const auto before = model;
    state = atRest;
    parameters = dampedParameters();
    inputs = {};
    ASSERT_EQ(sleepingSteps(1), 1);
    change();
    EXPECT_EQ(sleepingSteps(1), 0) << what;
    model = before;
  }
}

/// The sheet, with warp along that direction.
std::shared_ptr<const ClothModel> asFabricWithWarp(const ClothModel& model, const fabric::Material& material,
                                                   const Vec3& warp) {
  return fabric::withFabric(model, material, fabric::warpAlong(warp, model.restPositions, model.triangles));
}

TEST_F(Sleeping, endsWhenTheFabricChanges) {
  fabric::Material material = testing::woven();
  material.stiffeningWarp = 100.0;
  fabric::Material stiffening = material;
  stiffening.stiffeningStrain *= 0.5;
  const auto before = asFabricWithWarp(*model, material, Vec3::UnitX());
  const auto stiffer = asFabricWithWarp(*model, stiffening, Vec3::UnitX());
  const auto turned = asFabricWithWarp(*model, material, Vec3::UnitY());
  ASSERT_EQ(before->fabricStiffness, stiffer->fabricStiffness) << "the stiffness at rest does not tell them apart";
  const SleepConditions conditions{parameters, parameters.contact, inputs, 1e-3};
  for (const auto& changed : {stiffer, turned}) {
    SleepDetection detection;
    StepMemory memory;
    state = stateAtRest(model->restPositions);
    EXPECT_FALSE(detection.isAsleep(*before, conditions, memory, state)) << "the reference";
    state.time = 2.0 * tuning.sleepTime;
    EXPECT_TRUE(detection.isAsleep(*before, conditions, memory, state));
    EXPECT_TRUE(detection.isAsleep(*before, conditions, memory, state));
    EXPECT_FALSE(detection.isAsleep(*changed, conditions, memory, state));
  }
}

TEST_F(Sleeping, endsWhenABodyMovesOrIsTakenAway) {
  placeGround(-1.004);  // so that the sheet's lower edge stands on it
  const contact::BodyStep place = bodies.front();
  settle();
  const ClothState atRest = state;
  bodies[0].end.position.y() += 1e-6;
  EXPECT_EQ(sleepingSteps(1), 0) << "it moves";
  state = atRest;
  bodies[0] = place;
  ASSERT_EQ(sleepingSteps(1), 1);
  bodies.clear();
  EXPECT_EQ(sleepingSteps(1), 0) << "it is gone";
}

TEST_F(Sleeping, comesToClothOfAnySize) {
  for (const double size : {1e-3, 1e3}) {
    const double slower = std::sqrt(size);
    model = hangingSheet(size);
    state = stateAtRest(model->restPositions);
    parameters = dampedParameters();
    parameters.timeStep *= slower;
    parameters.material.stiffness /= size;
    parameters.material.damping /= slower;
    parameters.air.drag /= size * size * size;
    parameters.automatic.errorTolerance *= size;
    parameters.automatic.costBudget /= slower;
    int sleeping = 0;
    for (int round = 0; round < 120 && sleeping == 0; ++round) {
      sleeping = sleepingSteps(150);
    }
    EXPECT_GT(sleeping, 0) << size;
  }
}

/// A body elsewhere supports nothing.
TEST_F(Sleeping, needsABodyBelowFreeCloth) {
  model = buildClothModel(testing::sheet(5), 0.1, MassLumping::Uniform, {});
  state = stateAtRest(model->restPositions);
  parameters.gravity = 0.0;
  placeGround(-1.0);
  EXPECT_EQ(sleepingSteps(450), 0) << "it floats above the ground without weight";
  parameters.gravity = 9.81;
  settle();
  EXPECT_LT(state.positions[12].y(), -0.99);
}

TEST_F(Sleeping, doesNotComeToClothThatTheAirSupports) {
  // A wind from below that balances the weight of the flat sheet.
  model = buildClothModel(testing::sheet(5), 0.1, MassLumping::Area, {});
  state = stateAtRest(model->restPositions);
  parameters.air.drag = 1.0;
  parameters.air.lift = 0.0;
  placeGround(-1.0);
  parameters.gravity = 0.5 * parameters.air.density * 4.0 / 0.1;
  parameters.air.wind = Vec3(0.0, 2.0, 0.0);
  EXPECT_EQ(sleepingSteps(600), 0);
}

/// A sheet between its four corners in line with the wind. Lift makes every ripple grow, but at the start there is
/// none, or only that of rounding, which differs between float and double.
TEST_F(Sleeping, doesNotComeToASheetInLineWithTheWind) {
  placeGround(-5.0);
  const Mat3 turned = Eigen::AngleAxisd(0.5, Vec3(1.0, 2.0, 3.0).normalized()).toRotationMatrix();
  for (const Mat3& rotation : {turned, Mat3(Mat3::Identity())}) {
    for (const Precision precision : {Precision::Float, Precision::Double}) {
      ClothMesh mesh = testing::sheet(17);
      for (Vec3& position : mesh.positions) {
        position = rotation * Vec3(position.x(), -position.z(), 0.0) + Vec3(0.0, 0.3, 0.0);
      }
      model = buildClothModel(mesh, 0.15, MassLumping::Area, {0, 16, 272, 288});
      state = stateAtRest(model->restPositions);
      parameters.material.stiffness = 100.0;
      parameters.material.damping = 0.01;
      parameters.gravity = 0.0;
      parameters.air.drag = 0.5;
      parameters.air.lift = 0.3;
      parameters.air.wind = rotation * Vec3(8.0, 0.0, 0.0);
      parameters.timeStep = 1.0 / 150.0;
      parameters.precision = precision;
      EXPECT_EQ(sleepingSteps(450), 0);
      double largest = 0.0;
      for (std::size_t v = 0; v < state.positions.size(); ++v) {
        largest = std::max(largest, (state.positions[v] - model->restPositions[v]).norm());
      }
      EXPECT_GT(largest, 0.01) << "[m]";
    }
  }
}

TEST_F(Sleeping, comesToClothThatADisturbanceInTheWindLeavesInPlace) {
  parameters.air.wind = Vec3(0.0, 0.0, 0.5);
  settle();
  EXPECT_TRUE(stepMemoryOf(state).disturbed);
}

TEST_F(Sleeping, comesToFreeClothOnABodyThatStandsAnywhere) {
  // At these heights a body that is interpolated over a step would be displaced by rounding.
  model = buildClothModel(testing::sheet(5), 0.1, MassLumping::Uniform, {});
  for (const double height : {-0.02, -0.1, -0.07}) {
    state = stateAtRest(model->restPositions);
    placeGround(height);
    settle();
  }
}

TEST_F(Sleeping, isNotForUndampedOrUnsupportedCloth) {
  parameters.gravity = 0.0;
  parameters.material.damping = 0.0;
  parameters.air.drag = 0.0;
  state = stateAtRest(model->restPositions);
  EXPECT_EQ(sleepingSteps(300), 0) << "undamped";
  parameters.material.damping = 0.03;
  model = withPins(*model, std::vector<bool>(25, false));
  state = stateAtRest(model->restPositions);
  for (Vec3& velocity : state.velocities) {
    velocity.x() = 1e-7;
  }
  EXPECT_EQ(sleepingSteps(450), 0) << "free cloth drifts on, however slowly";
  EXPECT_NEAR(state.positions[12].x() - model->restPositions[12].x(), 3e-7, 1e-12);
}

/// A sheet as a pendulum, released with a small deflection; or in air so dense that it creeps.
TEST_F(Sleeping, doesNotFreezeSlowMotion) {
  for (const double drag : {0.0, 3000.0}) {
    state = stateAtRest(model->restPositions);
    const double aside = drag > 0.0 ? 0.05 : 2e-4;
    for (Vec3& position : state.positions) {
      position.z() = -aside * position.y();
    }
    parameters = dampedParameters();
    parameters.material.damping = 1e-4;
    parameters.air.drag = drag;
    ClothState exact = state;
    Stepper verlet("verlet");
    StepParameters fine = parameters;
    fine.substeps = static_cast<int>(std::ceil(4.0 * fine.timeStep / verletStepLimit(*model, fine)));
    MotionKept kept;
    for (int step = 0; step < 1200; ++step) {
      const auto [own, reference] = std::pair(state.positions, exact.positions);
      stepper.step(*model, parameters, {}, state);
      verlet.step(*model, fine, {}, exact);
      kept.add(*model, {own, state.positions, reference, exact.positions});
    }
    EXPECT_GT(kept.value(), 0.95) << drag;
  }
}

}  // namespace
}  // namespace drape::sim::adaptive
