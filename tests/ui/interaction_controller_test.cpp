#include "ui/interaction_controller.hpp"

#include "session/simulation.hpp"

#include <gtest/gtest.h>

namespace drape::ui {
namespace {

/// A grid that hangs in the middle of the picture.
class Interaction : public ::testing::Test {
 protected:
  Interaction() : simulation_(scene()) {
    controller_.setView(view_);
    simulation_.capture(snapshot_);
    controller_.lookFrom(render::Camera::Side::Top, snapshot_);
    controller_.frameCloth(snapshot_);
    onCloth_ = inWindow(middleOf(0.31, 0.43));
  }

  static std::shared_ptr<const scene::Scene> scene() {
    const scene::SceneDescription description = scene::openScene("grid");
    return scene::buildScene(description, description.settings);
  }

  [[nodiscard]] Vec3 middleOf(double across, double along) const {
    Vec3 low = snapshot_.positions.front();
    Vec3 high = low;
    for (const Vec3& position : snapshot_.positions) {
      low = low.cwiseMin(position);
      high = high.cwiseMax(position);
    }
    return {low.x() + across * (high.x() - low.x()), low.y(), low.z() + along * (high.z() - low.z())};
  }

  [[nodiscard]] Vec2 inWindow(const Vec3& point) const {
    return controller_.camera().project(point, static_cast<int>(view_.width), static_cast<int>(view_.height)) +
           Vec2(view_.x, view_.y);
  }

  UiOutput send(const InputEvent& event) {
    UiOutput output;
    controller_.handle(event, snapshot_, output);
    return output;
  }

  [[nodiscard]] bool cameraMoved(const scene::CameraPose& before) const {
    const scene::CameraPose& now = controller_.camera().pose();
    return (now.position - before.position).norm() > 1e-9 || (now.focalPoint - before.focalPoint).norm() > 1e-9;
  }

