#pragma once

#include "scene/scene.hpp"

#include <CLI/CLI.hpp>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace drape {

/// Exit status of the programs.
enum class ExitStatus { Ok = 0, Failed = 1, WrongUsage = 2 };

/// "[SCENE|MESH] [--set key=value]...", which every command that opens a scene takes.
struct SceneArguments {
  std::string scene;                  ///< built-in scene, scene file or mesh file; empty: the first built-in scene
  std::vector<std::string> settings;  ///< key=value, each

  void addTo(CLI::App& app);

  /// Opens and builds it. Warnings about the mesh go to standard error. Throws UsageError for a bad --set, InputError
  /// for a bad scene or mesh.
  [[nodiscard]] std::shared_ptr<const Scene> load() const;
};

/// Prints a note to standard error when "key=value" uses a former key of a setting.
void printFormerKey(std::string_view expression);

/// Accepts a number from min to max, both included, and nothing that is not a number.
[[nodiscard]] CLI::Validator numberFrom(double min, double max);

/// Accepts any text but the empty one, which a script passes where a variable is not set.
[[nodiscard]] CLI::Validator notEmpty();

/// Parses the command line and runs `body`. Help is printed; wrong usage and errors become one message on standard
/// error, starting with the program's name, and the exit status that main() returns. That standard output could not be
/// written is such an error.
[[nodiscard]] int runProgram(CLI::App& app, int argc, char** argv, const std::function<void()>& body);

}  // namespace drape
