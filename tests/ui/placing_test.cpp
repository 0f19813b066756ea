// The mode Place: what its drags, clicks and choices ask for, and what the picture shows meanwhile.
#include "ui/placing.hpp"

#include "scene/scene_parts.hpp"
#include "session/simulation.hpp"
#include "sim/model/bounds.hpp"
#include "ui/interaction_controller.hpp"
#include "ui/scene_changes.hpp"
#include "ui/undo.hpp"

#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <optional>
#include <stdexcept>
#include <string>
#include <variant>

namespace drape::ui {
namespace {

using Request = PlacingRequest::Kind;

/// A scene in the window, controlled by mouse and keyboard.
class PlacingInWindow : public ::testing::Test {
 protected:
  explicit PlacingInWindow(const char* name = "grid") : PlacingInWindow(scene::openScene(name)) {}
  explicit PlacingInWindow(const scene::SceneDescription& description) : simulation_(built(description)) {
    controller_.setView({372.0, 0.0, 900.0, 690.0});
    controller_.lookAtScene(simulation_.scene());
    capture();
  }

  static std::shared_ptr<const scene::Scene> built(const scene::SceneDescription& description) {
    return scene::buildScene(description, description.settings);
  }

  void capture() {
    simulation_.capture(snapshot_);
    controller_.placing().follow(snapshot_);
  }

  UiOutput send(const InputEvent& event) {
    UiOutput output;
    controller_.handle(event, snapshot_, output);
    apply(output);
    return output;
  }

  /// As the viewer does: commands to the simulation, and the scene built again.
  void apply(const UiOutput& output) {
    for (const session::Command& command : output.commands) {
      simulation_.apply(command);
    }
    for (const UiRequest& request : output.requests) {
      if (const auto* rebuild = std::get_if<RebuildSceneRequest>(&request)) {
        ASSERT_TRUE(rebuild->placements.has_value());
        simulation_.apply(session::LoadSceneCommand{scene::buildScene(
            scene::withPlacements(snapshot_.scene->description, *rebuild->placements), rebuild->settings)});
      }
    }
    capture();
  }

  UiOutput ask(const PlacingRequest& request) {
    UiOutput output;
    controller_.placing().on(request, snapshot_, output);
    apply(output);
    return output;
  }

  [[nodiscard]] PlacingView view() {
    const std::optional<PlacingView> view = controller_.placingView(snapshot_);
    EXPECT_TRUE(view.has_value());
    return view.value_or(PlacingView());
  }

  [[nodiscard]] const GizmoLine& lineOf(const PlacingView& view, GizmoHandle handle) const {
    const auto found = std::ranges::find(view.handles, handle, &GizmoLine::handle);
    if (found == view.handles.end()) {
      throw std::runtime_error("the gizmo does not have this handle");
    }
    return *found;
  }

  /// Drags a handle by some window units; the mouse button stays down.
  void pull(GizmoHandle handle, const Vec2& by, bool control = false) {
    const PlacingView before = view();
    const Vec2 grip = lineOf(before, handle).grip;
    send(MoveEvent{grip});
    send(PressEvent{.position = grip});
    send(MoveEvent{grip + 0.5 * by, control});
    send(MoveEvent{grip + by, control});
  }
  UiOutput letGo() { return send(ReleaseEvent{}); }

  [[nodiscard]] Vec3 middleOfCloth() const { return sim::boundsOf(snapshot_.positions).center(); }

