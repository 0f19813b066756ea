#pragma once

#include "render/camera.hpp"
#include "session/snapshot.hpp"
#include "ui/placing.hpp"
#include "ui/sewing_mode.hpp"
#include "ui/shortcuts.hpp"
#include "ui/ui_output.hpp"
#include "ui/vertex_selection.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <variant>

namespace drape::ui {

enum class MouseButton { Left, Middle, Right };

struct PressEvent {
  MouseButton button = MouseButton::Left;
  Vec2 position = Vec2::Zero();  ///< window units
  bool shift = false;
  bool control = false;
  double time = 0.0;  ///< [s]
};
struct ReleaseEvent {
  MouseButton button = MouseButton::Left;
};
struct MoveEvent {
  Vec2 position = Vec2::Zero();  ///< window units
  bool control = false;          ///< whether Ctrl is held
};
struct ScrollEvent {
  double amount = 0.0;  ///< notches, positive away from the user
};
struct KeyEvent {
  Key key = Key::Space;
  bool repeated = false;  ///< a repeat of a held key
  bool control = false;   ///< whether Ctrl is held
  bool shift = false;
};
/// The window lost the keyboard focus, which ends all gestures.
struct FocusLostEvent {};

using InputEvent = std::variant<PressEvent, ReleaseEvent, MoveEvent, ScrollEvent, KeyEvent, FocusLostEvent>;

/// Turns mouse and keyboard events into commands and camera moves. Independent of the window system.
class InteractionController {
 public:
  [[nodiscard]] const render::Camera& camera() const { return camera_; }

  /// The part of the window with the picture. @param scale of lengths on the screen
  void setView(const UiRect& view, double scale = 1.0) {
    view_ = view;
    scale_ = scale;
  }

  void handle(const InputEvent& event, const session::Snapshot& snapshot, UiOutput& output);

  /// Takes the author's view of a scene, from farther away when the picture is too narrow.
  void lookAtScene(const scene::Scene& scene);
  /// The present view for a scene file: lookAtScene restores it in a picture of the same shape.
  [[nodiscard]] scene::CameraPose viewForScene() const;
  /// Moves the camera so that the cloth at its current position fills the view.
  void frameCloth(const session::Snapshot& snapshot);
  /// Looks from a side, never from below the ground.
  void lookFrom(render::Camera::Side side, const session::Snapshot& snapshot);
  /// Moves the camera when the action does that. False for other actions.
  bool moveCamera(UiAction action, const session::Snapshot& snapshot);

  /// Puts the camera there.
  void recall(const render::Camera& camera) { camera_ = camera; }

  /// Turns the camera as a turntable, if it is one. @param seconds since the last call
  void turn(double seconds, const session::Snapshot& snapshot);
  [[nodiscard]] bool turns() const { return turns_; }

  /// Selects vertices, or pins or releases the selected ones, when the action does that. False for other actions.
  bool select(UiAction action, const session::Snapshot& snapshot, UiOutput& output);
  /// The selected vertices, for the window.
  [[nodiscard]] SelectionView selection(const session::Snapshot& snapshot);
  [[nodiscard]] bool selects() const { return selection_.isActive(); }

  /// Starts the mode Place, or takes its next tool, when the action does that. False for other actions.
  bool place(UiAction action, const session::Snapshot& snapshot, UiOutput& output);
  /// Starts the mode Place. @param wasPlaying whether the clock goes on at its end
  void startPlacing(bool wasPlaying, UiOutput& output);
  [[nodiscard]] Placing& placing() { return placing_; }
  [[nodiscard]] const Placing& placing() const { return placing_; }
  /// The mode Place, for the window; empty while it is off.
  [[nodiscard]] std::optional<PlacingView> placingView(const session::Snapshot& snapshot);

  /// Starts the mode Sew when the action does that. False for other actions.
  bool sew(UiAction action, UiOutput& output);
  [[nodiscard]] SewingMode& sewing() { return sewing_; }
  /// The mode Sew, for the window; empty while it is off.
  [[nodiscard]] std::optional<SewingView> sewingView(const session::Snapshot& snapshot);

