#include "sim/measures/energy_balance.hpp"

#include "all_forces.hpp"
#include "fabric_cloths.hpp"
#include "sim/stepping/stepper.hpp"
#include "test_meshes.hpp"

#include <gtest/gtest.h>
#include <cmath>

namespace drape::sim {
namespace {

constexpr double radius = 0.5;       // of the triangle at rest [m]
constexpr double vertexMass = 0.01;  // [kg]

/// An equilateral triangle without pins. Where its vertices move along their radii alone, r obeys
/// m r'' = -3 k (r - r0) - 3 C_d r': a damped oscillator with a closed form.
std::shared_ptr<const ClothModel> breathingTriangle() {
  ClothMesh mesh;
  for (int corner = 0; corner < 3; ++corner) {
    const double angle = 2.0 * M_PI * corner / 3.0;
    mesh.positions.emplace_back(radius * std::cos(angle), 0.0, -radius * std::sin(angle));
  }
  mesh.triangles = {{0, 1, 2}};
  return buildClothModel(mesh, 3.0 * vertexMass, MassLumping::Uniform, {});
}

StepParameters breathingParameters() {
  StepParameters parameters;
  parameters.gravity = 0.0;
  parameters.material.stiffness = 20.0;
  parameters.material.damping = 0.01;
  return parameters;
}

/// r = r0 (1 + 0.2 e^(-c t) cos(w t)), the closed form.
ClothState breathingState(const ClothModel& model, const StepParameters& parameters, double time) {
  const double c = 1.5 * parameters.material.damping / vertexMass;
  const double w = std::sqrt(3.0 * parameters.material.stiffness / vertexMass - c * c);
  const double decay = 0.2 * std::exp(-c * time);
  ClothState state = stateAtRest(model.restPositions);
  for (std::size_t i = 0; i < 3; ++i) {
    state.positions[i] *= 1.0 + decay * std::cos(w * time);
    state.velocities[i] = -decay * (c * std::cos(w * time) + w * std::sin(w * time)) * model.restPositions[i];
  }
  state.time = time;
  return state;
}

/// The balance of the exact motion over 0.5 s, in steps of h.
EnergyBalance breathe(const ClothModel& model, StepParameters parameters, int steps) {
  parameters.timeStep = 0.5 / steps;
  EnergyBalance balance;
  for (int i = 0; i < steps; ++i) {
    balance.add(model, parameters, {}, breathingState(model, parameters, i * parameters.timeStep),
                breathingState(model, parameters, (i + 1) * parameters.timeStep));
  }
  return balance;
}

TEST(EnergyBalance, ofADampedSpringGivesTheLossToTheDampingWithAnErrorOfSecondOrder) {
  const auto model = breathingTriangle();
  const StepParameters parameters = breathingParameters();
  const double loss = energyOf(*model, parameters, breathingState(*model, parameters, 0.5)).total() -
                      energyOf(*model, parameters, breathingState(*model, parameters, 0.0)).total();
  const EnergyBalance coarse = breathe(*model, parameters, 400);
  const EnergyBalance fine = breathe(*model, parameters, 800);
  ASSERT_LT(loss, -0.1);
  EXPECT_NEAR(coarse.change(), loss, 1e-12);
  EXPECT_NEAR(fine.damping(), loss, 1e-3 * std::abs(loss));
  EXPECT_NEAR(coarse.integrator() / fine.integrator(), 4.0, 0.1);
  EXPECT_EQ(fine.air(), 0.0);
  EXPECT_EQ(fine.attachment(), 0.0);
}

TEST(EnergyBalance, givesTheWorkOfAWindThatPushesAMovingSheet) {
  const auto model = testing::pinnedSheet(3);
  const auto free = withPins(*model, std::vector<bool>(9, false));
  StepParameters parameters;
  parameters.gravity = 0.0;
  parameters.air.drag = 0.02;  // so little that the bound on the air's force is not reached
  parameters.air.wind = Vec3(0.0, 3.0, 0.0);
  parameters.timeStep = 0.01;
  ClothState before = stateAtRest(free->restPositions);
  for (Vec3& velocity : before.velocities) {
    velocity = Vec3(0.0, 1.0, 0.0);
  }
  ClothState after = before;
  for (Vec3& position : after.positions) {
    position.y() += 0.01;
  }
  EnergyBalance balance;
  balance.add(*free, parameters, {}, before, after);
  // 1/2 rho C S |v - wind|^2 over the sheet's square metre, along 1 cm.
  EXPECT_NEAR(balance.air(), 0.5 * 1.225 * 0.02 * 4.0 * 0.01, 1e-15);
  // The sheet did not become faster by it, so the motion given here lost as much.
  EXPECT_NEAR(balance.integrator(), -balance.air(), 1e-15);
}

TEST(EnergyBalance, givesTheWorkOfAnAttachmentAsTheEnergyOfItsSpring) {
  const auto model = testing::pinnedSheet(3);
  StepInputs inputs;
  inputs.attachment = Attachment{{7, Vec3(0.2, 0.3, 0.5), Vec3(0.5, 2.0, 1.0)}, {5.0, 1e9}};
  const ClothState before = stateAtRest(model->restPositions);
  ClothState after = before;
  const Triangle& corners = model->triangles[7];
  Vec3 start = Vec3::Zero();
  for (std::size_t c = 0; c < 3; ++c) {
    const auto v = static_cast<std::size_t>(corners[c]);
    start += inputs.attachment->barycentric[static_cast<Eigen::Index>(c)] * before.positions[v];
    after.positions[v].y() += 0.5;
  }
  const double distance = (inputs.attachment->target - start).squaredNorm();
  const double nearer = (inputs.attachment->target - start - Vec3(0.0, 0.5, 0.0)).squaredNorm();
  EnergyBalance balance;
  balance.add(*model, {}, inputs, before, after);
  EXPECT_NEAR(balance.attachment(), 0.5 * 5.0 * (distance - nearer), 1e-13);
}

TEST(EnergyBalance, doesNotBlameTheMethodForChangedSettings) {
  const auto model = testing::pinnedSheet(3);
  const ClothState state = testing::shaken(*model, 0.05, 1);
  StepParameters stiffer;
  stiffer.material.stiffness = 1e4;
  EnergyBalance balance;
  balance.add(*model, {}, {}, state, state);
  balance.add(*model, stiffer, {}, state, state);
  EXPECT_EQ(balance.change(), 0.0);
}

/// A classical Runge-Kutta step of fourth order: nearly the exact motion, with everything acting.
ClothState rungeKutta(const ClothModel& model, const StepParameters& parameters, const StepInputs& inputs,
                      const ClothState& start) {
  Workers workers;
  const double h = parameters.timeStep;
  const std::size_t count = start.positions.size();
  std::vector<std::vector<Vec3>> speeds;
  std::vector<std::vector<Vec3>> accelerations;
  for (const double part : {0.0, 0.5, 0.5, 1.0}) {
    ClothState stage = start;
    for (std::size_t i = 0; !speeds.empty() && i < count; ++i) {
      stage.positions[i] += part * h * speeds.back()[i];
      stage.velocities[i] += part * h * accelerations.back()[i];
    }
    std::vector<Vec3> force;
    testing::evaluateForces(model, parameters, inputs, stage, workers, force);
    for (std::size_t i = 0; i < count; ++i) {
      force[i] = model.pinned[i] ? Vec3(Vec3::Zero()) : Vec3(force[i] / model.vertexMass[i]);
    }
    speeds.push_back(stage.velocities);
    accelerations.push_back(force);
  }
  ClothState end = start;
  for (std::size_t i = 0; i < count; ++i) {
    end.positions[i] += h / 6.0 * (speeds[0][i] + 2.0 * speeds[1][i] + 2.0 * speeds[2][i] + speeds[3][i]);
    end.velocities[i] +=
        h / 6.0 * (accelerations[0][i] + 2.0 * accelerations[1][i] + 2.0 * accelerations[2][i] + accelerations[3][i]);
  }
  return end;
}

EnergyBalance everythingActing(int steps) {
  const auto model = testing::pinnedSheet(4);
  StepParameters parameters;
  parameters.material.stiffness = 20.0;
  parameters.material.damping = 0.01;
  parameters.air.drag = 0.5;
  parameters.air.lift = 0.3;
  parameters.air.wind = Vec3(0.5, 4.0, 1.0);  // always from below: where it changes sides the forces have a kink
  parameters.timeStep = 0.1 / steps;
  StepInputs inputs;
  inputs.attachment = Attachment{{10, Vec3(0.2, 0.3, 0.5), Vec3(0.5, 0.3, 1.0)}, {5.0, 1.0}};
  ClothState state = testing::shaken(*model, 0.02, 3);
  EnergyBalance balance;
  for (int i = 0; i < steps; ++i) {
    const ClothState next = rungeKutta(*model, parameters, inputs, state);
    balance.add(*model, parameters, inputs, state, next);
    state = next;
  }
  return balance;
}

TEST(EnergyBalance, leavesTheIntegratorNothingButSecondOrderWhenDampingWindAndAttachmentActTogether) {
  const EnergyBalance coarse = everythingActing(100);
  const EnergyBalance fine = everythingActing(200);
  EXPECT_LT(fine.damping(), -1e-4);
  EXPECT_GT(std::abs(fine.air()), 1e-4);
  EXPECT_GT(std::abs(fine.attachment()), 1e-4);
  EXPECT_LT(std::abs(fine.integrator()), 1e-3 * std::abs(fine.damping()));
  EXPECT_NEAR(coarse.integrator() / fine.integrator(), 4.0, 0.4);
}

/// Verlet without damping and air, which it takes to first order only.
EnergyBalance verlet(int steps) {
  const auto model = testing::pinnedSheet(4);
  StepParameters parameters;
  parameters.material.stiffness = 20.0;
  parameters.timeStep = 0.2 / steps;
  Stepper stepper("verlet");
  ClothState state = testing::shaken(*model, 0.05, 3);
  EnergyBalance balance;
  for (int i = 0; i < steps; ++i) {
    const ClothState before = state;
    stepper.step(*model, parameters, {}, state);
    balance.add(*model, parameters, {}, before, state);
  }
  return balance;
}

TEST(EnergyBalance, countsTheDampingOfAFabricWithEverySolverThatTakesIt) {
  fabric::Material material = testing::woven();
  material.stretchDamping = 1e-3;
  material.bendDamping = 1e-2;
  const auto model = testing::asFabric(*testing::pinnedSheet(6), material);
  StepParameters parameters;
  parameters.timeStep = 2e-4;
  for (const SolverInfo& info : solverTable()) {
    if (!info.takesFabric) {
      continue;
    }
    Stepper stepper(info.name);
    ClothState state = testing::shaken(*model, 1e-3, 3);
    const double start = energyOf(*model, parameters, state).total();
    EnergyBalance balance;
    for (int i = 0; i < 20; ++i) {
      const ClothState before = state;
      stepper.step(*model, parameters, {}, state);
      balance.add(*model, parameters, {}, before, state, nullptr, {.damping = stepper.dampingWork()});
    }
    EXPECT_LT(balance.damping(), -0.05 * start) << info.name;
    if (info.name == "verlet") {
      EXPECT_NEAR(balance.integrator(), 0.0, 0.02 * start);
    }
  }
}

TEST(EnergyBalance, ofVerletLeavesTheIntegratorAnErrorOfSecondOrder) {
  const EnergyBalance coarse = verlet(200);
  const EnergyBalance fine = verlet(400);
  EXPECT_GT(std::abs(fine.integrator()), 1e-10);
  EXPECT_LT(std::abs(fine.integrator()), 1e-3);
  EXPECT_NEAR(coarse.integrator() / fine.integrator(), 4.0, 0.2);
}

TEST(EnergyBalance, ofAFabricHasNoWorkOfTheSpringsDamping) {
  const auto springs = breathingTriangle();
  const auto model = testing::asFabric(*springs, testing::woven());
  const EnergyBalance balance = breathe(*model, breathingParameters(), 100);
  EXPECT_NE(balance.change(), 0.0);
  EXPECT_EQ(balance.damping(), 0.0);
}

}  // namespace
}  // namespace drape::sim
