#include "sim/adaptive/energy_guard.hpp"

#include "test_meshes.hpp"

#include <gtest/gtest.h>
#include <limits>

namespace drape {
namespace {

/// A sheet at rest of which a step has been booked, so that the energy it begins with is known.
class LookingAtTheEnergy : public ::testing::Test {
 protected:
  LookingAtTheEnergy() { parameters.stiffness = 10.0; }

  /// In how many of the next 24 steps of so many passes the energy at the end is due.
  int looks(int passes) {
    const StepPlan plan{.substeps = passes};
    int due = 0;
    state = stateAtRest(model->restPositions);
    begin();
    guard.store(*model, parameters, plan, StepEnergy{.ends = true}, 0.0, state);
    state.memory.energyDrift = risen;
    state.memory.retryLevel = caution;
    for (state.memory.steps = 1; state.memory.steps <= 24; ++state.memory.steps) {
      begin();
      due += guard.isMeasurementDue(plan, state.memory) ? 1 : 0;
    }
    return due;
  }

  void begin() {
    guard.prepare(*model, localRatesOf(*model), parameters, state, 0.5 * std::numeric_limits<float>::epsilon());
  }

  std::shared_ptr<const ClothModel> model = testing::pinnedSheet(9);
  StepParameters parameters;
  ClothState state;
  EnergyGuard guard;
  double risen = 0.0;
  int caution = 0;
};

TEST_F(LookingAtTheEnergy, isDueNowAndThenInStepsOfFewPassesAndInAllOthersAlways) {
  EXPECT_EQ(looks(6), 6);
  EXPECT_EQ(looks(12), 12);
  EXPECT_EQ(looks(24), 24);
}

TEST_F(LookingAtTheEnergy, isDueInEveryStepOnceTheEnergyRoseOrAStepWasTakenAgain) {
  risen = 0.01 * parameters.gravity * model->totalMass();
  EXPECT_EQ(looks(6), 24);
  risen = 0.0;
  caution = 1;
  EXPECT_EQ(looks(6), 24);
}

TEST_F(LookingAtTheEnergy, isDueInEveryStepInWind) {
  parameters.wind = {1.0, 0.0, 0.0};
  parameters.drag = 1.0;
  EXPECT_EQ(looks(6), 24);
}

TEST_F(LookingAtTheEnergy, isDueWhereTheClothIsNotAsTheLastStepLeftIt) {
  looks(6);
  const StepPlan plan{.substeps = 6};
  state.memory.steps = 1;
  begin();
  ASSERT_FALSE(guard.isMeasurementDue(plan, state.memory));
  state.positions.back().y() += 0.01;
  begin();
  EXPECT_TRUE(guard.isMeasurementDue(plan, state.memory));
}

}  // namespace
}  // namespace drape
