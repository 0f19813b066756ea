#pragma once

#include "scene/sewing.hpp"
#include "settings/settings_table.hpp"

#include <cstdint>
#include <memory>
#include <string>
#include <variant>
#include <vector>

namespace drape::session {

struct SetSettingCommand {
  std::string key;
  settings::SettingValue value;
};
/// Gives the cloth all values of a fabric at once. One by one they could pass through combinations that are refused.
struct UseFabricCommand {
  settings::OwnFabric fabric;  ///< material.preset has its name then, or "NAME, changed" where the values differ
};
/// Replaces the own fabrics that material.preset can name.
struct SetOwnFabricsCommand {
  settings::OwnFabrics fabrics;
};
struct PauseCommand {
  bool paused = true;
};
/// Takes one step; the simulation stays paused.
struct SingleStepCommand {};
/// Returns to the start of the scene. Settings and pins keep the user's changes.
struct ResetCommand {};
struct AttachCommand : sim::AttachmentEnds {};
struct MoveAttachmentCommand {
  Vec3 target = Vec3::Zero();  ///< [m]
};
struct DetachCommand {};
/// Pins the vertex nearest to the attached point at its current position, or releases it when it is pinned.
struct TogglePinCommand {};
/// Pins exactly these vertices where they are, and releases all others.
struct SetPinsCommand {
  std::vector<int> vertices;
};
/// Moves pinned vertices to places, at rest. The springs pull the cloth after them.
struct PlacePinsCommand {
  std::vector<int> vertices;
  std::vector<Vec3> places;  ///< one per vertex [m]
};
/// Moves all pins together. The springs pull the cloth after them.
struct MovePinsCommand {
  Vec3 by = Vec3::Zero();  ///< [m]
};
/// Replaces the keyframes of pins that move without a body.
struct SetPinPathsCommand {
  std::vector<scene::PinPath> paths;  ///< a vertex is in one of them at most
  /// Whether the pins go from where their earlier path has them now to where the new one has them. Otherwise they are
  /// there already.
  bool moves = true;
};
/// Replaces the seams and the elastic bands. New seams are drawn together from now on. One that is no longer among them
/// opens.
struct SetSewingCommand {
  scene::Sewing sewing;
};
/// Moves the cloth until it no longer intersects itself, and brings it to rest there. Pins stay where they are.
struct UntangleCommand {};
/// Puts the cloth at rest into other positions, as dressing a body does.
struct PlaceClothCommand {
  std::vector<Vec3> positions;  ///< one per vertex [m]; empty with isStart: the start of the scene
  /// Whether the scene starts there from now on, and returns to its start. Otherwise the time goes on.
  bool isStart = false;
};
/// Switches contact with a body on or off.
struct SwitchBodyCommand {
  int body = 0;  ///< index into the scene's bodies
  bool on = true;
};
/// Changes the surface of a body.
struct SetSurfaceCommand {
  int body = 0;  ///< index into the scene's bodies
  sim::contact::SurfaceProperties surface;
};
/// Shifts a body relative to its own motion. The body moves there at a bounded speed while the simulation runs.
struct MoveBodyCommand {
  int body = 0;               ///< index into the scene's bodies
  Vec3 shift = Vec3::Zero();  ///< [m]
};
/// Gives a figure another motion, speed or proportions. It blends into them in a second, from what it does now.
struct SetFigureCommand {
  int body = 0;  ///< index into the scene's bodies
  figure::FigureOptions figure;
};
/// The cost budget of `auto`, as it follows from auto.budget. The simulation gives this command to itself, so that the
/// log holds every decision that depends on the clock.
struct SetCostBudgetCommand {
  double costBudget = 0.0;  ///< spring evaluations per simulated second [1e6/s]
};
/// Adds velocities and contact loads to the snapshots, as fields of picked vertices need them. Does not change the
/// motion.
struct ObserveCommand {
  bool on = true;
};
/// Returns to a state of the timeline (settings.timeline.memory), and pauses. Settings, pins and surfaces stay as they
/// are.
struct GoToCommand {
  double time = 0.0;  ///< of the state that is nearest to it [s]
};
/// Returns to the state of the timeline before the present one, and pauses.
struct StepBackCommand {};
struct LoadSceneCommand {
  std::shared_ptr<const scene::Scene> scene;
};

/// All commands to a running simulation.
using Command =
    std::variant<SetSettingCommand, UseFabricCommand, SetOwnFabricsCommand, PauseCommand, SingleStepCommand,
                 ResetCommand, AttachCommand, MoveAttachmentCommand, DetachCommand, TogglePinCommand, SetPinsCommand,
                 PlacePinsCommand, MovePinsCommand, SetPinPathsCommand, SetSewingCommand, UntangleCommand,
                 PlaceClothCommand, SwitchBodyCommand, SetSurfaceCommand, MoveBodyCommand, SetFigureCommand,
                 SetCostBudgetCommand, ObserveCommand, GoToCommand, StepBackCommand, LoadSceneCommand>;

/// A command, and the number of steps before it took effect. A log of these reproduces a session.
struct LoggedCommand {
  std::int64_t step = 0;
  Command command;
};

}  // namespace drape::session
