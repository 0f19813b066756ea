#pragma once

#include "render/camera.hpp"
#include "session/snapshot.hpp"
#include "ui/ui_output.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <variant>

namespace drape {

enum class MouseButton { Left, Middle, Right };

/// The keys that do something.
enum class Key { Space, Period, One, Three, Seven, F, H, P, R, W, Help, F12, Escape };

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
};
struct ScrollEvent {
  double amount = 0.0;  ///< notches, positive away from the user
};
struct KeyEvent {
  Key key = Key::Space;
  bool repeated = false;  ///< the key is held down
};
/// The window lost the keyboard: nothing that is held may stay held.
struct FocusLostEvent {};

using InputEvent = std::variant<PressEvent, ReleaseEvent, MoveEvent, ScrollEvent, KeyEvent, FocusLostEvent>;

/// Turns the mouse and the keyboard into commands and camera moves. Knows of no window system.
class InteractionController {
 public:
  [[nodiscard]] const Camera& camera() const { return camera_; }
  void setCamera(const Camera& camera) { camera_ = camera; }

  /// The part of the window that shows the picture.
  void setView(const UiRect& view) { view_ = view; }

  void handle(const InputEvent& event, const Snapshot& snapshot, UiOutput& output);

  /// Looks at a scene as its author wants it seen; from farther away where the picture is too narrow for that.
  void lookAtScene(const Scene& scene);
  /// Moves the camera so that the cloth as it is now fills the view.
  void frameCloth(const Snapshot& snapshot);
  /// Looks from a side, but never from below the ground.
  void lookFrom(Camera::Side side, const Snapshot& snapshot);

  /// True while a gesture drags a body.
  [[nodiscard]] bool holdsBody() const { return std::holds_alternative<MovingBody>(gesture_); }
  [[nodiscard]] bool holdsCloth() const { return std::holds_alternative<Pulling>(gesture_); }

 private:
  struct Idle {};
  struct Orbiting {};
  struct Panning {};
  struct Pulling {
    Vec3 point = Vec3::Zero();           ///< where it was taken [m]; tells how deep the hand moves
    std::shared_ptr<const Scene> scene;  ///< that was running
  };

  struct MovingBody {
    int body = 0;
    Vec3 point = Vec3::Zero();  ///< where it was taken [m]
    Vec3 shift = Vec3::Zero();  ///< of the body when it was taken [m]
    std::shared_ptr<const Scene> scene;
  };

  void on(const PressEvent& event, const Snapshot& snapshot, UiOutput& output);
  void on(const ReleaseEvent& event, const Snapshot& snapshot, UiOutput& output);
  void on(const MoveEvent& event, const Snapshot& snapshot, UiOutput& output);
  void on(const ScrollEvent& event, const Snapshot& snapshot, UiOutput& output);
  void on(const KeyEvent& event, const Snapshot& snapshot, UiOutput& output);
  void on(const FocusLostEvent& event, const Snapshot& snapshot, UiOutput& output);

  void pressLeft(const PressEvent& event, const Snapshot& snapshot, UiOutput& output);
  bool recentreOnDoubleClick(const PressEvent& event, const Snapshot& snapshot);
  bool attach(const PressEvent& event, const Snapshot& snapshot, UiOutput& output);
  void letGo(UiOutput& output);
  void escape(UiOutput& output);
  void moveCamera(const Snapshot& snapshot, const std::function<void(Camera&)>& move);
  [[nodiscard]] Vec2 inView(const Vec2& position) const { return position - Vec2(view_.x, view_.y); }
  [[nodiscard]] int width() const { return static_cast<int>(view_.width); }
  [[nodiscard]] int height() const { return static_cast<int>(view_.height); }

  Camera camera_;
  UiRect view_{0.0, 0.0, 1280.0, 720.0};
  std::variant<Idle, Orbiting, Panning, Pulling, MovingBody> gesture_;
  MouseButton gestureButton_ = MouseButton::Left;
  Vec2 mouse_ = Vec2::Zero();
  std::optional<PressEvent> lastLeftPress_;
};

}  // namespace drape
