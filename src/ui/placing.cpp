#include "ui/placing.hpp"

#include "scene/reading_change.hpp"

#include <algorithm>
#include <cmath>

namespace drape::ui {
namespace {

constexpr double maxDistance = 100.0;  // coordinate of the middle of a thing that is dragged [m]

/// The corners of a box, in the order of three bits.
std::array<Vec3, 8> cornersOf(const Eigen::AlignedBox3d& box) {
  std::array<Vec3, 8> corners;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    corners[i] = {(i & 1U) != 0 ? box.max().x() : box.min().x(), (i & 2U) != 0 ? box.max().y() : box.min().y(),
                  (i & 4U) != 0 ? box.max().z() : box.min().z()};
  }
  return corners;
}

/// The edges of the box around a thing in the window; none when a part of it is behind the eye.
std::vector<std::array<Vec2, 2>> edgesOf(const PlacedShape& shape, const scene::Placement& placement,
                                         const GizmoPicture& picture) {
  std::array<Vec3, 8> corners = cornersOf(shape.box());
  for (Vec3& corner : corners) {
    corner = placement.applied(corner);
    if (picture.directionTo(corner).dot(picture.back()) >= 0.0) {
      return {};
    }
  }
  std::vector<std::array<Vec2, 2>> edges;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    for (const std::size_t bit : {1U, 2U, 4U}) {
      if ((i & bit) == 0) {
        edges.push_back({picture.toWindow(corners[i]), picture.toWindow(corners[i | bit])});
      }
    }
  }
  return edges;
}

/// The placement at the end of a drag.
scene::Placement changed(const scene::Placement& from, const GizmoChange& change, PlacingTool tool,
                         const Vec3& middle) {
  switch (tool) {
    case PlacingTool::Move:
      return movedTo(from, middle, (from.applied(middle) + change.move).cwiseMax(-maxDistance).cwiseMin(maxDistance));
    case PlacingTool::Turn:
      return turnedAbout(from, middle, Eigen::Quaterniond(Eigen::AngleAxisd(change.angle, change.axis)));
    case PlacingTool::Scale:
      return scaledAbout(from, middle, from.scale * change.factor);
  }
  return from;
}

}  // namespace

void Placing::next(const session::Snapshot& snapshot, UiOutput& output) {
  if (drag_) {
    return;
  }
  if (isOn_) {
    const bool scales = scene::whyNotScaled(snapshot.scene->description, thing_).empty();
    tool_ = tool_ == PlacingTool::Move             ? PlacingTool::Turn
            : tool_ == PlacingTool::Turn && scales ? PlacingTool::Scale
                                                   : PlacingTool::Move;
    return;
  }
  begin(!snapshot.paused, output);
}

void Placing::begin(bool wasPlaying, UiOutput& output) {
  isOn_ = true;
  waits_ = false;
  wasPlaying_ = wasPlaying;
  tool_ = PlacingTool::Move;
  output.commands.emplace_back(session::PauseCommand{true});
}

void Placing::end(UiOutput& output) {
  if (isOn_ && wasPlaying_) {
    output.commands.emplace_back(session::PauseCommand{false});
  }
  isOn_ = false;
  cancelDrag();
}

void Placing::forget() {
  expectNothing();
  cancelDrag();
  isOn_ = false;
  thing_ = {};
}

void Placing::follow(const session::Snapshot& snapshot) {
  const scene::SceneDescription& description = snapshot.scene->description;
  const std::vector<scene::Placeable> things = scene::placeablesOf(description);
  if (std::ranges::find(things, thing_) == things.end()) {
    thing_ = {};
    cancelDrag();
  }
  if (expected_ && *expected_ == scene::placementsOf(description)) {
    expected_.reset();
  }
  if (isOn_ && waits_ && !snapshot.paused) {
    isOn_ = false;
    cancelDrag();
  }
  waits_ = snapshot.paused;
}

