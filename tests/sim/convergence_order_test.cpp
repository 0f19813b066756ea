#include "sim/model/mesh_topology.hpp"
#include "sim/stepping/stepper.hpp"

#include <gtest/gtest.h>
#include <cmath>
#include <string>
#include <vector>

namespace drape::sim {
namespace {

constexpr double mass = 0.01;      // [kg]
constexpr double rest = 0.5;       // [m]
constexpr double stiffness = 4.0;  // [N/m]
constexpr double damping = 0.02;   // [N s/m], where nothing else is said
constexpr double gravity = 9.81;   // [m/s^2]

/// A mass that hangs by one damped spring.
std::shared_ptr<const ClothModel> hangingMass() {
  ClothModel model;
  model.restPositions = {Vec3(0.0, 0.0, 0.0), Vec3(0.0, -rest, 0.0)};
  model.springs = {Spring{0, 1, rest}};
  model.springEnds = springEndsOf(model.springs, 2);
  model.vertexTriangles = trianglesOfVertices({}, 2);
  model.vertexArea = {0.0, 0.0};
  model.vertexMass = {mass, mass};
  model.pinned = {true, false};
  return std::make_shared<const ClothModel>(model);
}

constexpr double stretch = mass * gravity / stiffness;  // in equilibrium [m]

/// Its height, let go `amplitude` below equilibrium: a damped harmonic motion.
double exactHeight(const StepParameters& parameters, double amplitude, double time) {
  const double decay = parameters.material.damping / (2.0 * mass);
  const double omega = std::sqrt(stiffness / mass - decay * decay);
  return -rest - stretch -
         amplitude * std::exp(-decay * time) * (std::cos(omega * time) + decay / omega * std::sin(omega * time));
}

double errorWith(const std::string& solver, StepParameters parameters, double amplitude, int steps) {
  const auto model = hangingMass();
  constexpr double duration = 0.4;
  parameters.timeStep = duration / steps;
  ClothState state = stateAtRest(model->restPositions);
  state.positions[1].y() = exactHeight(parameters, amplitude, 0.0);
  Stepper stepper(solver);
  for (int step = 0; step < steps; ++step) {
    stepper.step(*model, parameters, {}, state);
  }
  return std::abs(state.positions[1].y() - exactHeight(parameters, amplitude, duration));
}

StepParameters parametersOf(Integration integration) {
  StepParameters parameters;
  parameters.material.stiffness = stiffness;
  parameters.material.damping = damping;
  parameters.gravity = gravity;
  parameters.iteration.tolerance = 1e-12;
  parameters.iteration.iterations = 41;
  parameters.integration = integration;
  parameters.theta = 0.5;
  return parameters;
}

double orderOf(const std::string& solver, const StepParameters& parameters, double amplitude, int steps = 200) {
  const double coarse = errorWith(solver, parameters, amplitude, steps);
  const double fine = errorWith(solver, parameters, amplitude, 2 * steps);
  return std::log2(coarse / fine);
}

class Order : public ::testing::TestWithParam<std::string> {};

TEST_P(Order, isOneForBackwardEulerAndTwoForMidpointAndBdf2OnAHangingSpring) {
  const double amplitude = 0.8 * stretch;  // the spring is never compressed
  const auto order = [&](Integration integration) {
    StepParameters parameters = parametersOf(integration);
    if (GetParam() == "xpbd") {
      parameters.material.damping = 0.0;  // XPBD damps the velocities in a separate step of first order
    }
    return orderOf(GetParam(), parameters, amplitude);
  };
  EXPECT_NEAR(order(Integration::BackwardEuler), 1.0, 0.1);
  EXPECT_NEAR(order(Integration::Theta), 2.0, 0.1);
  EXPECT_NEAR(order(Integration::Bdf2), 2.0, 0.1);
}

TEST(OrderOfMidpointAndBdf2, fallsToOneWithTheDampingOfXpbd) {
  EXPECT_NEAR(orderOf("xpbd", parametersOf(Integration::Theta), 0.8 * stretch), 1.0, 0.2);
}

std::vector<std::string> solversOfBackwardEulerSteps() {
  std::vector<std::string> names;
  for (const SolverInfo& solver : solverTable()) {
    if (solver.backwardEuler) {
      names.emplace_back(solver.name);
    }
  }
  return names;
}

INSTANTIATE_TEST_SUITE_P(All, Order, ::testing::ValuesIn(solversOfBackwardEulerSteps()),
                         [](const auto& chosen) { return chosen.param; });

TEST(OrderOfMidpointAndBdf2, staysTwoUnderCompressionWhereTheStepIsSolvedToTheEnd) {
  const double amplitude = 2.0 * stretch;
  EXPECT_NEAR(orderOf("newton", parametersOf(Integration::Theta), amplitude), 2.0, 0.1);
  EXPECT_NEAR(orderOf("newton", parametersOf(Integration::Bdf2), amplitude), 2.0, 0.1);
}

TEST(OrderOfMidpointAndBdf2, fallsTowardsOneUnderCompressionWhereTheStabilisedDerivativeIsNotTheForces) {
  const double amplitude = 10.0 * stretch;
  StepParameters parameters = parametersOf(Integration::Theta);
  EXPECT_NEAR(orderOf("pcg", parameters, amplitude, 1600), 1.0, 0.2);
  parameters.derivative = ForceDerivative::Axial;  // which is the force's along the spring
  EXPECT_NEAR(orderOf("pcg", parameters, amplitude), 2.0, 0.1);
}

}  // namespace
}  // namespace drape::sim
