#pragma once

#include <CLI/CLI.hpp>

namespace drape {

/// Each adds its subcommand to the program; the subcommand runs when it has been parsed.
void addRunCommand(CLI::App& app);
void addCaptureCommand(CLI::App& app);
void addMeasureCommand(CLI::App& app);
void addHardCasesCommand(CLI::App& app);
void addListCommand(CLI::App& app);

}  // namespace drape