scene::Placements Placing::placements(const session::Snapshot& snapshot) const {
  scene::Placements present = scene::placementsOf(snapshot.scene->description);
  const bool fits = expected_ && expected_->cloths.size() == present.cloths.size() &&
                    expected_->bodies.size() == present.bodies.size();
  return fits ? *expected_ : present;
}

scene::Placements Placing::shownPlacements(const session::Snapshot& snapshot) const {
  scene::Placements all = placements(snapshot);
  if (edited_) {
    all.of(thing_) = *edited_;
  }
  return all;
}

const session::Snapshot& Placing::shown(const session::Snapshot& snapshot) {
  if (!isOn_) {
    previewScene_.reset();
    return snapshot;
  }
  const scene::Placements wanted = shownPlacements(snapshot);
  if (previewScene_ != snapshot.scene || previewOf_ != snapshot.version || previewed_ != wanted) {
    preview_ = snapshot;
    preview_.version = -2 - ++previews_;  // a version that no snapshot has
    showPlaced(wanted, preview_);
    previewScene_ = snapshot.scene;
    previewOf_ = snapshot.version;
    previewed_ = wanted;
  }
  return preview_;
}

const PlacedShape& Placing::shape(const session::Snapshot& snapshot) {
  if (shapeScene_ != snapshot.scene || shapeThing_ != thing_) {
    shape_ = placedShapeOf(*snapshot.scene, thing_);
    shapeScene_ = snapshot.scene;
    shapeThing_ = thing_;
  }
  return shape_;
}

Vec3 Placing::rawMiddle(const session::Snapshot& snapshot) {
  return shape(snapshot).box().center();
}

void Placing::place(const scene::Placement& placement, const session::Snapshot& snapshot, UiOutput& output) {
  edited_.reset();
  scene::Placements all = placements(snapshot);
  if (all.of(thing_) == placement) {
    return;
  }
  if (!scene::isAllowed(placement)) {
    output.hint = "This is too far from the origin of the scene. Nothing was placed.";
    return;
  }
  all.of(thing_) = placement;
  expect(all);
  output.requests.emplace_back(RebuildSceneRequest{snapshot.settings, std::move(all)});
}

/// Another unit or up axis needs the scene as it is now, so the user waits for the one that is being built.
void Placing::read(const scene::ReadingChoice& reading, const session::Snapshot& snapshot, UiOutput& output) {
  edited_.reset();
  if (isBuilding()) {
    output.hint = "The scene is being built. Try again in a moment.";
    return;
  }
  scene::ReadingChange change = scene::withReading(*snapshot.scene, thing_, reading, rawMiddle(snapshot),
                                                   {snapshot.settings, placements(snapshot)});
  if (!scene::isAllowed(change.placements.of(thing_))) {
    output.hint = "This is too far from the origin of the scene. Nothing was placed.";
    return;
  }
  expect(change.placements);
  output.requests.emplace_back(RebuildSceneRequest{std::move(change.settings), std::move(change.placements)});
}

void Placing::placeOnGround(const session::Snapshot& snapshot, UiOutput& output) {
  if (scene::isPlane(snapshot.scene->description, thing_)) {
    output.hint = "A plane is infinite, so it has no lowest point.";
    return;
  }
  scene::Placement placement = shownPlacements(snapshot).of(thing_);
  const double height = snapshot.scene->groundHeight + gapToGround(snapshot, thing_);
  // Six decimal places, rounded up: the cloth must not begin inside the ground.
  constexpr double places = 1e6;
  constexpr double tolerance = 1e-3;
  const double y = placement.position.y() + height - shape(snapshot).lowest(placement);
  placement.position.y() = std::ceil(y * places - tolerance) / places + 0.0;
  place(placement, snapshot, output);
}

void Placing::use(PlacingTool tool, const session::Snapshot& snapshot, UiOutput& output) {
  const std::string refusal =
      tool == PlacingTool::Scale ? scene::whyNotScaled(snapshot.scene->description, thing_) : std::string();
  if (refusal.empty()) {
    tool_ = tool;
  } else {
    output.hint = refusal;
  }
}

