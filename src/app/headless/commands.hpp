#pragma once

#include <CLI/CLI.hpp>

namespace drape::app {

/// Each function adds a subcommand to the program. The subcommand runs after parsing.
void addRunCommand(CLI::App& app);
void addCaptureCommand(CLI::App& app);
void addBakeCommand(CLI::App& app);
void addMeasureCommand(CLI::App& app);
void addErrorsCommand(CLI::App& app);
void addHardCasesCommand(CLI::App& app);
void addValidateCommand(CLI::App& app);
void addUntangleCommand(CLI::App& app);
void addDressCommand(CLI::App& app);
void addSaveCommand(CLI::App& app);
void addListCommand(CLI::App& app);

}  // namespace drape::app
