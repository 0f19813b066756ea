#include "session/change_history.hpp"

#include "session/simulation.hpp"
#include "test_scene.hpp"

#include <gtest/gtest.h>

namespace drape::session {
namespace {

/// A small cloth and its history, with a clock that the test moves.
class History : public ::testing::Test {
 protected:
  History() : simulation_(testing::smallGrid()) { look(); }

  /// Shows the present state to the history and applies what it asks for.
  void look(bool settled = true) {
    now_ += 1.0;
    const UserState present = state();
    if (const auto missed = history_.observe(present, settled, now_)) {
      apply(present, *missed);
    }
  }
  UserState state() {
    simulation_.capture(snapshot_);
    return userStateOf(snapshot_);
  }
  void set(const std::string& key, const settings::SettingValue& value) {
    simulation_.apply(SetSettingCommand{key, value});
  }
  void apply(const UserState& from, const UserState& to) {
    for (const Command& command : commandsBetween(from, to, simulation_.scene())) {
      simulation_.apply(command);
    }
  }
  bool undo() {
    const auto step = history_.undo(state(), now_);
    if (step) {
      apply(step->after, step->before);
      look();
    }
    return step.has_value();
  }
  bool redo() {
    const auto step = history_.redo(state(), now_);
    if (step) {
      apply(step->before, step->after);
      look();
    }
    return step.has_value();
  }

