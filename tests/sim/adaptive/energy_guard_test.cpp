#include "sim/adaptive/energy_guard.hpp"

#include "test_meshes.hpp"

#include <gtest/gtest.h>
#include <limits>

namespace drape {
namespace {

/// A sheet at rest after an accepted step, so that the energy at the start of the next step is known.
class MeasuringTheEnergy : public ::testing::Test {
 protected:
  MeasuringTheEnergy() { parameters.stiffness = 10.0; }

  /// The number of energy measurements in the next 24 steps of so many force evaluations.
  int measurements(int evaluations) {
    const StepPlan plan{.substeps = evaluations};
    int due = 0;
    state = stateAtRest(model->restPositions);
    memory = {};
    prepare();
    guard.store(*model, parameters, plan, StepEnergy{.ends = true}, 0.0, memory, state);
    memory.energyDrift = drift;
    memory.retryLevel = retryLevel;
    for (memory.steps = 1; memory.steps <= 24; ++memory.steps) {
      prepare();
      due += guard.isMeasurementDue(plan, memory) ? 1 : 0;
    }
    return due;
  }

  void prepare() {
    guard.prepare(*model, localRatesOf(*model), parameters, state, 0.5 * std::numeric_limits<float>::epsilon());
  }

  std::shared_ptr<const ClothModel> model = testing::pinnedSheet(9);
  StepParameters parameters;
  ClothState state;
  StepMemory memory;
  EnergyGuard guard;
  double drift = 0.0;
  int retryLevel = 0;
};

TEST_F(MeasuringTheEnergy, isDueNowAndThenInStepsOfFewEvaluationsAndAlwaysInAllOthers) {
  EXPECT_EQ(measurements(6), 6);
  EXPECT_EQ(measurements(12), 12);
  EXPECT_EQ(measurements(24), 24);
}

TEST_F(MeasuringTheEnergy, isDueInEveryStepAfterAnEnergyDriftOrARetry) {
  drift = 0.01 * parameters.gravity * model->totalMass();
  EXPECT_EQ(measurements(6), 24);
  drift = 0.0;
  retryLevel = 1;
  EXPECT_EQ(measurements(6), 24);
}

TEST_F(MeasuringTheEnergy, isDueInEveryStepInWind) {
  parameters.wind = {1.0, 0.0, 0.0};
  parameters.drag = 1.0;
  EXPECT_EQ(measurements(6), 24);
}

TEST_F(MeasuringTheEnergy, isDueWhenTheStateChangedSinceTheLastStep) {
  measurements(6);
  const StepPlan plan{.substeps = 6};
  memory.steps = 1;
  prepare();
  ASSERT_FALSE(guard.isMeasurementDue(plan, memory));
  state.positions.back().y() += 0.01;
  prepare();
  EXPECT_TRUE(guard.isMeasurementDue(plan, memory));
}

}  // namespace
}  // namespace drape
