#include "sim/adaptive/step_choice.hpp"

#include <gtest/gtest.h>

namespace drape::sim::adaptive {
namespace {

TEST(StepChoice, hasItsMembersByName) {
  const auto figures = figuresOf({.substeps = 12, .usedFallback = true, .energyDrift = 0.25});
  const auto value = [&](std::string_view wanted) {
    for (const auto& [name, figure] : figures) {
      if (name == wanted) {
        return figure;
      }
    }
    ADD_FAILURE() << "there is no " << wanted;
    return 0.0;
  };
  EXPECT_EQ(value("substeps"), 12.0);
  EXPECT_EQ(value("used_fallback"), 1.0);
  EXPECT_EQ(value("energy_drift"), 0.25);
  EXPECT_EQ(value("stiffness_scale"), 1.0);
  EXPECT_EQ(value("sleeping"), 0.0);
  EXPECT_EQ(value("cost_ratio"), 0.0);
}

TEST(StepChoice, ofSeveralStepsAddsTheirSubstepsAndKeepsTheWorstStiffness) {
  StepChoice choice{.substeps = 3,
                    .forceEvaluations = 12,
                    .hOmega = 1.0,
                    .costRatio = 2.0,
                    .stiffnessScale = 0.5,
                    .retries = 1,
                    .sleeping = true};
  choice.add({.substeps = 5, .forceEvaluations = 5, .hOmega = 2.0, .stiffnessScale = 1.0, .error = 0.1});
  EXPECT_EQ(choice.substeps, 8);
  EXPECT_EQ(choice.forceEvaluations, 17);
  EXPECT_EQ(choice.retries, 1);
  EXPECT_DOUBLE_EQ(choice.hOmega, 3.0);
  EXPECT_DOUBLE_EQ(choice.stiffnessScale, 0.5);
  EXPECT_DOUBLE_EQ(choice.error, 0.1);
  EXPECT_DOUBLE_EQ(choice.costRatio, 2.0);
  EXPECT_FALSE(choice.sleeping);
}

}  // namespace
}  // namespace drape::sim::adaptive
