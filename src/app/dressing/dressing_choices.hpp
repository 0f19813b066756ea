#pragma once

#include "app/command_line.hpp"
#include "dressing/dressing.hpp"
#include "scene/mesh_reading.hpp"

#include <CLI/CLI.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace drape::app {

/// What to dress and how: the arguments "GARMENT BODY --place ..." that the commands `dress` of both programs share.
struct DressingChoices {
  std::string garment;               ///< a mesh file, or "builtin:tshirt.obj"
  std::string body;                  ///< a mesh file, "mannequin" or "figure"
  std::optional<std::string> clip;   ///< of the body's file, which moves the body; empty: the only one; absent: none
  std::string rule = "auto";         ///< of the placement
  std::vector<double> move;          ///< x, y, z [m]; empty: none
  double turn = 0.0;                 ///< about the vertical [degrees]
  double scale = 1.0;                ///< of the garment [-]
  scene::ReadingChoice bodyReading;  ///< the unit and the up axis of the body's file; those of the garment are settings
  double maxSeconds = 4.0;           ///< of the simulation after the body has its full size [s]

  void addTo(CLI::App& app);

  /// The scene of a garment and the body, which moves if there is a clip. @param wear a garment as in `garment`
  [[nodiscard]] scene::SceneDescription description(const std::string& wear,
                                                    const settings::OwnFabrics& own = {}) const;

  /// Builds the scene of garment and body. A garment that is scaled has another unit there. Throws InputError.
  /// @param arguments settings; its scene is not used  @param own the user's fabrics
  [[nodiscard]] std::shared_ptr<const scene::Scene> open(const SceneArguments& arguments,
                                                         const settings::OwnFabrics& own = {}) const;

  /// @param settings of that scene
  [[nodiscard]] dressing::DressingOptions options(const settings::Settings& settings) const;
};

}  // namespace drape::app
