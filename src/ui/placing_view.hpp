#pragma once

#include "scene/placements.hpp"
#include "sim/model/vector.hpp"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace drape::ui {

/// What a drag in the picture does to the thing that is placed.
enum class PlacingTool { Move, Turn, Scale };

/// The parts of the gizmo (ui/gizmo.hpp).
enum class GizmoHandle {
  None,
  MoveX,  ///< along an axis
  MoveY,
  MoveZ,
  MoveYZ,  ///< in a plane
  MoveZX,
  MoveXY,
  MoveView,  ///< parallel to the view
  TurnX,     ///< about an axis
  TurnY,
  TurnZ,
  Size
};

/// A handle of the gizmo, as it is drawn.
struct GizmoLine {
  GizmoHandle handle = GizmoHandle::None;
  std::vector<Vec2> outline;  ///< [window units]
  Vec2 grip = Vec2::Zero();   ///< where a press takes it [window units]
  bool isLit = false;         ///< under the mouse, or dragged
};

/// The state of the mode Place, for the window.
struct PlacingView {
  scene::Placeable thing;
  PlacingTool tool = PlacingTool::Move;
  scene::Placement placement;     ///< as it is shown: with the drag that is under way
  Vec3 middle = Vec3::Zero();     ///< of the box around the thing, so placed [m]
  Vec3 rawMiddle = Vec3::Zero();  ///< the same without the placement [m]
  /// The unit and the up axis with which its file is read, if the user can change them.
  std::optional<scene::ReadingChoice> reading = std::nullopt;
  bool isBuilding = false;               ///< whether the scene with this placement is not there yet
  std::vector<GizmoLine> handles;        ///< in the order in which they are drawn
  std::vector<std::array<Vec2, 2>> box;  ///< the edges of the box around the thing [window units]
};

}  // namespace drape::ui
