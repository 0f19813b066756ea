#include "sim/adaptive/step_plan.hpp"

#include "fabric_cloths.hpp"
#include "sim/forces/stability.hpp"
#include "test_meshes.hpp"

#include <gtest/gtest.h>
#include <cmath>

namespace drape::sim::adaptive {
namespace {

/// A sheet with a budget of so many force evaluations a step. Its springs may be softened.
class StepPlanning : public ::testing::Test {
 protected:
  StepPlanning() { parameters.automatic.soften = true; }

  StepPlan plan(double evaluations) {
    parameters.automatic.costBudget =
        1.0001 * evaluations * static_cast<double>(model->springs.size()) / parameters.timeStep * 1e-6;
    memory.forceEvaluations = evaluations;
    return planStep(*model, localRatesOf(*model), parameters, parameters.automatic, inputs, memory);
  }

  std::shared_ptr<const ClothModel> model = testing::pinnedSheet(17);
  StepParameters parameters;
  StepInputs inputs;
  StepMemory memory;
};

TEST_F(StepPlanning, takesTheFourthOrderWhereTheBudgetGoesFarBeyondTheLimit) {
  parameters.material.stiffness = 10.0;  // H = 3.2
  const StepPlan chosen = plan(12.0);
  EXPECT_EQ(chosen.scheme, ExplicitScheme::Pefrl);
  EXPECT_EQ(chosen.forceEvaluations(), 12);
}

TEST_F(StepPlanning, takesVerletWhereDampingAirOrAnAttachmentActOnVelocities) {
  parameters.material.stiffness = 10.0;
  parameters.material.damping = 1e-5;
  EXPECT_EQ(plan(12.0).scheme, ExplicitScheme::Verlet);
  parameters.material.damping = 0.0;
  parameters.air.drag = 1.0;
  EXPECT_EQ(plan(12.0).scheme, ExplicitScheme::Verlet);
  parameters.air.drag = 0.0;
  inputs.attachment.emplace();
  EXPECT_EQ(plan(12.0).scheme, ExplicitScheme::Verlet);
}

TEST_F(StepPlanning, keepsTheFullStiffnessWhileASubstepIsBelowTheLimit) {
  parameters.material.stiffness = 1000.0;  // H = 32
  const StepPlan chosen = plan(17.0);
  EXPECT_EQ(chosen.substeps, 17);
  EXPECT_EQ(chosen.hOmegaLimit, 0.0);
  EXPECT_FALSE(chosen.usesCoarseLevels);
}

TEST_F(StepPlanning, keepsADistanceFromTheLimitWithAFabricSinceStretchRaisesItsFrequency) {
  model = testing::asFabric(*model, testing::membraneOnly());
  parameters.automatic.soften = false;
  const double preferred = stableEvaluations(*model, parameters);
  for (const double share : {0.5, 0.9, 0.95, 1.0}) {
    const StepPlan chosen = plan(std::floor(share * preferred));
    EXPECT_GE(chosen.substeps, std::floor(preferred)) << share;
    EXPECT_EQ(chosen.hOmegaLimit, 0.0);
  }
}

TEST_F(StepPlanning, exceedsTheBudgetALittleWhereAllSpringsThenKeepTheirStiffness) {
  parameters.material.stiffness = 1000.0;
  const StepPlan close = plan(13.0);
  EXPECT_EQ(close.substeps, 16);
  EXPECT_EQ(close.hOmegaLimit, 0.0);
  parameters.material.stiffness = 150.0;  // 7 evaluations, no more than the cost of four with coarse levels
  EXPECT_EQ(plan(2.0).substeps, 7);
  EXPECT_FALSE(plan(2.0).usesCoarseLevels);
}

TEST_F(StepPlanning, keepsTheFullStiffnessWhereItIsHardlySlowerThanCoarseLevels) {
  parameters.material.stiffness = 1000.0;  // 16 evaluations; 4 substeps with levels take as long as 18
  const StepPlan chosen = plan(2.0);
  EXPECT_FALSE(chosen.softens);
  EXPECT_EQ(chosen.substeps, 16);
}

TEST_F(StepPlanning, clampsSpringsAndAddsLevelsWhereTheyKeepLittleStiffness) {
  parameters.material.stiffness = 1e4;
  const StepPlan far = plan(8.0);
  EXPECT_TRUE(far.usesCoarseLevels);
  EXPECT_EQ(far.substeps, 4);
  const double scale = medianStiffnessScale(localRatesOf(*model), parameters, far);
  EXPECT_NEAR(scale, std::pow(1.8 * 4.0 / (parameters.timeStep * largestFrequency(*model, parameters)), 2.0), 1e-9);
}

TEST_F(StepPlanning, takesTheTimeOfTheLevelsForMoreSubstepsWhileTheyStoreTooMuch) {
  parameters.material.stiffness = 1e4;
  ASSERT_TRUE(plan(8.0).usesCoarseLevels);
  memory.withoutLevels = 3;
  const StepPlan chosen = plan(8.0);
  EXPECT_FALSE(chosen.usesCoarseLevels);
  EXPECT_TRUE(chosen.softens);
  EXPECT_EQ(chosen.substeps, 18);
}

TEST_F(StepPlanning, takesImplicitSubstepsOfTheSameCostForTautClothWithoutContactsAndAttachment) {
  parameters.material.stiffness = 1e4;
  memory.taut = true;
  const StepPlan chosen = plan(8.0);
  EXPECT_TRUE(chosen.isImplicit);
  EXPECT_FALSE(chosen.softens);
  EXPECT_EQ(chosen.substeps, 5);
  EXPECT_EQ(chosen.cost(), 17);
  inputs.attachment.emplace();
  EXPECT_FALSE(plan(8.0).isImplicit);
  inputs.attachment.reset();
  std::vector<SubstepContact> contacts;
  inputs.contacts = &contacts;
  EXPECT_FALSE(plan(8.0).isImplicit);
  inputs.contacts = nullptr;
  parameters.automatic.soften = false;
  EXPECT_FALSE(plan(8.0).isImplicit) << "nothing is softened";
}

TEST_F(StepPlanning, needsDoubleForDampedClothOnlyWhileItHardlyMoves) {
  parameters.material.stiffness = 1e5;
  parameters.material.damping = 0.003;
  const auto needsDouble = [&](double speed, bool contactsAct) {
    memory.speed = speed;
    return roundingAddsEnergy(*model, localRatesOf(*model), parameters, parameters.automatic, memory, 1.0, contactsAct);
  };
  EXPECT_TRUE(needsDouble(0.01, false));
  EXPECT_FALSE(needsDouble(0.1, false));
  EXPECT_EQ(needsDouble(0.1, true), needsDouble(0.01, true)) << "contact delays rest";
}

TEST_F(StepPlanning, usesNoLevelsWhereTheLoadHardlyStretchesTheClampedSprings) {
  parameters.material.stiffness = 1e5;
  ASSERT_TRUE(plan(30.0).usesCoarseLevels) << "it hangs from two vertices";
  std::vector<int> edge;
  for (int v = 0; v < 17; ++v) {
    edge.push_back(v);
  }
  model = buildClothModel(testing::sheet(17), 0.1, MassLumping::Uniform, edge);
  const StepPlan clamped = plan(30.0);
  EXPECT_FALSE(clamped.usesCoarseLevels);
  EXPECT_EQ(clamped.substeps, 30);
  inputs.attachment.emplace();
  EXPECT_TRUE(plan(30.0).usesCoarseLevels) << "an attachment pulls at one place";
  inputs.attachment.reset();
  parameters.air.wind = {100.0, 0.0, 0.0};
  parameters.air.drag = 1.0;
  EXPECT_TRUE(plan(30.0).usesCoarseLevels) << "a storm";
}

TEST_F(StepPlanning, keepsToTheBudgetOtherwiseButTakesAtLeastFourEvaluations) {
  parameters.material.stiffness = 1e5;
  EXPECT_EQ(plan(30.0).forceEvaluations(), 15) << "coarse levels cost as much again";
  EXPECT_EQ(plan(0.5).forceEvaluations(), 4);
}

TEST_F(StepPlanning, exceedsTheBudgetWhereTheSpringsMayNotBeSoftened) {
  parameters.automatic.soften = false;
  parameters.material.stiffness = 1e5;  // H = 320
  const double hOmega = parameters.timeStep * largestFrequency(*model, parameters);
  for (const double evaluations : {0.5, 30.0, 80.0}) {
    const StepPlan chosen = plan(evaluations);
    EXPECT_NEAR(chosen.substeps, hOmega / 1.8, 1.0) << evaluations;
    EXPECT_EQ(chosen.hOmegaLimit, 0.0);
    EXPECT_FALSE(chosen.usesCoarseLevels);
  }
  EXPECT_EQ(plan(190.0).substeps, 190);
}

TEST_F(StepPlanning, softensClothOnlyWhereAStepWouldTakeSeconds) {
  parameters.automatic.soften = false;
  parameters.material.stiffness = 1e5;
  EXPECT_FALSE(maySoften(*model, parameters, parameters.automatic));
  parameters.material.stiffness = 1e15;  // 16 million evaluations
  EXPECT_TRUE(maySoften(*model, parameters, parameters.automatic));
  const StepPlan chosen = plan(30.0);
  EXPECT_TRUE(chosen.softens);
  EXPECT_NEAR(chosen.cost(), 2e9 / static_cast<double>(model->springs.size()), 2.0);
}

TEST_F(StepPlanning, usesASaferPlanForARetry) {
  const StepPlan softer = saferPlan({.substeps = 10, .hOmegaLimit = 1.8, .softens = true});
  EXPECT_EQ(softer.substeps, 10) << "clamped further at first";
  EXPECT_LT(softer.hOmegaLimit, 1.8);
  const StepPlan finer = saferPlan(softer);
  EXPECT_EQ(finer.substeps, 20);
  EXPECT_NEAR(finer.hOmegaLimit * finer.substeps, softer.hOmegaLimit * softer.substeps, 1e-12) << "as soft as before";
  EXPECT_EQ(saferPlan({.substeps = 10, .hOmegaLimit = 1.8}).substeps, 20)
      << "springs that may not be softened get more substeps at once";
  const StepPlan plain = saferPlan({.scheme = ExplicitScheme::Pefrl, .substeps = 5});
  EXPECT_EQ(plain.scheme, ExplicitScheme::Verlet);
  EXPECT_EQ(plain.substeps, 40);
}

TEST_F(StepPlanning, spendsNoMoreThanTheErrorEstimateNeeds) {
  parameters.material.stiffness = 1000.0;
  parameters.automatic.costBudget = 1e6;
  const LocalRates rates = localRatesOf(*model);
  const StepPlan frugal =
      planStep(*model, rates, parameters, parameters.automatic, inputs, StepMemory{.forceEvaluations = 1.0});
  const double hOmega = parameters.timeStep * largestFrequency(*model, parameters);
  EXPECT_NEAR(frugal.forceEvaluations(), hOmega / 1.8, 1.0);
  EXPECT_EQ(planStep(*model, rates, parameters, parameters.automatic, inputs, StepMemory{.forceEvaluations = 50.0})
                .forceEvaluations(),
            50);
}

TEST_F(StepPlanning, takesMoreEvaluationsForATightToleranceThanInChaoticMotionOtherwise) {
  parameters.material.stiffness = 10.0;
  parameters.material.damping = 1e-5;
  parameters.automatic.costBudget = 1e6;
  const LocalRates rates = localRatesOf(*model);
  const auto evaluations = [&](double tolerance) {
    parameters.automatic.errorTolerance = tolerance;
    return planStep(*model, rates, parameters, parameters.automatic, inputs, StepMemory{.forceEvaluations = 1e5})
        .forceEvaluations();
  };
  EXPECT_EQ(evaluations(1e-4), 64);
  EXPECT_EQ(evaluations(1e-5), 64);
  EXPECT_EQ(evaluations(2.5e-6), 128);
  EXPECT_EQ(evaluations(1e-12), 512);
}

/// Whether a step is taken in double where the budget allows `inFloat` H omega evaluations in float, and the tolerance
/// is out of reach.
bool takesDouble(const ClothModel& model, StepParameters parameters, double inFloat) {
  parameters.automatic.errorTolerance = 1e-12;
  const double evaluations = inFloat * parameters.timeStep * largestFrequency(model, parameters);
  parameters.automatic.costBudget =
      evaluations * static_cast<double>(model.springs.size()) / parameters.timeStep * 1e-6;
  return roundingExceedsTolerance(model, localRatesOf(model), parameters, parameters.automatic, {},
                                  StepMemory{.forceEvaluations = 10.0 * evaluations}, 1.0);
}

TEST_F(StepPlanning, takesDoubleInsteadOfMoreEvaluationsOnlyInAStepOfTheSameOrder) {
  parameters.material.stiffness = 1000.0;
  EXPECT_TRUE(takesDouble(*model, parameters, 1.9)) << "second order in both";
  EXPECT_FALSE(takesDouble(*model, parameters, 2.1)) << "fourth order in float alone";
  EXPECT_FALSE(takesDouble(*model, parameters, 5.9)) << "fourth order in float alone";
  EXPECT_TRUE(takesDouble(*model, parameters, 6.1)) << "fourth order in both";
}

/// h lambda of damping in a substep.
double dampedIn(const ClothModel& model, const StepParameters& parameters, const StepPlan& plan) {
  return parameters.timeStep / plan.substeps * model.unitDampingRate * parameters.material.damping;
}

TEST_F(StepPlanning, splitsDampingWhereSubstepsForItWouldCostMore) {
  parameters.automatic.soften = false;
  parameters.material.stiffness = 1000.0;  // H = 32
  const double hOmega = parameters.timeStep * largestFrequency(*model, parameters);
  parameters.material.damping = 1e-4;
  EXPECT_EQ(plan(20.0).dampingStages, 0);
  for (const double damping : {1.0, 10.0, 100.0}) {
    parameters.material.damping = damping;
    const StepPlan chosen = plan(20.0);
    const double s = chosen.dampingStages;
    EXPECT_GT(s, 0.0) << damping;
    EXPECT_GE(s * s + s, dampedIn(*model, parameters, chosen)) << damping;
    EXPECT_GE(1.5 * chosen.substeps, hOmega) << damping;
    EXPECT_LT(chosen.cost(), 0.5 * parameters.timeStep / verletStepLimit(*model, parameters)) << damping;
  }
}

TEST_F(StepPlanning, usesTheFullDampingWhereSpringsAreClampedToo) {
  parameters.material.stiffness = 1e5;
  parameters.material.damping = 0.1;
  const StepPlan chosen = plan(20.0);
  const double s = chosen.dampingStages;
  EXPECT_TRUE(chosen.softens);
  EXPECT_GE(s * s + s, dampedIn(*model, parameters, chosen));
  EXPECT_EQ(chosen.hOmegaLimit, 1.5) << "the limit of the stages";
  EXPECT_LT(chosen.cost(), 24);
}

TEST_F(StepPlanning, doesNotLetAFewFastVerticesDetermineTheSubsteps) {
  ClothMesh mesh = testing::sheet(17);
  mesh.positions[8 * 17 + 8] = mesh.positions[8 * 17 + 9] + Vec3(-1e-3, 0.0, 0.0);  // slivers around one vertex
  model = buildClothModel(mesh, 0.1, MassLumping::Area, {0, 16});
  parameters.material.stiffness = 1000.0;
  const LocalRates rates = localRatesOf(*model);
  const StepPlan chosen = plan(17.0);
  EXPECT_GT(parameters.timeStep * largestFrequency(*model, parameters), 2.04 * 17.0);
  EXPECT_EQ(medianStiffnessScale(rates, parameters, chosen), 1.0);
  EXPECT_FALSE(chosen.usesCoarseLevels);
  parameters.material.damping = 10.0;
  const double slivers = model->unitDampingRate / rates.dampingPercentile99;
  EXPECT_GT(slivers, 1.2);
  const StepPlan damped = plan(17.0);
  EXPECT_LT(damped.dampingStages, std::sqrt(dampedIn(*model, parameters, damped) / slivers) + 2.0);
  parameters.material.damping = 0.0;
  parameters.automatic.soften = false;
  EXPECT_LT(plan(17.0).substeps, 20) << "also where springs may not be softened";
  EXPECT_FALSE(plan(17.0).softens);
}

}  // namespace
}  // namespace drape::sim::adaptive
