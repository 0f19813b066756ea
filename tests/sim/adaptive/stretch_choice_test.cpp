#include "sim/adaptive/stretch_choice.hpp"

#include "fabric_cloths.hpp"
#include "sim/adaptive/step_plan.hpp"
#include "sim/adaptive/tuning.hpp"
#include "sim/fabric/fabric.hpp"
#include "sim/forces/diagnostics.hpp"
#include "sim/stepping/stepper.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace drape::sim::adaptive {
namespace {

using namespace testing;

/// A sheet of 1 m that hangs from its upper edge. @param damping of stretch and bending [s]
std::shared_ptr<const ClothModel> hangingFabric(double damping = 0.0) {
  fabric::Material material = woven();
  material.stretchWarp = material.stretchWeft = 6000.0;
  material.stretchDamping = material.bendDamping = damping;
  return hangingFromRow(material);
}

/// Two sheets of 1 m that hang side by side from their upper edges. @param soft the second one, which its own weight
/// strains by several percent
std::shared_ptr<const ClothModel> hangingPair(const fabric::Material& stiff, const fabric::Material& soft) {
  const ClothMesh one = sheet(17);
  const int vertices = static_cast<int>(one.positions.size());
  ClothMesh both = one;
  std::vector<int> materialOf(one.triangles.size(), 0);
  for (const Vec3& position : one.positions) {
    both.positions.push_back(position + Vec3(2.0, 0.0, 0.0));
  }
  for (const Triangle& triangle : one.triangles) {
    both.triangles.push_back({triangle[0] + vertices, triangle[1] + vertices, triangle[2] + vertices});
    materialOf.push_back(1);
  }
  std::vector<int> pins;
  for (int i = 0; i < 17; ++i) {
    pins.push_back(i);
    pins.push_back(vertices + i);
  }
  const auto springs = buildClothModel(both, 0.2, MassLumping::Area, pins);
  return fabric::withFabric(*springs, fabric::TriangleMaterials({stiff, soft}, materialOf),
                            fabric::warpAlong(Vec3::UnitX(), springs->restPositions, springs->triangles));
}

fabric::Material wovenOf(double modulus) {
  fabric::Material material = woven();
  material.stretchWarp = material.stretchWeft = modulus;
  return material;
}

/// With a budget that is far too small for the full stiffness.
StepParameters smallCostBudget() {
  StepParameters parameters;
  parameters.timeStep = 1.0 / 60.0;
  parameters.automatic.costBudget = 0.2;
  parameters.automatic.strainLimit = 0.01;
  return parameters;
}

/// The state after some steps of auto, and the report of the last one.
std::pair<ClothState, StepReport> afterStepsOfAuto(const ClothModel& model, const StepParameters& parameters,
                                                   int steps) {
  Stepper stepper("auto");
  ClothState state = stateAtRest(model.restPositions);
  StepReport report;
  for (int i = 0; i < steps; ++i) {
    report = stepper.step(model, parameters, {}, state);
  }
  return {state, report};
}

TEST(StretchChoice, keepsTheFullStiffnessWithoutALimit) {
  StepParameters parameters = smallCostBudget();
  parameters.automatic.strainLimit = 0.0;
  EXPECT_EQ(afterStepsOfAuto(*hangingFabric(), parameters, 3).second.choice->stiffnessScale, 1.0);
}

TEST(StretchChoice, keepsTheFullStiffnessWithinTheBudget) {
  StepParameters parameters = smallCostBudget();
  parameters.automatic.costBudget = 1e5;
  EXPECT_EQ(afterStepsOfAuto(*hangingFabric(), parameters, 3).second.choice->stiffnessScale, 1.0);
}

TEST(StretchChoice, lowersTheStiffnessAndKeepsTheStrainBelowTheLimit) {
  const auto [state, report] = afterStepsOfAuto(*hangingFabric(), smallCostBudget(), 60);
  EXPECT_LT(report.choice->stiffnessScale, 0.3);
  EXPECT_LT(report.choice->strain, 0.01);
  EXPECT_GT(report.choice->fullStiffnessCost, 1.3);
}

TEST(StretchChoice, lowersTheStiffnessOfAStiffMaterialBesideOneThatIsStrainedBeyondTheLimit) {
  const auto model = hangingPair(wovenOf(6000.0), wovenOf(20.0));
  const auto [state, report] = afterStepsOfAuto(*model, smallCostBudget(), 60);
  const std::vector<double> strains = fabric::strainsAlongYarns(*model, state.positions);
  EXPECT_GT(strains[1], 0.02);
  EXPECT_LT(strains[0], 0.01);
  EXPECT_GT(stepMemoryOf(state).stretch[0].level, 4);
  EXPECT_EQ(stepMemoryOf(state).stretch[1].level, 0);
  EXPECT_LT(report.choice->stiffnessScale, 0.3);
  EXPECT_NEAR(report.choice->strain, strains[0], 0.005);
  EXPECT_EQ(report.choice->softestMaterial, 0);
}

TEST(StretchChoice, keepsTheStiffnessOfAMaterialThatDoesNotShortenTheSubsteps) {
  const auto model = hangingPair(wovenOf(60000.0), wovenOf(2000.0));
  const auto [state, report] = afterStepsOfAuto(*model, smallCostBudget(), 3);
  const std::vector<StretchMemory> materials = stepMemoryOf(state).stretch;
  EXPECT_GT(materials[0].level, 4);
  EXPECT_LT(StretchChoice::scaleOf(materials[0].level) * 60000.0,
            1.5 * StretchChoice::scaleOf(materials[1].level) * 2000.0);
  EXPECT_LT(materials[1].level, materials[0].level);
}

TEST(StretchChoice, lowersEqualMaterialsTogether) {
  const auto model = hangingPair(wovenOf(6000.0), wovenOf(6000.0));
  const std::vector<StretchMemory> materials =
      stepMemoryOf(afterStepsOfAuto(*model, smallCostBudget(), 3).first).stretch;
  EXPECT_GT(materials[0].level, 2);
  EXPECT_EQ(materials[0].level, materials[1].level);
}

TEST(StretchChoice, softensSmallTrianglesOnlyWithALimit) {
  ClothMesh mesh = sheet(31);
  mesh.positions[15 * 31 + 15] += 0.88 * (mesh.positions[1] - mesh.positions[0]);
  const auto model = asFabric(*buildClothModel(mesh, 0.1, MassLumping::Area, {0, 30}), woven());
  StepParameters parameters = smallCostBudget();
  parameters.automatic.costBudget = 1e5;
  const StepReport limited = afterStepsOfAuto(*model, parameters, 2).second;
  EXPECT_GT(limited.choice->softenedTriangles, 0);
  EXPECT_EQ(limited.choice->stiffnessScale, 1.0);
  EXPECT_GT(limited.choice->fullStiffnessCost, 1.05);
  parameters.automatic.strainLimit = 0.0;
  const StepReport full = afterStepsOfAuto(*model, parameters, 2).second;
  EXPECT_EQ(full.choice->softenedTriangles, 0);
  EXPECT_GT(full.choice->substeps, limited.choice->substeps);
}

/// The largest strain along the yarns at the ends of some steps.
double largestStrain(const ClothModel& model, const StepParameters& parameters, int steps, ClothState& state) {
  Stepper stepper("auto");
  double largest = 0.0;
  for (int i = 0; i < steps; ++i) {
    (void)stepper.step(model, parameters, {}, state);
    largest = std::max(largest, fabric::strainsAlongYarns(model, state.positions).front());
  }
  return largest;
}

TEST(StretchChoice, keepsTheStrainBelowTheLimitWhenTheWeightActsSuddenly) {
  const auto model = hangingFabric();
  ClothState state = stateAtRest(model->restPositions);
  EXPECT_LT(largestStrain(*model, smallCostBudget(), 60, state), 0.01);
  EXPECT_GT(stepMemoryOf(state).stretch.front().level, 2);
}

TEST(StretchChoice, raisesTheStiffnessBeforeAFastRiseOfTheLoadExceedsTheLimit) {
  const auto model = hangingFabric(0.002);
  StepParameters parameters = smallCostBudget();
  parameters.timeStep = 1.0 / 300.0;
  ClothState state = stateAtRest(model->restPositions);
  (void)largestStrain(*model, parameters, 300, state);
  parameters.gravity *= 3.0;
  EXPECT_LT(largestStrain(*model, parameters, 300, state), 0.015);
}

TEST(StretchChoice, lowersTheStiffnessAgainByTheStrainThatALoadLeaves) {
  const auto model = hangingFabric(0.002);
  StepParameters parameters = smallCostBudget();
  ClothState state = stateAtRest(model->restPositions);
  (void)largestStrain(*model, parameters, 60, state);
  const int before = stepMemoryOf(state).stretch.front().level;
  parameters.gravity *= 3.0;
  (void)largestStrain(*model, parameters, 30, state);
  ASSERT_LT(stepMemoryOf(state).stretch.front().level, before - 2);
  parameters.gravity /= 3.0;
  (void)largestStrain(*model, parameters, 300, state);
  EXPECT_GE(stepMemoryOf(state).stretch.front().level, before - 1);
}

TEST(StretchChoice, raisesTheStiffnessWithTheLoad) {
  const auto model = hangingFabric();
  StepParameters parameters = smallCostBudget();
  Stepper stepper("auto");
  ClothState state = stateAtRest(model->restPositions);
  for (int i = 0; i < 30; ++i) {
    (void)stepper.step(*model, parameters, {}, state);
  }
  const double before = stepMemoryOf(state).stretch.front().level;
  parameters.gravity *= 30.0;
  for (int i = 0; i < 30; ++i) {
    (void)stepper.step(*model, parameters, {}, state);
  }
  EXPECT_LT(stepMemoryOf(state).stretch.front().level, before);
}

TEST(StretchChoice, keepsTheStiffnessOfClothThatSleeps) {
  const auto model = hangingFabric();
  StepParameters parameters = smallCostBudget();
  parameters.automatic.costBudget = 1e5;
  parameters.air.drag = 1.0;
  parameters.gravity = 0.0;
  Stepper stepper("auto");
  ClothState state = stateAtRest(model->restPositions);
  bool sleeps = false;
  for (int i = 0; i < 120 && !sleeps; ++i) {
    sleeps = stepper.step(*model, parameters, {}, state).choice->sleeping;
  }
  ASSERT_TRUE(sleeps);
  parameters.automatic.costBudget = 0.2;  // moving cloth would become softer
  for (int i = 0; i < 120; ++i) {
    const StepReport report = stepper.step(*model, parameters, {}, state);
    EXPECT_TRUE(report.choice->sleeping);
    EXPECT_EQ(report.choice->stiffnessScale, 1.0);
  }
}

TEST(StretchChoice, continuesEquallyFromACopyOfTheState) {
  const auto model = hangingFabric();
  const StepParameters parameters = smallCostBudget();
  auto [state, report] = afterStepsOfAuto(*model, parameters, 10);
  ClothState copy = state;
  Stepper one("auto");
  Stepper other("auto");
  for (int i = 0; i < 10; ++i) {
    (void)one.step(*model, parameters, {}, state);
  }
  for (int i = 0; i < 10; ++i) {
    (void)other.step(*model, parameters, {}, copy);
  }
  EXPECT_EQ(stateHash(state), stateHash(copy));
}

}  // namespace
}  // namespace drape::sim::adaptive
