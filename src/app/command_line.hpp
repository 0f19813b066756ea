#pragma once

#include "app/fabric_list.hpp"
#include "scene/scene.hpp"

#include <CLI/CLI.hpp>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace drape::app {

/// Exit status of the programs: WrongUsage for a UsageError, Failed for every other error.
enum class ExitStatus { Ok = 0, Failed = 1, WrongUsage = 2 };

/// The arguments "[SCENE|MESH] [--set key=value]... [--fabrics FILE]" of every command that opens a scene.
struct SceneArguments {
  std::string scene;                  ///< built-in scene, scene file or mesh file; empty: the first built-in scene
  std::vector<std::string> settings;  ///< each key=value
  std::string fabrics;                ///< the file of the user's fabrics; empty: the usual one
  std::function<void(settings::Settings&)> adjust = {};  ///< changes the scene's own settings before --set does

  void addTo(CLI::App& app);
  /// Adds --set and --fabrics only, for a command with other names of the files.
  void addSettingsTo(CLI::App& app);

  /// Opens and builds the scene. Warnings about the mesh go to standard error. Throws UsageError for a bad --set,
  /// InputError for a bad scene or mesh.
  /// @param own the user's fabrics
  [[nodiscard]] std::shared_ptr<const scene::Scene> load(const settings::OwnFabrics& own) const;
  /// The same with the fabrics of the list that `fabrics` names.
  [[nodiscard]] std::shared_ptr<const scene::Scene> load() const;
  /// Builds a scene that is open already, with the settings. Throws as load().
  [[nodiscard]] std::shared_ptr<const scene::Scene> build(const scene::SceneDescription& description) const;
};

/// Adds the option --fabrics FILE.
void addFabricsOption(CLI::App& app, std::string& file);

/// Reads the user's fabrics. A usual file that is bad becomes a warning on standard error. Throws InputError as
/// FabricList does.
[[nodiscard]] FabricList readFabricList(const std::string& file,
                                        FabricList::Missing missing = FabricList::Missing::Refused);

/// Prints a note to standard error when "key=value" uses a former key of a setting.
void printFormerKey(std::string_view expression);

/// Prints the warnings about the mesh file of a scene to standard error.
void printMeshWarnings(const scene::Scene& scene);

/// Accepts a number from min to max, both included.
[[nodiscard]] CLI::Validator numberFrom(double min, double max);

/// Accepts any text except the empty one, which a script passes when a variable is not set.
[[nodiscard]] CLI::Validator notEmpty();

/// Parses the command line and runs `body`. Help goes to standard output. Wrong usage and errors, also a failed write
/// to standard output, become one message on standard error, which starts with the program's name. Returns the exit
/// status.
[[nodiscard]] int runProgram(CLI::App& app, int argc, char** argv, const std::function<void()>& body);

}  // namespace drape::app
