#include "fabric_cloths.hpp"
#include "sim/adaptive/step_memory.hpp"
#include "sim/forces/diagnostics.hpp"
#include "sim/forces/stability.hpp"
#include "sim/measures/measures.hpp"
#include "sim/motion/momentum.hpp"
#include "sim/solvers/solver.hpp"
#include "sim/stepping/stepper.hpp"
#include "test_meshes.hpp"

#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <functional>
#include <stop_token>

namespace drape::sim {
namespace {

using testing::pinnedSheet;

constexpr double frame = 1.0 / 150.0;

/// Parameters with a budget of so many force evaluations in a step of 1/150 s, and a tolerance that uses all of it.
StepParameters withEvaluations(const ClothModel& model, double stiffness, double evaluations) {
  StepParameters parameters;
  parameters.timeStep = frame;
  parameters.material.stiffness = stiffness;
  parameters.automatic.costBudget = 1.0001e-6 * evaluations * static_cast<double>(model.springs.size()) / frame;
  parameters.automatic.errorTolerance = 1e-12;
  parameters.automatic.soften = true;
  return parameters;
}

/// The state after 0.2 s of a sheet that falls from two corners.
ClothState fallen(const char* solver, const ClothModel& model, const StepParameters& parameters,
                  StepReport* last = nullptr) {
  Stepper stepper(solver);
  ClothState state = stateAtRest(model.restPositions);
  for (int step = 0; step < 30; ++step) {
    const StepReport report = stepper.step(model, parameters, {}, state);
    if (last != nullptr) {
      *last = report;
    }
  }
  return state;
}

double meanDistanceOf(const ClothState& a, const ClothState& b) {
  double sum = 0.0;
  for (std::size_t v = 0; v < a.positions.size(); ++v) {
    sum += (a.positions[v] - b.positions[v]).norm();
  }
  return sum / static_cast<double>(a.positions.size());
}

/// The converged motion by Verlet in double, well below its limit.
ClothState converged(const ClothModel& model, double stiffness) {
  StepParameters parameters;
  parameters.timeStep = frame;
  parameters.material.stiffness = stiffness;
  parameters.substeps = static_cast<int>(std::ceil(frame / (0.5 * verletStepLimit(model, parameters)))) + 20;
  return fallen("verlet", model, parameters);
}

TEST(Auto, isAsAccurateAsSpecifiedInFloatWithThirtyEvaluations) {
  struct Case {
    double stiffness;  // [N/m]
    double evaluations;
    double maxError;  // after 0.2 s [m]
    int order;
    bool levels;
  };
  const auto model = pinnedSheet(33);
  for (const Case each : {Case{10.0, 8.0, 1e-5, 2, false}, Case{10.0, 30.0, 3e-6, 4, false},
                          Case{1e3, 31.0, 1e-5, 2, false}, Case{1e5, 22.0, 3.8e-3, 2, true}}) {
    StepParameters parameters = withEvaluations(*model, each.stiffness, each.evaluations);
    parameters.precision = Precision::Float;
    StepReport report;
    const ClothState state = fallen("auto", *model, parameters, &report);
    EXPECT_LT(meanDistanceOf(state, converged(*model, each.stiffness)), each.maxError)
        << each.stiffness << " " << each.evaluations;
    ASSERT_TRUE(report.choice);
    EXPECT_EQ(report.choice->order, each.order);
    EXPECT_EQ(report.choice->coarseLevels > 0, each.levels);
    EXPECT_LE(report.choice->forceEvaluations, each.evaluations);
  }
}

TEST(Auto, usesCoarseLevelsWhereTheBudgetIsATenthOfWhatTheSpringsNeed) {
  const auto model = pinnedSheet(33);  // H omega = 622, so the springs need 311 evaluations
  StepReport report;
  const ClothState exact = converged(*model, 1e5);
  const double error = meanDistanceOf(fallen("auto", *model, withEvaluations(*model, 1e5, 34.0), &report), exact);
  EXPECT_LT(error, 0.004) << "[m]";
  ASSERT_TRUE(report.choice);
  EXPECT_GE(report.choice->coarseLevels, 2);
  EXPECT_EQ(report.choice->substeps, 17) << "with levels each costs two evaluations";
  EXPECT_EQ(report.choice->forceEvaluations, 34);
  StepParameters xpbd = withEvaluations(*model, 1e5, 0.0);
  xpbd.substeps = 17;
  xpbd.iteration.iterations = 1;
  EXPECT_LT(3.0 * error, meanDistanceOf(fallen("xpbd", *model, xpbd), exact));
}

/// How far the energy rises above the start's, of m g D [-].
double largestRise(const ClothModel& model, const StepParameters& parameters, int steps, StepReport& report) {
  Stepper stepper("auto");
  ClothState state = stateAtRest(model.restPositions);
  const double start = energyOf(model, parameters, state).total();
  double highest = 0.0;
  for (int step = 0; step < steps; ++step) {
    report = stepper.step(model, parameters, {}, state);
    highest = std::max(highest, energyOf(model, parameters, state).total() - start);
  }
  return highest / (model.totalMass() * parameters.gravity * diagonalOf(model));
}

TEST(Auto, takesAsLongAsItNeedsRatherThanBreakThePhysics) {
  const auto model = pinnedSheet(33);
  StepParameters parameters = withEvaluations(*model, 1e5, 10.0);
  StepReport report;
  EXPECT_GT(largestRise(*model, parameters, 30, report), 1.0) << "softer springs gain visible energy with this budget";
  parameters.automatic.soften = false;
  EXPECT_LT(largestRise(*model, parameters, 30, report), 0.005);
  ASSERT_TRUE(report.choice);
  EXPECT_EQ(report.choice->stiffnessScale, 1.0);
  EXPECT_NEAR(report.choice->costRatio, 34.6, 1.0) << "346 evaluations, 10 are allowed";
  EXPECT_LT(meanDistanceOf(fallen("auto", *model, parameters), converged(*model, 1e5)), 0.002) << "[m]";
}

TEST(Auto, endsALongStepWhenAStopIsRequested) {
  const auto model = pinnedSheet(9);
  StepParameters parameters = withEvaluations(*model, 1e7, 10.0);
  parameters.automatic.soften = false;
  int calls = 0;
  std::stop_source source;
  const std::function<void()> onProgress = [&] {
    if (++calls == 5) {
      source.request_stop();
    }
  };
  StepInputs inputs;
  inputs.stop = source.get_token();
  inputs.onProgress = &onProgress;
  ClothState state = testing::shaken(*model, 0.001, 7);
  const auto before = stateHash(state);
  EXPECT_THROW(findSolver("auto")->make()->step(*model, parameters, inputs, state), StepStopped);
  EXPECT_EQ(calls, 5);
  EXPECT_EQ(stateHash(state), before);
}

TEST(Auto, keepsTheEnergyWhereOnlySliversAreClamped) {
  ClothMesh mesh = testing::sheet(33);
  const Vec3 middle = mesh.positions[16 * 33 + 16];
  for (const std::size_t row : {15U, 16U, 17U}) {
    for (const std::size_t column : {15U, 16U, 17U}) {
      Vec3& position = mesh.positions[row * 33 + column];
      position = middle + (position - middle) / 30.0;
    }
  }
  const auto model = buildClothModel(mesh, 0.1, MassLumping::Area, {0, 32});
  for (const double stiffness : {100.0, 1e4}) {
    StepParameters parameters = withEvaluations(*model, stiffness, 10.0);
    parameters.automatic.soften = false;
    StepReport report;
    EXPECT_LT(largestRise(*model, parameters, 60, report), 0.01) << stiffness;
    ASSERT_TRUE(report.choice);
    EXPECT_LT(1.2 * report.choice->substeps, 0.5 * report.choice->hOmega)
        << "slivers do not determine the number of substeps";
  }
}

TEST(Auto, estimatesTheSizeOfItsError) {
  struct Case {
    double stiffness;
    double evaluations;
  };
  const auto model = pinnedSheet(17);
  for (const Case each : {Case{10.0, 4.0}, Case{10.0, 8.0}, Case{1e4, 9.0}, Case{1e3, 17.0}, Case{1e5, 17.0}}) {
    StepReport report;
    const ClothState state = fallen("auto", *model, withEvaluations(*model, each.stiffness, each.evaluations), &report);
    const double error = meanDistanceOf(state, converged(*model, each.stiffness));
    ASSERT_TRUE(report.choice);
    EXPECT_GT(report.choice->error, 0.1 * error) << each.stiffness << " " << each.evaluations;
    EXPECT_LT(report.choice->error, 20.0 * error) << each.stiffness << " " << each.evaluations;
  }
}

TEST(Auto, spendsLessOnALooserTolerance) {
  const auto model = pinnedSheet(17);
  StepParameters parameters = withEvaluations(*model, 10.0, 1000.0);
  parameters.material.damping = 1e-4;
  int before = 0;
  for (const double tolerance : {1e-2, 1e-6, 1e-8}) {
    parameters.automatic.errorTolerance = tolerance;
    StepReport report;
    fallen("auto", *model, parameters, &report);
    ASSERT_TRUE(report.choice);
    EXPECT_GT(report.choice->substeps, before);
    before = report.choice->substeps;
  }
}

TEST(Auto, keepsToItsToleranceUnderStrongDampingWithoutSubstepsForIt) {
  const auto model = pinnedSheet(17);
  for (const double damping : {2.0, 10.0}) {
    StepParameters parameters;
    parameters.timeStep = frame;
    parameters.material.stiffness = 1000.0;
    parameters.material.damping = damping;
    const double needed = frame / verletStepLimit(*model, parameters);
    StepParameters fine = parameters;
    fine.substeps = static_cast<int>(std::ceil(2.0 * needed));
    const ClothState reference = fallen("verlet", *model, fine);
    for (const Precision precision : {Precision::Float, Precision::Double}) {
      parameters.precision = precision;
      StepReport report;
      const ClothState state = fallen("auto", *model, parameters, &report);
      EXPECT_LT(meanDistanceOf(state, reference), parameters.automatic.errorTolerance) << damping;
      EXPECT_LT(report.choice->substeps, 0.5 * needed) << damping;
      EXPECT_EQ(report.choice->retries, 0) << damping;
    }
  }
}

TEST(Auto, doesNotLetLiftTurnTheSideThatClothFacesTheWindWith) {
  ClothMesh mesh;
  mesh.positions = {Vec3(0.0, 0.0, 0.0), Vec3(0.1, 0.0, 0.0), Vec3(0.0, 0.0, -0.1)};
  mesh.triangles = {{0, 1, 2}};
  const auto model = buildClothModel(mesh, 0.001, MassLumping::Uniform, {});
  StepParameters parameters;
  parameters.gravity = 0.0;
  parameters.air.lift = 1.0;
  parameters.air.density = 1000.0;
  parameters.air.wind = Vec3(10.0, 0.0, 0.0);
  for (const double rising : {0.1, -0.1}) {
    ClothState state = stateAtRest(model->restPositions);
    for (Vec3& velocity : state.velocities) {
      velocity.y() = rising;
    }
    Stepper stepper("auto");
    for (int step = 0; step < 5; ++step) {
      stepper.step(*model, parameters, {}, state);
      for (const Vec3& velocity : state.velocities) {
        EXPECT_LT(std::abs(velocity.y()), 1e-6) << "it stays parallel to the wind";
      }
    }
  }
}

/// A free flat sheet that lies along the wind sinks and is carried away. Lift that jumps at zero
/// incidence would hold it in place.
TEST(Auto, doesNotLetAFlatSheetHoverInTheWind) {
  const auto model = buildClothModel(testing::sheet(17), 0.15, MassLumping::Area, {});
  for (const Precision precision : {Precision::Float, Precision::Double}) {
    for (const Vec3& wind : {Vec3(5, 0, 0), Vec3(-3, 0, 4), Vec3(10, 0, 0), Vec3(0, 0, 20)}) {
      for (const double lift : {0.2, 1.0}) {
        StepParameters parameters;
        parameters.timeStep = frame;
        parameters.material.damping = 0.01;
        parameters.air.drag = 0.5;
        parameters.air.lift = lift;
        parameters.air.wind = wind;
        parameters.precision = precision;
        ClothState state = stateAtRest(model->restPositions);
        Stepper stepper("auto");
        for (int step = 0; step < 300; ++step) {
          EXPECT_FALSE(stepper.step(*model, parameters, {}, state).choice->sleeping);
        }
        const Vec3 velocity = linearMomentum(*model, state) / model->totalMass();
        EXPECT_GT(velocity.dot(wind.normalized()), 0.3) << wind.transpose() << ", lift " << lift;
      }
    }
  }
}

StepParameters liftInWindAlongX() {
  StepParameters parameters;
  parameters.timeStep = frame;
  parameters.air.lift = 0.4;
  parameters.air.wind = Vec3(8.0, 0.0, 0.0);
  return parameters;
}

/// While it is flat, its speed of sinking follows from the lift of a thin plate, pi rho |w| S times that speed.
TEST(Auto, letsAFlatSheetSinkThroughTheWindAsFastAsAThinPlate) {
  const auto model = buildClothModel(testing::sheet(9), 0.15, MassLumping::Area, {});
  StepParameters parameters = liftInWindAlongX();
  parameters.precision = Precision::Double;
  ClothState state = stateAtRest(model->restPositions);
  Stepper stepper("auto");
  for (int step = 0; step < 15; ++step) {
    stepper.step(*model, parameters, {}, state);
  }
  const double sinking = 0.15 * parameters.gravity / (M_PI * parameters.air.density * 8.0);
  EXPECT_NEAR(linearMomentum(*model, state).y() / model->totalMass(), -sinking, 0.01 * sinking);
}

/// Eq. 20 holds it: at the jump of the lift a sheet that sinks is pushed up, and one that rises is pushed down.
TEST(Auto, withFullLiftHoldsAFlatSheetAlongTheWindAsEq20Does) {
  const auto model = buildClothModel(testing::sheet(9), 0.15, MassLumping::Area, {});
  StepParameters parameters = liftInWindAlongX();
  parameters.automatic.fullLift = true;
  for (const Precision precision : {Precision::Float, Precision::Double}) {
    parameters.precision = precision;
    ClothState state = stateAtRest(model->restPositions);
    Stepper stepper("auto");
    for (int step = 0; step < 15; ++step) {
      stepper.step(*model, parameters, {}, state);
    }
    EXPECT_LT(meanDistanceOf(state, stateAtRest(model->restPositions)), 1e-5);
  }
}

TEST(Auto, isNearTheConvergedMotionOfAFlagInHeavyAir) {
  ClothMesh mesh = testing::sheet(9);
  for (Vec3& position : mesh.positions) {
    position = Vec3(position.x(), -position.z(), 0.0);
  }
  const auto model = buildClothModel(mesh, 0.15, MassLumping::Area, {0, 9, 18, 27, 36, 45, 54, 63, 72});
  StepParameters parameters;
  parameters.timeStep = frame;
  parameters.air.drag = 0.5;
  parameters.air.lift = 0.3;
  parameters.air.density = 100.0;
  parameters.air.wind = Vec3(8.0, 0.0, 2.0);
  const auto after = [&](const char* solver, int substeps) {
    parameters.substeps = substeps;
    Stepper stepper(solver);
    ClothState state = stateAtRest(model->restPositions);
    for (int step = 0; step < 15; ++step) {
      stepper.step(*model, parameters, {}, state);
    }
    return state;
  };
  const ClothState converged = after("verlet", 10000);
  const double error = meanDistanceOf(after("auto", 1), converged);
  EXPECT_LT(error, 3e-3) << "with a thin plate's lift at small incidence";
  EXPECT_LT(error, 0.1 * meanDistanceOf(after("verlet", 64), converged)) << "as many substeps as auto takes at most";
}

TEST(Auto, leavesClothAloneThatIsAtRestWithoutGravity) {
  // Out of line, so that no length is exact.
  ClothMesh mesh = testing::sheet(9);
  testing::RandomVectors random(3);
  for (Vec3& position : mesh.positions) {
    position += random.next(0.02);
  }
  const auto model = buildClothModel(mesh, 0.1, MassLumping::Area, {0, 8});
  for (const Precision precision : {Precision::Float, Precision::Double}) {
    for (const double damping : {0.0, 1.0}) {
      StepParameters parameters;
      parameters.gravity = 0.0;
      parameters.material.stiffness = 1e4;
      parameters.material.damping = damping;
      parameters.precision = precision;
      ClothState state = stateAtRest(model->restPositions);
      Stepper stepper("auto");
      for (int step = 0; step < 10; ++step) {
        const StepReport report = stepper.step(*model, parameters, {}, state);
        EXPECT_EQ(report.choice->retries, 0) << "step " << step;
      }
      EXPECT_LT(meanDistanceOf(state, stateAtRest(model->restPositions)), 1e-6);
    }
  }
}

TEST(Auto, leavesAFabricAloneThatIsAtRestWithoutGravity) {
  ClothMesh irregular = testing::sheet(9);
  testing::RandomVectors random(3);
  for (Vec3& position : irregular.positions) {
    const Vec3 move = random.next(0.02);
    position += Vec3(move.x(), 0.0, move.z());
  }
  for (const ClothMesh& mesh : {testing::sheet(17), irregular}) {
    const auto model = testing::asFabric(*buildClothModel(mesh, 0.1, MassLumping::Area, {0, 8}), testing::woven());
    for (const Precision precision : {Precision::Float, Precision::Double}) {
      StepParameters parameters;
      parameters.gravity = 0.0;
      parameters.precision = precision;
      ClothState state = stateAtRest(model->restPositions);
      Stepper stepper("auto");
      for (int step = 0; step < 10; ++step) {
        const StepReport report = stepper.step(*model, parameters, {}, state);
        EXPECT_EQ(report.choice->retries, 0) << "step " << step;
        EXPECT_FALSE(report.choice->usedFallback) << "step " << step;
      }
      EXPECT_LT(meanDistanceOf(state, stateAtRest(model->restPositions)), 1e-6);
    }
  }
}

/// In float rounding leaves energy in the strains of a fabric, which is all the energy that it has.
TEST(Auto, takesNoStepOfAFreeFabricWithoutGravityInParts) {
  ClothMesh mesh = testing::sheet(25);
  for (Vec3& position : mesh.positions) {
    position *= 0.6;
  }
  fabric::Material cotton = testing::woven();
  cotton.stretchWarp = 4e3;
  cotton.stretchWeft = 6e3;
  const auto model = testing::asFabric(*buildClothModel(mesh, 0.04, MassLumping::Area, {}), cotton);
  StepParameters parameters;
  parameters.gravity = 0.0;
  parameters.precision = Precision::Float;
  ClothState state = stateAtRest(model->restPositions);
  Stepper stepper("auto");
  for (int step = 0; step < 150; ++step) {
    const adaptive::StepChoice choice = stepper.step(*model, parameters, {}, state).choice.value();
    ASSERT_FALSE(choice.inParts) << "step " << step;
  }
}

TEST(Auto, goesOnFromACopyOfTheStateToTheSameBits) {
  const auto model = pinnedSheet(17);
  StepParameters parameters = withEvaluations(*model, 1000.0, 100.0);
  parameters.automatic.errorTolerance = 1e-6;
  Stepper one("auto");
  ClothState state = stateAtRest(model->restPositions);
  for (int step = 0; step < 40; ++step) {
    one.step(*model, parameters, {}, state);
  }
  ClothState copy = state;
  Stepper other("auto");
  for (int step = 0; step < 40; ++step) {
    one.step(*model, parameters, {}, state);
    other.step(*model, parameters, {}, copy);
  }
  EXPECT_EQ(stateHash(state), stateHash(copy));
}

TEST(Auto, ignoresTheSettingOfSubsteps) {
  const auto model = pinnedSheet(9);
  StepParameters parameters = withEvaluations(*model, 1e3, 30.0);
  const auto hash = stateHash(fallen("auto", *model, parameters));
  parameters.substeps = 7;
  EXPECT_EQ(stateHash(fallen("auto", *model, parameters)), hash);
}

TEST(Auto, gainsNoEnergyInHardStarts) {
  for (const int n : {9, 17}) {
    const auto model = pinnedSheet(n);
    for (const double stiffness : {10.0, 1e3, 1e5}) {
      for (const double evaluations : {8.0, 30.0, 300.0}) {
        StepParameters parameters = withEvaluations(*model, stiffness, evaluations);
        parameters.gravity = 0.0;
        parameters.precision = Precision::Float;
        ClothState state = stateAtRest(model->restPositions);
        testing::RandomVectors random(5);
        for (std::size_t v = 0; v < state.positions.size(); ++v) {
          state.positions[v] = model->pinned[v] ? model->restPositions[v] : random.next(0.5);
        }
        const double start = energyOf(*model, parameters, state).total();
        Stepper stepper("auto");
        double highest = 0.0;
        for (int step = 0; step < 60; ++step) {
          stepper.step(*model, parameters, {}, state);
          highest = std::max(highest, energyOf(*model, parameters, state).total());
        }
        EXPECT_LT(highest, 1.01 * start) << n << " " << stiffness << " " << evaluations;
      }
    }
  }
}

TEST(Auto, keepsTheMotionWithALargeBudgetAndASmallOne) {
  const auto model = pinnedSheet(17);
  const auto positionsOf = [&](const char* solver, const StepParameters& parameters) {
    std::vector<std::vector<Vec3>> positions{model->restPositions};
    Stepper stepper(solver);
    ClothState state = stateAtRest(model->restPositions);
    for (int step = 0; step < 15; ++step) {
      stepper.step(*model, parameters, {}, state);
      positions.push_back(state.positions);
    }
    return positions;
  };
  for (const double stiffness : {10.0, 1e3, 1e5}) {
    StepParameters parameters = withEvaluations(*model, stiffness, 1e4);
    parameters.timeStep = 1.0 / 30.0;
    parameters.automatic.errorTolerance = 1e-4;
    StepParameters fine = parameters;
    fine.substeps = static_cast<int>(std::ceil(fine.timeStep / (0.5 * verletStepLimit(*model, parameters))));
    const auto reference = positionsOf("verlet", fine);
    for (const double share : {1.0, 0.002}) {  // of 50,000 evaluations a step
      StepParameters own = parameters;
      own.automatic.costBudget *= share;
      const auto positions = positionsOf("auto", own);
      MotionKept kept;
      for (std::size_t k = 1; k < positions.size(); ++k) {
        kept.add(*model, {positions[k - 1], positions[k], reference[k - 1], reference[k]});
      }
      EXPECT_GT(kept.value(), 0.95) << stiffness << " " << share;
    }
  }
}

/// Whether a step in float gives the bits of one in double.
bool isTakenInDouble(const ClothModel& model, StepParameters parameters) {
  parameters.precision = Precision::Double;
  const auto inDouble = stateHash(fallen("auto", model, parameters));
  parameters.precision = Precision::Float;
  return stateHash(fallen("auto", model, parameters)) == inDouble;
}

TEST(Auto, usesDoubleWhereRoundingWouldAddEnergy) {
  const auto model = pinnedSheet(17);
  for (const double stiffness : {10.0, 1e7}) {
    StepParameters parameters = withEvaluations(*model, stiffness, 3000.0);
    parameters.automatic.errorTolerance = 1e-4;
    EXPECT_EQ(isTakenInDouble(*model, parameters), stiffness > 1e6) << stiffness;
  }
}

TEST(Auto, usesFloatWhileDampedClothFalls) {
  const auto model = pinnedSheet(17);
  StepParameters parameters = withEvaluations(*model, 1e5, 1000.0);
  parameters.material.damping = 0.003;
  parameters.automatic.errorTolerance = 1e-4;
  EXPECT_FALSE(isTakenInDouble(*model, parameters));
}

TEST(Auto, usesDoubleWhereRoundingExceedsTheToleranceAndTheBudgetAllowsIt) {
  const auto model = pinnedSheet(17);
  StepParameters parameters = withEvaluations(*model, 10.0, 1000.0);
  parameters.automatic.errorTolerance = 1e-9;
  EXPECT_TRUE(isTakenInDouble(*model, parameters));
  StepParameters little = withEvaluations(*model, 10.0, 40.0);
  little.automatic.errorTolerance = 1e-9;
  EXPECT_FALSE(isTakenInDouble(*model, little));
  parameters.automatic.errorTolerance = 1e-5;
  EXPECT_FALSE(isTakenInDouble(*model, parameters));
}

/// The energy of free cloth relative to air that moves with `wind`, except a constant [J]: in the frame of the air,
/// gravity also acts against the motion of the frame.
double energyInTheAir(const ClothModel& model, const StepParameters& parameters, const ClothState& state) {
  const Energy energy = energyOf(model, parameters, state);
  double kinetic = 0.0;
  for (std::size_t v = 0; v < state.velocities.size(); ++v) {
    kinetic += 0.5 * model.vertexMass[v] * (state.velocities[v] - parameters.air.wind).squaredNorm();
  }
  return kinetic + energy.elastic + energy.potential -
         model.totalMass() * parameters.gravity * parameters.air.wind.y() * state.time;
}

TEST(Auto, gainsNoEnergyRelativeToTheWindOnStiffFreeCloth) {
  const auto model = buildClothModel(testing::sheet(17), 0.1, MassLumping::Area, {});
  for (const double stiffness : {3e4, 1e5, 1e6}) {
    for (const Vec3& wind : {Vec3(5.0, 0.0, 0.0), Vec3(2.0, 4.0, 1.0)}) {
      StepParameters parameters;
      parameters.timeStep = frame;
      parameters.material.stiffness = stiffness;
      parameters.air.drag = parameters.air.lift = 0.4;
      parameters.air.wind = wind;
      parameters.automatic.costBudget = 31.0;
      Stepper stepper("auto");
      ClothState state = testing::shaken(*model, 1e-4, 4);
      double lowest = energyInTheAir(*model, parameters, state);
      const double scale = lowest + model->totalMass() * parameters.gravity * std::sqrt(2.0);
      double largestRise = 0.0;
      for (int step = 0; step < 150; ++step) {
        stepper.step(*model, parameters, {}, state);
        const double energy = energyInTheAir(*model, parameters, state);
        lowest = std::min(lowest, energy);
        largestRise = std::max(largestRise, energy - lowest);
      }
      EXPECT_LT(largestRise, 0.01 * scale) << stiffness << " N/m, wind " << wind.transpose();
    }
  }
}

StepParameters stiff(double stiffness) {
  StepParameters parameters;
  parameters.material.stiffness = stiffness;
  return parameters;
}

TEST(Auto, usesDoubleWithAThirdOfTheEvaluationsWhereRoundingIsTheLargerError) {
  const auto model = pinnedSheet(17);
  const double stable = frame / (0.8 * verletStepLimit(*model, stiff(1000.0)));
  StepParameters parameters = withEvaluations(*model, 1000.0, 20.0 * stable);
  parameters.precision = Precision::Float;
  parameters.automatic.soften = false;
  StepReport last;
  const ClothState chosen = fallen("auto", *model, parameters, &last);
  EXPECT_LT(last.choice->forceEvaluations, 8.0 * stable) << "double costs three times as much";
  parameters.substeps = static_cast<int>(20.0 * stable);
  const ClothState inFloat = fallen("verlet", *model, parameters);
  parameters.precision = Precision::Double;
  parameters.substeps *= 10;
  const ClothState exact = fallen("verlet", *model, parameters);
  EXPECT_LT(meanDistanceOf(chosen, exact), 0.3 * meanDistanceOf(inFloat, exact));
}

TEST(Auto, conservesTheMomentumOfFreeClothWithClampedStiffness) {
  const auto model = testing::irregularSheet(17, {});
  StepParameters parameters = withEvaluations(*model, 1e5, 10.0);
  parameters.gravity = 0.0;
  ClothState state = testing::shaken(*model, 0.0002, 5);
  for (std::size_t v = 0; v < state.positions.size(); ++v) {
    state.velocities[v] += Vec3(1.0, 0.5, 0.2) + Vec3(0.3, 1.0, 0.0).cross(state.positions[v]);
  }
  const Vec3 linear = linearMomentum(*model, state);
  const Vec3 angular = angularMomentum(*model, state, Vec3::Zero());
  Stepper stepper("auto");
  for (int step = 0; step < 150; ++step) {
    const StepReport report = stepper.step(*model, parameters, {}, state);
    ASSERT_TRUE(report.choice);
    EXPECT_GE(report.choice->coarseLevels, 1);
  }
  EXPECT_LT((linearMomentum(*model, state) - linear).norm(), 1e-10 * linear.norm());
  EXPECT_LT((angularMomentum(*model, state, Vec3::Zero()) - angular).norm(), 1e-10 * angular.norm());
}

TEST(Auto, conservesTheMomentumOfFreeClothInAStepInParts) {
  const auto model = buildClothModel(testing::sheet(33), 0.1, MassLumping::Area, {});
  StepParameters parameters = stiff(1e5);
  parameters.timeStep = frame;
  parameters.gravity = 0.0;
  parameters.automatic.costBudget = 31.0;
  ClothState state = stateAtRest(model->restPositions);
  for (std::size_t v = 0; v < state.positions.size(); ++v) {
    state.positions[v] *= 0.01;
    state.velocities[v] = Vec3(1.0, 0.0, 0.2) + Vec3(0.0, 1.0, 0.0).cross(100.0 * state.positions[v]);
  }
  const Vec3 linear = linearMomentum(*model, state);
  const Vec3 angular = angularMomentum(*model, state, Vec3::Zero());
  Stepper stepper("auto");
  int stepsInParts = 0;
  for (int step = 0; step < 3; ++step) {
    stepsInParts += stepper.step(*model, parameters, {}, state).choice.value().inParts ? 1 : 0;
  }
  EXPECT_GT(stepsInParts, 0) << "this start is not hard enough";
  EXPECT_LT((linearMomentum(*model, state) - linear).norm(), 1e-10 * linear.norm());
  EXPECT_LT((angularMomentum(*model, state, Vec3::Zero()) - angular).norm(), 1e-10 * angular.norm());
}

TEST(Auto, keepsTheEnergyOfAViolentStart) {
  for (const bool pinned : {false, true}) {
    const std::vector<int> pins = pinned ? std::vector<int>{0, 32} : std::vector<int>();
    const auto model = buildClothModel(testing::sheet(33), 0.1, MassLumping::Area, pins);
    StepParameters parameters = stiff(1e5);
    parameters.timeStep = frame;
    parameters.precision = Precision::Float;
    parameters.gravity = 0.0;
    parameters.automatic.costBudget = 31.0;
    ClothState state = stateAtRest(model->restPositions);
    for (std::size_t v = 0; v < state.positions.size(); ++v) {
      state.positions[v] *= model->pinned[v] ? 1.0 : pinned ? -0.1 : 0.01;
    }
    const double start = energyOf(*model, parameters, state).total();
    Stepper stepper("auto");
    int inParts = 0;
    for (int step = 0; step < 3; ++step) {
      const auto choice = stepper.step(*model, parameters, {}, state).choice.value();
      inParts += choice.inParts ? 1 : 0;
      EXPECT_FALSE(choice.usedFallback);
      EXPECT_NEAR(energyOf(*model, parameters, state).total(), start, 0.01 * start) << "step " << step;
    }
    EXPECT_GT(inParts, 0) << "this start is not violent enough";
    if (!pinned) {
      const double speed = std::sqrt(2.0 * start / model->totalMass());
      EXPECT_LT(linearMomentum(*model, state).norm(), 1e-5 * model->totalMass() * speed);
    }
  }
}

/// No number of explicit substeps within the limits is stable for a fabric that is stretched a thousand times.
TEST(Auto, takesAHopelessStartOfAFabricByTheFallbackSolverWithoutGainingEnergyOrMomentum) {
  const auto springs = buildClothModel(testing::sheet(9), 0.1, MassLumping::Area, {});
  const auto model = testing::asFabric(*springs, testing::woven());
  StepParameters parameters;
  parameters.timeStep = frame;
  parameters.gravity = 0.0;
  ClothState state = stateAtRest(model->restPositions);
  testing::RandomVectors random(5);
  for (Vec3& position : state.positions) {
    position = random.next(100.0);
  }
  const double start = energyOf(*model, parameters, state).total();
  const double speed = std::sqrt(2.0 * start / model->totalMass());
  Stepper stepper("auto");
  int withFallback = 0;
  for (int step = 0; step < 3; ++step) {
    withFallback += stepper.step(*model, parameters, {}, state).choice->usedFallback ? 1 : 0;
    EXPECT_LE(energyOf(*model, parameters, state).total(), 1.01 * start) << "step " << step;
    EXPECT_LT(linearMomentum(*model, state).norm(), 1e-6 * model->totalMass() * speed) << "step " << step;
  }
  EXPECT_GT(withFallback, 0) << "this start is not hopeless enough";
}

/// Cloth with a budget so small that its springs keep 0.2 % of their stiffness.
StepParameters soft() {
  StepParameters parameters = stiff(1e5);
  parameters.timeStep = frame;
  parameters.automatic.costBudget = 2.0;
  parameters.automatic.soften = true;
  return parameters;
}

double fallEnergy(const ClothModel& model, const StepParameters& parameters) {
  return model.totalMass() * parameters.gravity * diagonalOf(model);
}

/// With the stiffness that it uses. Retries lower that stiffness, and later steps raise it again.
TEST(Auto, gainsNoEnergyWhenTheStiffnessOfSoftenedSpringsRises) {
  const auto model = buildClothModel(testing::sheet(17), 0.1, MassLumping::Area, {0});
  const StepParameters parameters = soft();
  Stepper stepper("auto");
  ClothState state = stateAtRest(model->restPositions);  // upright above its pin
  for (Vec3& position : state.positions) {
    position = Vec3(position.x(), position.z(), 1e-4 * std::sin(70.0 * position.x()));
  }
  double highest = -1e9;
  double start = 0.0;
  for (int step = 0; step < 1500; ++step) {
    stepper.step(*model, parameters, {}, state);
    const double energy = adaptive::stepMemoryOf(state).energy;
    start = step == 0 ? energy : start;
    highest = std::max(highest, energy);
  }
  EXPECT_LT(highest - start, 0.01 * fallEnergy(*model, parameters));
}

/// With the full stiffness.
TEST(Auto, gainsNoVisibleEnergyFromAReflectedOrCrumpledStartOfSoftenedCloth) {
  const auto model = buildClothModel(testing::sheet(17), 0.1, MassLumping::Area, {0, 16});
  const StepParameters parameters = soft();
  for (const Vec3& factors : {Vec3(-1.0, 1.0, 1.0), Vec3(0.01, 0.01, 0.01), Vec3(-0.1, -0.1, -0.1)}) {
    Stepper stepper("auto");
    ClothState state = stateAtRest(model->restPositions);
    for (std::size_t v = 0; v < state.positions.size(); ++v) {
      state.positions[v] = model->pinned[v] ? state.positions[v] : Vec3(factors.cwiseProduct(state.positions[v]));
    }
    const Energy start = energyOf(*model, parameters, state);
    const double scale = start.elastic + fallEnergy(*model, parameters);
    double highest = 0.0;
    for (int step = 0; step < 300; ++step) {
      stepper.step(*model, parameters, {}, state);
      highest = std::max(highest, energyOf(*model, parameters, state).total());
    }
    EXPECT_LT(highest - start.total(), 0.01 * scale) << factors.transpose();
  }
}

/// Rounding in float must not grow in the coarse levels, whose compressed springs have no stiffness.
TEST(Auto, gainsNoVisibleEnergyInTheFreeFallOfSoftenedCloth) {
  const auto model = buildClothModel(testing::sheet(17), 0.1, MassLumping::Area, {});
  StepParameters parameters = soft();
  parameters.automatic.costBudget = 6.0;
  parameters.precision = Precision::Float;
  Stepper stepper("auto");
  ClothState state = stateAtRest(model->restPositions);
  for (int step = 0; step < 300; ++step) {
    stepper.step(*model, parameters, {}, state);
    ASSERT_LT(energyOf(*model, parameters, state).total(), 0.01 * fallEnergy(*model, parameters)) << step;
  }
}

/// A sheet of 33 x 33 vertices at its four corners, with a budget so small that its springs would be softened.
class TautSheet : public ::testing::Test {
 protected:
  TautSheet() {
    parameters.automatic.costBudget = 20.0;
    parameters.precision = Precision::Float;
  }

