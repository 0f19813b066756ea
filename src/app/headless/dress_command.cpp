#include "app/dressing/dress_arguments.hpp"
#include "app/headless/commands.hpp"

#include <memory>

namespace drape::app {

void addDressCommand(CLI::App& app) {
  auto arguments = std::make_shared<DressArguments>();
  CLI::App* command = app.add_subcommand("dress", "Puts a garment on a body, without intersections");
  arguments->addTo(*command);
  command->add_option("--output", arguments->output, "The fitted garment, in the unit and axes of its file")
      ->type_name("OUT.obj")
      ->required()
      ->check(notEmpty());
  command->callback([arguments] { arguments->run(); });
}

}  // namespace drape::app
