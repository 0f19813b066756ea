#pragma once

#include "render/camera.hpp"
#include "sim/model/vector.hpp"
#include "ui/placing_view.hpp"
#include "ui/ui_rect.hpp"

#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace drape::ui {

/// The picture in which a gizmo is shown: a camera and a part of the window.
class GizmoPicture {
 public:
  GizmoPicture(const render::Camera& camera, const UiRect& view) : camera_(camera), view_(view) {}

  /// The place of a point in the window.
  [[nodiscard]] Vec2 toWindow(const Vec3& point) const;
  [[nodiscard]] render::Ray rayThrough(const Vec2& place) const;
  /// The direction from the eye to a point, a unit vector.
  [[nodiscard]] Vec3 directionTo(const Vec3& point) const;
  /// Against the direction of the view, a unit vector.
  [[nodiscard]] Vec3 back() const;
  /// The length of a window unit at a point, parallel to the view [m].
  [[nodiscard]] double unitAt(const Vec3& point) const;

 private:
  const render::Camera& camera_;
  UiRect view_;
};

/// The handles that move, turn or scale a thing, about its middle. All lengths on the screen stay the same, whatever
/// the distance. Pure geometry: it neither draws nor knows the thing.
class Gizmo {
 public:
  /// @param middle of the thing [m]  @param scale of lengths on the screen
  Gizmo(PlacingTool tool, Vec3 middle, double scale) : tool_(tool), middle_(std::move(middle)), scale_(scale) {}

  [[nodiscard]] const Vec3& middle() const { return middle_; }

  /// The handles of the tool, except those that cannot be dragged from where the eye is: arrows that point at it, and
  /// squares that are seen from their edge.
  [[nodiscard]] std::vector<GizmoHandle> handles(const GizmoPicture& picture) const;

  /// The outline of a handle in the window. A line has two points, a square four, a ring many.
  [[nodiscard]] std::vector<Vec2> outlineOf(GizmoHandle handle, const GizmoPicture& picture) const;

  /// A place in the window where a press takes this handle.
  [[nodiscard]] Vec2 gripOf(GizmoHandle handle, const GizmoPicture& picture) const;

  /// The handle at a place in the window, or None.
  [[nodiscard]] GizmoHandle handleAt(const Vec2& place, const GizmoPicture& picture) const;

  /// The radius of a ring [m].
  [[nodiscard]] double radius(const GizmoPicture& picture) const;

 private:
  [[nodiscard]] double lengthIn(const GizmoPicture& picture) const;
  [[nodiscard]] double distanceTo(GizmoHandle handle, const Vec2& place, const GizmoPicture& picture) const;

  PlacingTool tool_;
  Vec3 middle_;
  double scale_;
};

/// What a drag of a handle does to a thing, about its middle at the start of the drag.
struct GizmoChange {
  Vec3 move = Vec3::Zero();  ///< [m]
  Vec3 axis = Vec3::UnitY();
  double angle = 0.0;   ///< about that axis [rad]
  double factor = 1.0;  ///< of the size [-]
};

/// A drag of a handle. The change follows the mouse exactly: the point that was taken stays under it, on the axis, in
/// the plane or on the ring of the handle. A ring that is seen from its edge rolls under the mouse instead. Where the
/// mouse does not reach them, the change stays as it was.
class GizmoDrag {
 public:
  GizmoDrag(const Gizmo& gizmo, GizmoHandle handle, const Vec2& at, const GizmoPicture& picture);

  [[nodiscard]] GizmoHandle handle() const { return handle_; }

  /// @param snaps to steps of 1 cm, 5 degrees or 10 %
  [[nodiscard]] GizmoChange to(const Vec2& at, const GizmoPicture& picture, bool snaps);

 private:
  [[nodiscard]] std::optional<Vec3> pointUnder(const Vec2& at, const GizmoPicture& picture) const;
  void turnTo(const Vec3& point);

  GizmoHandle handle_;
  Vec3 middle_;
  Vec3 normal_;                // of the plane in which the mouse moves; for an arrow its axis
  Vec3 axis_;                  // of a ring
  double rollRadius_ = 0.0;    // of a ring that rolls under the mouse; 0: it does not [m]
  std::optional<Vec3> taken_;  // the point that was taken
  Vec3 moved_ = Vec3::Zero();  // since then [m]
  double turned_ = 0.0;        // since then [rad]; more than a turn is possible
  double factor_ = 1.0;
};

/// The axis of an arrow or a ring, or the normal of a plane; zero for the others.
[[nodiscard]] Vec3 axisOf(GizmoHandle handle);

}  // namespace drape::ui
