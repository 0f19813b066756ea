#include "ui/interaction_controller.hpp"

#include "render/picking.hpp"
#include "sim/model/bounds.hpp"
#include "ui/body_picking.hpp"
#include "ui/pin_keys.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <numbers>
#include <utility>

namespace drape::ui {
namespace {

constexpr double doubleClickTime = 0.35;     // [s]
constexpr double doubleClickDistance = 5.0;  // [window units]
constexpr double clickDistance = 4.0;        // [window units]
constexpr double zoomPerNotch = 0.88;        // factor of the distance
constexpr double turnPerHeight =
    std::numbers::pi;  // a drag over the whole height of the view turns by half a circle [rad]

std::optional<render::Hit> clothHitBy(const render::Ray& ray, const session::Snapshot& snapshot) {
  return render::pick(ray, snapshot.positions, snapshot.model->triangles);
}

/// A body under the mouse pointer.
struct BodyHit {
  std::size_t body = 0;
  render::Hit hit;
};

/// The first body that a ray hits. Infinite planes are ignored.
std::optional<BodyHit> bodyHitBy(const render::Ray& ray, const session::Snapshot& snapshot) {
  std::optional<BodyHit> nearest;
  for (std::size_t i = 0; i < snapshot.bodies.size(); ++i) {
    const session::BodyStatus& status = snapshot.bodies[i];
    const sim::contact::Body& body = (*snapshot.scene->bodies)[i];
    if (!status.on || !body.drawn || !snapshot.settings.step.contact.bodies ||
        std::holds_alternative<sim::contact::PlaneShape>(body.shape)) {
      continue;
    }
    const std::optional<render::Hit> hit = pickBody(ray, body, status);
    if (hit && (!nearest || hit->distance < nearest->hit.distance)) {
      nearest = BodyHit{i, *hit};
    }
  }
  return nearest;
}

/// The bounds for the camera: around the cloth now and at its start.
render::CameraBounds boundsAround(const session::Snapshot& snapshot, const scene::CameraPose& pose) {
  Eigen::AlignedBox3d box = sim::boundsOf(snapshot.scene->start.positions);
  box.extend(sim::boundsOf(snapshot.positions));
  return render::boundsFor(box, snapshot.scene->groundHeight, pose);
}

/// What to do where vertices must be selected first.
text::Sentence howToSelect(SelectionMode mode) {
  switch (mode) {
    case SelectionMode::Rectangle:
      return text::Sentence("No vertices are selected: drag a rectangle over some, or click one");
    case SelectionMode::Border:
      return text::Sentence("No vertices are selected: click near an open border");
    case SelectionMode::Off:
      break;
  }
  return text::Sentence("No vertices are selected: B selects by a rectangle, L a border");
}

}  // namespace

void InteractionController::handle(const InputEvent& event, const session::Snapshot& snapshot, UiOutput& output) {
  const auto holdsOtherScene = [&](const auto& gesture) {
    if constexpr (requires { gesture.scene; }) {
      return gesture.scene != snapshot.scene;
    }
    return false;
  };
  if (std::visit(holdsOtherScene, gesture_)) {
    gesture_ = Idle{};  // another scene is running, so what the gesture held is gone
  }
  std::visit([&](const auto& each) { on(each, snapshot, output); }, event);
}

void InteractionController::lookAtScene(const scene::Scene& scene) {
  camera_.moveTo(scene.camera);
  camera_.zoom(zoomOfScenes());
}

scene::CameraPose InteractionController::viewForScene() const {
  render::Camera camera = camera_;
  camera.zoom(1.0 / zoomOfScenes());
  return camera.pose();
}

double InteractionController::zoomOfScenes() const {
  constexpr double authorsAspect = 4.0 / 3.0;
  return std::max(1.0, authorsAspect * view_.height / view_.width);
}

void InteractionController::frameCloth(const session::Snapshot& snapshot) {
  if (snapshot.positions.empty()) {
    return;
  }
  Eigen::AlignedBox3d box = sim::boundsOf(snapshot.positions);
  if (snapshot.ghost) {
    const Eigen::AlignedBox3d ghost = sim::boundsOf(snapshot.ghost->positions);
    box.extend(ghost.translated(Vec3(snapshot.settings.ghost.offset, 0.0, 0.0)));
  }
  camera_.frame(box.min(), box.max(), view_.width / view_.height);
}

void InteractionController::lookFrom(render::Camera::Side side, const session::Snapshot& snapshot) {
  moveCamera(snapshot, [&](render::Camera& camera) { camera.lookFrom(side); });
}

bool InteractionController::moveCamera(UiAction action, const session::Snapshot& snapshot) {
  switch (action) {
    case UiAction::FrameCloth:
      frameCloth(snapshot);
      return true;
    case UiAction::ViewFront:
      lookFrom(render::Camera::Side::Front, snapshot);
      return true;
    case UiAction::ViewRight:
      lookFrom(render::Camera::Side::Right, snapshot);
      return true;
    case UiAction::ViewTop:
      lookFrom(render::Camera::Side::Top, snapshot);
      return true;
    case UiAction::ToggleProjection:
      camera_.useOrthographic(!camera_.isOrthographic());
      return true;
    case UiAction::ToggleTurntable:
      turns_ = !turns_;
      return true;
    default:
      return false;
  }
}

void InteractionController::moveCamera(const session::Snapshot& snapshot,
                                       const std::function<void(render::Camera&)>& move) {
  if (snapshot.positions.empty()) {
    return;
  }
  const render::CameraBounds bounds = boundsAround(snapshot, camera_.pose());
  move(camera_);
  camera_.keepWithin(bounds);
}

void InteractionController::turn(double seconds, const session::Snapshot& snapshot) {
  if (turns_) {
    constexpr double turnTime = 12.0;  // [s]
    moveCamera(snapshot,
               [&](render::Camera& camera) { camera.orbit(2.0 * std::numbers::pi * seconds / turnTime, 0.0); });
  }
}

VertexSelection::Projection InteractionController::toWindow() const {
  return [this](const Vec3& point) {
    return Vec2(camera_.project(point, static_cast<int>(view_.width), static_cast<int>(view_.height)) +
                Vec2(view_.x, view_.y));
  };
}

SelectionView InteractionController::selection(const session::Snapshot& snapshot) {
  selection_.follow(snapshot);
  return selection_.view(snapshot, toWindow());
}

bool InteractionController::select(UiAction action, const session::Snapshot& snapshot, UiOutput& output) {
  selection_.follow(snapshot);
  const std::vector<int>& vertices = selection_.vertices();
  const auto pin = [&](bool pinned) {
    if (vertices.empty()) {
      output.hint = howToSelect(selection_.mode());
    } else {
      output.commands.emplace_back(pinsWith(snapshot, vertices, pinned));
    }
  };
  switch (action) {
    case UiAction::SelectRectangle:
      placing_.end(output);
      sewing_.end();
      selection_.use(SelectionMode::Rectangle);
      return true;
    case UiAction::SelectBorder:
      placing_.end(output);
      sewing_.end();
      selection_.use(SelectionMode::Border);
      return true;
    case UiAction::PinSelected:
      pin(true);
      return true;
    case UiAction::ReleaseSelected:
      pin(false);
      return true;
    case UiAction::TogglePinsSelected:
      pin(!std::ranges::all_of(vertices, [&](int vertex) { return snapshot.model->pinned[vertex]; }));
      return true;
    case UiAction::EndSelection:
      selection_.use(SelectionMode::Off);
      selection_.clear();
      return true;
    default:
      return false;
  }
}

bool InteractionController::place(UiAction action, const session::Snapshot& snapshot, UiOutput& output) {
  if (action != UiAction::Place) {
    return false;
  }
  selection_.use(SelectionMode::Off);
  selection_.clear();
  sewing_.end();
  placing_.next(snapshot, output);
  return true;
}

void InteractionController::startPlacing(bool wasPlaying, UiOutput& output) {
  selection_.use(SelectionMode::Off);
  selection_.clear();
  sewing_.end();
  placing_.begin(wasPlaying, output);
}

bool InteractionController::sew(UiAction action, UiOutput& output) {
  if (action != UiAction::Sew && action != UiAction::SetBand) {
    return false;
  }
  selection_.use(SelectionMode::Off);
  selection_.clear();
  placing_.end(output);
  sewing_.start(action == UiAction::Sew ? SewingKind::Seam : SewingKind::Band);
  return true;
}

std::optional<SewingView> InteractionController::sewingView(const session::Snapshot& snapshot) {
  return sewing_.view(snapshot, GizmoPicture(camera_, view_), scale_);
}

std::optional<PlacingView> InteractionController::placingView(const session::Snapshot& snapshot) {
  return placing_.view(snapshot, GizmoPicture(camera_, view_), scale_);
}

/// Takes a handle of the gizmo, or turns or moves the view. In the mode Sew a press that does not move picks a border.
void InteractionController::pressInPlace(const PressEvent& event, const session::Snapshot& snapshot) {
  pressed_ = event.position;
  pressedWithShift_ = event.shift;
  if (placing_.isOn() && placing_.press(event.position, GizmoPicture(camera_, view_), snapshot, scale_)) {
    gesture_ = Placed{};
  } else if (event.shift) {
    gesture_ = Panning{};
  } else {
    gesture_ = Orbiting{};
    turns_ = false;
  }
}

/// A press beside the gizmo that did not turn the view chooses the thing there.
void InteractionController::clickInPlace(const session::Snapshot& snapshot, UiOutput& output) {
  if ((mouse_ - pressed_).norm() < clickDistance) {
    placing_.click(mouse_, GizmoPicture(camera_, view_), snapshot, output);
  }
}

/// A press that did not turn or move the view picks the border there.
void InteractionController::clickInSewing(const session::Snapshot& snapshot) {
  if ((mouse_ - pressed_).norm() < clickDistance) {
    sewing_.click(mouse_, pressedWithShift_, snapshot, GizmoPicture(camera_, view_), scale_);
  }
}

render::Ray InteractionController::rayThrough(const Vec2& position) const {
  return camera_.rayThrough(position.x() - view_.x, position.y() - view_.y, static_cast<int>(view_.width),
                            static_cast<int>(view_.height));
}

Vec3 InteractionController::movedTo(const Vec2& position, const Vec3& point) const {
  return camera_.pointAtDepthOf(point, position.x() - view_.x, position.y() - view_.y, static_cast<int>(view_.width),
                                static_cast<int>(view_.height));
}

void InteractionController::on(const PressEvent& event, const session::Snapshot& snapshot, UiOutput& output) {
  mouse_ = event.position;
  if (!std::holds_alternative<Idle>(gesture_)) {
    return;  // one gesture at a time; another button does not end it
  }
  if (event.button == MouseButton::Right && placing_.isOn()) {
    return;
  }
  if (event.button == MouseButton::Right) {
    pickVertex(event, snapshot, output);
    return;
  }
  gestureButton_ = event.button;
  if (event.button == MouseButton::Left) {
    pressLeft(event, snapshot, output);
  } else if (event.button == MouseButton::Middle) {
    gesture_ = Panning{};
  }
}

void InteractionController::pressLeft(const PressEvent& event, const session::Snapshot& snapshot, UiOutput& output) {
  if (placing_.isOn() || sewing_.isOn()) {
    pressInPlace(event, snapshot);
  } else if (selection_.mode() != SelectionMode::Off) {
    if (holdPins(event, snapshot)) {
      return;
    }
    using Change = VertexSelection::Change;
    selection_.press(event.position, event.control ? Change::Remove : event.shift ? Change::Add : Change::Replace);
    gesture_ = Selecting{};
  } else if (event.shift) {
    gesture_ = Panning{};
  } else if (!recentreOnDoubleClick(event, snapshot) && !attach(event, snapshot, output) && !event.control) {
    gesture_ = Orbiting{};
    turns_ = false;
  }
}

/// Starts to drag the selected pins when the mouse is on one of them.
bool InteractionController::holdPins(const PressEvent& event, const session::Snapshot& snapshot) {
  constexpr double reach = 7.0;  // [window units]
  selection_.follow(snapshot);
  const std::vector<int> pins = pinnedOf(snapshot, selection_.vertices());
  const VertexSelection::Projection projected = toWindow();
  const auto distance = [&](int pin) { return (projected(snapshot.positions[pin]) - event.position).norm(); };
  const auto nearest = std::ranges::min_element(pins, {}, distance);
  if (event.shift || event.control || nearest == pins.end() || distance(*nearest) > reach) {
    return false;
  }
  MovingPins moving{pins, {}, snapshot.positions[*nearest], snapshot.scene};
  std::ranges::transform(pins, std::back_inserter(moving.places), [&](int pin) { return snapshot.positions[pin]; });
  gesture_ = std::move(moving);
  return true;
}

bool InteractionController::recentreOnDoubleClick(const PressEvent& event, const session::Snapshot& snapshot) {
  const bool isDouble = lastLeftPress_ && event.time - lastLeftPress_->time < doubleClickTime &&
                        (event.position - lastLeftPress_->position).norm() < doubleClickDistance;
  lastLeftPress_ = event;
  if (!isDouble) {
    return false;
  }
  lastLeftPress_.reset();  // a third click is not a second double click
  if (const auto hit = clothHitBy(rayThrough(event.position), snapshot)) {
    camera_.recentre(hit->point);
  }
  return true;
}

/// Picks the vertex nearest to the point of the cloth under the mouse, unless a body hides it.
void InteractionController::pickVertex(const PressEvent& event, const session::Snapshot& snapshot,
                                       UiOutput& output) const {
  const render::Ray ray = rayThrough(event.position);
  const auto hit = clothHitBy(ray, snapshot);
  const auto body = bodyHitBy(ray, snapshot);
  if (!hit || (body && body->hit.distance < hit->distance)) {
    return;
  }
  Eigen::Index corner = 0;
  hit->barycentric.maxCoeff(&corner);
  output.requests.emplace_back(
      PickVertexRequest{snapshot.model->triangles[hit->triangle][static_cast<std::size_t>(corner)]});
}

/// Starts to drag the nearest thing under the mouse: the cloth or a body.
bool InteractionController::attach(const PressEvent& event, const session::Snapshot& snapshot, UiOutput& output) {
  const render::Ray ray = rayThrough(event.position);
  const auto hit = clothHitBy(ray, snapshot);
  const auto body = bodyHitBy(ray, snapshot);
  if (body && (!hit || body->hit.distance < hit->distance)) {
    gesture_ =
        MovingBody{static_cast<int>(body->body), body->hit.point, snapshot.bodies[body->body].shift, snapshot.scene};
    return true;
  }
  if (!hit) {
    return false;
  }
  output.commands.emplace_back(session::AttachCommand{{hit->triangle, hit->barycentric, hit->point}});
  gesture_ = Pulling{hit->point, snapshot.scene};
  return true;
}

void InteractionController::endGesture(UiOutput& output) {
  if (holdsCloth()) {
    output.commands.emplace_back(session::DetachCommand{});
  }
  selection_.cancelDrag();
  placing_.cancelDrag();
  gesture_ = Idle{};
}

void InteractionController::on(const ReleaseEvent& event, const session::Snapshot& snapshot, UiOutput& output) {
  if (event.button == gestureButton_) {
    if (std::holds_alternative<Selecting>(gesture_)) {
      selection_.release(snapshot, toWindow());
    } else if (std::holds_alternative<Placed>(gesture_)) {
      placing_.release(snapshot, output);
    } else if (std::holds_alternative<Orbiting>(gesture_) && placing_.isOn()) {
      clickInPlace(snapshot, output);
    } else if (sewing_.isOn() && event.button == MouseButton::Left) {
      clickInSewing(snapshot);
    }
    endGesture(output);
  }
}

void InteractionController::on(const MoveEvent& event, const session::Snapshot& snapshot, UiOutput& output) {
  const Vec2 moved = (event.position - mouse_) / view_.height;
  mouse_ = event.position;
  placing_.hover(event.position);
  sewing_.hover(event.position, view_.contains(event.position));
  if (std::holds_alternative<Placed>(gesture_)) {
    placing_.drag(event.position, GizmoPicture(camera_, view_), event.control);
  } else if (std::holds_alternative<Orbiting>(gesture_)) {
    moveCamera(snapshot,
               [&](render::Camera& camera) { camera.orbit(-moved.x() * turnPerHeight, moved.y() * turnPerHeight); });
  } else if (std::holds_alternative<Panning>(gesture_)) {
    moveCamera(snapshot, [&](render::Camera& camera) { camera.pan(-moved.x(), moved.y()); });
  } else if (std::holds_alternative<Selecting>(gesture_)) {
    selection_.drag(event.position);
  } else if (const auto* pulling = std::get_if<Pulling>(&gesture_)) {
    output.commands.emplace_back(session::MoveAttachmentCommand{movedTo(event.position, pulling->point)});
  } else if (const auto* moving = std::get_if<MovingBody>(&gesture_)) {
    const Vec3 target = movedTo(event.position, moving->point);
    output.commands.emplace_back(session::MoveBodyCommand{moving->body, moving->shift + target - moving->point});
  } else if (const auto* pins = std::get_if<MovingPins>(&gesture_)) {
    const Vec3 by = movedTo(event.position, pins->point) - pins->point;
    session::PlacePinsCommand command{pins->pins, pins->places};
    std::ranges::for_each(command.places, [&](Vec3& place) { place += by; });
    output.commands.emplace_back(std::move(command));
  }
}

void InteractionController::on(const ScrollEvent& event, const session::Snapshot& snapshot, UiOutput& /*output*/) {
  moveCamera(snapshot, [&](render::Camera& camera) { camera.zoom(std::pow(zoomPerNotch, event.amount)); });
}

void InteractionController::on(const KeyEvent& event, const session::Snapshot& snapshot, UiOutput& output) {
  // While Ctrl + drag pulls the cloth, the keys act as without Ctrl.
  const Shortcut* shortcut = findShortcut(event.key, event.control && !holdsCloth(), event.shift);
  if (shortcut == nullptr || (event.repeated && !shortcut->repeats)) {
    return;
  }
  if (event.key == Key::Escape && leaveMode(snapshot, output)) {
    return;
  }
  if (event.key == Key::P && !event.control && !holdsCloth() && selects()) {
    select(UiAction::TogglePinsSelected, snapshot, output);
    return;
  }
  const auto* action = std::get_if<UiAction>(&shortcut->action);
  if (action == nullptr || !(moveCamera(*action, snapshot) || select(*action, snapshot, output) ||
                             place(*action, snapshot, output) || sew(*action, output))) {
    request(*shortcut, snapshot, output);
  }
}

/// What Esc does to gestures and modes. @return false if there are none
bool InteractionController::leaveMode(const session::Snapshot& snapshot, UiOutput& output) {
  if (holdsCloth() || holdsBody()) {
    endGesture(output);
    return true;
  }
  if (placing_.isOn()) {
    if (!placing_.isDragging()) {
      placing_.end(output);
    }
    endGesture(output);
    return true;
  }
  if (sewing_.isOn()) {
    endGesture(output);
    if (!sewing_.cancel()) {
      sewing_.end();
    }
    return true;
  }
  if (selects()) {
    endGesture(output);
    select(UiAction::EndSelection, snapshot, output);
    return true;
  }
  return false;
}

void InteractionController::on(const FocusLostEvent& /*event*/, const session::Snapshot& /*snapshot*/,
                               UiOutput& output) {
  endGesture(output);
}

}  // namespace drape::ui
