#include "sim/step_choice.hpp"

#include <gtest/gtest.h>

namespace drape {
namespace {

TEST(StepChoice, isWrittenAsText) {
  const StepChoice choice{.substeps = 12, .forceEvaluations = 12, .hOmega = 20.0, .error = 2.04e-4};
  EXPECT_EQ(inWords(choice, 0.0004, 0.016), "stiff cloth: 12 explicit substeps, 0.4 ms of 16 ms, error about 0.2 mm");
}

TEST(StepChoice, tellsTheStiffnessScaleAndTheLevels) {
  const StepChoice choice{.substeps = 17, .hOmega = 622.0, .stiffnessScale = 0.00243, .coarseLevels = 4, .retries = 1};
  EXPECT_EQ(inWords(choice),
            "very stiff cloth: 17 explicit substeps at 0.24 % of the stiffness with 4 coarse levels, 1 retry");
}

TEST(StepChoice, tellsTheFourthOrderAndTheFallbackSolver) {
  EXPECT_EQ(inWords({.order = 4, .substeps = 1, .hOmega = 1.0, .error = 3e-8}),
            "soft cloth: 1 explicit substep of fourth order, error about 30 nm");
  EXPECT_EQ(inWords({.order = 1, .substeps = 4, .hOmega = 1.0, .retries = 4, .usedFallback = true}),
            "soft cloth: 4 substeps of XPBD, 4 retries");
}

TEST(StepChoice, tellsSlowMotionAndSleep) {
  EXPECT_EQ(inWords({.substeps = 305, .hOmega = 622.0, .costRatio = 17.9}, 0.3, 0.0067),
            "very stiff cloth: 305 explicit substeps, 18 times the cost budget: slow motion, 300 ms of 6.7 ms");
  EXPECT_EQ(inWords({.substeps = 305, .hOmega = 622.0, .costRatio = 17.9}, 0.003, 0.0067),
            "very stiff cloth: 305 explicit substeps, 18 times the cost budget, 3 ms of 6.7 ms");
  EXPECT_EQ(inWords({.substeps = 30, .hOmega = 62.0, .costRatio = 1.5}), "stiff cloth: 30 explicit substeps");
  EXPECT_EQ(inWords({.substeps = 0, .forceEvaluations = 0, .sleeping = true}),
            "at rest: nothing is computed until something changes");
}

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
}  // namespace drape
