// The mode Sew: what clicks pick, what it asks for, and what the picture shows.
#include "ui/sewing_mode.hpp"

#include "scene/scene_file.hpp"
#include "session/simulation.hpp"
#include "ui/interaction_controller.hpp"
#include "ui/undo.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <variant>

namespace drape::ui {
namespace {

using Ask = SewingRequest::Kind;

/// Two sheets of 5 x 5 vertices side by side, seen from the front, controlled by mouse and keyboard.
class SewingInWindow : public ::testing::Test {
 protected:
  SewingInWindow() : simulation_(sheets()) {
    controller_.setView(view_);
    capture();
    controller_.lookFrom(render::Camera::Side::Front, snapshot_);
    controller_.frameCloth(snapshot_);
  }

  static std::shared_ptr<const scene::Scene> sheets() {
    const auto description = scene::parseScene(R"(
[[cloths]]
name = "left"
grid = "vertical"
position = [-0.3, 1, 0]

[[cloths]]
name = "right"
grid = "vertical"
position = [0.3, 1, 0]

[settings]
grid.resolution = 5
grid.width = 0.4
grid.height = 0.4
)",
                                               "test", "test.toml", std::filesystem::current_path());
    return scene::buildScene(description, description.settings);
  }

  void capture() { simulation_.capture(snapshot_); }

  [[nodiscard]] Vec2 inWindow(int vertex) const {
    return GizmoPicture(controller_.camera(), view_).toWindow(snapshot_.positions[vertex]);
  }

  UiOutput send(const InputEvent& event) {
    UiOutput output;
    controller_.handle(event, snapshot_, output);
    return output;
  }

  UiOutput ask(SewingRequest request) {
    UiOutput output;
    controller_.sewing().on(request, snapshot_, output);
    return output;
  }

  void clickAt(const Vec2& place, bool shift = false) {
    send(MoveEvent{place});
    send(PressEvent{.position = place, .shift = shift});
    send(ReleaseEvent{});
  }
  void clickOn(int vertex, bool shift = false) { clickAt(inWindow(vertex), shift); }

  SewingView view() { return controller_.sewingView(snapshot_).value(); }

  void apply(const UiOutput& output) {
    for (const session::Command& command : output.commands) {
      simulation_.apply(command);
    }
    capture();
  }

  // The middle of the right border of the left sheet, and of the left border of the right one.
  static constexpr int innerLeft = 14;
  static constexpr int innerRight = 25 + 10;

