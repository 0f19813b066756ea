#include "ui/gizmo.hpp"

#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace drape::ui {
namespace {

const UiRect gizmoView{372.0, 0.0, 900.0, 690.0};

/// Looks at the middle of a gizmo from the front, the right and above.
render::Camera obliqueCamera(bool orthographic) {
  return render::Camera({Vec3(2.0, 2.2, 3.0), Vec3(0.2, 1.0, 0.1), 35.0, orthographic});
}

class GizmoOfProjection : public ::testing::TestWithParam<bool> {
 protected:
  /// The point of the middle after a drag of a handle that moves its grip by some window units.
  [[nodiscard]] GizmoChange dragged(PlacingTool tool, GizmoHandle handle, const Vec2& by, bool snaps = false) const {
    const Gizmo gizmo(tool, middle_, 1.0);
    const Vec2 grip = gizmo.gripOf(handle, picture_);
    GizmoDrag drag(gizmo, handle, grip, picture_);
    return drag.to(grip + by, picture_, snaps);
  }

  const Vec3 middle_{0.1, 1.1, 0.0};
  const render::Camera camera_ = obliqueCamera(GetParam());
  const GizmoPicture picture_{camera_, gizmoView};
};

TEST_P(GizmoOfProjection, EveryHandleIsTakenAtItsGrip) {
  for (const PlacingTool tool : {PlacingTool::Move, PlacingTool::Turn, PlacingTool::Scale}) {
    const Gizmo gizmo(tool, middle_, 1.0);
    const std::vector<GizmoHandle> handles = gizmo.handles(picture_);
    EXPECT_EQ(handles.size(), tool == PlacingTool::Move ? 7U : tool == PlacingTool::Turn ? 3U : 1U);
    for (const GizmoHandle handle : handles) {
      EXPECT_EQ(gizmo.handleAt(gizmo.gripOf(handle, picture_), picture_), handle) << static_cast<int>(handle);
    }
    EXPECT_EQ(gizmo.handleAt(picture_.toWindow(middle_) + Vec2(300.0, 0.0), picture_), GizmoHandle::None);
  }
}

TEST_P(GizmoOfProjection, HasTheSameSizeOnTheScreenFromAnywhere) {
  const Gizmo gizmo(PlacingTool::Turn, middle_, 1.0);
  for (const double factor : {0.5, 1.0, 3.0}) {
    render::Camera camera = camera_;
    camera.recentre(middle_);
    camera.zoom(factor);
    const GizmoPicture picture(camera, gizmoView);
    double largest = 0.0;
    for (const Vec2& point : gizmo.outlineOf(GizmoHandle::TurnY, picture)) {
      largest = std::max(largest, (point - picture.toWindow(middle_)).norm());
    }
    EXPECT_NEAR(largest, 96.0, 8.0) << factor;
  }
}

TEST_P(GizmoOfProjection, AnArrowMovesAlongItsAxisOnlyAndStaysUnderTheMouse) {
  const std::array arrows{GizmoHandle::MoveX, GizmoHandle::MoveY, GizmoHandle::MoveZ};
  for (const GizmoHandle arrow : arrows) {
    const Gizmo gizmo(PlacingTool::Move, middle_, 1.0);
    const std::vector<Vec2> outline = gizmo.outlineOf(arrow, picture_);
    const Vec2 along = 60.0 * (outline.back() - outline.front()).normalized();
    const Vec3 move = dragged(PlacingTool::Move, arrow, along).move;
    const Vec3 axis = axisOf(arrow);
    EXPECT_GT(move.dot(axis), 0.01);
    EXPECT_LT((move - move.dot(axis) * axis).norm(), 1e-12);
    // The taken point of the axis is under the mouse again.
    const Vec2 grip = gizmo.gripOf(arrow, picture_);
    const render::Ray ray = picture_.rayThrough(grip + along);
    const render::Ray before = picture_.rayThrough(grip);
    const auto nearest = [&](const render::Ray& each) {
      const double cosine = each.direction.dot(axis);
      const Vec3 offset = each.origin - middle_;
      return (offset.dot(axis) - cosine * offset.dot(each.direction)) / (1.0 - cosine * cosine);
    };
    EXPECT_NEAR(nearest(ray) - nearest(before), move.dot(axis), 1e-9);
  }
}

TEST_P(GizmoOfProjection, ASquareMovesInItsPlaneAndTheMiddleParallelToTheView) {
  const Vec2 by(37.0, -22.0);
  for (const GizmoHandle square : {GizmoHandle::MoveYZ, GizmoHandle::MoveZX, GizmoHandle::MoveXY}) {
    const Vec3 move = dragged(PlacingTool::Move, square, by).move;
    EXPECT_NEAR(move.dot(axisOf(square)), 0.0, 1e-12);
    EXPECT_GT(move.norm(), 0.01);
    const Gizmo gizmo(PlacingTool::Move, middle_, 1.0);
    const Vec2 grip = gizmo.gripOf(square, picture_);
    // The point of the plane under the grip moves to where the mouse is.
    const render::Ray ray = picture_.rayThrough(grip);
    const Vec3 normal = axisOf(square);
    const Vec3 taken = ray.origin + (middle_ - ray.origin).dot(normal) / ray.direction.dot(normal) * ray.direction;
    EXPECT_LT((picture_.toWindow(taken + move) - (grip + by)).norm(), 1e-6);
  }
  const Vec3 move = dragged(PlacingTool::Move, GizmoHandle::MoveView, by).move;
  EXPECT_NEAR(move.dot(picture_.back()), 0.0, 1e-12);
  EXPECT_LT((picture_.toWindow(middle_ + move) - picture_.toWindow(middle_) - by).norm(), 1e-6);
}

TEST_P(GizmoOfProjection, ARingTurnsAboutItsAxisByTheAngleOfTheMouse) {
  for (const GizmoHandle ring : {GizmoHandle::TurnX, GizmoHandle::TurnY, GizmoHandle::TurnZ}) {
    const Gizmo gizmo(PlacingTool::Turn, middle_, 1.0);
    const std::vector<Vec2> outline = gizmo.outlineOf(ring, picture_);
    GizmoDrag drag(gizmo, ring, outline.front(), picture_);
    const std::size_t eighth = outline.size() / 8;
    GizmoChange change;
    for (std::size_t i = 1; i <= 9; ++i) {  // a turn and an eighth
      change = drag.to(outline[(i * eighth) % outline.size()], picture_, false);
      EXPECT_NEAR(change.angle, static_cast<double>(i) * 0.25 * std::numbers::pi, 1e-6);
    }
    EXPECT_EQ(change.axis, axisOf(ring));
    EXPECT_EQ(change.move, Vec3::Zero());
  }
}

TEST_P(GizmoOfProjection, TheKnobScalesByTheDistanceFromTheMiddle) {
  const Gizmo gizmo(PlacingTool::Scale, middle_, 1.0);
  const Vec2 grip = gizmo.gripOf(GizmoHandle::Size, picture_);
  const Vec2 arm = grip - picture_.toWindow(middle_);
  GizmoDrag drag(gizmo, GizmoHandle::Size, grip, picture_);
  EXPECT_NEAR(drag.to(grip + 0.5 * arm, picture_, false).factor, 1.5, 1e-6);
  EXPECT_NEAR(drag.to(grip - 0.25 * arm, picture_, false).factor, 0.75, 1e-6);
  EXPECT_NEAR(drag.to(grip + 0.13 * arm, picture_, true).factor, 1.1, 1e-12);
}

TEST_P(GizmoOfProjection, SnapsToCentimetresAndFiveDegrees) {
  const Vec3 move = dragged(PlacingTool::Move, GizmoHandle::MoveView, Vec2(41.0, 13.0), true).move;
  for (const double part : move) {
    EXPECT_NEAR(part, 0.01 * std::round(part / 0.01), 1e-12);
  }
  EXPECT_GT(move.norm(), 0.01);
  const double angle = dragged(PlacingTool::Turn, GizmoHandle::TurnY, Vec2(25.0, 18.0), true).angle;
  const double step = std::numbers::pi / 36.0;
  EXPECT_NEAR(angle, step * std::round(angle / step), 1e-12);
  EXPECT_GT(std::abs(angle), 0.0);
}

INSTANTIATE_TEST_SUITE_P(Gizmo, GizmoOfProjection, ::testing::Bool(),
                         [](const auto& each) { return each.param ? "Orthographic" : "Perspective"; });

TEST(Gizmo, HidesWhatCannotBeDraggedFromWhereTheEyeIs) {
  for (const bool orthographic : {false, true}) {
    const render::Camera front({Vec3(0.0, 1.0, 3.0), Vec3(0.0, 1.0, 0.0), 35.0, orthographic});
    const GizmoPicture picture(front, gizmoView);
    const auto shown = Gizmo(PlacingTool::Move, Vec3(0.0, 1.0, 0.0), 1.0).handles(picture);
    const std::vector<GizmoHandle> expected{GizmoHandle::MoveView, GizmoHandle::MoveXY, GizmoHandle::MoveX,
                                            GizmoHandle::MoveY};
    EXPECT_EQ(shown, expected);
    const auto rings = Gizmo(PlacingTool::Turn, Vec3(0.0, 1.0, 0.0), 1.0).handles(picture);
    EXPECT_EQ(rings.size(), 3U) << "rings roll where they are seen from their edge";
  }
  const render::Camera away({Vec3(0.0, 1.0, 3.0), Vec3(0.0, 1.0, 5.0), 35.0, false});
  EXPECT_TRUE(Gizmo(PlacingTool::Move, Vec3(0.0, 1.0, 0.0), 1.0).handles(GizmoPicture(away, gizmoView)).empty());
}

TEST(Gizmo, ARingThatIsSeenFromItsEdgeRollsUnderTheMouse) {
  for (const bool orthographic : {false, true}) {
    const render::Camera front({Vec3(0.0, 1.0, 3.0), Vec3(0.0, 1.0, 0.0), 35.0, orthographic});
    const GizmoPicture picture(front, gizmoView);
    const Gizmo gizmo(PlacingTool::Turn, Vec3(0.0, 1.0, 0.0), 1.0);
    const Vec2 grip = picture.toWindow(gizmo.middle());
    GizmoDrag about(gizmo, GizmoHandle::TurnY, grip, picture);
    const GizmoChange change = about.to(grip + Vec2(48.0, 0.0), picture, false);
    EXPECT_NEAR(change.angle, 0.5, 1e-6) << "half a radius to the right";
    EXPECT_EQ(change.axis, Vec3::UnitY());
    const Vec3 turned = Eigen::AngleAxisd(change.angle, change.axis) * Vec3::UnitZ();
    EXPECT_GT(turned.x(), 0.4) << "the near side follows the mouse";
    GizmoDrag over(gizmo, GizmoHandle::TurnX, grip, picture);
    EXPECT_NEAR(over.to(grip + Vec2(0.0, 48.0), picture, false).angle, 0.5, 1e-6);
  }
}

TEST(Gizmo, ADragBeyondTheHorizonOfAPlaneStaysWhereItWas) {
  const render::Camera camera({Vec3(0.0, 1.6, 3.0), Vec3(0.0, 1.0, 0.0), 60.0, false});
  const GizmoPicture picture(camera, gizmoView);
  const Gizmo gizmo(PlacingTool::Move, Vec3(0.0, 0.5, 0.0), 1.0);
  const Vec2 grip = gizmo.gripOf(GizmoHandle::MoveZX, picture);
  GizmoDrag drag(gizmo, GizmoHandle::MoveZX, grip, picture);
  const Vec3 before = drag.to(grip - Vec2(0.0, 20.0), picture, false).move;
  const Vec2 sky(grip.x(), 2.0);
  ASSERT_GT(picture.rayThrough(sky).direction.y(), 0.0);
  EXPECT_EQ(drag.to(sky, picture, false).move, before);
  EXPECT_GT(before.norm(), 0.01);
}

}  // namespace
}  // namespace drape::ui