  session::Simulation simulation_;
  session::Snapshot snapshot_;
  InteractionController controller_;
};

class PlacingSphere : public PlacingInWindow {
 protected:
  PlacingSphere() : PlacingInWindow("sphere") {}
};

class PlacingFigure : public PlacingInWindow {
 protected:
  PlacingFigure() : PlacingInWindow("dance") {}
};

TEST_F(PlacingInWindow, TheClockWaitsMeanwhileAndGoesOnAfterwards) {
  EXPECT_FALSE(snapshot_.paused);
  send(KeyEvent{Key::G});
  EXPECT_TRUE(controller_.placing().isOn());
  EXPECT_TRUE(snapshot_.paused);
  send(KeyEvent{Key::Escape});
  EXPECT_FALSE(controller_.placing().isOn());
  EXPECT_FALSE(snapshot_.paused);
}

TEST_F(PlacingInWindow, TheKeyChoosesTheNextTool) {
  send(KeyEvent{Key::G});
  EXPECT_EQ(view().tool, PlacingTool::Move);
  send(KeyEvent{Key::G});
  EXPECT_EQ(view().tool, PlacingTool::Turn);
  send(KeyEvent{Key::G});
  EXPECT_EQ(view().tool, PlacingTool::Scale);
  send(KeyEvent{Key::G});
  EXPECT_EQ(view().tool, PlacingTool::Move);
}

TEST_F(PlacingInWindow, APlayingClockEndsTheMode) {
  send(KeyEvent{Key::G});
  send(KeyEvent{Key::Space});
  EXPECT_FALSE(snapshot_.paused);
  EXPECT_FALSE(controller_.placing().isOn());
}

TEST_F(PlacingInWindow, AnArrowMovesTheClothAlongItsAxisOnly) {
  const Vec3 before = middleOfCloth();
  send(KeyEvent{Key::G});
  pull(GizmoHandle::MoveX, Vec2(70.0, 10.0));
  EXPECT_TRUE(controller_.placing().isDragging());
  const UiOutput output = letGo();
  ASSERT_EQ(output.requests.size(), 1U);
  const Vec3 moved = middleOfCloth() - before;
  EXPECT_GT(moved.x(), 0.05);
  EXPECT_NEAR(moved.y(), 0.0, 1e-9);
  EXPECT_NEAR(moved.z(), 0.0, 1e-9);
  EXPECT_EQ(snapshot_.step, 0);
  EXPECT_TRUE(snapshot_.paused);
  EXPECT_FALSE(controller_.placing().isBuilding());
  EXPECT_TRUE(differsFromScene(snapshot_, snapshot_.settings)) << "Reset all would take it back";
}

TEST_F(PlacingInWindow, ThePictureShowsTheStartAndThenTheDrag) {
  for (int i = 0; i < 20; ++i) {
    simulation_.step();
  }
  capture();
  EXPECT_EQ(&controller_.placing().shown(snapshot_), &snapshot_);
  send(KeyEvent{Key::G});
  const session::Snapshot& shown = controller_.placing().shown(snapshot_);
  EXPECT_EQ(shown.positions, snapshot_.scene->start.positions);
  EXPECT_NE(shown.positions, snapshot_.positions);
  const std::int64_t version = shown.version;
  pull(GizmoHandle::MoveY, Vec2(0.0, -50.0));
  const session::Snapshot& dragged = controller_.placing().shown(snapshot_);
  EXPECT_NE(dragged.version, version) << "so that the renderer takes it";
  EXPECT_GT(dragged.positions[5].y(), snapshot_.scene->start.positions[5].y() + 0.02);
  const std::vector<Vec3> preview = dragged.positions;
  letGo();
  for (std::size_t v = 0; v < preview.size(); ++v) {
    ASSERT_LT((preview[v] - snapshot_.positions[v]).norm(), 1e-9) << "the scene is built where the preview was";
  }
}

TEST_F(PlacingInWindow, EscapeTakesADragBackAndThenEndsTheMode) {
  send(KeyEvent{Key::G});
  const Vec3 before = view().middle;
  pull(GizmoHandle::MoveX, Vec2(70.0, 0.0));
  EXPECT_GT((view().middle - before).norm(), 0.02);
  send(KeyEvent{Key::Escape});
  EXPECT_FALSE(controller_.placing().isDragging());
  EXPECT_EQ(view().middle, before);
  EXPECT_TRUE(letGo().requests.empty());
  send(KeyEvent{Key::Escape});
  EXPECT_FALSE(controller_.placing().isOn());
}

TEST_F(PlacingInWindow, LosingTheFocusTakesADragBack) {
  send(KeyEvent{Key::G});
  pull(GizmoHandle::MoveX, Vec2(70.0, 0.0));
  EXPECT_TRUE(send(FocusLostEvent{}).requests.empty());
  EXPECT_FALSE(controller_.placing().isDragging());
  EXPECT_TRUE(view().placement.isNone());
}

TEST_F(PlacingInWindow, RingsTurnAboutTheMiddleInSteps) {
  send(KeyEvent{Key::G});
  ask({.kind = Request::UseTool, .tool = PlacingTool::Turn});
  const Vec3 middle = view().middle;
  pull(GizmoHandle::TurnY, Vec2(40.0, 25.0), true);
  letGo();
  const scene::Placement placement = snapshot_.scene->description.cloth().placement;
  EXPECT_GT(std::abs(placement.rotation.y()), 4.9);
  EXPECT_NEAR(placement.rotation.y(), 5.0 * std::round(placement.rotation.y() / 5.0), 1e-5);
  EXPECT_LT((view().middle - middle).norm(), 2e-6);
}

TEST_F(PlacingInWindow, TheKnobScalesTheRestShapeAboutTheMiddle) {
  send(KeyEvent{Key::G});
  ask({.kind = Request::UseTool, .tool = PlacingTool::Scale});
  const PlacingView before = view();
  const Vec2 grip = lineOf(before, GizmoHandle::Size).grip;
  const Vec2 from = lineOf(before, GizmoHandle::Size).outline.front();
  const double length = snapshot_.model->springs.front().restLength;
  pull(GizmoHandle::Size, 0.5 * (grip - from), true);
  letGo();
  EXPECT_NEAR(snapshot_.scene->description.cloth().placement.scale, 1.5, 1e-9);
  EXPECT_NEAR(snapshot_.model->springs.front().restLength, 1.5 * length, 1e-9);
  EXPECT_LT((view().middle - before.middle).norm(), 2e-6);
}

TEST_F(PlacingInWindow, ToGroundLetsTheClothKeepItsContactOffset) {
  send(KeyEvent{Key::G});
  ask({.kind = Request::OnGround});
  const double offset = snapshot_.bodies.back().surface.thickness + 0.5 * snapshot_.settings.step.contact.thickness;
  const double lowest = sim::boundsOf(snapshot_.positions).min().y();
  EXPECT_GE(lowest, snapshot_.scene->groundHeight + offset - 1e-8);
  EXPECT_LT(lowest, snapshot_.scene->groundHeight + offset + 2e-6);
  EXPECT_TRUE(ask({.kind = Request::OnGround}).requests.empty()) << "it is there already";
  ask({.kind = Request::Restore});
  EXPECT_TRUE(snapshot_.scene->description.cloth().placement.isNone());
  EXPECT_FALSE(differsFromScene(snapshot_, snapshot_.settings));
}

TEST_F(PlacingInWindow, NumbersArePreviewedUntilTheUserLetsGo) {
  send(KeyEvent{Key::G});
  const scene::Placement wanted{Vec3(0.3, 0.0, 0.0), Vec3::Zero(), 1.0};
  EXPECT_TRUE(ask({.kind = Request::Preview, .placement = wanted}).requests.empty());
  EXPECT_EQ(view().placement, wanted);
  EXPECT_TRUE(snapshot_.scene->description.cloth().placement.isNone());
  EXPECT_EQ(ask({.kind = Request::Keep}).requests.size(), 1U);
  EXPECT_EQ(snapshot_.scene->description.cloth().placement, wanted);
  EXPECT_TRUE(ask({.kind = Request::Keep}).requests.empty());
}

TEST_F(PlacingInWindow, TwoPlacementsInARowBothCount) {
  send(KeyEvent{Key::G});
  UiOutput output;
  controller_.placing().on({.kind = Request::Place, .placement = {Vec3(0.3, 0, 0), Vec3::Zero(), 1.0}}, snapshot_,
                           output);
  EXPECT_TRUE(controller_.placing().isBuilding());
  EXPECT_EQ(controller_.placing().placements(snapshot_).cloths[0].position, Vec3(0.3, 0, 0));
  EXPECT_EQ(view().placement.position, Vec3(0.3, 0, 0)) << "although the scene is not there yet";
  controller_.placing().expectNothing();  // the scene could not be built
  EXPECT_TRUE(view().placement.isNone());
}

TEST_F(PlacingInWindow, RefusesAPlacementThatIsTooFarAway) {
  send(KeyEvent{Key::G});
  const UiOutput output = ask({.kind = Request::Place, .placement = {Vec3(1e5, 0, 0), Vec3::Zero(), 1.0}});
  EXPECT_TRUE(output.requests.empty());
  EXPECT_NE(output.hint.english().find("too far"), std::string::npos);
  pull(GizmoHandle::MoveX, Vec2(-1e7, 0.0));
  EXPECT_GE(view().middle.x(), -100.000001);
}

TEST_F(PlacingSphere, AClickChoosesWhatIsThereAndADragTurnsTheView) {
  send(KeyEvent{Key::G});
  EXPECT_EQ(view().thing, scene::Placeable());
  const GizmoPicture picture(controller_.camera(), {372.0, 0.0, 900.0, 690.0});
  const Vec2 onBall = picture.toWindow(Vec3(0.0, 0.5, 0.0));  // below the cloth
  send(MoveEvent{onBall});
  send(PressEvent{.position = onBall});
  letGo();
  EXPECT_EQ(view().thing, (scene::Placeable{scene::Placeable::Kind::Body, 0}));
  const Vec3 eye = controller_.camera().pose().position;
  send(PressEvent{.position = onBall + Vec2(0.0, 60.0)});
  send(MoveEvent{onBall + Vec2(80.0, 60.0)});
  letGo();
  EXPECT_GT((controller_.camera().pose().position - eye).norm(), 0.1);
  EXPECT_EQ(view().thing, (scene::Placeable{scene::Placeable::Kind::Body, 0})) << "a drag chooses nothing";
}

TEST_F(PlacingSphere, AClickOnTheGroundSaysThatItCannotBePlaced) {
  send(KeyEvent{Key::G});
  const GizmoPicture picture(controller_.camera(), {372.0, 0.0, 900.0, 690.0});
  const Vec2 onGround = picture.toWindow(Vec3(0.5, 0.0, 0.6));
  send(MoveEvent{onGround});
  send(PressEvent{.position = onGround});
  EXPECT_EQ(letGo().hint.english().find("The ground cannot be placed"), 0U);
}

TEST_F(PlacingSphere, ABodyIsPlacedWithItsMotionAndStandsOnTheGround) {
  send(KeyEvent{Key::G});
  ask({.kind = Request::Choose, .thing = {scene::Placeable::Kind::Body, 0}});
  ask({.kind = Request::Place, .placement = {Vec3(0.25, 0, 0), Vec3::Zero(), 2.0}});
  EXPECT_TRUE(snapshot_.bodies[0].pose.position.isApprox(Vec3(0.25, 1.4, 0.0), 1e-12));
  EXPECT_EQ(std::get<sim::contact::SphereShape>((*snapshot_.scene->bodies)[0].shape).radius, 0.6);
  ask({.kind = Request::OnGround});
  EXPECT_NEAR(snapshot_.bodies[0].pose.position.y(), snapshot_.scene->groundHeight + 0.6, 2e-6);
  EXPECT_EQ(snapshot_.positions, snapshot_.scene->start.positions) << "the cloth stays";
}

TEST_F(PlacingSphere, ThePreviewOfABodyIsWhereItWillBe) {
  send(KeyEvent{Key::G});
  ask({.kind = Request::Choose, .thing = {scene::Placeable::Kind::Body, 0}});
  const scene::Placement wanted{Vec3(0.25, -0.5, 0.1), Vec3(0, 40, 10), 1.5};
  ask({.kind = Request::Preview, .placement = wanted});
  const session::BodyStatus shown = controller_.placing().shown(snapshot_).bodies[0];
  const double radius = (shown.vertices.at(3)).norm();
  ask({.kind = Request::Keep});
  EXPECT_LT((shown.pose.position - snapshot_.bodies[0].pose.position).norm(), 1e-12);
  EXPECT_LT(shown.pose.rotation.angularDistance(snapshot_.bodies[0].pose.rotation), 1e-7);
  EXPECT_NEAR(radius, sim::contact::surfaceOf((*snapshot_.scene->bodies)[0].shape).positions[3].norm(), 1e-12);
}

TEST_F(PlacingFigure, AFigureIsMovedAndTurnedButNotScaled) {
  send(KeyEvent{Key::G});
  ask({.kind = Request::Choose, .thing = {scene::Placeable::Kind::Body, 0}});
  EXPECT_NE(ask({.kind = Request::UseTool, .tool = PlacingTool::Scale}).hint.english().find("measures"),
            std::string::npos);
  EXPECT_EQ(view().tool, PlacingTool::Move);
  send(KeyEvent{Key::G});
  send(KeyEvent{Key::G});
  EXPECT_EQ(view().tool, PlacingTool::Move) << "the key leaves the scale out";
  const Vec3 before = snapshot_.bodies[0].pose.position;
  ask({.kind = Request::Place, .placement = {Vec3(1, 0, 0), Vec3::Zero(), 1.0}});
  EXPECT_TRUE(snapshot_.bodies[0].pose.position.isApprox(before + Vec3(1, 0, 0), 1e-12));
}

/// A sheet and a closed body from files in centimetres with y up, each with its own unit.
scene::SceneDescription descriptionOfFiles() {
  const auto folder =
      std::filesystem::path(::testing::TempDir()) / ::testing::UnitTest::GetInstance()->current_test_info()->name();
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "sheet.obj") << "v 0 100 0\nv 80 100 0\nv 80 160 0\nv 0 160 9\nf 1 2 3\nf 1 3 4\n";
  std::ofstream(folder / "body.obj") << "v -20 0 0\nv 20 0 0\nv 0 170 0\nv 0 0 -30\n"
                                        "f 1 2 3\nf 2 4 3\nf 4 1 3\nf 1 4 2\n";
  return scene::openParts({.cloth = (folder / "sheet.obj").string(),
                           .bodies = {(folder / "body.obj").string()},
                           .dressed = true,
                           .placed = true,
                           .clothReading = {"cm", "y"},
                           .bodyReadings = {{"cm", "y"}}});
}

class PlacingFiles : public PlacingInWindow {
 protected:
  PlacingFiles() : PlacingInWindow(descriptionOfFiles()) { send(KeyEvent{Key::G}); }

