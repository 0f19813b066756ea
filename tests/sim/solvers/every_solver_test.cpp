#include "runge_kutta.hpp"
#include "sim/forces/diagnostics.hpp"
#include "sim/forces/stability.hpp"
#include "sim/motion/momentum.hpp"
#include "sim/solvers/solver.hpp"
#include "sim/stepping/stepper.hpp"
#include "spring_chain.hpp"
#include "test_meshes.hpp"

#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <string>

/// Requirements on every solver in the table. A new one is tested as a first-order method that conserves the momentum
/// of free cloth; deviations of a method are in `methods`.
namespace drape::sim {
namespace {

using testing::hangingChain;
using testing::pinnedSheet;
using testing::shaken;

struct Method {
  std::string name;
  double order = 1.0;           ///< of convergence, without damping; 0 where it is the method's to choose
  double dampedOrder = 1.0;     ///< with it
  double lostMomentum = 1e-11;  ///< bound of the relative loss of free cloth in 300 steps [-]
  int coarseSteps = 300;        ///< for 0.2 s, from which on the limit is within reach
  int threadedSheet = 129;      ///< vertices a side: enough for loops, those over one colour too, to be shared
};

std::vector<Method> methods() {
  const std::vector<Method> special{
      {.name = "one_iteration", .lostMomentum = 1e-3},
      {.name = "auto", .order = 0.0, .dampedOrder = 0.0},
      {.name = "chebyshev", .lostMomentum = 5e-5},
      {.name = "newton", .coarseSteps = 120, .threadedSheet = 49},
      {.name = "verlet", .order = 2.0},
      {.name = "vbd", .lostMomentum = 1e-4, .coarseSteps = 120},
      {.name = "kang", .lostMomentum = 0.005, .coarseSteps = 2400},
      {.name = "desbrun", .coarseSteps = 2400, .threadedSheet = 65},
      {.name = "meyer", .coarseSteps = 2400, .threadedSheet = 65},
      {.name = "local_global", .threadedSheet = 65},
  };
  std::vector<Method> all;
  for (const SolverInfo& solver : solverTable()) {
    const auto known =
        std::find_if(special.begin(), special.end(), [&](const Method& method) { return method.name == solver.name; });
    all.push_back(known != special.end() ? *known : Method{.name = std::string(solver.name)});
  }
  return all;
}

void PrintTo(const Method& method, std::ostream* out) {
  *out << method.name;
}

class EverySolver : public ::testing::TestWithParam<Method> {
 protected:
  std::unique_ptr<Solver> make() const { return findSolver(GetParam().name)->make(); }

  /// Steps that every method stands: short, and with enough iterations to be solved.
  static StepParameters calm() {
    StepParameters parameters;
    parameters.timeStep = 1.0 / 3000.0;
    parameters.material.stiffness = 10.0;
    parameters.iteration.iterations = 61;
    parameters.iteration.tolerance = 1e-12;
    return parameters;
  }

