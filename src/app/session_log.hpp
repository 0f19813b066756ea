#pragma once

#include "app/output_file.hpp"
#include "scene/placements.hpp"
#include "session/simulation.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace drape::app {

/// A recorded session: the scene, the commands and the end. `drape --record` writes it, `drape-headless run --replay`
/// runs it again to the same bits. It covers the time since the last scene was opened.
struct SessionLog {
  std::string file;                                           ///< that it was read from; empty for a new log
  scene::SceneParts parts;                                    ///< of the scene; file names are absolute
  std::vector<std::pair<std::string, std::string>> settings;  ///< key and value of all, when the scene was opened
  settings::OwnFabrics fabrics;                               ///< that the settings can name
  std::optional<scene::Placements> placements;                ///< by the user; empty: those of the scene file
  std::vector<session::LoggedCommand> commands;
  std::int64_t steps = 0;  ///< taken in the whole session
  std::string stateHash;   ///< at the end (sim/model/cloth_state.hpp)
};

/// The log of a simulation from its scene to now.
[[nodiscard]] SessionLog sessionLogOf(const session::Simulation& simulation);

/// Writes the log as JSON (docs/guide/headless.md). Throws InputError when it could not be written.
void write(const SessionLog& log, OutputFile& file);

/// Throws InputError with file and cause when it is not a complete session log.
[[nodiscard]] SessionLog readSessionLog(const std::string& file);

/// Opens the scene of the log and builds it under the logged settings. Throws InputError as opening a scene does, and
/// with the file of the log for a wrong setting.
[[nodiscard]] std::shared_ptr<const scene::Scene> openLoggedScene(const SessionLog& log);

}  // namespace drape::app