  const UiRect view_{372.0, 0.0, 900.0, 690.0};
  session::Simulation simulation_;
  session::Snapshot snapshot_;
  InteractionController controller_;
};

TEST_F(SewingInWindow, SStartsTheModeAndEscapeLeavesIt) {
  EXPECT_FALSE(controller_.sewingView(snapshot_).has_value());
  send(KeyEvent{Key::S});
  EXPECT_EQ(view().kind, SewingKind::Seam);
  clickOn(innerLeft);
  EXPECT_EQ(view().sides.size(), 1U);
  send(KeyEvent{Key::Escape});
  EXPECT_TRUE(view().sides.empty()) << "it takes back what was picked first";
  send(KeyEvent{Key::Escape});
  EXPECT_FALSE(controller_.sewingView(snapshot_).has_value());
}

TEST_F(SewingInWindow, AnotherModeEndsIt) {
  send(KeyEvent{Key::S});
  send(KeyEvent{Key::B});
  EXPECT_FALSE(controller_.sewing().isOn());
  EXPECT_TRUE(controller_.selects());
  send(KeyEvent{Key::S});
  EXPECT_FALSE(controller_.selects());
  send(KeyEvent{Key::G});
  EXPECT_FALSE(controller_.sewing().isOn());
  EXPECT_TRUE(controller_.placing().isOn());
}

TEST_F(SewingInWindow, ShowsTheBorderUnderTheMouse) {
  send(KeyEvent{Key::S});
  send(MoveEvent{inWindow(innerLeft) + Vec2(5.0, 0.0)});
  EXPECT_EQ(view().border.points.size(), 16U) << "around the sheet";
  EXPECT_EQ(view().hovered.points.size(), 5U) << "from corner to corner";
  send(MoveEvent{inWindow(12)});
  EXPECT_TRUE(view().border.points.empty()) << "inside the sheet";
  send(MoveEvent{Vec2(100.0, inWindow(10).y())});
  EXPECT_TRUE(view().border.points.empty()) << "over the panels";
}

TEST_F(SewingInWindow, TwoClicksAndSewAddASeam) {
  send(KeyEvent{Key::S});
  clickOn(innerLeft);
  clickOn(innerRight);
  const SewingView picked = view();
  ASSERT_EQ(picked.sides.size(), 2U);
  EXPECT_EQ(picked.sides[0].vertices, 5U);
  EXPECT_NEAR(picked.sides[1].length, 0.4, 1e-9);
  EXPECT_TRUE(picked.problem.empty()) << picked.problem;
  ASSERT_EQ(picked.pairs.size(), 5U);
  for (const auto& pair : picked.pairs) {
    EXPECT_NEAR(pair[0].y(), pair[1].y(), 0.5) << "the near ends meet";
  }
  const UiOutput output = ask({.kind = Ask::Sew});
  ASSERT_EQ(output.commands.size(), 1U);
  apply(output);
  EXPECT_TRUE(snapshot_.message.empty()) << snapshot_.message;
  ASSERT_EQ(snapshot_.seams->size(), 1U);
  EXPECT_EQ(snapshot_.seams->front().pairs.size(), 5U);
  EXPECT_TRUE(view().sides.empty()) << "ready for the next seam";
  ASSERT_EQ(view().seams.size(), 1U);
  EXPECT_FALSE(view().seams.front().isWelded);
}

TEST_F(SewingInWindow, FlipJoinsTheOtherEnds) {
  send(KeyEvent{Key::S});
  clickOn(innerLeft);
  clickOn(innerRight);
  ask({.kind = Ask::Flip});
  const SewingView flipped = view();
  ASSERT_EQ(flipped.pairs.size(), 5U);
  EXPECT_GT(std::abs(flipped.pairs.front()[0].y() - flipped.pairs.front()[1].y()), 50.0);
  EXPECT_NEAR(flipped.pairs[2][0].y(), flipped.pairs[2][1].y(), 0.5) << "the middle stays";
  apply(ask({.kind = Ask::Sew}));
  ASSERT_EQ(snapshot_.seams->size(), 1U);
  const sim::SeamPair& first = snapshot_.seams->front().pairs.front();
  EXPECT_GT(std::abs(snapshot_.positions[first.a].y() - snapshot_.positions[first.b].y()), 0.3);
}

TEST_F(SewingInWindow, TwoPointsPickThePartBetweenThem) {
  send(KeyEvent{Key::S});
  ask({.kind = Ask::UseExtent, .extent = BorderExtent::Points});
  clickOn(9);
  EXPECT_TRUE(view().sides.empty());
  EXPECT_TRUE(view().start.has_value());
  send(MoveEvent{inWindow(24)});
  EXPECT_EQ(view().hovered.points.size(), 4U) << "a preview of the part";
  clickOn(24);
  ASSERT_EQ(view().sides.size(), 1U);
  EXPECT_EQ(view().sides[0].vertices, 4U);
  send(KeyEvent{Key::Escape});
  clickOn(9);
  clickOn(24, true);
  ASSERT_EQ(view().sides.size(), 1U);
  EXPECT_EQ(view().sides[0].vertices, 14U) << "Shift takes the longer way";
}

TEST_F(SewingInWindow, APointOnAnotherBorderStartsThere) {
  send(KeyEvent{Key::S});
  ask({.kind = Ask::UseExtent, .extent = BorderExtent::Points});
  clickOn(innerLeft);
  clickOn(innerRight);
  EXPECT_TRUE(view().sides.empty());
  clickOn(25 + 20);
  ASSERT_EQ(view().sides.size(), 1U);
  EXPECT_EQ(view().sides[0].vertices, 3U);
}

TEST_F(SewingInWindow, WholeBordersMeetWhereTheyAreClicked) {
  send(KeyEvent{Key::S});
  ask({.kind = Ask::UseExtent, .extent = BorderExtent::Whole});
  clickOn(innerLeft);
  clickOn(innerRight);
  const SewingView picked = view();
  ASSERT_EQ(picked.pairs.size(), 16U);
  EXPECT_NEAR((picked.pairs.front()[0] - inWindow(innerLeft)).norm(), 0.0, 0.5);
  EXPECT_NEAR((picked.pairs.front()[1] - inWindow(innerRight)).norm(), 0.0, 0.5);
}

TEST_F(SewingInWindow, SaysWhyBordersCannotBeSewn) {
  send(KeyEvent{Key::S});
  clickOn(innerLeft);
  ask({.kind = Ask::UseExtent, .extent = BorderExtent::Whole});
  clickOn(innerRight);
  EXPECT_NE(view().problem.english().find("whole border"), std::string::npos) << view().problem;
  const UiOutput output = ask({.kind = Ask::Sew});
  EXPECT_TRUE(output.commands.empty());
  EXPECT_FALSE(output.hint.empty());
  ask({.kind = Ask::Clear});
  EXPECT_EQ(ask({.kind = Ask::Sew}).hint, "Pick two borders first");
}

TEST_F(SewingInWindow, RefusesTheSameSeamTwice) {
  send(KeyEvent{Key::S});
  clickOn(innerLeft);
  clickOn(innerRight);
  apply(ask({.kind = Ask::Sew}));
  clickOn(innerLeft);
  clickOn(innerRight);
  EXPECT_EQ(view().problem, "other seams join these vertices already");
}

TEST_F(SewingInWindow, AClickOnAPickedBorderTakesItBackAndAThirdOneReplaces) {
  send(KeyEvent{Key::S});
  clickOn(innerLeft);
  clickOn(innerLeft);
  EXPECT_TRUE(view().sides.empty());
  clickOn(innerLeft);
  clickOn(innerRight);
  clickOn(25 + 14);
  EXPECT_EQ(view().sides.size(), 2U);
  EXPECT_NEAR(view().pairs.front()[1].x(), inWindow(25 + 14).x(), 0.5);
}

TEST_F(SewingInWindow, ADragTurnsTheViewAndPicksNothing) {
  send(KeyEvent{Key::S});
  const scene::CameraPose before = controller_.camera().pose();
  const Vec2 from = inWindow(innerLeft);
  send(PressEvent{.position = from});
  send(MoveEvent{from + Vec2(40.0, 0.0)});
  send(ReleaseEvent{});
  EXPECT_NE(controller_.camera().pose(), before);
  EXPECT_TRUE(view().sides.empty());
}

TEST_F(SewingInWindow, AnElasticBandIsSetChangedAndReplaced) {
  UiOutput output;
  controller_.sew(UiAction::SetBand, output);
  EXPECT_EQ(view().kind, SewingKind::Band);
  EXPECT_EQ(ask({.kind = Ask::SetBand, .length = 0.8}).hint, "Pick a border first");
  clickOn(innerLeft);
  EXPECT_FALSE(view().bandLength.has_value());
  apply(ask({.kind = Ask::SetBand, .length = 0.8}));
  EXPECT_TRUE(snapshot_.message.empty()) << snapshot_.message;
  EXPECT_EQ(view().bandLength, 0.8);
  apply(ask({.kind = Ask::SetBand, .length = 0.6}));
  ASSERT_EQ(snapshot_.sewing->bands[0].size(), 1U);
  EXPECT_EQ(snapshot_.sewing->bands[0][0].length, 0.6);
  ask({.kind = Ask::UseExtent, .extent = BorderExtent::Whole});
  ask({.kind = Ask::Clear});
  clickOn(innerLeft);
  apply(ask({.kind = Ask::SetBand, .length = 0.9}));
  ASSERT_EQ(snapshot_.sewing->bands[0].size(), 1U) << "the part of it is replaced";
  EXPECT_EQ(snapshot_.sewing->bands[0][0].vertices.size(), 1U);
  EXPECT_TRUE(snapshot_.sewing->bands[1].empty());
}

TEST_F(SewingInWindow, UndoNamesTheSeam) {
  Undo undo;
  UiOutput output;
  undo.watch(snapshot_, snapshot_.settings, true, 0.0, output);
  send(KeyEvent{Key::S});
  clickOn(innerLeft);
  clickOn(innerRight);
  apply(ask({.kind = Ask::Sew}));
  undo.watch(snapshot_, snapshot_.settings, true, 0.1, output);
  EXPECT_EQ(undo.undo(output), "Undone: seam added");
  apply(output);
  EXPECT_TRUE(snapshot_.seams->empty());
}

TEST_F(SewingInWindow, ForgetsTheBordersOfAnotherScene) {
  send(KeyEvent{Key::S});
  clickOn(innerLeft);
  simulation_.apply(session::LoadSceneCommand{sheets()});
  capture();
  EXPECT_TRUE(view().sides.empty());
}

}  // namespace
}  // namespace drape::ui