  /// Whether a gesture drags a body.
  [[nodiscard]] bool holdsBody() const { return std::holds_alternative<MovingBody>(gesture_); }
  [[nodiscard]] bool holdsCloth() const { return std::holds_alternative<Pulling>(gesture_); }

 private:
  struct Idle {};
  struct Orbiting {};
  struct Panning {};
  struct Selecting {};
  struct Placed {};  ///< drags a handle of the gizmo
  struct Pulling {
    Vec3 point = Vec3::Zero();                  ///< the attached point [m]; sets the depth of the drag
    std::shared_ptr<const scene::Scene> scene;  ///< at the start of the gesture
  };

  struct MovingBody {
    int body = 0;
    Vec3 point = Vec3::Zero();  ///< the point that was hit [m]
    Vec3 shift = Vec3::Zero();  ///< shift of the body at the start of the gesture [m]
    std::shared_ptr<const scene::Scene> scene;
  };

  struct MovingPins {
    std::vector<int> pins;
    std::vector<Vec3> places;   ///< of the pins at the start of the gesture [m]
    Vec3 point = Vec3::Zero();  ///< of the pin that was hit [m]
    std::shared_ptr<const scene::Scene> scene;
  };

  void on(const PressEvent& event, const session::Snapshot& snapshot, UiOutput& output);
  void on(const ReleaseEvent& event, const session::Snapshot& snapshot, UiOutput& output);
  void on(const MoveEvent& event, const session::Snapshot& snapshot, UiOutput& output);
  void on(const ScrollEvent& event, const session::Snapshot& snapshot, UiOutput& output);
  void on(const KeyEvent& event, const session::Snapshot& snapshot, UiOutput& output);
  void on(const FocusLostEvent& event, const session::Snapshot& snapshot, UiOutput& output);

  void pressLeft(const PressEvent& event, const session::Snapshot& snapshot, UiOutput& output);
  void pressInPlace(const PressEvent& event, const session::Snapshot& snapshot);
  void clickInPlace(const session::Snapshot& snapshot, UiOutput& output);
  void clickInSewing(const session::Snapshot& snapshot);
  bool leaveMode(const session::Snapshot& snapshot, UiOutput& output);
  bool recentreOnDoubleClick(const PressEvent& event, const session::Snapshot& snapshot);
  void pickVertex(const PressEvent& event, const session::Snapshot& snapshot, UiOutput& output) const;
  bool holdPins(const PressEvent& event, const session::Snapshot& snapshot);
  bool attach(const PressEvent& event, const session::Snapshot& snapshot, UiOutput& output);
  void endGesture(UiOutput& output);
  void moveCamera(const session::Snapshot& snapshot, const std::function<void(render::Camera&)>& move);
  /// The factor of the distance by which lookAtScene moves away when the picture is narrow; at least 1.
  [[nodiscard]] double zoomOfScenes() const;
  /// The ray through a position in the window.
  [[nodiscard]] render::Ray rayThrough(const Vec2& position) const;
  /// `point` moved parallel to the view to a position in the window.
  [[nodiscard]] Vec3 movedTo(const Vec2& position, const Vec3& point) const;

  [[nodiscard]] VertexSelection::Projection toWindow() const;

  render::Camera camera_;
  bool turns_ = false;  // as a turntable
  VertexSelection selection_;
  Placing placing_;
  SewingMode sewing_;
  UiRect view_{0.0, 0.0, 1280.0, 720.0};
  double scale_ = 1.0;
  std::variant<Idle, Orbiting, Panning, Selecting, Placed, Pulling, MovingBody, MovingPins> gesture_;
  Vec2 pressed_ = Vec2::Zero();
  bool pressedWithShift_ = false;
  MouseButton gestureButton_ = MouseButton::Left;
  Vec2 mouse_ = Vec2::Zero();
  std::optional<PressEvent> lastLeftPress_;
};

}  // namespace drape::ui
