#include "app/dressing/dress_arguments.hpp"

#include "app/dressing/dressing_text.hpp"
#include "app/exported_cloth.hpp"
#include "app/output_file.hpp"
#include "app/progress_line.hpp"
#include "app/scene_saving.hpp"
#include "app/used_files.hpp"
#include "dressing/dressing.hpp"
#include "dressing/piercing.hpp"
#include "io/animation/animation.hpp"
#include "messages/error.hpp"
#include "scene/found_mesh.hpp"
#include "scene/garment_on_body.hpp"
#include "scene/unit_guess.hpp"
#include "settings/settings_table.hpp"
#include "sim/model/bounds.hpp"

#include <fmt/core.h>
#include <cmath>
#include <iostream>
#include <utility>

namespace drape::app {
namespace {

using dressing::Dressed;

/// Shows the stages as one bar each.
void showProgress(ProgressLine& line, dressing::Stage stage, double share) {
  line.show(inWords(stage).english(), std::round(100.0 * share), 100.0);
}

Dressed dressed(const scene::Scene& scene, const sim::ClothMesh& body, const DressingChoices& choices) {
  dressing::DressingOptions options = choices.options(scene.settings);
  ProgressLine line;
  options.progress = [&](dressing::Stage stage, double share) { showProgress(line, stage, share); };
  return dressing::dress(*scene.model, scene.start.positions, body, options);
}

Existing existing(const DressArguments& arguments) {
  return arguments.replace ? Existing::Replaced : Existing::Refused;
}

void writeGarment(scene::Scene scene, const Dressed& result, const DressArguments& arguments) {
  scene.cloths.front().placement.metresPerUnit /= arguments.choices.scale;
  exportFrame(scene, *scene.model, result.positions, arguments.output, existing(arguments));
}

/// A scene of the garment, whose unit and axes are known now. It starts where it was fitted.
void writeScene(const scene::Scene& scene, const DressArguments& arguments) {
  scene::SceneDescription fitted = arguments.choices.description(arguments.choices.garment);
  fitted.cloth().start = scene::MeshFileSource{arguments.output};
  fitted.bodies.front().meshes = scene.description.bodies.front().meshes;
  settings::Settings settings = scene.settings;
  const scene::MeshPlacement& placement = scene.cloths.front().placement;
  settings.mesh.unit = scene::wordForUnit(placement.metresPerUnit / arguments.choices.scale);
  fitted.cloth().placement.scale = arguments.choices.scale;
  settings.mesh.up = placement.up;
  const auto built = scene::buildScene(fitted, settings);
  for (const text::Sentence& note :
       saveScene(*built, scene::unchanged(*built), sceneFile(arguments.sceneOutput), existing(arguments))) {
    std::cerr << "note: " << note << '\n';
  }
}

void printNotes(const Dressed& result) {
  if (result.fits && !result.placedFaults.empty() && result.before.body > 0) {
    std::cerr << "note: where the garment was placed, the shrunk body was not inside it: "
              << inWords(result.placedFaults) << '\n';
  }
  if (result.placement.rule == dressing::PlacementRule::Boxes) {
    std::cerr
        << "note: the garment was placed by its size, not by neck, sleeves, waist or hood. Check the result: it may "
           "slide off the body\n";
  }
}

/// Figures for games are often several metres tall.
void printNoteOnHeight(const sim::ClothMesh& body) {
  constexpr double usualHeight = 1.75;  // [m]
  const double height = sim::boundsOf(body.positions).sizes().y();
  if (height > scene::largestPerson) {
    std::cerr << fmt::format(
        "note: the body is {:.3g} m tall, more than a person. If its unit is wrong, give --body-unit. Else a garment "
        "for a person of {} m fits with about --scale {:.2g}\n",
        height, usualHeight, height / usualHeight);
  }
}

/// Prints what was found in a file, and how it is read.
void printFound(const std::string& file, const scene::ReadingChoice& choice, io::MeshUse use) {
  const scene::FoundMesh found = scene::findMesh(file);
  const scene::MeshReading reading = scene::readingOf(found, choice, use);
  std::cout << (use == io::MeshUse::Body ? "body: " : "garment: ") << file << '\n';
  for (const text::Sentence& fact : scene::inWords(found, reading, use)) {
    std::cout << "  " << fact << '\n';
  }
}

/// How the garment is read, before it is scaled. @param changes of the settings, each key=value
scene::ReadingChoice garmentReading(settings::Settings settings, const std::vector<std::string>& changes) {
  for (const std::string& change : changes) {
    settings::assignSettingExpression(settings, change);
  }
  return {settings.mesh.unit, settings.mesh.up};
}

/// Throws InputError if the file exists and may not be replaced, or cannot be written.
/// @param what it will contain, for messages
void requireFile(const std::filesystem::path& file, const char* what, Existing existing) {
  requireFree(file, existing, "--replace");
  const OutputFile canBeWritten(file.string(), what);
}

}  // namespace

void DressArguments::addTo(CLI::App& app) {
  choices.addTo(app);
  app.add_option("--scene", sceneOutput, "Also write a scene file of the fitted garment and the body")
      ->type_name("OUT.toml")
      ->check(notEmpty());
  app.add_flag("--replace", replace, "Replace files of these names");
  settings.addSettingsTo(app);
}

void DressArguments::run() const {
  static_cast<void>(io::animation::formatOf(output));  // throws for an unknown extension
  requireFile(output, "the garment", existing(*this));
  if (!sceneOutput.empty()) {
    requireFile(sceneFile(sceneOutput), "the scene", existing(*this));
    if (!output.ends_with(".obj")) {
      throw messages::UsageError(output + ": a scene needs the garment as an OBJ file; end --output in .obj");
    }
  }
  const auto scene = choices.open(settings);
  UsedFiles files(*scene);
  files.write(output, "--output");
  files.write(sceneOutput.empty() ? "" : sceneFile(sceneOutput), "--scene");
  const bool isBuiltIn = scene::isBuiltInWear(choices.garment);
  printFound(choices.garment,
             isBuiltIn ? scene::ReadingChoice() : garmentReading(scene->description.settings, settings.settings),
             io::MeshUse::Cloth);
  if (!choices.clip) {
    printFound(choices.body, choices.bodyReading, io::MeshUse::Body);
  }
  const sim::ClothMesh body = dressing::bodiesAtStart(*scene).front().mesh;
  printNoteOnHeight(body);
  requireDressable({text::Sentence::verbatim(choices.garment), choices.body},
                   {scene->start.positions, scene->model->triangles}, body);
  const Dressed result = dressed(*scene, body, choices);
  if (!result.fits) {
    throw messages::InputError(refusalOf(result, text::Sentence::verbatim(choices.garment)).english() +
                               " Move it with --move, --turn or --scale.");
  }
  printNotes(result);
  writeGarment(*scene, result, *this);
  if (!sceneOutput.empty()) {
    writeScene(*scene, *this);
  }
  const std::string summary = output + ": " + summaryOf(result).english();
  if (result.after.all() > 0 || !result.faults.empty()) {
    throw messages::InputError(summary + ". Try another place with --move, --turn or --scale.");
  }
  std::cout << summary << '\n';
}

}  // namespace drape::app
