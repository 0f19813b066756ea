#include "ui/pin_keys.hpp"
#include "panel_fixture.hpp"
#include "session/simulation.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace drape::ui {
namespace {

using sim::contact::Keyframe;

/// The built-in grid at a small size, and its snapshot.
class PinKeys : public ::testing::Test {
 protected:
  PinKeys() : simulation_(scene()) { simulation_.capture(snapshot_); }

  void apply(const session::Command& command) {
    simulation_.apply(command);
    simulation_.capture(snapshot_);
  }

  void step(int steps) {
    for (int i = 0; i < steps; ++i) {
      simulation_.step();
    }
    simulation_.capture(snapshot_);
  }

  [[nodiscard]] Vec3 displacement(int vertex) const {
    return snapshot_.positions[vertex] - snapshot_.scene->start.positions[vertex];
  }

  static std::shared_ptr<const scene::Scene> scene() {
    scene::SceneDescription description = scene::openScene("grid");
    settings::assignSettingExpression(description.settings, "grid.resolution=5");
    settings::assignSettingExpression(description.settings, "time_step=1/100");
    return scene::buildScene(description, description.settings);
  }

  session::Simulation simulation_;
  session::Snapshot snapshot_;
};

TEST_F(PinKeys, ThatAreAddedLeadBackToWhereThePinsWere) {
  apply(session::SetPinsCommand{{0, 4}});
  step(50);
  const Vec3 up(0.05, 0.2, -0.1);
  apply(session::PlacePinsCommand{{0, 4}, {snapshot_.positions[0] + up, snapshot_.positions[4] + up}});
  const std::vector<int> pins{0, 4};
  apply(withKeyframeHere(snapshot_, pins));
  EXPECT_NEAR((displacement(0) - up).norm(), 0.0, 1e-12) << "the pins stay";
  const auto* motion = commonMotion(snapshot_, pins);
  ASSERT_NE(motion, nullptr);
  ASSERT_EQ(motion->keyframes.size(), 2U) << "one at the start, one here";
  EXPECT_NEAR(motion->keyframes[1].time, 0.5, 1e-12);
  apply(session::ResetCommand{});
  EXPECT_NEAR(displacement(4).norm(), 0.0, 1e-12);
  step(50);
  EXPECT_NEAR((displacement(0) - up).norm(), 0.0, 1e-12);
  EXPECT_NEAR((displacement(4) - up).norm(), 0.0, 1e-12);
}

TEST_F(PinKeys, AtOneTimeReplaceEachOther) {
  apply(session::SetPinsCommand{{0}});
  const std::vector<int> pins{0};
  step(10);
  apply(withKeyframeHere(snapshot_, pins));
  apply(session::PlacePinsCommand{{0}, {snapshot_.positions[0] + Vec3(0.0, 0.1, 0.0)}});
  apply(withKeyframeHere(snapshot_, pins));
  const auto* motion = commonMotion(snapshot_, pins);
  ASSERT_NE(motion, nullptr);
  ASSERT_EQ(motion->keyframes.size(), 2U);
  EXPECT_NEAR((motion->keyframes[1].position - Vec3(0.0, 0.1, 0.0)).norm(), 0.0, 1e-12);
}

TEST_F(PinKeys, OfSomePinsLeaveTheOthersTheirPath) {
  apply(session::SetPinsCommand{{0, 2, 4}});
  sim::contact::BodyMotion motion;
  motion.keyframes = {{0.0, Vec3::Zero(), Vec3::Zero()}, {1.0, Vec3(0.0, 0.3, 0.0), Vec3::Zero()}};
  const std::vector<int> all{0, 2, 4};
  apply(withMotion(snapshot_, all, motion));
  const std::vector<int> some{0, 2};
  sim::contact::BodyMotion other = motion;
  other.keyframes[1].position.y() = 0.1;
  apply(withMotion(snapshot_, some, other));
  EXPECT_EQ(commonMotion(snapshot_, all), nullptr);
  ASSERT_NE(commonMotion(snapshot_, some), nullptr);
  EXPECT_EQ(*commonMotion(snapshot_, some), other);
  ASSERT_NE(commonMotion(snapshot_, std::vector<int>{4}), nullptr);
  EXPECT_EQ(*commonMotion(snapshot_, std::vector<int>{4}), motion);
  apply(withMotion(snapshot_, all, {}));
  EXPECT_TRUE(snapshot_.pinPaths->empty());
}

/// The box of selected vertices, with two corners of the grid selected.
class PinKeyRows : public PanelFixture {
 protected:
  PinKeyRows() {
    apply({{session::PauseCommand{true}, session::SetPinsCommand{{0, 4}}}, {}, {}});
    stats_.selection.mode = SelectionMode::Rectangle;
    stats_.selection.vertices = {0, 4};
    stats_.selection.points = {Vec2(500.0, 300.0), Vec2(600.0, 300.0)};
    stats_.selection.pinned = 2;
    settle();
  }
};

TEST_F(PinKeyRows, AddChangeAndRemoveKeyframes) {
  for (int i = 0; i < 20; ++i) {
    simulation_.step();
  }
  settle();
  apply(click(button("button.add_key")));
  settle();
  ASSERT_EQ(snapshot_.pinPaths->size(), 1U);
  EXPECT_EQ(snapshot_.pinPaths->front().vertices, (std::vector<int>{0, 4}));
  ASSERT_EQ(snapshot_.pinPaths->front().motion.keyframes.size(), 2U);
  const UiOutput dragged = drag(button("keys.move"), 0.45, 0.55);
  ASSERT_FALSE(dragged.commands.empty());
  apply(dragged);
  settle();
  EXPECT_GT(snapshot_.pinPaths->front().motion.keyframes[1].position.norm(), 0.0);
  apply(click(button("keys.loop"), 0.1));
  settle();
  EXPECT_TRUE(snapshot_.pinPaths->front().motion.loop);
  apply(click(button("button.key.0")));
  settle();
  apply(click(button("button.remove_key")));
  settle();
  ASSERT_EQ(snapshot_.pinPaths->front().motion.keyframes.size(), 1U);
  EXPECT_FALSE(snapshot_.pinPaths->front().motion.loop);
  apply(click(button("button.remove_keys")));
  settle();
  EXPECT_TRUE(snapshot_.pinPaths->empty());
}

TEST_F(PinKeyRows, ATypedNumberBeyondItsRangeBecomesTheNearestAndAHintSaysSo) {
  for (int i = 0; i < 20; ++i) {
    simulation_.step();
  }
  settle();
  apply(click(button("button.add_key")));
  settle();
  const UiRect row = button("keys.move");
  UiOutput typed = typeInto({row.x, row.y, row.width / 3.0, row.height}, "5000");
  append(typed, frame());
  EXPECT_EQ(typed.hint, "Move must be a number from -1000 to 1000, so 5000 became 1000");
  apply(typed);
  settle();
  EXPECT_EQ(snapshot_.pinPaths->front().motion.keyframes[1].position.x(), 1000.0);
}

TEST_F(PinKeyRows, AreHiddenWithoutPins) {
  apply({{session::SetPinsCommand{}}, {}, {}});
  stats_.selection.pinned = 0;
  settle();
  EXPECT_FALSE(panels_.buttons().contains("button.add_key"));
}

}  // namespace
}  // namespace drape::ui
