#include "app/command_line.hpp"
#include "app/headless/commands.hpp"

int main(int argc, char** argv) {
  CLI::App app("Cloth simulation without a window: runs with statistics, pictures, error measurements, and lists",
               "drape-headless");
  app.require_subcommand(1);
  drape::app::addRunCommand(app);
  drape::app::addCaptureCommand(app);
  drape::app::addBakeCommand(app);
  drape::app::addMeasureCommand(app);
  drape::app::addErrorsCommand(app);
  drape::app::addHardCasesCommand(app);
  drape::app::addValidateCommand(app);
  drape::app::addUntangleCommand(app);
  drape::app::addDressCommand(app);
  drape::app::addSaveCommand(app);
  drape::app::addListCommand(app);
  return drape::app::runProgram(app, argc, argv, [] {});
}
