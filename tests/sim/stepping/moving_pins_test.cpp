#include "sim/stepping/stepper.hpp"

#include "fabric_cloths.hpp"
#include "intersection/intersections.hpp"
#include "sim/forces/diagnostics.hpp"
#include "sim/measures/measures.hpp"
#include "test_meshes.hpp"

#include <gtest/gtest.h>
#include <algorithm>
#include <vector>

namespace drape::sim {
namespace {

constexpr int size = 9;
constexpr int steps = 50;
constexpr double pullTime = 0.5;  // [s]

/// A sheet of 1 m that is pinned at two opposite edges.
std::shared_ptr<const ClothModel> sheetOnTwoEdges() {
  std::vector<int> pins;
  for (int row = 0; row < size; ++row) {
    pins.push_back(row * size);
    pins.push_back(row * size + size - 1);
  }
  return buildClothModel(testing::sheet(size), 0.1, MassLumping::Area, pins);
}

/// The pins of the right edge, each moved by that much in a step [m].
std::vector<MovedPin> rightEdge(const Vec3& by) {
  std::vector<MovedPin> moved;
  for (int row = 0; row < size; ++row) {
    moved.push_back({row * size + size - 1, by});
  }
  return moved;
}

struct Pulled {
  ClothState state;
  Energy energy;
  int retries = 0;
};

/// Pulls the right edge by a tenth of the sheet's length, without gravity and damping.
Pulled pulled(const ClothModel& model, const char* solver, int substeps) {
  StepParameters parameters;
  parameters.timeStep = pullTime / steps;
  parameters.gravity = 0.0;
  parameters.substeps = substeps;
  parameters.material.stiffness = 500.0;
  const std::vector<MovedPin> moved = rightEdge(Vec3(0.1 / steps, 0.0, 0.0));
  StepInputs inputs;
  inputs.movedPins = &moved;
  Stepper stepper(solver);
  Pulled result{.state = stateAtRest(model.restPositions), .energy = {}};
  for (int step = 0; step < steps; ++step) {
    const StepReport report = stepper.step(model, parameters, inputs, result.state);
    result.retries += report.choice ? report.choice->retries : 0;
  }
  result.energy = energyOf(model, parameters, result.state);
  return result;
}

TEST(MovingPins, StretchAClothWithAutoAsSmoothlyAsWithManyShortSteps) {
  const auto springs = sheetOnTwoEdges();
  for (const auto& model : {springs, testing::asFabric(*springs, testing::woven())}) {
    const Pulled exact = pulled(*model, "verlet", 400);
    const Pulled automatic = pulled(*model, "auto", 1);
    const bool isFabric = model->fabric != nullptr;
    EXPECT_NEAR(automatic.energy.elastic, exact.energy.elastic, 0.01 * exact.energy.elastic) << isFabric;
    EXPECT_LT(automatic.energy.kinetic, 1.2 * exact.energy.kinetic + 1e-4 * exact.energy.elastic) << isFabric;
    EXPECT_LT(meanDistance(automatic.state.positions, exact.state.positions), 2e-4) << isFabric;
    EXPECT_EQ(automatic.retries, 0) << "the guard counts the work of the pins" << isFabric;
  }
}

TEST(MovingPins, EndExactlyWhereTheyAreMovedAndRestThere) {
  const auto model = sheetOnTwoEdges();
  const Pulled automatic = pulled(*model, "auto", 1);
  for (const MovedPin& pin : rightEdge(Vec3::Zero())) {
    const Vec3 wanted = model->restPositions[pin.vertex] + Vec3(0.1, 0.0, 0.0);
    EXPECT_LT((automatic.state.positions[pin.vertex] - wanted).norm(), 1e-12);
    EXPECT_TRUE(automatic.state.velocities[pin.vertex].isZero(0.0));
  }
}

TEST(MovingPins, ThatAllMoveAlikeCarryClothWithoutDeformingIt) {
  const auto model = sheetOnTwoEdges();
  StepParameters parameters;
  parameters.gravity = 0.0;
  parameters.material.damping = 0.01;
  std::vector<MovedPin> moved;
  for (int v = 0; v < static_cast<int>(model->restPositions.size()); ++v) {
    if (model->pinned[v]) {
      moved.push_back({v, Vec3(0.01, 0.0, 0.0)});
    }
  }
  StepInputs inputs;
  inputs.movedPins = &moved;
  ClothState state = stateAtRest(model->restPositions);
  for (std::size_t v = 0; v < state.velocities.size(); ++v) {
    state.velocities[v] = model->pinned[v] ? Vec3::Zero().eval() : Vec3(0.01 / parameters.timeStep, 0.0, 0.0);
  }
  Stepper stepper("auto");
  constexpr int longer = 300;
  for (int step = 0; step < longer; ++step) {
    const StepReport report = stepper.step(*model, parameters, inputs, state);
    ASSERT_FALSE(report.choice->sleeping) << "step " << step;
  }
  EXPECT_LT(maxStretch(*model, state), 1e-5);
  EXPECT_NEAR(state.positions[40].x() - model->restPositions[40].x(), 0.01 * longer, 1e-5);
}

TEST(MovingPins, ThatPassOtherPinsThroughTheClothAddLittleEnergyAndLeaveNoIntersection) {
  constexpr int n = 30;
  constexpr double width = 0.6;     // [m]
  constexpr double distance = 0.7;  // [m]
  constexpr int stepsOfWay = 75;
  ClothMesh mesh = testing::sheet(n);
  std::vector<int> pins;
  std::vector<MovedPin> moved;
  for (Vec3& position : mesh.positions) {
    position *= width;
  }
  for (int row = 0; row < n; ++row) {
    pins.insert(pins.end(), {row * n, row * n + n - 1});
    moved.push_back({row * n, Vec3::Zero()});
  }
  const auto model = buildClothModel(mesh, 0.1, MassLumping::Area, pins);
  StepParameters parameters;
  parameters.contact.self = contact::SelfCollision::Exact;
  StepInputs inputs;
  inputs.movedPins = &moved;
  Stepper stepper("auto");
  ClothState state = stateAtRest(model->restPositions);
  std::size_t maxPairs = 0;
  double maxEnergy = 0.0;
  const auto pairs = [&]() {
    return drape::intersection::intersectingPairs({state.positions, model->triangles}).size();
  };
  for (int step = 0; step < 3 * stepsOfWay; ++step) {
    const double by = step < stepsOfWay ? distance : step < 2 * stepsOfWay ? -distance : 0.0;
    for (MovedPin& pin : moved) {
      pin.by = Vec3(by / stepsOfWay, 0.0, 0.0);
    }
    stepper.step(*model, parameters, inputs, state);
    maxPairs = std::max(maxPairs, pairs());
    maxEnergy = std::max(maxEnergy, energyOf(*model, parameters, state).total());
  }
  EXPECT_GT(maxPairs, 0U) << "pins are driven into each other";
  EXPECT_EQ(pairs(), 0U);
  EXPECT_LT(maxEnergy, 20.0);
}

}  // namespace
}  // namespace drape::sim