  static constexpr int side = 33;
  static constexpr int otherEdge = side * (side - 1);
  std::shared_ptr<const ClothModel> model =
      buildClothModel(testing::sheet(side), 0.1, MassLumping::Area, {0, side - 1, otherEdge, otherEdge + side - 1});
  StepParameters parameters = soft();
  Stepper stepper{"auto"};
  ClothState state = stateAtRest(model->restPositions);
};

TEST_F(TautSheet, isNearerToItsTrueMotionThanWithSoftenedSprings) {
  const auto after = [&](const char* solver, const StepParameters& own) {
    Stepper ofOwn(solver);
    ClothState moved = stateAtRest(model->restPositions);
    for (int step = 0; step < 30; ++step) {
      ofOwn.step(*model, own, {}, moved);
    }
    return moved;
  };
  StepParameters fine = parameters;
  fine.precision = Precision::Double;
  fine.substeps = static_cast<int>(std::ceil(fine.timeStep / (0.5 * verletStepLimit(*model, fine))));
  const ClothState reference = after("verlet", fine);
  EXPECT_LT(meanDistance(after("auto", parameters).positions, reference.positions), 4e-3);
}

TEST_F(TautSheet, isTakenInImplicitStepsUntilACornerIsReleased) {
  EXPECT_EQ(stepper.step(*model, parameters, {}, state).choice->order, 1);
  const auto released = buildClothModel(testing::sheet(side), 0.1, MassLumping::Area, {0, side - 1, otherEdge});
  int order = 1;
  for (int step = 0; step < 80; ++step) {
    order = stepper.step(*released, parameters, {}, state).choice->order;
  }
  EXPECT_EQ(order, 2);
}

TEST_F(TautSheet, gainsNoVisibleEnergy) {
  double highest = -1e9;
  for (int step = 0; step < 300; ++step) {
    stepper.step(*model, parameters, {}, state);
    highest = std::max(highest, energyOf(*model, parameters, state).total());
  }
  EXPECT_LT(highest, 0.01 * fallEnergy(*model, parameters));
}

TEST_F(TautSheet, keepsTheEnergyThatTheMouseGaveIt) {
  stepper.step(*model, parameters, {}, state);
  const double start = adaptive::stepMemoryOf(state).tautEnergy;
  StepInputs inputs;
  inputs.attachment = Attachment{{.triangle = 1024, .barycentric = Vec3(0.3, 0.3, 0.4), .target = Vec3(0.5, 0.3, 0.5)},
                                 {.stiffness = 100.0, .maxForce = 5.0}};
  for (int step = 0; step < 20; ++step) {
    EXPECT_EQ(stepper.step(*model, parameters, inputs, state).choice->order, 2);
  }
  stepper.step(*model, parameters, {}, state);
  EXPECT_GT(adaptive::stepMemoryOf(state).tautEnergy, start + 0.01 * fallEnergy(*model, parameters));
}

TEST_F(TautSheet, followsPinsThatMoveInEqualParts) {
  for (int step = 0; step < 60; ++step) {
    std::vector<MovedPin> pins{{.vertex = 0, .by = Vec3(0.0, 1e-3, 0.0)}};
    StepInputs inputs;
    inputs.movedPins = &pins;
    stepper.step(*model, parameters, inputs, state);
  }
  EXPECT_NEAR(state.positions[0].y(), model->restPositions[0].y() + 0.06, 1e-9);
}

TEST(Auto, warnsWhenTheCostBudgetIsTooSmallForTheStiffness) {
  const auto model = pinnedSheet(33);
  const auto warning = findSolver("auto")->warning;
  EXPECT_FALSE(warning(*model, withEvaluations(*model, 1e3, 31.0)));
  StepParameters parameters = withEvaluations(*model, 1e5, 31.0);
  const SolverWarning softened = warning(*model, parameters).value();
  EXPECT_EQ(softened.kind, SolverWarning::Kind::Softened);
  EXPECT_NEAR(softened.stiffnessScale, 0.0019, 0.00005);
  EXPECT_TRUE(softened.softenedByChoice);
  parameters.automatic.costBudget = softened.neededCost;
  EXPECT_FALSE(warning(*model, parameters)) << "the budget that was named must do";
  parameters = withEvaluations(*model, 1e5, 31.0);
  parameters.automatic.soften = false;
  const SolverWarning slow = warning(*model, parameters).value();
  EXPECT_EQ(slow.kind, SolverWarning::Kind::SlowMotion);
  EXPECT_NEAR(slow.costRatio, 10.0, 0.5);
}

TEST(Auto, warnsThatItLimitsTheLiftOfEq20) {
  const auto model = pinnedSheet(9);
  const auto warning = findSolver("auto")->warning;
  StepParameters parameters = withEvaluations(*model, 1e3, 31.0);
  parameters.air.drag = 1.0;
  EXPECT_FALSE(warning(*model, parameters));
  parameters.air.lift = 0.3;
  ASSERT_TRUE(warning(*model, parameters));
  EXPECT_EQ(warning(*model, parameters)->kind, SolverWarning::Kind::LimitedLift);
  parameters.air.model = AirModel::Plate;
  EXPECT_FALSE(warning(*model, parameters)) << "this law has no jump";
}

}  // namespace
}  // namespace drape::sim
