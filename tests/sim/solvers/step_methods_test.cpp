#include "sim/diagnostics.hpp"
#include "sim/solver.hpp"
#include "spring_chain.hpp"
#include "test_meshes.hpp"

#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <string>

/// What is asked of the explicit methods and of those that solve for positions alike.
namespace drape {
namespace {

using testing::hangingChain;
using testing::pinnedSheet;
using testing::shaken;

struct Method {
  std::string name;
  double order = 0.0;        ///< of convergence, without damping
  double dampedOrder = 0.0;  ///< with it
};

void PrintTo(const Method& method, std::ostream* out) {
  *out << method.name;
}

class StepMethod : public ::testing::TestWithParam<Method> {
 protected:
  std::unique_ptr<Solver> make() const { return findSolver(GetParam().name)->make(); }

  /// Steps that every method stands: short, and with enough iterations to be solved.
  static StepParameters calm() {
    StepParameters parameters;
    parameters.timeStep = 1.0 / 3000.0;
    parameters.stiffness = 10.0;
    parameters.iterations = 60;
    return parameters;
  }

  void run(const ClothModel& model, const StepParameters& parameters, int steps, ClothState& state) const {
    const auto solver = make();
    for (int step = 0; step < steps; ++step) {
      solver->step(model, parameters, {}, state);
    }
  }
};

/// A mass on a hanging spring that is let go at the spring's rest length with some speed.
struct Oscillator {
  double mass = 0.1;
  double stiffness = 40.0;
  double damping = 0.0;
  double restLength = 0.5;
  double gravity = 9.81;
  double speed = -0.2;

  /// Height and velocity of the mass at that time, in closed form.
  [[nodiscard]] Vec2 at(double time) const {
    const double sag = mass * gravity / stiffness;
    const double decay = 0.5 * damping / mass;
    const double omega = std::sqrt(stiffness / mass - decay * decay);
    const double a = sag;
    const double b = (speed + decay * a) / omega;
    const double c = std::cos(omega * time);
    const double s = std::sin(omega * time);
    const double fade = std::exp(-decay * time);
    return {-restLength - sag + fade * (a * c + b * s), fade * (-decay * (a * c + b * s) + omega * (b * c - a * s))};
  }