  void run(const ClothModel& model, const StepParameters& parameters, int steps, ClothState& state) const {
    const auto solver = make();
    for (int step = 0; step < steps; ++step) {
      solver->step(model, parameters, {}, state);
    }
  }
};

/// That halving the steps divides the error as the order says, or that a method which chooses its own order is
/// accurate.
void expectOrder(double order, double coarse, double fine) {
  if (order > 0.0) {
    EXPECT_NEAR(std::log2(coarse / fine), order, 0.1) << coarse << " " << fine;
    EXPECT_LT(fine, 0.05);
  } else {
    EXPECT_LT(fine, 1e-3);
  }
}

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
    parameters.material.stiffness = stiffness;
    parameters.material.damping = damping;
    parameters.gravity = gravity;
    parameters.iteration.iterations = 41;
    parameters.iteration.tolerance = 1e-12;
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

/// Weight and the air's force on a whole cloth [N], written down here once more from eqs. 18-20: sums over triangles,
/// no function of the library. `auto` has the lift of a thin plate where it is less than eq. 19 (docs/theory/auto.md).
Vec3 weightAndAir(const ClothModel& model, const StepParameters& p, const ClothState& state, bool thinPlate) {
  std::vector<Vec3> normals(state.positions.size(), Vec3::Zero());
  for (const Triangle& t : model.triangles) {
    const auto corner = [&](std::size_t c) { return state.positions[t[c]]; };
    const Vec3 area = (corner(1) - corner(0)).cross(corner(2) - corner(0));
    for (const int v : t) {
      normals[v] += area;
    }
  }
  Vec3 sum(0.0, -p.gravity * model.totalMass(), 0.0);
  for (std::size_t v = 0; v < normals.size(); ++v) {
    const Vec3 wind = state.velocities[v] - p.air.wind;
    const double pressure = 0.5 * p.air.density * wind.squaredNorm() * model.vertexArea[v];
    const Vec3 u = wind.normalized();
    const double incidence = normals[v].normalized().dot(u);
    sum -= pressure * p.air.drag * std::abs(incidence) * u;
    if (incidence != 0.0) {
      const Vec3 front = (incidence > 0.0 ? 1.0 : -1.0) * normals[v].normalized();
      const double full = p.air.lift * (1.0 - std::abs(incidence));
      const Vec3 across = front.cross(u).cross(u);
      const double plate = 2.0 * M_PI * std::abs(incidence) / across.norm();
      sum += pressure * (thinPlate ? std::min(full, plate) : full) * across;
    }
  }
  return sum;
}

/// Free sheets of 9 x 9 vertices: flat or wavy, horizontal or tilted.
std::vector<std::shared_ptr<const ClothModel>> freeSheets() {
  std::vector<std::shared_ptr<const ClothModel>> models;
  for (const double wave : {0.0, 0.05}) {
    for (const double tilt : {0.0, 0.3}) {
      ClothMesh mesh = testing::sheet(9);
      for (Vec3& place : mesh.positions) {
        place.y() = wave * std::sin(7.0 * place.x() + 2.0 * place.z()) + tilt * place.z();
      }
      models.push_back(buildClothModel(mesh, 0.15, MassLumping::Area, {}));
    }
  }
  return models;
}

/// Whether a vertex lies along the wind exactly: eq. 20 does not say to which side its lift points.
bool liesAlong(const ClothModel& model, const Vec3& wind) {
  for (const Triangle& t : model.triangles) {
    const auto corner = [&](std::size_t c) { return model.restPositions[t[c]]; };
    if (std::abs((corner(1) - corner(0)).cross(corner(2) - corner(0)).normalized().dot(wind)) < 1e-9) {
      return true;
    }
  }
  return false;
}

/// What moves free cloth as a whole is its weight and the air, whatever the springs do. Flat sheets along the wind are
/// among the cases of a method whose lift is continuous there: nothing but the weight acts.
TEST_P(EverySolver, acceleratesFreeClothAsItsWeightAndTheAirAsk) {
  const bool chooses = findSolver(GetParam().name)->choosesSubsteps;
  const double allowed = std::max(2e-3, GetParam().lostMomentum);
  for (const auto& model : freeSheets()) {
    for (const Vec3& wind : {Vec3(5, 0, 0), Vec3(10, 0, 0), Vec3(0, 0, -7), Vec3(0, 6, 0), Vec3(3, -2, 8)}) {
      if (!chooses && liesAlong(*model, wind)) {
        continue;
      }
      for (const auto& [drag, lift] : {std::pair(0.5, 0.2), std::pair(1.0, 0.5), std::pair(0.0, 1.0)}) {
        for (const Precision precision : {Precision::Float, Precision::Double}) {
          StepParameters parameters = calm();
          parameters.timeStep = 1e-5;
          parameters.air.wind = wind;
          parameters.air.drag = drag;
          parameters.air.lift = lift;
          parameters.precision = precision;
          ClothState state = stateAtRest(model->restPositions);
          const Vec3 expected = weightAndAir(*model, parameters, state, chooses) / model->totalMass();
          make()->step(*model, parameters, {}, state);
          const Vec3 acceleration = linearMomentum(*model, state) / (model->totalMass() * parameters.timeStep);
          EXPECT_LT((acceleration - expected).norm(), allowed * (parameters.gravity + expected.norm()))
              << "wind " << wind.transpose() << ", drag " << drag << ", lift " << lift << ": "
              << acceleration.transpose() << " in place of " << expected.transpose();
        }
      }
    }
  }
}

/// The same all along a motion, as the mean of each step's two ends: cloth must not come to hang in the air. The wind
/// comes from above, so that no vertex passes the incidence at which eq. 20 jumps; a method without that jump also
/// meets wind along the sheet.
TEST_P(EverySolver, acceleratesFreeClothByItsWeightAndTheAir) {
  const bool chooses = findSolver(GetParam().name)->choosesSubsteps;
  const auto model = freeSheets()[3];
  for (const Vec3& wind : {Vec3(1, -6, 2), Vec3(6, 0, 1)}) {
    if (wind.y() == 0.0 && !chooses) {
      continue;
    }
    StepParameters parameters = calm();
    parameters.air.wind = wind;
    parameters.air.drag = 0.5;
    parameters.air.lift = 0.3;
    const auto solver = make();
    ClothState state = stateAtRest(model->restPositions);
    Vec3 impulse = Vec3::Zero();
    double size = 0.0;
    for (int step = 0; step < 300; ++step) {
      const Vec3 before = weightAndAir(*model, parameters, state, chooses);
      solver->step(*model, parameters, {}, state);
      const Vec3 after = weightAndAir(*model, parameters, state, chooses);
      impulse += 0.5 * parameters.timeStep * (before + after);
      size += 0.5 * parameters.timeStep * (before.norm() + after.norm());
    }
    const double allowed = std::max(0.01, GetParam().lostMomentum);
    EXPECT_LT((linearMomentum(*model, state) - impulse).norm(), allowed * size)
        << linearMomentum(*model, state).transpose() << " in place of " << impulse.transpose();
  }
}

TEST_P(EverySolver, convergesToTheHangingSpringsClosedFormWithItsOrder) {
  const Oscillator oscillator;
  const auto solver = make();
  const double coarse = oscillator.error(*solver, 400);
  const double fine = oscillator.error(*solver, 800);
  expectOrder(GetParam().order, coarse, fine);
}

TEST_P(EverySolver, convergesToTheDampedSpringsClosedFormWithItsOrder) {
  Oscillator oscillator;
  oscillator.damping = 0.8;
  const auto solver = make();
  const double coarse = oscillator.error(*solver, 400);
  const double fine = oscillator.error(*solver, 800);
  expectOrder(GetParam().dampedOrder, coarse, fine);
}

TEST_P(EverySolver, leavesAClothAtRestWithoutForcesWhereItIs) {
  const auto model = pinnedSheet(9);
  ClothState state = stateAtRest(model->restPositions);
  StepParameters parameters = calm();
  parameters.timeStep = 1.0 / 150.0;
  parameters.gravity = 0.0;
  parameters.material.damping = 0.001;
  parameters.air.drag = 1.0;
  run(*model, parameters, 100, state);
  for (std::size_t v = 0; v < state.positions.size(); ++v) {
    EXPECT_LT((state.positions[v] - model->restPositions[v]).norm(), 1e-12);
  }
}

TEST_P(EverySolver, keepsPinnedVerticesWhereTheyAre) {
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

TEST_P(EverySolver, letsClothWithoutStiffnessFallFreely) {
  const auto model = pinnedSheet(5);
  ClothState state = stateAtRest(model->restPositions);
  StepParameters parameters = calm();
  parameters.material.stiffness = 0.0;
  parameters.timeStep = 0.01;
  const int steps = 50;
  run(*model, parameters, steps, state);
  const double fall = 0.5 * 9.81 * 0.25;
  const double firstOrder = 0.5 * 9.81 * 0.5 * parameters.timeStep;
  EXPECT_NEAR(state.positions[12].y(), -fall, firstOrder * (1.0 + 1e-9));
  EXPECT_NEAR(state.velocities[12].y(), -9.81 * 0.5, 1e-9);
  EXPECT_EQ(state.positions[0], model->restPositions[0]);
}

TEST_P(EverySolver, losesNoMoreMomentumOfFreeClothThanItsBound) {
  const auto model = testing::irregularSheet(9, {});
  StepParameters parameters;
  parameters.material.stiffness = 10.0;
  parameters.material.damping = 0.001;
  parameters.gravity = 0.0;
  parameters.iteration.tolerance = 1e-12;
  if (const auto limit = findSolver(GetParam().name)->stepLimit; limit != nullptr) {
    parameters.timeStep = std::min(parameters.timeStep, 0.9 * limit(*model, parameters));
  }
  ClothState state = shaken(*model, 0.01, 5);
  for (Vec3& velocity : state.velocities) {
    velocity += Vec3(1.0, 0.5, 0.2);
  }
  const Vec3 before = linearMomentum(*model, state);
  run(*model, parameters, 300, state);
  const double lost = (linearMomentum(*model, state) - before).norm() / before.norm();
  EXPECT_LT(lost, GetParam().lostMomentum);
  if (GetParam().lostMomentum > Method().lostMomentum) {
    EXPECT_GT(lost, 0.05 * GetParam().lostMomentum) << "the bound is far from what happens";
  }
}

TEST_P(EverySolver, givesTheSameBitsForAnyNumberOfThreads) {
  const auto model = pinnedSheet(GetParam().threadedSheet);
  const auto hashWith = [&](int threads) {
    ClothState state = shaken(*model, 0.0005, 3);
    StepParameters parameters = calm();
    parameters.timeStep = 1e-4;
    parameters.iteration.iterations = 3;
    parameters.iteration.maxIterations = 3;
    parameters.threads = threads;
    parameters.air.drag = 0.5;
    parameters.material.damping = 0.0001;
    parameters.air.wind = Vec3(2.0, 0.0, 1.0);
    run(*model, parameters, 3, state);
    EXPECT_TRUE(isFinite(state));
    return stateHash(state);
  };
  EXPECT_EQ(hashWith(1), hashWith(4));
}

TEST_P(EverySolver, survivesVerticesThatFallTogether) {
  const auto model = pinnedSheet(3);
  ClothState state = stateAtRest(std::vector<Vec3>(9, Vec3(0.5, 0.0, 0.5)));
  run(*model, calm(), 3, state);
  EXPECT_TRUE(isFinite(state));
}

TEST_P(EverySolver, followsAnotherModelThatComesAlong) {
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

/// Fall of a sheet with 10 N/m from two pins.
constexpr double fallSeconds = 0.2;
constexpr double fallStiffness = 10.0;

std::vector<Vec3> exactFall(const ClothModel& model) {
  return testing::rungeKutta(model, fallStiffness, fallSeconds, 400);
}

/// Mean distance from the exact motion [m], after the error of first order was taken out by halving the step.
double extrapolatedError(const Method& method, Integration integration, int coarseSteps, const ClothModel& model,
                         const std::vector<Vec3>& exact) {
  StepParameters parameters;
  parameters.material.stiffness = fallStiffness;
  parameters.iteration.tolerance = 1e-9;
  parameters.integration = integration;
  const auto after = [&](int steps) {
    parameters.timeStep = fallSeconds / steps;
    Stepper stepper(method.name);
    ClothState state = stateAtRest(model.restPositions);
    for (int step = 0; step < steps; ++step) {
      stepper.step(model, parameters, {}, state);
    }
    return state.positions;
  };
  const std::vector<Vec3> coarse = after(coarseSteps);
  const std::vector<Vec3> fine = after(2 * coarseSteps);
  double sum = 0.0;
  for (std::size_t v = 0; v < exact.size(); ++v) {
    sum += (2.0 * fine[v] - coarse[v] - exact[v]).norm();
  }
  return sum / static_cast<double>(exact.size());
}

double sheetError(const Method& method, Integration integration, int coarseSteps) {
  static const auto model = pinnedSheet(17);
  static const std::vector<Vec3> exact = exactFall(*model);
  return extrapolatedError(method, integration, coarseSteps, *model, exact);
}

TEST_P(EverySolver, convergesToTheMotionOfASheetThatRungeKuttaFinds) {
  EXPECT_LT(sheetError(GetParam(), Integration::BackwardEuler, GetParam().coarseSteps), 1e-4) << "[m]";
}

TEST_P(EverySolver, convergesToTheMotionOfASheetWithSoftAndStiffSprings) {
  const auto even = pinnedSheet(9);
  std::vector<double> relative(even->springs.size());
  for (std::size_t s = 0; s < relative.size(); ++s) {
    relative[s] = s % 3 == 0 ? 3.7 : 0.6;
  }
  const auto model = withSpringStiffness(*even, relative);
  const std::vector<Vec3> exact = exactFall(*model);
  EXPECT_LT(extrapolatedError(GetParam(), Integration::BackwardEuler, GetParam().coarseSteps, *model, exact), 1e-4)
      << "[m]";
}

TEST_P(EverySolver, takesStiffnessFromTheSpringsAsItTakesItFromTheSetting) {
  const auto even = pinnedSheet(9);
  const auto stiffer = withSpringStiffness(*even, std::vector<double>(even->springs.size(), 4.0));
  for (const Precision precision : {Precision::Float, Precision::Double}) {
    StepParameters parameters = calm();
    parameters.material.damping = 0.002;
    parameters.precision = precision;
    ClothState own = shaken(*even, 0.01, 3);
    ClothState other = own;
    run(*stiffer, parameters, 5, own);
    parameters.material.stiffness *= 4.0;
    run(*even, parameters, 5, other);
    EXPECT_EQ(stateHash(own), stateHash(other)) << "four is a power of two, so not a bit may differ";
  }
}

TEST_P(EverySolver, convergesToTheSameMotionByMidpointAndBdf2) {
  if (!findSolver(GetParam().name)->backwardEuler) {
    GTEST_SKIP() << "has an integration of its own";
  }
  EXPECT_LT(sheetError(GetParam(), Integration::Theta, GetParam().coarseSteps / 2), 1e-4) << "[m]";
  EXPECT_LT(sheetError(GetParam(), Integration::Bdf2, GetParam().coarseSteps / 2), 1e-4) << "[m]";
}

TEST_P(EverySolver, hasADescriptionAndWarnings) {
  const SolverInfo& info = *findSolver(GetParam().name);
  EXPECT_GT(info.title.size(), 0U);
  EXPECT_EQ(info.help.back(), '.');
  EXPECT_GT(std::count(info.help.begin(), info.help.end(), '.'), 1)
      << "what it is, then what it costs and when it fails";
  EXPECT_NE(info.source, "");
  if (info.warning != nullptr) {
    StepParameters parameters = calm();
    parameters.material.damping = 0.01;
    EXPECT_FALSE(info.warning(*pinnedSheet(5), parameters)) << "nothing is wrong here";
  }
}

TEST(SolverWarnings, sayWhereOneConstantMatrixIsSluggishOrTooLittleIterated) {
  const auto model = pinnedSheet(17);
  StepParameters parameters;
  parameters.material.stiffness = 10.0;  // (h omega)^2 = 10
  for (const char* solver : {"kang", "desbrun", "meyer"}) {
    const SolverWarning warning = findSolver(solver)->warning(*model, parameters).value();
    EXPECT_EQ(warning.kind, SolverWarning::Kind::StiffFolds);
    EXPECT_EQ(warning.substeps, 11.0);
  }
  const SolverInfo& localGlobal = *findSolver("local_global");
  EXPECT_FALSE(localGlobal.warning(*model, parameters));
  parameters.material.stiffness = 1000.0;
  EXPECT_EQ(localGlobal.warning(*model, parameters).value().kind, SolverWarning::Kind::TooFewIterations);
  EXPECT_EQ(localGlobal.warning(*model, parameters)->substeps, 4.0);
}

TEST(SolverWarnings, sayThatNewtonIsSlowOnFineMeshes) {
  EXPECT_FALSE(findSolver("newton")->warning(*pinnedSheet(17), {}));
  EXPECT_EQ(findSolver("newton")->warning(*pinnedSheet(33), {}).value().kind, SolverWarning::Kind::TooSlow);
}

/// The solver's result after some steps with damping, air and an attachment, from a start that is moved by `offset`;
/// moved back.
std::vector<Vec3> movedFrom(Solver& solver, const ClothModel& model, const Vec3& offset) {
  StepParameters parameters;
  parameters.timeStep = 1.0 / 600.0;
  parameters.material = {.stiffness = 200.0, .damping = 0.002};
  parameters.air.drag = 0.5;
  parameters.air.lift = 0.3;
  parameters.air.wind = Vec3(1.0, 0.5, -2.0);
  StepInputs inputs;
  inputs.attachment = Attachment{{9, Vec3(0.5, 0.3, 0.2), Vec3(0.5, 0.5, 0.5) + offset}, {50.0, 5.0}};
  ClothState state = shaken(model, 1e-3, 3);
  for (Vec3& position : state.positions) {
    position = (position * 0x1p30).array().round().matrix() * 0x1p-30 + offset;  // without rounding
  }
  for (int step = 0; step < 20; ++step) {
    solver.step(model, parameters, inputs, state);
  }
  for (Vec3& position : state.positions) {
    position -= offset;
  }
  return state.positions;
}

TEST_P(EverySolver, movesClothFarFromTheOriginAsNearIt) {
  const auto model = pinnedSheet(9);
  const std::vector<Vec3> near = movedFrom(*make(), *model, Vec3::Zero());
  const std::vector<Vec3> far = movedFrom(*make(), *model, Vec3(1024.0, -512.0, 2048.0));
  for (std::size_t v = 0; v < near.size(); ++v) {
    EXPECT_LT((far[v] - near[v]).norm(), 2e-6) << v;  // float at 2 km rounds by 1e-4 m
  }
}

INSTANTIATE_TEST_SUITE_P(All, EverySolver, ::testing::ValuesIn(methods()),
                         [](const auto& chosen) { return chosen.param.name; });

}  // namespace
}  // namespace drape::sim
