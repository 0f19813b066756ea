#include "sim/adaptive/energy_guard.hpp"

#include "fabric_cloths.hpp"
#include "sim/adaptive/tuning.hpp"
#include "sim/forces/diagnostics.hpp"
#include "test_meshes.hpp"

#include <gtest/gtest.h>
#include <limits>

namespace drape::sim::adaptive {
namespace {

/// A sheet at rest after an accepted step, so that the energy at the start of the next step is known.
class MeasuringTheEnergy : public ::testing::Test {
 protected:
  MeasuringTheEnergy() { parameters.material.stiffness = 10.0; }

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
    guard.prepare(*model, localRatesOf(*model), parameters, state, 0.5 * std::numeric_limits<float>::epsilon(),
                  Vec3::Zero());
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
  parameters.air.wind = {1.0, 0.0, 0.0};
  parameters.air.drag = 1.0;
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

TEST_F(MeasuringTheEnergy, isDueWhenTheFabricChangedSinceTheLastStep) {
  const auto springs = model;
  const auto fabricOf = [&](const fabric::Material& material, const Vec3& warp) {
    return fabric::withFabric(*springs, material, fabric::warpAlong(warp, springs->restPositions, springs->triangles));
  };
  fabric::Material material = testing::woven();
  material.stiffeningWarp = 100.0;
  fabric::Material stiffening = material;
  stiffening.stiffeningStrain *= 0.5;
  const StepPlan plan{.substeps = 6};
  for (const auto& changed : {fabricOf(stiffening, Vec3::UnitX()), fabricOf(material, Vec3::UnitZ())}) {
    model = fabricOf(material, Vec3::UnitX());
    measurements(6);
    memory.steps = 1;
    prepare();
    ASSERT_FALSE(guard.isMeasurementDue(plan, memory));
    ASSERT_NEAR(changed->unitFrequency, model->unitFrequency, 1e-3 * model->unitFrequency);
    model = changed;
    prepare();
    EXPECT_TRUE(guard.isMeasurementDue(plan, memory));
  }
}

/// A step of a shaken sheet whose energies are given. The reference energy is a fraction of that of a fall.
class DecidingOnAStep : public ::testing::Test {
 protected:
  DecidingOnAStep() {
    parameters.material.stiffness = 10.0;
    const LocalRates rates = localRatesOf(*model);
    fall = parameters.gravity * rates.mass * rates.diagonal;
    guard.prepare(*model, rates, parameters, state, 0.5 * std::numeric_limits<float>::epsilon(), Vec3::Zero());
    for (std::size_t v = 0; v < state.positions.size(); ++v) {
      potential += parameters.gravity * model->vertexMass[v] * state.positions[v].y();
    }
  }

  /// Energies of a step during which the scheme's energy grows by `scheme` and the visible energy by `visible` [J].
  [[nodiscard]] StepEnergy growth(double scheme, double visible) const {
    return {
        .first = potential, .last = potential + scheme, .start = potential, .end = potential + visible, .ends = true};
  }
  [[nodiscard]] double schemeLimit(double fraction) const { return fraction * tuning.fallEnergyFraction * fall; }

