#include "app/command_line.hpp"
#include "app/headless/commands.hpp"

int main(int argc, char** argv) {
  CLI::App app("Cloth simulation without a window: runs with statistics, pictures, error measurements, and lists",
               "drape-headless");
  app.require_subcommand(1);
  drape::addRunCommand(app);
  drape::addCaptureCommand(app);
  drape::addMeasureCommand(app);
  drape::addHardCasesCommand(app);
  drape::addListCommand(app);
  return drape::runProgram(app, argc, argv, [] {});
}