  /// How far a method is off after that time, in units of the amplitude.
  [[nodiscard]] double error(Solver& solver, int steps) const {
    constexpr double time = 0.25;
    const auto model = hangingChain(1, mass, restLength);
    StepParameters parameters;
    parameters.timeStep = time / steps;
    parameters.stiffness = stiffness;
    parameters.damping = damping;
    parameters.gravity = gravity;
    parameters.iterations = 40;
    ClothState state = stateAtRest(model->restPositions);
    state.velocities[1].y() = speed;
    for (int step = 0; step < steps; ++step) {
      solver.step(*model, parameters, {}, state);
    }
    const Vec2 exact = at(time);
    const double omega = std::sqrt(stiffness / mass);
    const double sag = mass * gravity / stiffness;
    return std::hypot(state.positions[1].y() - exact.x(), (state.velocities[1].y() - exact.y()) / omega) / sag;
  }
};

TEST_P(StepMethod, convergesToTheHangingSpringsClosedFormWithItsOrder) {
  const Oscillator oscillator;
  const auto solver = make();
  const double coarse = oscillator.error(*solver, 400);
  const double fine = oscillator.error(*solver, 800);
  EXPECT_NEAR(std::log2(coarse / fine), GetParam().order, 0.1) << coarse << " " << fine;
  EXPECT_LT(fine, 0.05);
}

TEST_P(StepMethod, convergesToTheDampedSpringsClosedFormWithItsOrder) {
  Oscillator oscillator;
  oscillator.damping = 0.8;
  const auto solver = make();
  const double coarse = oscillator.error(*solver, 400);
  const double fine = oscillator.error(*solver, 800);
  EXPECT_NEAR(std::log2(coarse / fine), GetParam().dampedOrder, 0.1) << coarse << " " << fine;
  EXPECT_LT(fine, 0.05);
}

TEST_P(StepMethod, leavesAClothAtRestWithoutForcesWhereItIs) {
  const auto model = pinnedSheet(9);
  ClothState state = stateAtRest(model->restPositions);
  StepParameters parameters = calm();
  parameters.timeStep = 1.0 / 150.0;
  parameters.gravity = 0.0;
  parameters.damping = 0.001;
  parameters.drag = 1.0;
  run(*model, parameters, 100, state);
  for (std::size_t v = 0; v < state.positions.size(); ++v) {
    EXPECT_LT((state.positions[v] - model->restPositions[v]).norm(), 1e-12);
  }
}

TEST_P(StepMethod, keepsPinnedVerticesWhereTheyAre) {
  const auto model = pinnedSheet(5);
  ClothState state = stateAtRest(model->restPositions);
  run(*model, calm(), 1500, state);
  for (const std::size_t pin : {0U, 4U}) {
    EXPECT_EQ(state.positions[pin], model->restPositions[pin]);
    EXPECT_EQ(state.velocities[pin], Vec3(Vec3::Zero()));
  }
  EXPECT_LT(state.positions[24].y(), -0.3) << "the free end should have fallen";
  EXPECT_NEAR(state.time, 0.5, 1e-9);
}

TEST_P(StepMethod, letsClothWithoutStiffnessFallFreely) {
  const auto model = pinnedSheet(5);
  ClothState state = stateAtRest(model->restPositions);
  StepParameters parameters = calm();
  parameters.stiffness = 0.0;
  parameters.timeStep = 0.01;
  const int steps = 50;
  run(*model, parameters, steps, state);
  const double fall = 0.5 * 9.81 * 0.25;
  const double firstOrder = 0.5 * 9.81 * 0.5 * parameters.timeStep;
  EXPECT_NEAR(state.positions[12].y(), -fall, firstOrder * (1.0 + 1e-9));
  EXPECT_NEAR(state.velocities[12].y(), -9.81 * 0.5, 1e-9);
  EXPECT_EQ(state.positions[0], model->restPositions[0]);
}

TEST_P(StepMethod, keepsTheLinearMomentumOfFreeCloth) {
  const auto model = buildClothModel(testing::sheet(5), 0.1, MassLumping::Area, {});
  ClothState state = shaken(*model, 0.02, 5);
  const auto momentum = [&] {
    Vec3 sum = Vec3::Zero();
    for (std::size_t v = 0; v < state.velocities.size(); ++v) {
      sum += model->vertexMass[v] * state.velocities[v];
    }
    return sum;
  };
  StepParameters parameters = calm();
  parameters.gravity = 0.0;
  parameters.damping = 0.001;
  const Vec3 before = momentum();
  run(*model, parameters, 300, state);
  EXPECT_GT(before.norm(), 1e-3);
  EXPECT_LT((momentum() - before).norm(), 1e-10 * before.norm());
}

TEST_P(StepMethod, givesTheSameBitsForAnyNumberOfThreads) {
  const auto model = pinnedSheet(129);
  const auto hashWith = [&](int threads) {
    ClothState state = shaken(*model, 0.0005, 3);
    StepParameters parameters = calm();
    parameters.timeStep = 1e-4;
    parameters.iterations = 3;
    parameters.threads = threads;
    parameters.drag = 0.5;
    parameters.damping = 0.0001;
    parameters.wind = Vec3(2.0, 0.0, 1.0);
    run(*model, parameters, 3, state);
    EXPECT_TRUE(isFinite(state));
    return stateHash(state);
  };
  EXPECT_EQ(hashWith(1), hashWith(4));
}

TEST_P(StepMethod, survivesVerticesThatFallTogether) {
  const auto model = pinnedSheet(3);
  ClothState state = stateAtRest(std::vector<Vec3>(9, Vec3(0.5, 0.0, 0.5)));
  run(*model, calm(), 3, state);
  EXPECT_TRUE(isFinite(state));
}

TEST_P(StepMethod, followsAnotherModelThatComesAlong) {
  const auto solver = make();
  for (const int n : {9, 3, 5}) {
    const auto model = pinnedSheet(n);
    ClothState state = stateAtRest(model->restPositions);
    ClothState fresh = state;
    solver->step(*model, calm(), {}, state);
    make()->step(*model, calm(), {}, fresh);
    EXPECT_EQ(stateHash(state), stateHash(fresh));
  }
}

INSTANTIATE_TEST_SUITE_P(Every, StepMethod,
                         ::testing::Values(Method{"explicit_euler", 1.0, 1.0}, Method{"verlet", 2.0, 1.0},
                                           Method{"xpbd", 1.0, 1.0}, Method{"vbd", 1.0, 1.0}),
                         [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace drape
