#include "app/command_line.hpp"

#include "app/progress_line.hpp"
#include "app/standard_streams.hpp"
#include "messages/sim_error_text.hpp"
#include "scene/cloth_material.hpp"
#include "scene/rest_pattern.hpp"
#include "settings/settings_table.hpp"
#include "text/words.hpp"

#include <cmath>
#include <exception>
#include <iostream>
#include <new>

namespace drape::app {
namespace {

int fail(const CLI::App& app, ExitStatus status, const std::string& message) {
  std::cerr << app.get_name() << ": " << message << '\n';
  if (status == ExitStatus::WrongUsage) {
    std::cerr << "'" << app.get_name() << " --help' shows the usage.\n";
  }
  return static_cast<int>(status);
}

/// The message for a program with commands that was given none of them.
std::string commandMessage(const CLI::App& app) {
  std::vector<std::string> commands;
  std::string list;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    commands.push_back(command->get_name());
    list += (list.empty() ? "" : ", ") + command->get_name();
  }
  const std::vector<std::string> rest = app.remaining();
  if (rest.empty()) {
    return "give a command: " + list;
  }
  const std::string& given = rest.front();
  if (given.starts_with('-')) {
    return "give a command before " + given + ": " + list;
  }
  const std::string meant = text::nearestWord(given, commands);
  return "there is no command '" + given + "'; " + (meant.empty() ? "the" : "did you mean '" + meant + "'? The") +
         " commands are " + list;
}

/// Parses the command line and runs the subcommand. Returns false after it printed the help or the version.
bool parseOrHelp(CLI::App& app, int argc, char** argv) {
  app.set_version_flag("--version", app.get_name() + " " DRAPE_VERSION, "Print the version and exit");
  try {
    app.parse(argc, argv);
    return true;
  } catch (const CLI::RequiredError&) {
    if (app.get_require_subcommand_min() > app.get_subcommands().size()) {
      throw messages::UsageError(commandMessage(app));
    }
    throw;
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() != 0) {
      throw;
    }
    static_cast<void>(app.exit(error));
    return false;
  }
}

/// Builds a scene. When this takes longer than half a second, the terminal shows a progress bar.
std::shared_ptr<const scene::Scene> buildWithProgress(const scene::SceneDescription& description,
                                                      const settings::Settings& settings) {
  constexpr double patience = 0.5;  // [s]
  ProgressLine bar;
  io::ImportWatch watch;
  watch.progress = [&](double share, std::string_view) {
    if (bar.spent() > patience) {
      bar.show("opening " + description.name, std::round(100.0 * share), 100.0);
    }
  };
  return scene::buildScene(description, settings, watch);
}

/// Prints how a mesh file was read, and warns when all vertices or none are pinned, each with the option that changes
/// it.
void printNotes(const scene::Scene& scene) {
  if (scene.reading && scene.reading->needsReview()) {
    std::string options;
    for (const scene::ReadingAlternative& other : scene.reading->alternatives) {
      const std::string option = "--set " + other.key + "=";
      options += options.find(option) != std::string::npos ? "" : (options.empty() ? "" : ", ") + option + other.value;
    }
    std::cerr << "note: " << scene::inWords(*scene.reading) << " To change it: " << options << '\n';
  }
  if (const text::Sentence note = scene::warpNote(scene.cloths, scene.settings); !note.empty()) {
    std::cerr << "note: " << note << '\n';
  }
  if (const text::Sentence note = scene::restShapeNote(*scene.model, scene.cloths.front().uvs, scene.settings);
      !note.empty()) {
    std::cerr << "warning: " << note << '\n';
  }
  if (scene.pinAdvice) {
    const scene::Advice& advice = *scene.pinAdvice;
    std::cerr << "warning: " << advice.text
              << (advice.key.empty() ? "" : " Use --set " + advice.key + "=" + advice.value) << '\n';
  }
}

}  // namespace

void printFormerKey(std::string_view expression) {
  if (const std::string note = settings::formerKeyNote(settings::keyOf(expression)); !note.empty()) {
    std::cerr << "note: " << note << '\n';
  }
}

