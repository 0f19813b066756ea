#pragma once

#include "session/snapshot.hpp"
#include "ui/gizmo.hpp"
#include "ui/placed_shape.hpp"
#include "ui/ui_output.hpp"

#include <memory>
#include <optional>

namespace drape::ui {

/// The mode Place: moves, turns and scales a cloth or a body of the scene by a gizmo. Meanwhile the clock waits, and
/// the picture shows the start of the scene. A finished drag becomes a RebuildSceneRequest with the new placements;
/// until the scene is built, the picture shows a preview.
class Placing {
 public:
  [[nodiscard]] bool isOn() const { return isOn_; }
  [[nodiscard]] bool isDragging() const { return drag_.has_value(); }
  /// Whether the scene with the last placement is not there yet.
  [[nodiscard]] bool isBuilding() const { return expected_.has_value(); }

  /// Starts the mode. The clock goes on at its end if it ran before. @param wasPlaying whether it did
  void begin(bool wasPlaying, UiOutput& output);
  /// Whether the clock ran before the mode.
  [[nodiscard]] bool wasPlaying() const { return wasPlaying_; }
  /// Starts the mode, or takes the next tool.
  void next(const session::Snapshot& snapshot, UiOutput& output);
  /// Ends the mode. The clock goes on if it ran before.
  void end(UiOutput& output);
  void on(const PlacingRequest& request, const session::Snapshot& snapshot, UiOutput& output);

  /// Another scene was opened.
  void forget();
  /// The scene is being built with these placements.
  void expect(const scene::Placements& placements) { expected_ = placements; }
  /// The scene could not be built with them, or the user cancelled it.
  void expectNothing() { expected_.reset(); }

  /// Call it once a frame. The mode ends when the clock runs again.
  void follow(const session::Snapshot& snapshot);

  /// The placements of the scene, with those that are being built.
  [[nodiscard]] scene::Placements placements(const session::Snapshot& snapshot) const;

  /// The snapshot for the picture: in this mode the start of the scene with the placement that is being changed.
  [[nodiscard]] const session::Snapshot& shown(const session::Snapshot& snapshot);

  /// Takes the handle at a place in the window. False if there is none.
  [[nodiscard]] bool press(const Vec2& place, const GizmoPicture& picture, const session::Snapshot& snapshot,
                           double scale);
  void drag(const Vec2& place, const GizmoPicture& picture, bool snaps);
  /// Ends the drag and asks for the scene with the new placement.
  void release(const session::Snapshot& snapshot, UiOutput& output);
  /// Takes the drag back.
  void cancelDrag();
  /// Lights the handle at a place.
  void hover(const Vec2& place) { mouse_ = place; }
  /// Chooses the thing at a place.
  void click(const Vec2& place, const GizmoPicture& picture, const session::Snapshot& snapshot, UiOutput& output);

  /// For the window. Empty while the mode is off. @param scale of lengths on the screen
  [[nodiscard]] std::optional<PlacingView> view(const session::Snapshot& snapshot, const GizmoPicture& picture,
                                                double scale);

 private:
  /// A drag that is under way.
  struct Drag {
    GizmoDrag gizmo;
    scene::Placement from;
  };

  [[nodiscard]] scene::Placements shownPlacements(const session::Snapshot& snapshot) const;
  [[nodiscard]] Vec3 rawMiddle(const session::Snapshot& snapshot);
  const PlacedShape& shape(const session::Snapshot& snapshot);
  void place(const scene::Placement& placement, const session::Snapshot& snapshot, UiOutput& output);
  void read(const scene::ReadingChoice& reading, const session::Snapshot& snapshot, UiOutput& output);
  void placeOnGround(const session::Snapshot& snapshot, UiOutput& output);
  void use(PlacingTool tool, const session::Snapshot& snapshot, UiOutput& output);

  bool isOn_ = false;
  bool wasPlaying_ = false;  // before the mode
  bool waits_ = false;       // whether the clock has stopped since
  PlacingTool tool_ = PlacingTool::Move;
  scene::Placeable thing_;
  std::optional<Drag> drag_;
  std::optional<scene::Placement> edited_;     // of the thing, until the drag ends
  std::optional<scene::Placements> expected_;  // of the scene that is being built
  Vec2 mouse_ = Vec2::Constant(-1.0);

  // What follows from the scene and the thing.
  std::shared_ptr<const scene::Scene> shapeScene_;
  scene::Placeable shapeThing_;
  PlacedShape shape_;

  // The picture, and what it follows from.
  session::Snapshot preview_;
  std::int64_t previewOf_ = -1;  // version of the snapshot
  std::shared_ptr<const scene::Scene> previewScene_;
  scene::Placements previewed_;
  std::int64_t previews_ = 0;
};

}  // namespace drape::ui