  const UiRect view_{372.0, 0.0, 900.0, 690.0};
  const Vec2 beside_{380.0, 5.0};
  session::Simulation simulation_;
  session::Snapshot snapshot_;
  InteractionController controller_;
  Vec2 onCloth_ = Vec2::Zero();
};

TEST_F(Interaction, LeftOnTheClothAttachesToTheHitPoint) {
  const UiOutput output = send(PressEvent{.position = onCloth_});
  ASSERT_EQ(output.commands.size(), 1U);
  const auto& attached = std::get<session::AttachCommand>(output.commands.front());
  EXPECT_NEAR(attached.barycentric.sum(), 1.0, 1e-9);
  EXPECT_TRUE(attached.target.isApprox(middleOf(0.31, 0.43), 1e-6));
  EXPECT_TRUE(controller_.holdsCloth());
}

TEST_F(Interaction, DraggingMovesTheTargetAtTheDepthOfTheAttachedPoint) {
  const UiOutput pressed = send(PressEvent{.position = onCloth_});
  const Vec3 taken = std::get<session::AttachCommand>(pressed.commands.front()).target;
  const scene::CameraPose before = controller_.camera().pose();
  const UiOutput moved = send(MoveEvent{onCloth_ + Vec2(60.0, -20.0)});
  ASSERT_EQ(moved.commands.size(), 1U);
  const Vec3 target = std::get<session::MoveAttachmentCommand>(moved.commands.front()).target;
  EXPECT_TRUE(inWindow(target).isApprox(onCloth_ + Vec2(60.0, -20.0), 1e-6));
  const Vec3 direction = (before.focalPoint - before.position).normalized();
  EXPECT_NEAR((target - taken).dot(direction), 0.0, 1e-9);
  EXPECT_FALSE(cameraMoved(before));
}

TEST_F(Interaction, LettingGoReleases) {
  send(PressEvent{.position = onCloth_});
  EXPECT_TRUE(send(ReleaseEvent{MouseButton::Right}).commands.empty());
  const UiOutput output = send(ReleaseEvent{MouseButton::Left});
  ASSERT_EQ(output.commands.size(), 1U);
  EXPECT_TRUE(std::holds_alternative<session::DetachCommand>(output.commands.front()));
  EXPECT_TRUE(send(MoveEvent{beside_}).commands.empty());
}

TEST_F(Interaction, LeftBesideTheClothTurnsTheView) {
  const scene::CameraPose before = controller_.camera().pose();
  EXPECT_TRUE(send(PressEvent{.position = beside_}).commands.empty());
  EXPECT_TRUE(send(MoveEvent{beside_ + Vec2(80.0, 10.0)}).commands.empty());
  EXPECT_TRUE(cameraMoved(before));
  EXPECT_TRUE(controller_.camera().pose().focalPoint.isApprox(before.focalPoint));
  EXPECT_TRUE(send(ReleaseEvent{MouseButton::Left}).commands.empty());
}

TEST_F(Interaction, ControlNeverTurnsTheView) {
  const scene::CameraPose before = controller_.camera().pose();
  send(PressEvent{.position = beside_, .control = true});
  send(MoveEvent{beside_ + Vec2(80.0, 10.0)});
  EXPECT_FALSE(cameraMoved(before));
  send(ReleaseEvent{MouseButton::Left});
  EXPECT_EQ(send(PressEvent{.position = onCloth_, .control = true, .time = 5.0}).commands.size(), 1U);
}

TEST_F(Interaction, ShiftAndTheMiddleButtonMoveTheView) {
  for (const PressEvent& press : {PressEvent{.position = onCloth_, .shift = true},
                                  PressEvent{.button = MouseButton::Middle, .position = onCloth_}}) {
    const scene::CameraPose before = controller_.camera().pose();
    EXPECT_TRUE(send(press).commands.empty());
    send(MoveEvent{onCloth_ + Vec2(50.0, 0.0)});
    send(ReleaseEvent{press.button});
    const scene::CameraPose& now = controller_.camera().pose();
    EXPECT_GT((now.focalPoint - before.focalPoint).norm(), 1e-3);
    EXPECT_TRUE((now.position - before.position).isApprox(now.focalPoint - before.focalPoint, 1e-6));
  }
}

TEST_F(Interaction, TheWheelComesNearer) {
  const auto distance = [&] {
    const scene::CameraPose& pose = controller_.camera().pose();
    return (pose.position - pose.focalPoint).norm();
  };
  const double before = distance();
  send(ScrollEvent{1.0});
  EXPECT_LT(distance(), before);
  send(ScrollEvent{-1.0});
  EXPECT_NEAR(distance(), before, 1e-9);
}

TEST_F(Interaction, ADoubleClickLooksAtThePoint) {
  send(PressEvent{.position = onCloth_, .time = 1.0});
  send(ReleaseEvent{MouseButton::Left});
  const UiOutput second = send(PressEvent{.position = onCloth_, .time = 1.2});
  EXPECT_TRUE(second.commands.empty());
  EXPECT_TRUE(controller_.camera().pose().focalPoint.isApprox(middleOf(0.31, 0.43), 1e-6));
}

TEST_F(Interaction, TwoSlowClicksAreNoDoubleClick) {
  send(PressEvent{.position = onCloth_, .time = 1.0});
  send(ReleaseEvent{MouseButton::Left});
  EXPECT_EQ(send(PressEvent{.position = onCloth_, .time = 2.0}).commands.size(), 1U);
}

TEST_F(Interaction, KeysAreCommands) {
  snapshot_.paused = true;
  EXPECT_FALSE(std::get<session::PauseCommand>(send(KeyEvent{Key::Space}).commands.at(0)).paused);
  EXPECT_TRUE(std::holds_alternative<session::SingleStepCommand>(send(KeyEvent{Key::Period}).commands.at(0)));
  EXPECT_TRUE(std::holds_alternative<session::ResetCommand>(send(KeyEvent{Key::R}).commands.at(0)));
  EXPECT_TRUE(std::holds_alternative<session::TogglePinCommand>(send(KeyEvent{Key::P}).commands.at(0)));
  const UiOutput wireframe = send(KeyEvent{Key::W});
  EXPECT_EQ(std::get<session::SetSettingCommand>(wireframe.commands.at(0)).key, "view.wireframe");
  EXPECT_EQ(std::get<UiAction>(send(KeyEvent{Key::H}).requests.at(0)), UiAction::TogglePanels);
  EXPECT_EQ(std::get<UiAction>(send(KeyEvent{Key::F12}).requests.at(0)), UiAction::Screenshot);
  EXPECT_EQ(std::get<UiAction>(send(KeyEvent{Key::E}).requests.at(0)), UiAction::SaveCloth);
  EXPECT_EQ(std::get<UiAction>(send(KeyEvent{Key::Help}).requests.at(0)), UiAction::ToggleHelp);
}

TEST_F(Interaction, PInAModeThatSelectsSaysHowToSelect) {
  send(KeyEvent{Key::B});
  const UiOutput rectangle = send(KeyEvent{Key::P});
  EXPECT_TRUE(rectangle.commands.empty()) << "no command about the pulled vertex";
  EXPECT_EQ(rectangle.hint, "No vertices are selected: drag a rectangle over some, or click one");
  send(KeyEvent{Key::L});
  EXPECT_EQ(send(KeyEvent{Key::P}).hint, "No vertices are selected: click near an open border");
}

TEST_F(Interaction, OnlySteppingRepeats) {
  EXPECT_EQ(send(KeyEvent{Key::Period, true}).commands.size(), 1U);
  EXPECT_TRUE(send(KeyEvent{Key::Space, true}).commands.empty());
  EXPECT_TRUE(send(KeyEvent{Key::P, true}).commands.empty());
}

TEST_F(Interaction, EscapeLetsGoAndNeverQuits) {
  send(PressEvent{.position = onCloth_});
  const UiOutput first = send(KeyEvent{Key::Escape});
  EXPECT_TRUE(std::holds_alternative<session::DetachCommand>(first.commands.at(0)));
  EXPECT_TRUE(first.requests.empty());
  const UiOutput second = send(KeyEvent{Key::Escape});
  EXPECT_EQ(std::get<UiAction>(second.requests.at(0)), UiAction::Stop);
}

TEST_F(Interaction, CtrlQQuitsAndTheLetterAloneDoesNot) {
  EXPECT_TRUE(send(KeyEvent{Key::Q}).requests.empty());
  EXPECT_EQ(std::get<UiAction>(send(KeyEvent{Key::Q, false, true}).requests.at(0)), UiAction::Quit);
}

TEST_F(Interaction, LosingTheFocusLetsGo) {
  send(PressEvent{.position = onCloth_});
  EXPECT_EQ(send(FocusLostEvent{}).commands.size(), 1U);
  EXPECT_FALSE(controller_.holdsCloth());
}

TEST_F(Interaction, AnotherSceneIsNotHeld) {
  send(PressEvent{.position = onCloth_});
  snapshot_.scene = scene();
  EXPECT_TRUE(send(MoveEvent{onCloth_ + Vec2(5.0, 5.0)}).commands.empty());
  EXPECT_FALSE(controller_.holdsCloth());
}

TEST_F(Interaction, TheCameraStaysAboveTheGround) {
  controller_.lookAtScene(*snapshot_.scene);
  send(PressEvent{.position = beside_});
  for (int i = 1; i <= 20; ++i) {
    send(MoveEvent{beside_ + Vec2(0.0, -60.0 * i)});
  }
  EXPECT_GT(controller_.camera().pose().position.y(), snapshot_.scene->groundHeight);
  send(ReleaseEvent{MouseButton::Left});
  send(PressEvent{.button = MouseButton::Middle, .position = beside_});
  for (int i = 1; i <= 20; ++i) {
    send(MoveEvent{beside_ + Vec2(0.0, -300.0 * i)});
  }
  EXPECT_GT(controller_.camera().pose().position.y(), snapshot_.scene->groundHeight);
  EXPECT_GE(controller_.camera().pose().focalPoint.y(), snapshot_.scene->groundHeight);
}

TEST_F(Interaction, TheCameraStaysNearTheCloth) {
  controller_.lookAtScene(*snapshot_.scene);
  const auto distance = [&] { return (controller_.camera().pose().position - middleOf(0.5, 0.5)).norm(); };
  for (int i = 0; i < 200; ++i) {
    send(ScrollEvent{-3.0});
  }
  const double far = distance();
  EXPECT_LT(far, 20.0);
  send(PressEvent{.button = MouseButton::Middle, .position = beside_});
  for (int i = 1; i <= 50; ++i) {
    send(MoveEvent{beside_ + Vec2(400.0 * i, 0.0)});
  }
  EXPECT_LT(distance(), far + 5.0);
}

TEST_F(Interaction, AnAuthorsCameraThatIsFarAwayDoesNotJump) {
  scene::Scene scene = *snapshot_.scene;
  scene.camera = {Vec3(0.0, -3.0, 90.0), Vec3(0.0, 1.0, 0.0), 35.0};
  controller_.setView({0.0, 0.0, 1600.0, 690.0});  // wide, so that the camera keeps the author's distance
  controller_.lookAtScene(scene);
  send(ScrollEvent{0.01});
  EXPECT_NEAR((controller_.camera().pose().position - Vec3(0.0, -3.0, 90.0)).norm(), 0.0, 0.5);
}

TEST_F(Interaction, ANarrowPictureShowsTheSceneFromFartherAway) {
  const auto distance = [&] {
    const scene::CameraPose& pose = controller_.camera().pose();
    return (pose.position - pose.focalPoint).norm();
  };
  controller_.lookAtScene(*snapshot_.scene);
  const double wide = distance();
  controller_.setView({0.0, 0.0, 300.0, 690.0});
  controller_.lookAtScene(*snapshot_.scene);
  EXPECT_GT(distance(), 1.5 * wide);
}

/// The grid and a ball, which appears beside the cloth; seen from above.
class BodyInteraction : public Interaction {
 protected:
  BodyInteraction() {
    scene::SceneDescription description = scene::openScene("grid");
    sim::contact::Body ball;
    ball.name = "ball";
    ball.shape = sim::contact::SphereShape{0.1};
    ball.motion.keyframes = {{0.0, Vec3(0.8, 1.3, 0.0), Vec3::Zero()}};
    description.bodies.resize(1);
    description.bodies[0].body = ball;
    description.ground = sim::contact::Body{};
    simulation_.apply(session::LoadSceneCommand{scene::buildScene(description, description.settings)});
    simulation_.capture(snapshot_);
    controller_.lookFrom(render::Camera::Side::Top, snapshot_);
    onBall_ = inWindow(Vec3(0.8, 1.3, 0.0));
  }

