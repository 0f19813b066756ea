#include "messages/step_choice_text.hpp"

#include <gtest/gtest.h>

namespace drape::messages {
namespace {

TEST(StepChoiceText, isWrittenAsText) {
  const sim::adaptive::StepChoice choice{.substeps = 12, .forceEvaluations = 12, .hOmega = 20.0, .error = 2.04e-4};
  EXPECT_EQ(inWords(choice, {}, 0.0004, 0.016), "stiff cloth: 12 explicit substeps, 0.4 ms of 16 ms");
}

TEST(StepChoiceText, tellsTheStiffnessScaleAndTheLevels) {
  const sim::adaptive::StepChoice choice{
      .substeps = 17, .hOmega = 622.0, .stiffnessScale = 0.00243, .coarseLevels = 4, .retries = 1};
  EXPECT_EQ(inWords(choice, {}),
            "very stiff cloth: 17 explicit substeps at 0.24 % of the stiffness with 4 coarse levels, 1 retry");
}

TEST(StepChoiceText, tellsTheFourthOrderAndTheFallbackSolver) {
  EXPECT_EQ(inWords({.order = 4, .substeps = 1, .hOmega = 1.0, .error = 3e-8}, {}),
            "soft cloth: 1 explicit substep of fourth order");
  EXPECT_EQ(inWords({.order = 1, .substeps = 8, .hOmega = 200.0}, {}),
            "very stiff cloth: 8 implicit substeps for taut cloth");
  EXPECT_EQ(inWords({.order = 1, .substeps = 4, .hOmega = 1.0, .retries = 4, .usedFallback = true}, {}),
            "soft cloth: 4 substeps of the fallback solver, 4 retries");
}

TEST(StepChoiceText, tellsTheStretchStiffnessOfTheFabricAndHowFastTheFullOneRuns) {
  const sim::adaptive::StepChoice choice{.substeps = 60,
                                         .hOmega = 100.0,
                                         .costRatio = 0.5,
                                         .stiffnessScale = 0.08,
                                         .strain = 0.004,
                                         .fullStiffnessCost = 4.0};
  const text::Sentence cotton("Cotton");
  EXPECT_EQ(inWords(choice, cotton),
            "very stiff cloth: 60 explicit substeps at 8 % of the stretch stiffness of Cotton: 0.4 % strain; full "
            "stiffness costs 2 "
            "times the budget")
      << "no time was measured";
  EXPECT_EQ(
      inWords(choice, cotton, 0.001, 0.016),
      "very stiff cloth: 60 explicit substeps at 8 % of the stretch stiffness of Cotton: 0.4 % strain, 1 ms of 16 ms");
  EXPECT_EQ(inWords(choice, cotton, 0.016, 0.016),
            "very stiff cloth: 60 explicit substeps at 8 % of the stretch stiffness of Cotton: 0.4 % strain; full "
            "stiffness runs at "
            "0.25x, 16 ms of 16 ms");
}

TEST(StepChoiceText, tellsThatSmallTrianglesAreSoftened) {
  EXPECT_EQ(inWords({.substeps = 60, .hOmega = 100.0, .costRatio = 0.5, .softenedTriangles = 14}, {}),
            "very stiff cloth: 60 explicit substeps with 14 small triangles softened");
  EXPECT_EQ(inWords({.substeps = 60, .hOmega = 100.0, .stiffnessScale = 0.5, .strain = 0.004, .softenedTriangles = 1},
                    text::Sentence("Cotton")),
            "very stiff cloth: 60 explicit substeps at 50 % of the stretch stiffness of Cotton: 0.4 % strain, 1 small "
            "triangle "
            "softened");
}

TEST(StepChoiceText, tellsSlowMotionAndSleep) {
  EXPECT_EQ(inWords({.substeps = 305, .hOmega = 622.0, .costRatio = 17.9}, {}, 0.3, 0.0067),
            "very stiff cloth: 305 explicit substeps, 18 times the cost budget: slow motion, 300 ms of 6.7 ms");
  EXPECT_EQ(inWords({.substeps = 305, .hOmega = 622.0, .costRatio = 17.9}, {}, 0.003, 0.0067),
            "very stiff cloth: 305 explicit substeps, 18 times the cost budget, 3 ms of 6.7 ms");
  EXPECT_EQ(inWords({.substeps = 30, .hOmega = 62.0, .costRatio = 1.5}, {}), "stiff cloth: 30 explicit substeps");
  EXPECT_EQ(inWords({.substeps = 0, .forceEvaluations = 0, .sleeping = true}, {}),
            "at rest: nothing is computed until something changes");
}

}  // namespace
}  // namespace drape::messages
