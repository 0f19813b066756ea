#pragma once

#include "scene/scene.hpp"
#include "settings/settings_table.hpp"

#include <cstdint>
#include <memory>
#include <string>
#include <variant>

namespace drape {

struct SetSettingCommand {
  std::string key;
  SettingValue value;
};
struct PauseCommand {
  bool paused = true;
};
/// One step, and stay paused.
struct SingleStepCommand {};
/// Back to the scene's start; settings and pins stay as the user left them.
struct ResetCommand {};
struct AttachCommand {
  int triangle = 0;
  Vec3 barycentric = Vec3::Zero();
  Vec3 target = Vec3::Zero();  ///< [m]
};
struct MoveAttachmentCommand {
  Vec3 target = Vec3::Zero();  ///< [m]
};
struct DetachCommand {};
/// Pins the vertex nearest to the grabbed point where it is now; lets it go when it was pinned.
struct TogglePinCommand {};
/// Moves everything that is pinned at once; the cloth follows by its springs.
struct MovePinsCommand {
  Vec3 by = Vec3::Zero();  ///< [m]
};
/// Lets a body take part, or takes it away.
struct SwitchBodyCommand {
  int body = 0;  ///< index into the scene's bodies
  bool on = true;
};
/// Gives a body another surface.
struct SetSurfaceCommand {
  int body = 0;  ///< index into the scene's bodies
  SurfaceProperties surface;
};
/// Shifts a body from where its own motion puts it. It goes there at a bounded speed while the simulation runs.
struct MoveBodyCommand {
  int body = 0;               ///< index into the scene's bodies
  Vec3 shift = Vec3::Zero();  ///< [m]
};
/// The work that `auto` may do, as it follows from the time allowed for it (auto.budget). The simulation gives this
/// command to itself, so that the log holds what the clock had to say.
struct AllowWorkCommand {
  double work = 0.0;  ///< 1e6 evaluations of a spring a simulated second [1e6/s]
};
struct LoadSceneCommand {
  std::shared_ptr<const Scene> scene;
};

/// Everything that anybody can ask of a running simulation.
using Command = std::variant<SetSettingCommand, PauseCommand, SingleStepCommand, ResetCommand, AttachCommand,
                             MoveAttachmentCommand, DetachCommand, TogglePinCommand, MovePinsCommand, SwitchBodyCommand,
                             SetSurfaceCommand, MoveBodyCommand, AllowWorkCommand, LoadSceneCommand>;

/// A command and how many steps had been taken when it took effect: enough to run a session again.
struct LoggedCommand {
  std::int64_t step = 0;
  Command command;
};

}  // namespace drape
