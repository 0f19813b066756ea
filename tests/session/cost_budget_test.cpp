#include "session/cost_budget.hpp"

#include "session/simulation.hpp"
#include "test_scene.hpp"

#include <gtest/gtest.h>

namespace drape::session {
namespace {

constexpr double nanosecond = 1e-9;

sim::StepReport withForceEvaluations(int count) {
  sim::StepReport report;
  report.choice = sim::adaptive::StepChoice{.forceEvaluations = count};
  return report;
}

class Budgeting : public ::testing::Test {
 protected:
  /// The duration of ten force evaluations at this time per spring evaluation [s].
  [[nodiscard]] double tenForceEvaluations(double evaluation) const {
    return 10.0 * static_cast<double>(scene_->model->springs.size()) * evaluation;
  }

  std::shared_ptr<const scene::Scene> scene_ = testing::smallGrid();
  settings::Settings settings_ = scene_->settings;
  CostBudget budget_;
};

TEST_F(Budgeting, allowsTheWorkThatTheTimePaysFor) {
  settings_.automatic.budget = 2.0;
  const auto budget =
      budget_.budgetAfter(settings_, *scene_->model, withForceEvaluations(10), tenForceEvaluations(4.0 * nanosecond));
  ASSERT_TRUE(budget);
  EXPECT_NEAR(*budget, 30.0, 0.5);  // 2 ms in 1/60 s at 4 ns per evaluation: 500,000 in 1/60 s, 30 million in a second
}

TEST_F(Budgeting, takesContactForSomethingElse) {
  settings_.automatic.budget = 2.0;
  sim::StepReport report = withForceEvaluations(10);
  report.contact.bodySeconds = 0.001;
  report.contact.selfSeconds = 0.002;
  report.substepContactSeconds = 0.004;
  const auto budget =
      budget_.budgetAfter(settings_, *scene_->model, report, 0.007 + tenForceEvaluations(4.0 * nanosecond));
  ASSERT_TRUE(budget);
  EXPECT_NEAR(*budget, 30.0, 0.5);
}

TEST_F(Budgeting, leavesSmallDifferencesSingleHiccupsAndOtherSolversAlone) {
  settings_.automatic.budget = 2.0;
  const double seconds = tenForceEvaluations(4.0 * nanosecond);
  settings_.step.automatic.costBudget =
      budget_.budgetAfter(settings_, *scene_->model, withForceEvaluations(10), seconds).value();
  EXPECT_FALSE(budget_.budgetAfter(settings_, *scene_->model, withForceEvaluations(10), 1.1 * seconds));
  EXPECT_FALSE(budget_.budgetAfter(settings_, *scene_->model, withForceEvaluations(10), 1000.0 * seconds));
  EXPECT_FALSE(CostBudget().budgetAfter(settings_, *scene_->model, sim::StepReport(), 100.0 * seconds));
  settings_.automatic.budget = 0.0;
  EXPECT_FALSE(CostBudget().budgetAfter(settings_, *scene_->model, withForceEvaluations(10), 100.0 * seconds));
}

TEST_F(Budgeting, followsAMachineThatBecomesSlower) {
  settings_.automatic.budget = 2.0;
  settings_.step.automatic.costBudget = 30.0;
  for (int step = 0; step < 100; ++step) {
    const double cost = (step < 20 ? 4.0 : 12.0) * nanosecond;
    settings_.step.automatic.costBudget =
        budget_.budgetAfter(settings_, *scene_->model, withForceEvaluations(10), tenForceEvaluations(cost))
            .value_or(settings_.step.automatic.costBudget);
  }
  EXPECT_NEAR(settings_.step.automatic.costBudget, 10.0, 2.5);
}

/// Sets a cost budget that no machine can afford, with a short time budget, so that the cost budget must change.
void hurry(Simulation& simulation) {
  simulation.apply(SetSettingCommand{"solver", std::string("auto")});
  simulation.apply(SetSettingCommand{"stiffness", 1e4});
  simulation.apply(SetSettingCommand{"auto.tolerance", 1e-9});
  simulation.apply(SetSettingCommand{"auto.cost", 1e4});
  simulation.apply(SetSettingCommand{"auto.budget", 0.01});
}

TEST_F(Budgeting, isLoggedSoThatAReplayTakesTheSameSteps) {
  Simulation simulation(scene_);
  hurry(simulation);
  for (int step = 0; step < 20; ++step) {
    simulation.step();
  }
  simulation.apply(SingleStepCommand{});
  simulation.apply(PauseCommand{});  // so that the log contains all steps
  EXPECT_GT(simulation.log().size(), 7U) << "the cost budget changed";
  EXPECT_LT(simulation.settings().step.automatic.costBudget, 1e4);
  Simulation again(scene_);
  again.replay(simulation.log());
  EXPECT_EQ(again.log().size(), simulation.log().size()) << "a replay adds nothing of its own";
  EXPECT_EQ(again.stepsTaken(), 21);
  EXPECT_EQ(sim::stateHash(again.state()), sim::stateHash(simulation.state()));
}

TEST_F(Budgeting, readsNoClockWhenItIsOff) {
  Simulation simulation(scene_);
  hurry(simulation);
  simulation.apply(SetSettingCommand{"auto.budget", 0.0});
  const std::size_t commands = simulation.log().size();
  for (int step = 0; step < 20; ++step) {
    simulation.step();
  }
  EXPECT_EQ(simulation.log().size(), commands);
  EXPECT_EQ(simulation.settings().step.automatic.costBudget, 1e4);
}

}  // namespace
}  // namespace drape::session