void printMeshWarnings(const scene::Scene& scene) {
  for (const std::string& warning : scene.summary.warnings) {
    std::cerr << "warning: " << warning << '\n';
  }
}

void SceneArguments::addTo(CLI::App& app) {
  app.add_option("scene", scene, "A built-in scene, a scene file (.toml) or a mesh file")
      ->type_name("SCENE|MESH")
      ->check(notEmpty());
  addSettingsTo(app);
}

void SceneArguments::addSettingsTo(CLI::App& app) {
  app.add_option("--set", settings, "Set a setting; may be repeated ('drape-headless list settings' lists them)")
      ->type_name("KEY=VALUE")
      ->take_all()
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
      ->check(notEmpty());
  addFabricsOption(app, fabrics);
}

void addFabricsOption(CLI::App& app, std::string& file) {
  app.add_option("--fabrics", file, "The file with your own fabrics (default: fabrics.toml in ~/.config/drape)")
      ->type_name("FILE")
      ->check(notEmpty());
}

FabricList readFabricList(const std::string& file, FabricList::Missing missing) {
  FabricList list(file, missing);
  if (!list.problem().empty()) {
    std::cerr << "warning: " << list.problem() << '\n';
  }
  return list;
}

std::shared_ptr<const scene::Scene> SceneArguments::load() const {
  return load(readFabricList(fabrics).fabrics());
}

std::shared_ptr<const scene::Scene> SceneArguments::load(const settings::OwnFabrics& own) const {
  return build(scene::openScene(scene.empty() ? scene::sceneList().front().name : scene, own));
}

std::shared_ptr<const scene::Scene> SceneArguments::build(const scene::SceneDescription& description) const {
  settings::Settings inForce = description.settings;
  if (adjust) {
    adjust(inForce);
  }
  for (const std::string& note : description.notes) {
    std::cerr << "note: " << note << '\n';
  }
  for (const std::string& expression : settings) {
    settings::assignSettingExpression(inForce, expression);
    printFormerKey(expression);
  }
  settings::requireConsistent(inForce);
  for (const std::string& expression : settings) {
    const std::string note = settings::noEffectNote(inForce, settings::keyOf(expression));
    if (!note.empty()) {
      std::cerr << "note: " << note << '\n';
    }
  }
  auto built = buildWithProgress(description, inForce);
  printMeshWarnings(*built);
  printNotes(*built);
  return built;
}

CLI::Validator numberFrom(double min, double max) {
  const std::string range = settings::formatValue(min) + " to " + settings::formatValue(max);
  return {[min, max, range](std::string& text) {
            double value = 0.0;
            const bool inside = CLI::detail::lexical_cast(text, value) && value >= min && value <= max;
            return inside ? std::string() : "must be a number from " + range + "; '" + text + "' is not";
          },
          "FLOAT in [" + settings::formatValue(min) + " - " + settings::formatValue(max) + "]"};
}

CLI::Validator notEmpty() {
  return {[](std::string& text) { return text.empty() ? std::string("must not be empty") : std::string(); }, ""};
}

int runProgram(CLI::App& app, int argc, char** argv, const std::function<void()>& body) {
  occupyStandardStreams();
  try {
    if (parseOrHelp(app, argc, argv)) {
      body();
    }
    flushStandardOutput();
    return static_cast<int>(ExitStatus::Ok);
  } catch (const CLI::ParseError& error) {
    return fail(app, ExitStatus::WrongUsage, error.what());
  } catch (const messages::UsageError& error) {
    return fail(app, ExitStatus::WrongUsage, error.what());
  } catch (const messages::InputError& error) {
    return fail(app, ExitStatus::Failed, error.what());
  } catch (const std::bad_alloc&) {
    return fail(app, ExitStatus::Failed, "not enough memory; use a smaller mesh or grid");
  } catch (const std::exception& error) {
    return fail(app, ExitStatus::Failed, messages::messageOf(error));
  }
}

}  // namespace drape::app