  [[nodiscard]] Eigen::AlignedBox3d boxOfBody() const {
    std::vector<Vec3> positions = sim::contact::surfaceOf((*snapshot_.scene->bodies)[0].shape).positions;
    for (Vec3& position : positions) {
      position = snapshot_.bodies[0].pose.toWorld(position);
    }
    return sim::boundsOf(positions);
  }

  void watch(double now) {
    UiOutput none;
    undo_.watch(snapshot_, snapshot_.settings, true, now, none);
  }

  Undo undo_;
};

TEST_F(PlacingFiles, AnotherUnitOfTheClothIsAppliedAtOnceAndUndone) {
  const Vec3 middle = middleOfCloth();
  watch(0.0);
  watch(1.0);
  EXPECT_EQ(view().reading, (scene::ReadingChoice{"cm", "y"}));
  ask({.kind = Request::Read, .reading = {"inch", "y"}});
  EXPECT_NEAR(sim::boundsOf(snapshot_.positions).sizes().x(), 80.0 * 0.0254, 1e-6);
  EXPECT_LT((middleOfCloth() - middle).norm(), 1e-5);
  EXPECT_EQ(view().reading, (scene::ReadingChoice{"inch", "y"}));
  watch(2.0);
  watch(3.0);
  UiOutput back;
  static_cast<void>(undo_.undo(back));
  apply(back);
  EXPECT_NEAR(sim::boundsOf(snapshot_.positions).sizes().x(), 0.8, 1e-6);
  EXPECT_LT((middleOfCloth() - middle).norm(), 1e-9);
}

TEST_F(PlacingFiles, AnotherUpAxisOfTheBodyIsAppliedAtOnceAndUndone) {
  ask({.kind = Request::Choose, .thing = {scene::Placeable::Kind::Body, 0}});
  const Eigen::AlignedBox3d before = boxOfBody();
  watch(0.0);
  watch(1.0);
  ask({.kind = Request::Read, .reading = {"cm", "z"}});
  EXPECT_NEAR(boxOfBody().sizes().y(), 0.3, 1e-6) << "what was deep is tall";
  EXPECT_LT((boxOfBody().center() - before.center()).norm(), 1e-5);
  watch(2.0);
  watch(3.0);
  UiOutput back;
  EXPECT_NE(undo_.undo(back).english().find("unit and up axis of body"), std::string::npos);
  apply(back);
  EXPECT_LT((boxOfBody().sizes() - before.sizes()).norm(), 1e-9);
  EXPECT_LT((boxOfBody().center() - before.center()).norm(), 1e-9);
}

TEST_F(PlacingFiles, ADroppedBodyIsMovedTurnedAndScaledByTheGizmo) {
  ask({.kind = Request::Choose, .thing = {scene::Placeable::Kind::Body, 0}});
  const Eigen::AlignedBox3d before = boxOfBody();
  pull(GizmoHandle::MoveX, Vec2(70.0, 0.0));
  letGo();
  EXPECT_GT(boxOfBody().center().x(), before.center().x() + 0.02);
  ask({.kind = Request::UseTool, .tool = PlacingTool::Turn});
  pull(GizmoHandle::TurnY, Vec2(40.0, 25.0));
  letGo();
  EXPECT_GT(std::abs(snapshot_.scene->description.bodies[0].placement.rotation.y()), 1.0);
  ask({.kind = Request::Place, .placement = {Vec3::Zero(), Vec3::Zero(), 1.1}});
  EXPECT_NEAR(boxOfBody().sizes().y(), 1.1 * 1.7, 1e-6);
}

}  // namespace
}  // namespace drape::ui