  Vec2 onBall_ = Vec2::Zero();
};

TEST_F(BodyInteraction, DraggingABodyMovesItAtTheDepthWhereItWasTaken) {
  const scene::CameraPose before = controller_.camera().pose();
  EXPECT_TRUE(send(PressEvent{.position = onBall_}).commands.empty()) << "it moves with the mouse";
  EXPECT_TRUE(controller_.holdsBody());
  const UiOutput moved = send(MoveEvent{onBall_ + Vec2(40.0, 25.0)});
  ASSERT_EQ(moved.commands.size(), 1U);
  const auto& command = std::get<session::MoveBodyCommand>(moved.commands.front());
  EXPECT_EQ(command.body, 0);
  // The ray through the centre enters the ball there; that point is then under the mouse.
  const Vec3 middle(0.8, 1.3, 0.0);
  const Vec3 taken = middle + 0.1 * (before.position - middle).normalized();
  EXPECT_NEAR((inWindow(taken + command.shift) - (onBall_ + Vec2(40.0, 25.0))).norm(), 0.0, 0.5);
  EXPECT_NEAR(command.shift.y(), 0.0, 1e-3) << "across the view";
  EXPECT_FALSE(cameraMoved(before));
  EXPECT_TRUE(send(ReleaseEvent{MouseButton::Left}).commands.empty());
  EXPECT_TRUE(send(MoveEvent{onBall_}).commands.empty());
  EXPECT_FALSE(controller_.holdsBody());
}

TEST_F(BodyInteraction, ABodyThatWasMovedIsPickedAtItsNewPosition) {
  simulation_.apply(session::MoveBodyCommand{0, Vec3(0.0, 0.0, 0.3)});
  for (int i = 0; i < 40; ++i) {
    simulation_.step();
  }
  simulation_.capture(snapshot_);
  EXPECT_TRUE(send(PressEvent{.position = onBall_, .control = true}).commands.empty());
  EXPECT_FALSE(controller_.holdsBody()) << "it is no longer there";
  const Vec2 there = inWindow(Vec3(0.8, 1.3, 0.3));
  send(PressEvent{.position = there, .time = 9.0});
  ASSERT_TRUE(controller_.holdsBody());
  const UiOutput still = send(MoveEvent{there});
  EXPECT_NEAR((std::get<session::MoveBodyCommand>(still.commands.at(0)).shift - Vec3(0.0, 0.0, 0.3)).norm(), 0.0, 1e-9);
}

TEST_F(BodyInteraction, OnlyActiveFiniteBodiesArePicked) {
  send(PressEvent{.position = beside_});
  EXPECT_FALSE(controller_.holdsBody()) << "the ground stays";
  send(ReleaseEvent{MouseButton::Left});
  simulation_.apply(session::SwitchBodyCommand{0, false});
  simulation_.capture(snapshot_);
  send(PressEvent{.position = onBall_, .time = 5.0});
  EXPECT_FALSE(controller_.holdsBody());
}

TEST_F(Interaction, ADragOnASelectedPinMovesAllSelectedPinsParallelToTheView) {
  const int corner = 0;
  const int other = static_cast<int>(snapshot_.positions.size()) - 1;
  simulation_.apply(session::SetPinsCommand{{corner, other}});
  simulation_.capture(snapshot_);
  UiOutput ignored;
  (void)controller_.select(UiAction::SelectRectangle, snapshot_, ignored);
  const Vec2 at = inWindow(snapshot_.positions[corner]);
  (void)send(PressEvent{.position = Vec2(view_.x + 1.0, view_.y + 1.0)});
  (void)send(MoveEvent{{view_.x + view_.width - 1.0, view_.y + view_.height - 1.0}});
  (void)send(ReleaseEvent{});
  const std::vector<Vec3> before = snapshot_.positions;
  EXPECT_TRUE(send(PressEvent{.position = at}).commands.empty());
  const UiOutput moved = send(MoveEvent{at + Vec2(40.0, 25.0)});
  ASSERT_EQ(moved.commands.size(), 1U);
  const auto& command = std::get<session::PlacePinsCommand>(moved.commands.front());
  EXPECT_EQ(command.vertices, (std::vector<int>{corner, other}));
  EXPECT_NEAR((inWindow(command.places[0]) - at - Vec2(40.0, 25.0)).norm(), 0.0, 0.5);
  EXPECT_NEAR((command.places[1] - before[other] - (command.places[0] - before[corner])).norm(), 0.0, 1e-12);
  (void)send(ReleaseEvent{});
  EXPECT_EQ(controller_.selection(snapshot_).vertices.size(), snapshot_.positions.size()) << "the selection stays";
}

}  // namespace
}  // namespace drape::ui
