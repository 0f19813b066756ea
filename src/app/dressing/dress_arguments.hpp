#pragma once

#include "app/command_line.hpp"
#include "app/dressing/dressing_choices.hpp"

#include <CLI/CLI.hpp>
#include <string>

namespace drape::app {

/// The arguments "GARMENT BODY --output FILE ..." of the commands that put a garment on a body.
struct DressArguments {
  DressingChoices choices;
  std::string output;       ///< the fitted garment, in a format of io::animation
  std::string sceneOutput;  ///< a scene file of both; empty: none
  bool replace = false;     ///< whether files of these names may be replaced
  SceneArguments settings;  ///< its scene is not used

  void addTo(CLI::App& app);

  /// Dresses the body, writes the files, and reports on standard output. Progress and notes go to standard error.
  /// Throws InputError for bad meshes and files, and, after writing the files, if anything is wrong with the result.
  void run() const;
};

}  // namespace drape::app
