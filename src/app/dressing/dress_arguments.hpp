#pragma once

#include "app/command_line.hpp"

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace drape::app {

/// The arguments "GARMENT BODY --output FILE ..." of the commands that put a garment on a body.
struct DressArguments {
  std::string garment;        ///< a mesh file, or "builtin:tshirt.obj"
  std::string body;           ///< a mesh file, "mannequin" or "figure"
  std::string output;         ///< the fitted garment, in a format of io::animation
  std::string sceneOutput;    ///< a scene file of both; empty: none
  std::string rule = "auto";  ///< of the placement
  std::vector<double> move;   ///< x, y, z [m]; empty: none
  double turn = 0.0;          ///< about the vertical [degrees]
  double scale = 1.0;         ///< of the garment [-]
  double maxSeconds = 4.0;    ///< of the simulation after the body has its full size [s]
  SceneArguments settings;    ///< its scene is not used

  void addTo(CLI::App& app);

  /// Dresses the body, writes the files, and reports on standard output. Progress and notes go to standard error.
  /// Throws InputError for bad meshes and files, and, after writing the files, if anything is wrong with the result.
  void run() const;
};

}  // namespace drape::app