  std::shared_ptr<const ClothModel> model = testing::pinnedSheet(9);
  ClothState state = testing::shaken(*model, 0.5, 7);
  StepParameters parameters;
  StepMemory memory;
  EnergyGuard guard;
  double fall = 0.0;       // m g D [J]
  double potential = 0.0;  // of the start [J]
};

TEST_F(DecidingOnAStep, refusesAnEnergyThatIsNotFinite) {
  const double nothing = std::numeric_limits<double>::quiet_NaN();
  const double endless = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(guard.hasGrown(growth(nothing, 0.0), 0.0, false, memory));
  EXPECT_TRUE(guard.hasGrown(growth(0.0, endless), 0.0, false, memory));
  EXPECT_FALSE(guard.hasGrown(growth(0.0, 0.0), 0.0, false, memory));
}

TEST_F(DecidingOnAStep, refusesALossAboveTheTotalEnergy) {
  EXPECT_TRUE(guard.hasGrown(growth(-1e277, 0.0), 0.0, false, memory));
  EXPECT_TRUE(guard.hasGrown(growth(-10.0 * fall, 0.0), 0.0, false, memory));
  EXPECT_FALSE(guard.hasGrown(growth(-0.5 * fall, 0.0), 0.0, false, memory));
}

TEST_F(DecidingOnAStep, sumsTheGrowthOfTheSchemesEnergyAndRefusesTheStepThatExceedsTheLimit) {
  const StepEnergy grown = growth(0.6 * schemeLimit(tuning.maxSchemeDrift), 0.0);
  EXPECT_FALSE(guard.hasGrown(grown, 0.0, false, memory));
  const double sum = memory.schemeEnergyDrift;
  EXPECT_NEAR(sum, 0.6 * schemeLimit(tuning.maxSchemeDrift), 1e-12 * fall);
  EXPECT_TRUE(guard.hasGrown(grown, 0.0, false, memory));
  EXPECT_EQ(memory.schemeEnergyDrift, sum) << "a refused step does not count";
}

TEST_F(DecidingOnAStep, subtractsALossOfTheSchemesEnergyFromTheSum) {
  EXPECT_FALSE(guard.hasGrown(growth(0.9 * schemeLimit(tuning.maxSchemeDrift), 0.0), 0.0, false, memory));
  EXPECT_FALSE(guard.hasGrown(growth(-2.0 * schemeLimit(tuning.maxSchemeDrift), 0.0), 0.0, false, memory));
  EXPECT_EQ(memory.schemeEnergyDrift, 0.0);
}

TEST_F(DecidingOnAStep, acceptsGrowthThatExternalWorkExplains) {
  const double work = 3.0 * schemeLimit(tuning.maxSchemeDrift);
  EXPECT_TRUE(guard.hasGrown(growth(work, work), 0.0, false, memory));
  EXPECT_FALSE(guard.hasGrown(growth(work, work), work, false, memory));
}

TEST_F(DecidingOnAStep, testsARetryByItselfWithoutTheSumOfEarlierSteps) {
  memory.schemeEnergyDrift = schemeLimit(tuning.maxSchemeDrift);
  EXPECT_TRUE(guard.hasGrown(growth(1.1 * schemeLimit(tuning.maxSchemeDriftOfRetry), 0.0), 0.0, true, memory));
  EXPECT_FALSE(guard.hasGrown(growth(0.9 * schemeLimit(tuning.maxSchemeDriftOfRetry), 0.0), 0.0, true, memory));
  EXPECT_EQ(memory.schemeEnergyDrift, 0.0);
}

TEST_F(DecidingOnAStep, refusesAStepIfTheVisibleEnergyRoseTooFarToRemoveIt) {
  EXPECT_FALSE(guard.hasGrown(growth(0.0, 0.9 * tuning.maxRemovedEnergy * fall), 0.0, false, memory));
  EXPECT_TRUE(guard.hasGrown(growth(0.0, 1.1 * tuning.maxRemovedEnergy * fall), 0.0, false, memory));
  const StepEnergy nearLimit = growth(0.0, (tuning.maxRemovedEnergy - 0.5 * tuning.maxEnergyDrift) * fall);
  EXPECT_FALSE(guard.hasGrown(nearLimit, 0.0, false, memory));
  memory.energyDrift = tuning.maxEnergyDrift * fall;
  EXPECT_TRUE(guard.hasGrown(nearLimit, 0.0, false, memory));
}

TEST_F(DecidingOnAStep, acceptsAStepIfOnlyEarlierStepsGainedEnergyThatCouldNotBeRemoved) {
  memory.energyDrift = 10.0 * tuning.maxRemovedEnergy * fall;
  EXPECT_FALSE(guard.hasGrown(growth(0.0, 0.5 * tuning.maxRemovedEnergy * fall), 0.0, false, memory));
  EXPECT_TRUE(guard.hasGrown(growth(0.0, 1.1 * tuning.maxRemovedEnergy * fall), 0.0, false, memory));
}

TEST_F(DecidingOnAStep, removesTheVisibleEnergyAboveTheAllowedDriftFromTheMotion) {
  const double before = energyOf(*model, parameters, state).kinetic;
  const double excess = 0.03 * fall;
  ASSERT_GT(before, excess);
  guard.store(*model, parameters, StepPlan{}, growth(0.0, tuning.maxEnergyDrift * fall + excess), 0.0, memory, state);
  EXPECT_NEAR(before - energyOf(*model, parameters, state).kinetic, excess, 1e-9 * fall);
  EXPECT_NEAR(memory.energyDrift, tuning.maxEnergyDrift * fall, 1e-9 * fall);
  EXPECT_NEAR(memory.energy, potential + tuning.maxEnergyDrift * fall, 1e-9 * fall);
}

TEST_F(DecidingOnAStep, removesTheEnergyThatAStifferPlanAddsToSoftenedSprings) {
  const StepPlan softer{.substeps = 4, .hOmegaLimit = 1.0, .softens = true};
  const StepPlan stiffer{.substeps = 4, .hOmegaLimit = 1.8, .softens = true};
  const auto next = [&](const StepPlan& plan, double start) {
    guard.prepare(*model, localRatesOf(*model), parameters, state, 0.5 * std::numeric_limits<float>::epsilon(),
                  Vec3::Zero());
    StepEnergy energy = growth(0.0, 0.0);
    energy.start = energy.end = potential + start;
    guard.store(*model, parameters, plan, energy, 0.0, memory, state);
  };
  const double before = energyOf(*model, parameters, state).kinetic;
  const double added = 0.03 * fall;
  next(stiffer, 0.0);
  next(softer, -0.1 * fall);
  next(stiffer, 0.0);
  EXPECT_EQ(energyOf(*model, parameters, state).kinetic, before) << "it only got back what the softer plan took";
  next(softer, -0.1 * fall);
  next(stiffer, added);
  EXPECT_NEAR(before - energyOf(*model, parameters, state).kinetic, added, 1e-9 * fall);
  EXPECT_NEAR(memory.energy, potential, 1e-9 * fall);
}

TEST_F(DecidingOnAStep, leavesTheMotionAloneWhileTheDriftIsAllowed) {
  const std::uint64_t before = stateHash(state);
  guard.store(*model, parameters, StepPlan{}, growth(0.0, 0.9 * tuning.maxEnergyDrift * fall), 0.0, memory, state);
  EXPECT_EQ(stateHash(state), before);
}

}  // namespace
}  // namespace drape::sim::adaptive
