#include "sim/motion/momentum.hpp"

#include "dense_cloth.hpp"
#include "sim/forces/diagnostics.hpp"
#include "sim/model/pieces.hpp"
#include "sim/stepping/stepper.hpp"

#include <gtest/gtest.h>

namespace drape::sim {
namespace {

using namespace drape::sim::testing;

Vec3 barycentre(const ClothModel& model, const ClothState& state) {
  return rowsOf(state.positions).transpose() * massMatrix(model).diagonal() / model.totalMass();
}

Vec3 spinOf(const ClothModel& model, const ClothState& state) {
  return angularMomentum(model, state, barycentre(model, state));
}

/// Shaken, flying and spinning.
ClothState thrown(const ClothModel& model) {
  ClothState state = shaken(model, 0.01, 5);
  for (std::size_t v = 0; v < state.positions.size(); ++v) {
    state.velocities[v] += Vec3(1.0, 0.5, 0.2) + Vec3(0.3, 2.0, 1.0).cross(state.positions[v]);
  }
  return state;
}

StepParameters inEmptySpace() {
  StepParameters p;
  p.gravity = 0.0;
  p.material.damping = 0.01;
  return p;
}

TEST(Momentum, ofTwoPointsIsTheTextbooks) {
  const auto model = pair({});
  ClothState state = stateAtRest(model->restPositions);
  state.velocities = {Vec3(0.0, 0.0, 0.0), Vec3(0.0, 3.0, 0.0)};
  EXPECT_LT((linearMomentum(*model, state) - Vec3(0.0, 0.15, 0.0)).norm(), 1e-15);
  EXPECT_LT((angularMomentum(*model, state, Vec3(0.5, 0.0, 0.0)) - Vec3(0.0, 0.0, 0.075)).norm(), 1e-15);
}

TEST(FreePieces, areComponentsOfTheSpringGraphWithoutPins) {
  ClothMesh mesh = sheet(2);
  for (const Vec3& position : sheet(2).positions) {
    mesh.positions.emplace_back(position + Vec3(5.0, 0.0, 0.0));
  }
  mesh.triangles.push_back({5, 6, 7});
  mesh.triangles.push_back({4, 6, 5});
  mesh.positions.emplace_back(9.0, 0.0, 0.0);
  const auto pieces = freePieces(*buildClothModel(mesh, 1.0, MassLumping::Uniform, {1}));
  const std::vector<std::vector<std::size_t>> expected{{4, 5, 6, 7}, {8}};
  EXPECT_EQ(pieces, expected);
}

/// The relative change of linear and angular momentum over 300 steps.
std::pair<double, double> lossOf(const char* solver, StepParameters p) {
  const auto model = unevenSheet(9, {});
  ClothState state = thrown(*model);
  const Vec3 linear = linearMomentum(*model, state);
  const Vec3 spin = spinOf(*model, state);
  Stepper stepper(solver);
  for (int step = 0; step < 300; ++step) {
    stepper.step(*model, p, {}, state);
  }
  return {(linearMomentum(*model, state) - linear).norm() / linear.norm(),
          (spinOf(*model, state) - spin).norm() / spin.norm()};
}

TEST(KeepMomentum, restoresTheMomentumThatOneIterationLoses) {
  StepParameters p = inEmptySpace();
  const auto [linear, spin] = lossOf("one_iteration", p);
  EXPECT_GT(linear, 1e-3);
  EXPECT_GT(spin, 1e-2);
  p.keepMomentum = true;
  const auto [keptLinear, keptSpin] = lossOf("one_iteration", p);
  EXPECT_LT(keptLinear, 1e-12);
  EXPECT_LT(keptSpin, 1e-11);
}

TEST(KeepMomentum, holdsForEverySolverWithSubstepsAndEveryIntegration) {
  for (const Integration integration : {Integration::BackwardEuler, Integration::Theta, Integration::Bdf2}) {
    for (const SolverInfo& solver : solverTable()) {
      StepParameters p = inEmptySpace();
      p.material.stiffness = 1.0;  // stable for explicit methods too
      p.integration = integration;
      p.theta = 0.75;
      p.substeps = 2;
      p.keepMomentum = true;
      const auto [linear, spin] = lossOf(std::string(solver.name).c_str(), p);
      EXPECT_LT(linear, 1e-11) << solver.name;
      EXPECT_LT(spin, 1e-10) << solver.name;
    }
  }
}

TEST(KeepMomentum, letsTheBarycentreFallAsBackwardEulerDoes) {
  const auto model = unevenSheet(9, {});
  ClothState state = thrown(*model);
  const Vec3 start = barycentre(*model, state);
  const Vec3 velocity = linearMomentum(*model, state) / model->totalMass();
  StepParameters p;
  p.keepMomentum = true;
  Stepper stepper("one_iteration");
  const int steps = 60;
  for (int step = 0; step < steps; ++step) {
    stepper.step(*model, p, {}, state);
  }
  const double h = p.timeStep;
  const Vec3 expected = start + steps * h * velocity - Vec3(0.0, 0.5 * p.gravity * h * h * steps * (steps + 1), 0.0);
  EXPECT_LT((barycentre(*model, state) - expected).norm(), 1e-11);
}

TEST(KeepMomentum, givesAClothInTheWindTheImpulseOfTheWind) {
  const auto model = unevenSheet(9, {});
  ClothState state = thrown(*model);
  StepParameters p;
  p.air.drag = 0.5;
  p.air.lift = 0.5;
  p.air.wind = Vec3(2.0, 1.0, 0.0);
  p.keepMomentum = true;
  const Rows impulse = p.timeStep * outerForces(*model, p, state);
  const Vec3 centre = barycentre(*model, state);
  Vec3 linear = linearMomentum(*model, state);
  Vec3 spin = spinOf(*model, state);
  for (Eigen::Index i = 0; i < impulse.rows(); ++i) {
    const Vec3 push = impulse.row(i).transpose();
    linear += push;
    spin += (state.positions[i] - centre).cross(push);
  }
  Stepper("one_iteration").step(*model, p, {}, state);
  EXPECT_LT((linearMomentum(*model, state) - linear).norm(), 1e-14);
  EXPECT_LT((spinOf(*model, state) - spin).norm(), 1e-14);
}

TEST(KeepMomentum, givesAnAttachedClothTheImpulseOfTheAttachmentAtTheEndOfTheStep) {
  const auto model = unevenSheet(9, {});
  ClothState state = thrown(*model);
  StepParameters p;
  p.keepMomentum = true;
  StepInputs inputs;
  inputs.attachment = Attachment{{40, Vec3(0.5, 0.3, 0.2), Vec3(0.5, 0.2, 0.5)}, {500.0, 1e3}};
  const AttachmentForce pull = attachmentForce(*model, *inputs.attachment, state);
  const auto attachedPoint = [&] {
    Vec3 point = Vec3::Zero();
    for (Eigen::Index c = 0; c < 3; ++c) {
      point += pull.weights[c] * state.positions[pull.vertices[c]];
    }
    return point;
  };
  const Vec3 arm = attachedPoint() - barycentre(*model, state);
  const Vec3 linear = linearMomentum(*model, state) - Vec3(0.0, p.timeStep * model->totalMass() * p.gravity, 0.0);
  const Vec3 spin = spinOf(*model, state);
  Stepper("one_iteration").step(*model, p, inputs, state);
  const Vec3 impulse = p.timeStep * 500.0 * (inputs.attachment->target - attachedPoint());
  EXPECT_LT((linearMomentum(*model, state) - linear - impulse).norm(), 1e-13);
  EXPECT_LT((spinOf(*model, state) - spin - arm.cross(impulse)).norm(), 1e-13);
}

TEST(KeepMomentum, leavesPinnedPiecesAloneAndCorrectsFreeOnesBesideThem) {
  ClothMesh two = sheet(5);
  for (const Vec3& position : sheet(5).positions) {
    two.positions.emplace_back(position + Vec3(3.0, 0.0, 0.0));
  }
  for (const Triangle& t : sheet(5).triangles) {
    two.triangles.push_back({t[0] + 25, t[1] + 25, t[2] + 25});
  }
  const auto both = buildClothModel(two, 0.2, MassLumping::Uniform, {0, 4});
  const ClothState start = thrown(*both);
  const auto run = [&](bool keep) {
    ClothState state = start;
    for (const std::size_t pin : {0, 4}) {
      state.velocities[pin].setZero();
    }
    StepParameters p = inEmptySpace();
    p.keepMomentum = keep;
    Stepper stepper("one_iteration");
    for (int step = 0; step < 100; ++step) {
      stepper.step(*both, p, {}, state);
    }
    return state;
  };
  const ClothState kept = run(true);
  const ClothState plain = run(false);
  const auto freeMomentum = [&](const ClothState& state) {
    Vec3 sum = Vec3::Zero();
    for (std::size_t v = 25; v < 50; ++v) {
      sum += both->vertexMass[v] * state.velocities[v];
    }
    return sum;
  };
  for (std::size_t v = 0; v < 25; ++v) {
    EXPECT_EQ(kept.positions[v], plain.positions[v]);
    EXPECT_EQ(kept.velocities[v], plain.velocities[v]);
  }
  EXPECT_LT((freeMomentum(kept) - freeMomentum(start)).norm(), 1e-13);
  EXPECT_GT((freeMomentum(plain) - freeMomentum(start)).norm(), 1e-4);
}

TEST(KeepMomentum, spinsAPairThatHasNoInertiaAboutItsOwnLine) {
  const auto model = pair({});
  ClothState state = stateAtRest({Vec3(0.0, 0.0, 0.0), Vec3(1.2, 0.0, 0.0)});
  state.velocities = {Vec3(0.1, -1.0, 0.0), Vec3(0.1, 1.0, 0.5)};
  const Vec3 spin = spinOf(*model, state);
  StepParameters p = inEmptySpace();
  p.keepMomentum = true;
  Stepper stepper("one_iteration");
  for (int step = 0; step < 200; ++step) {
    stepper.step(*model, p, {}, state);
  }
  EXPECT_LT((spinOf(*model, state) - spin).norm(), 1e-12);
  EXPECT_LT((linearMomentum(*model, state) - Vec3(0.01, 0.0, 0.025)).norm(), 1e-14);
}

TEST(KeepMomentum, survivesAClothThatFellTogetherToAPointOrALine) {
  const auto model = unevenSheet(3, {});
  std::vector<Vec3> line;
  for (int i = 0; i < 9; ++i) {
    line.emplace_back(0.1 * i, 0.0, 0.0);
  }
  for (const std::vector<Vec3>& positions : {std::vector<Vec3>(9, Vec3(0.5, 0.0, 0.5)), line}) {
    ClothState state = stateAtRest(positions);
    StepParameters p;
    p.keepMomentum = true;
    Stepper stepper("one_iteration");
    for (int step = 0; step < 20; ++step) {
      stepper.step(*model, p, {}, state);
    }
    EXPECT_TRUE(isFinite(state));
    EXPECT_LT(std::abs(linearMomentum(*model, state).x()), 1e-12);
  }
}

TEST(KeepMomentum, doesNotLetAStrongAttachmentThrowALightClothAbout) {
  const auto model = buildClothModel(sheet(9), 0.02, MassLumping::Uniform, {});
  StepParameters p;
  p.timeStep = 1.0 / 30.0;
  p.material.damping = 0.01;
  p.keepMomentum = true;
  StepInputs inputs;
  inputs.attachment = Attachment{{40, Vec3(0.5, 0.3, 0.2), Vec3(0.5, 0.2, 0.5)}, {500.0, 1e3}};
  ClothState state = stateAtRest(model->restPositions);
  Stepper stepper("one_iteration");
  for (int step = 0; step < 300; ++step) {
    stepper.step(*model, p, inputs, state);
  }
  EXPECT_LT(rowsOf(state.velocities).rowwise().norm().maxCoeff(), 5.0) << "[m/s], of a swing from half a metre";
}

}  // namespace
}  // namespace drape::sim
