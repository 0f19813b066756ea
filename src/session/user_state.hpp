#pragma once

#include "scene/placements.hpp"
#include "session/command.hpp"
#include "session/snapshot.hpp"

#include <memory>
#include <vector>

namespace drape::session {

/// A pinned vertex of the cloth and its place [m].
struct PinPlace {
  int vertex = 0;
  Vec3 place = Vec3::Zero();
};

/// What a user can change about a body of the scene.
struct BodyChoice {
  bool on = true;
  Vec3 shift = Vec3::Zero();  ///< that the body has or approaches, relative to its own motion [m]
  sim::contact::SurfaceProperties surface;
  std::optional<figure::FigureOptions> figure = std::nullopt;  ///< motion and proportions of a figure

  bool operator==(const BodyChoice&) const = default;
};

/// All that a user can change about a running scene: its settings, pins, bodies, placements, seams, elastic bands, and
/// the start of the cloth. Undo goes back to an earlier one.
struct UserState {
  settings::Settings settings;
  std::shared_ptr<const std::vector<PinPlace>> pins;            ///< in the order of the vertices; never null
  std::vector<BodyChoice> bodies;                               ///< one per body of the scene
  std::shared_ptr<const std::vector<scene::PinPath>> pinPaths;  ///< of pins that move without a body; never null
  scene::Placements placements;                                 ///< of the cloths and the bodies of the scene
  std::shared_ptr<const scene::Sewing> sewing;                  ///< seams and elastic bands; never null
  /// Where the cloth starts, one position per vertex [m]; null: where the scene has it. Dressing a body changes this.
  std::shared_ptr<const std::vector<Vec3>> placedStart;
};

/// The pinned vertices of a snapshot, in order.
[[nodiscard]] std::shared_ptr<const std::vector<PinPlace>> pinsOf(const Snapshot& snapshot);

/// The state of a snapshot. @param pins its pins, as pinsOf() has them
[[nodiscard]] UserState userStateOf(const Snapshot& snapshot, std::shared_ptr<const std::vector<PinPlace>> pins);
[[nodiscard]] UserState userStateOf(const Snapshot& snapshot);

/// The settings that the user changed from `a` to `b`, in the order of the table: without the cost budget of `auto`
/// while the simulation adapts it to the clock.
[[nodiscard]] std::vector<const settings::SettingInfo*> changedSettings(const settings::Settings& a,
                                                                        const settings::Settings& b);

/// Whether the cloth starts in the same positions.
[[nodiscard]] bool haveSameStart(const UserState& a, const UserState& b);

/// Whether the same vertices are pinned.
[[nodiscard]] bool havePinsInCommon(const UserState& a, const UserState& b);

/// Whether settings, pinned vertices, bodies, placements, seams, elastic bands and the start of the cloth are the same.
[[nodiscard]] bool areSame(const UserState& a, const UserState& b);

/// The commands from the settings `from` to `to` that need no rebuild of the scene. The values of a fabric change
/// together.
[[nodiscard]] std::vector<Command> runningChanges(const settings::Settings& from, const settings::Settings& to);

/// The same for the user's changes of settings, as changedSettings() has them.
[[nodiscard]] std::vector<Command> settingCommands(const settings::Settings& from, const settings::Settings& to);

/// The commands that lead from one state to another, except changes that rebuild the scene: of some settings, and of
/// placements. Pins that are
/// set again return to their places, unless a body of the scene carries them.
[[nodiscard]] std::vector<Command> commandsBetween(const UserState& from, const UserState& to,
                                                   const scene::Scene& scene);

/// Whether a command changes the user's state.
[[nodiscard]] bool changesUserState(const Command& command);

}  // namespace drape::session