void Placing::on(const PlacingRequest& request, const session::Snapshot& snapshot, UiOutput& output) {
  using Kind = PlacingRequest::Kind;
  if (!isOn_) {
    return;
  }
  switch (request.kind) {
    case Kind::Choose:
      cancelDrag();
      thing_ = request.thing;
      follow(snapshot);
      if (!scene::whyNotScaled(snapshot.scene->description, thing_).empty() && tool_ == PlacingTool::Scale) {
        tool_ = PlacingTool::Move;
      }
      break;
    case Kind::UseTool:
      use(request.tool, snapshot, output);
      break;
    case Kind::Preview:
      edited_ = request.placement;
      break;
    case Kind::Place:
      place(request.placement, snapshot, output);
      break;
    case Kind::Read:
      read(request.reading, snapshot, output);
      break;
    case Kind::Keep:
      if (edited_) {
        place(scene::Placement(*edited_), snapshot, output);
      }
      break;
    case Kind::OnGround:
      placeOnGround(snapshot, output);
      break;
    case Kind::Restore:
      place(scene::writtenPlacementsOf(snapshot.scene->description).of(thing_), snapshot, output);
      break;
    case Kind::End:
      end(output);
      break;
  }
}

bool Placing::press(const Vec2& place, const GizmoPicture& picture, const session::Snapshot& snapshot, double scale) {
  const scene::Placement placement = shownPlacements(snapshot).of(thing_);
  const Gizmo gizmo(tool_, placement.applied(rawMiddle(snapshot)), scale);
  const GizmoHandle handle = gizmo.handleAt(place, picture);
  if (handle == GizmoHandle::None) {
    return false;
  }
  drag_ = Drag{GizmoDrag(gizmo, handle, place, picture), placement};
  return true;
}

void Placing::drag(const Vec2& place, const GizmoPicture& picture, bool snaps) {
  if (drag_) {
    edited_ = changed(drag_->from, drag_->gizmo.to(place, picture, snaps), tool_, shape_.box().center());
  }
}

void Placing::release(const session::Snapshot& snapshot, UiOutput& output) {
  drag_.reset();
  if (edited_) {
    place(scene::Placement(*edited_), snapshot, output);
  }
}

void Placing::cancelDrag() {
  drag_.reset();
  edited_.reset();
}

void Placing::click(const Vec2& place, const GizmoPicture& picture, const session::Snapshot& snapshot,
                    UiOutput& output) {
  const PlacedHit hit = placedHitBy(picture.rayThrough(place), shown(snapshot));
  if (hit.thing) {
    on(PlacingRequest{.kind = PlacingRequest::Kind::Choose, .thing = *hit.thing}, snapshot, output);
  } else {
    output.hint = hit.refusal;
  }
}

std::optional<PlacingView> Placing::view(const session::Snapshot& snapshot, const GizmoPicture& picture, double scale) {
  if (!isOn_) {
    return std::nullopt;
  }
  PlacingView view;
  view.thing = thing_;
  view.tool = tool_;
  view.placement = shownPlacements(snapshot).of(thing_);
  view.rawMiddle = rawMiddle(snapshot);
  view.middle = view.placement.applied(view.rawMiddle);
  view.reading = scene::changeableReading(*snapshot.scene, thing_);
  view.isBuilding = isBuilding();
  view.box = edgesOf(shape(snapshot), view.placement, picture);
  const Gizmo gizmo(tool_, view.middle, scale);
  const GizmoHandle lit = drag_ ? drag_->gizmo.handle() : gizmo.handleAt(mouse_, picture);
  for (const GizmoHandle handle : gizmo.handles(picture)) {
    view.handles.push_back({handle, gizmo.outlineOf(handle, picture), gizmo.gripOf(handle, picture), handle == lit});
  }
  return view;
}

}  // namespace drape::ui
