#include "sim/adaptive/step_memory.hpp"
#include "sim/adaptive/step_plan.hpp"
#include "sim/adaptive/tuning.hpp"

#include "fabric_cloths.hpp"
#include "sim/forces/diagnostics.hpp"
#include "sim/stepping/stepper.hpp"
#include "test_meshes.hpp"

#include <gtest/gtest.h>
#include <memory>
#include <vector>

namespace drape::sim::adaptive {
namespace {

using testing::hangingFromRow;
using testing::shaken;
using testing::woven;

/// A sheet of 1 m that hangs from its upper edge, with that multiple of the bending stiffness of `woven`.
std::shared_ptr<const ClothModel> bendingSheet(double bending = 1.0) {
  fabric::Material material = woven();
  material.stretchWarp = material.stretchWeft = 6000.0;
  for (double* stiffness : {&material.bendWarp, &material.bendWeft, &material.bendBias}) {
    *stiffness *= bending;
  }
  return hangingFromRow(material);
}

TEST(SlowForces, ofBendingActLessOftenThanThoseOfTheAir) {
  const auto model = bendingSheet();
  StepParameters parameters;
  parameters.timeStep = 1.0 / 60.0;
  parameters.automatic.costBudget = 1e5;
  parameters.air.drag = 1.0;
  const LocalRates rates = localRatesOf(*model);
  const StepPlan plan = planStep(*model, rates, parameters, parameters.automatic, {}, {});
  const double substep = parameters.timeStep / plan.substeps;
  EXPECT_LE(plan.airInterval * substep, tuning.maxAirTime);
  EXPECT_LE(plan.bendingInterval * substep * rates.bendingFrequency, tuning.maxBendingHOmega);
  EXPECT_GT(plan.bendingInterval, plan.airInterval);
  EXPECT_EQ(plan.bendingInterval % (2 * plan.airInterval), plan.airInterval)
      << "an odd multiple: both middles coincide";
  EXPECT_EQ(plan.substeps % plan.bendingInterval, 0);
}

TEST(SlowForces, actLessOftenThanTheMembraneAndKeepTheEnergy) {
  const auto model = bendingSheet();
  StepParameters parameters;
  parameters.timeStep = 1.0 / 60.0;
  parameters.automatic.costBudget = 1e5;
  parameters.air.drag = parameters.air.lift = 0.0;
  ClothState state = shaken(*model, 0.002, 5);
  const StepPlan plan = planStep(*model, localRatesOf(*model), parameters, parameters.automatic, {}, {});
  if (plan.scheme == ExplicitScheme::Verlet) {
    EXPECT_GT(plan.bendingInterval, 1);
    EXPECT_EQ(plan.bendingInterval % 2, 1);
    EXPECT_EQ(plan.substeps % plan.bendingInterval, 0);
  }
  Stepper stepper("auto");
  const double start = energyOf(*model, parameters, state).total();
  const double moving = energyOf(*model, parameters, state).elastic + energyOf(*model, parameters, state).kinetic;
  for (int i = 0; i < 60; ++i) {
    (void)stepper.step(*model, parameters, {}, state);
  }
  EXPECT_NEAR(energyOf(*model, parameters, state).total(), start, 0.02 * moving);
}

TEST(SlowForces, actInEverySubstepForAWhileAfterTheEnergyGrew) {
  constexpr double resonant = 500.0;
  const auto model = bendingSheet(resonant);
  StepParameters parameters;
  parameters.timeStep = 1.0 / 60.0;
  parameters.gravity = 1.0;
  parameters.automatic.costBudget = 1e5;
  parameters.air.drag = parameters.air.lift = 0.0;
  const auto planWith = [&](const StepMemory& memory) {
    return planStep(*model, localRatesOf(*model), parameters, parameters.automatic, {}, memory);
  };
  const StepPlan plan = planWith({});
  ASSERT_GT(plan.bendingInterval, 1);
  ClothState state = shaken(*model, 0.0015, 5);
  Stepper stepper("auto");
  const StepReport report = stepper.step(*model, parameters, {}, state);
  const StepMemory memory = stepMemoryOf(state);
  EXPECT_EQ(report.choice->retries, 1);
  EXPECT_EQ(report.choice->substeps, plan.substeps) << "no finer than before";
  EXPECT_EQ(memory.retryLevel, 0);
  EXPECT_EQ(memory.doubleSteps, 0) << "rounding is not the cause";
  EXPECT_EQ(memory.everySubstep, tuning.everySubstepSteps - 1);
  EXPECT_EQ(planWith(memory).bendingInterval, 1);
}

}  // namespace
}  // namespace drape::sim::adaptive
