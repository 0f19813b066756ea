#include "app/command_line.hpp"
#include "app/headless/commands.hpp"
#include "app/scene_saving.hpp"

#include <iostream>
#include <memory>
#include <string>

namespace drape::app {
namespace {

struct SaveArguments {
  SceneArguments scene;
  std::string output;
  bool replace = false;
};

void save(const SaveArguments& arguments) {
  const auto scene = arguments.scene.load();
  const std::filesystem::path file = sceneFile(arguments.output);
  const Existing existing = arguments.replace ? Existing::Replaced : Existing::Refused;
  for (const text::Sentence& note : saveScene(*scene, scene::unchanged(*scene), file, existing)) {
    std::cerr << "note: " << note << '\n';
  }
  std::cout << "saved " << file.string() << '\n';
}

}  // namespace

void addSaveCommand(CLI::App& app) {
  auto arguments = std::make_shared<SaveArguments>();
  CLI::App* command = app.add_subcommand("save", "Writes a scene with other settings as a scene file");
  arguments->scene.addTo(*command);
  command->add_option("--output", arguments->output, "The scene file")
      ->type_name("OUT.toml")
      ->required()
      ->check(notEmpty());
  command->add_flag("--replace", arguments->replace, "Replace a file of this name");
  command->callback([arguments] { save(*arguments); });
}

}  // namespace drape::app
