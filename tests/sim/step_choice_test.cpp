#include "sim/step_choice.hpp"

#include <gtest/gtest.h>

namespace drape {
namespace {

TEST(StepChoice, isToldInASentence) {
  const StepChoice choice{.substeps = 12, .passes = 12, .hardness = 20.0, .error = 2.04e-4};
  EXPECT_EQ(inWords(choice, 0.0004, 0.016), "stiff cloth: 12 explicit substeps, 0.4 ms of 16 ms, error about 0.2 mm");
}

TEST(StepChoice, tellsWhatSpringsKeepAndWhoCarriesTheRest) {
  const StepChoice choice{.substeps = 17, .hardness = 622.0, .stiffness = 0.00243, .levels = 4, .retaken = 1};
  EXPECT_EQ(inWords(choice),
            "very stiff cloth: 17 explicit substeps at 0.24 % of the stiffness with 4 coarse levels, taken again once");
}

TEST(StepChoice, namesTheFourthOrderAndTheLastResort) {
  EXPECT_EQ(inWords({.order = 4, .substeps = 1, .hardness = 1.0, .error = 3e-8}),
            "soft cloth: 1 explicit substep of fourth order, error about 30 nm");
  EXPECT_EQ(inWords({.order = 1, .substeps = 4, .hardness = 1.0, .retaken = 4, .lastResort = true}),
            "soft cloth: 4 substeps of XPBD, taken again 4 times");
}

TEST(StepChoice, saysThatTheClockFallsBehindAndThatThereIsNothingToDo) {
  EXPECT_EQ(inWords({.substeps = 305, .hardness = 622.0, .demand = 17.9}, 0.3, 0.0067),
            "very stiff cloth: 305 explicit substeps, 18 times the work allowed: slow motion, 300 ms of 6.7 ms");
  EXPECT_EQ(inWords({.substeps = 305, .hardness = 622.0, .demand = 17.9}, 0.003, 0.0067),
            "very stiff cloth: 305 explicit substeps, 18 times the work allowed, 3 ms of 6.7 ms");
  EXPECT_EQ(inWords({.substeps = 30, .hardness = 62.0, .demand = 1.5}), "stiff cloth: 30 explicit substeps");
  EXPECT_EQ(inWords({.substeps = 0, .passes = 0, .resting = true}), "at rest: nothing to do until something changes");
}

TEST(StepChoice, isToldInFiguresByName) {
  const auto figures = figuresOf({.substeps = 12, .lastResort = true, .gained = 0.25});
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
  EXPECT_EQ(value("last_resort"), 1.0);
  EXPECT_EQ(value("gained"), 0.25);
  EXPECT_EQ(value("stiffness"), 1.0);
  EXPECT_EQ(value("resting"), 0.0);
  EXPECT_EQ(value("demand"), 0.0);
}

TEST(StepChoice, ofSeveralStepsAddsTheirSubstepsAndKeepsTheWorstStiffness) {
  StepChoice choice{
      .substeps = 3, .passes = 12, .hardness = 1.0, .demand = 2.0, .stiffness = 0.5, .retaken = 1, .resting = true};
  choice.add({.substeps = 5, .passes = 5, .hardness = 2.0, .stiffness = 1.0, .error = 0.1});
  EXPECT_EQ(choice.substeps, 8);
  EXPECT_EQ(choice.passes, 17);
  EXPECT_EQ(choice.retaken, 1);
  EXPECT_DOUBLE_EQ(choice.hardness, 3.0);
  EXPECT_DOUBLE_EQ(choice.stiffness, 0.5);
  EXPECT_DOUBLE_EQ(choice.error, 0.1);
  EXPECT_DOUBLE_EQ(choice.demand, 2.0);
  EXPECT_FALSE(choice.resting);
}

}  // namespace
}  // namespace drape