  Simulation simulation_;
  Snapshot snapshot_;
  ChangeHistory history_;
  double now_ = 0.0;
};

TEST_F(History, UndoesAndRedoesEachSettledChange) {
  set("drag", 0.5);
  look();
  set("stiffness", 300.0);
  look();
  EXPECT_TRUE(undo());
  EXPECT_EQ(simulation_.settings().step.air.drag, 0.5);
  EXPECT_NE(simulation_.settings().step.material.stiffness, 300.0);
  EXPECT_TRUE(undo());
  EXPECT_EQ(simulation_.settings().step.air.drag, 0.0);
  EXPECT_FALSE(undo()) << "there is nothing left";
  EXPECT_TRUE(redo());
  EXPECT_TRUE(redo());
  EXPECT_EQ(simulation_.settings().step.air.drag, 0.5);
  EXPECT_EQ(simulation_.settings().step.material.stiffness, 300.0);
  EXPECT_FALSE(redo());
}

TEST_F(History, MakesOneStepOfADrag) {
  for (const double value : {0.1, 0.2, 0.3}) {
    set("drag", value);
    look(false);
  }
  look();
  EXPECT_EQ(history_.undoCount(), 1U);
  EXPECT_TRUE(undo());
  EXPECT_EQ(simulation_.settings().step.air.drag, 0.0);
}

TEST_F(History, UndoesAChangeThatIsNotSettledYet) {
  set("drag", 0.1);
  look(false);
  EXPECT_TRUE(undo());
  EXPECT_EQ(simulation_.settings().step.air.drag, 0.0);
}

TEST_F(History, ForgetsWhatWasUndoneAfterAnotherChange) {
  set("drag", 0.5);
  look();
  ASSERT_TRUE(undo());
  set("lift", 0.25);
  look();
  EXPECT_FALSE(redo());
  EXPECT_TRUE(undo());
  EXPECT_EQ(simulation_.settings().step.air.lift, 0.0);
}

TEST_F(History, KeepsABoundedNumberOfSteps) {
  for (std::size_t i = 1; i <= ChangeHistory::capacity + 5; ++i) {
    set("drag", 0.01 * static_cast<double>(i));
    look();
  }
  EXPECT_EQ(history_.undoCount(), ChangeHistory::capacity);
}

TEST_F(History, BringsAReleasedPinBackToItsPlace) {
  simulation_.capture(snapshot_);
  const Vec3 place = snapshot_.positions[0];
  ASSERT_TRUE(snapshot_.model->pinned[0]) << "a corner of the grid is pinned";
  std::vector<int> others;
  const auto pins = pinsOf(snapshot_);
  for (const PinPlace& pin : *pins) {
    if (pin.vertex != 0) {
      others.push_back(pin.vertex);
    }
  }
  simulation_.apply(SetPinsCommand{others});
  look();
  for (int i = 0; i < 20; ++i) {
    simulation_.step();
  }
  ASSERT_GT((simulation_.state().positions[0] - place).norm(), 1e-4) << "it falls";
  EXPECT_TRUE(undo());
  EXPECT_TRUE(simulation_.model().pinned[0]);
  EXPECT_EQ(simulation_.state().positions[0], place);
  simulation_.step();
  EXPECT_EQ(simulation_.state().positions[0], place);
  EXPECT_TRUE(redo());
  EXPECT_FALSE(simulation_.model().pinned[0]);
}

TEST_F(History, RestoresBodies) {
  ASSERT_FALSE(simulation_.bodies().bodies().empty());
  const auto surface = simulation_.bodies().surface(0);
  auto other = surface;
  other.staticFriction = 0.9;
  simulation_.apply(SwitchBodyCommand{0, false});
  simulation_.apply(SetSurfaceCommand{0, other});
  simulation_.apply(MoveBodyCommand{0, Vec3(0.0, 0.0, 0.5)});
  look();
  EXPECT_EQ(history_.undoCount(), 1U);
  EXPECT_TRUE(undo());
  EXPECT_TRUE(simulation_.bodies().isOn(0));
  EXPECT_EQ(simulation_.bodies().surface(0), surface);
  EXPECT_EQ(simulation_.bodies().targetShift(0), Vec3(Vec3::Zero()));
}

TEST_F(History, SendsChangesAgainWhenTheyDoNotArrive) {
  set("drag", 0.5);
  look();
  const auto step = history_.undo(state(), now_);
  ASSERT_TRUE(step.has_value());
  // The commands are lost, as when a scene is built meanwhile.
  look();
  EXPECT_EQ(simulation_.settings().step.air.drag, 0.0) << "the second attempt";
  EXPECT_EQ(history_.redoCount(), 1U);
}

TEST_F(History, LeavesTheUserAloneWhoChangesSomethingMeanwhile) {
  set("drag", 0.5);
  look();
  ASSERT_TRUE(history_.undo(state(), now_).has_value());
  history_.stopWaiting();
  set("drag", 0.7);
  look();
  look();
  EXPECT_EQ(simulation_.settings().step.air.drag, 0.7);
}

TEST_F(History, IgnoresTheCostBudgetThatFollowsTheClock) {
  set("auto.budget", 4.0);
  look();
  const std::size_t count = history_.undoCount();
  simulation_.apply(SetCostBudgetCommand{123.0});
  look();
  EXPECT_EQ(history_.undoCount(), count);
}

TEST_F(History, RestoresAFabricAsAWhole) {
  set("solver", std::string("auto"));
  set("material.model", std::string("fabric"));
  set("material.preset", std::string("denim"));
  look();
  set("material.preset", std::string("silk"));
  look();
  EXPECT_TRUE(undo());
  EXPECT_EQ(settings::settingValue(simulation_.settings(), settings::requireSetting("material.preset")),
            settings::SettingValue(std::string("denim")));
}

TEST_F(History, KnowsNothingOfThePreviousScene) {
  set("drag", 0.5);
  look();
  history_.forget();
  look();
  EXPECT_FALSE(undo());
}

TEST(PinCommands, RefuseVerticesThatDoNotExist) {
  Simulation simulation(testing::smallGrid());
  const auto pinned = simulation.model().pinned;
  simulation.apply(SetPinsCommand{{0, 100000}});
  EXPECT_NE(simulation.message().english().find("100000"), std::string::npos) << simulation.message();
  EXPECT_EQ(simulation.model().pinned, pinned);
}

TEST(PinCommands, PlaceOnlyPinnedVertices) {
  Simulation simulation(testing::smallGrid());
  simulation.apply(SetPinsCommand{{0}});
  const Vec3 before = simulation.state().positions[5];
  simulation.apply(PlacePinsCommand{{5}, {Vec3(1.0, 2.0, 3.0)}});
  EXPECT_FALSE(simulation.message().empty());
  EXPECT_EQ(simulation.state().positions[5], before);
  simulation.apply(PlacePinsCommand{{0}, {Vec3(1.0, 2.0, 3.0)}});
  EXPECT_EQ(simulation.state().positions[0], Vec3(1.0, 2.0, 3.0));
}

TEST_F(History, UndoesAnotherFabricWithTheFrictionThatTheUserHadChosen) {
  set("material.model", std::string("fabric"));
  set("material.preset", std::string("denim"));
  set("self_friction", 0.25);
  look();
  set("material.preset", std::string("silk"));
  look();
  ASSERT_TRUE(undo());
  EXPECT_EQ(simulation_.settings().fabric.preset, "denim");
  EXPECT_DOUBLE_EQ(simulation_.settings().step.contact.kineticFriction, 0.25);
}

}  // namespace
}  // namespace drape::session
