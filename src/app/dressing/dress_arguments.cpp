#include "app/dressing/dress_arguments.hpp"

#include "app/dressing/dressing_text.hpp"
#include "app/exported_cloth.hpp"
#include "app/progress_line.hpp"
#include "app/scene_saving.hpp"
#include "dressing/dressing.hpp"
#include "messages/error.hpp"
#include "scene/garment_on_body.hpp"
#include "scene/unit_guess.hpp"
#include "settings/settings_table.hpp"
#include "sim/model/bounds.hpp"

#include <fmt/core.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <map>
#include <numbers>
#include <utility>
#include <variant>

namespace drape::app {
namespace {

using dressing::Dressed;
using dressing::PlacementRule;

const std::map<std::string, PlacementRule>& rulesByName() {
  static const std::map<std::string, PlacementRule> rules{{"auto", PlacementRule::Auto},
                                                          {"file", PlacementRule::File},
                                                          {"landmarks", PlacementRule::Landmarks},
                                                          {"boxes", PlacementRule::Boxes}};
  return rules;
}

/// The body in the scene.
sim::ClothMesh bodyOf(const scene::Scene& scene) {
  const sim::contact::Body& body = scene.bodies->front();
  sim::contact::BodySurface surface = sim::contact::surfaceOf(body.shape);
  const sim::contact::Pose pose = sim::contact::poseAt(body.motion, 0.0);
  for (Vec3& position : surface.positions) {
    position = pose.toWorld(position);
  }
  return {std::move(surface.positions), std::move(surface.triangles)};
}

void requireFit(const scene::Scene& scene, const sim::ClothMesh& body, const DressArguments& arguments) {
  constexpr std::size_t maxTriangles = 300'000;
  if (body.triangles.size() > maxTriangles) {
    throw messages::InputError(fmt::format("{}: the body has {} triangles, and the limit is {}. Reduce the mesh first",
                                           arguments.body, body.triangles.size(), maxTriangles));
  }
  const auto side = [](const std::vector<Vec3>& positions) { return sim::boundsOf(positions).sizes().maxCoeff(); };
  const std::vector<Vec3>& start = scene.start.positions;
  const dressing::Misfit misfit = dressing::misfitOf({start, scene.model->triangles}, body);
  if (misfit != dressing::Misfit::None) {
    throw messages::InputError(inWords(misfit, arguments.garment, arguments.body, side(start), side(body.positions)));
  }
}

/// Shows the stages as one bar each.
void showProgress(ProgressLine& line, dressing::Stage stage, double share) {
  constexpr std::array<const char*, 4> labels{"shrinking the body", "placing the garment", "growing the body",
                                              "settling the garment"};
  line.show(labels[static_cast<std::size_t>(stage)], std::round(100.0 * share), 100.0);
}

Dressed dressed(const scene::Scene& scene, const sim::ClothMesh& body, const DressArguments& arguments) {
  dressing::DressingOptions options;
  options.rule = rulesByName().at(arguments.rule);
  if (!arguments.move.empty()) {
    options.move = Vec3(arguments.move[0], arguments.move[1], arguments.move[2]);
  }
  options.turn = arguments.turn * std::numbers::pi / 180.0;
  options.maxSettleTime = arguments.maxSeconds;
  options.step = scene.settings.step;
  ProgressLine line;
  options.progress = [&](dressing::Stage stage, double share) { showProgress(line, stage, share); };
  return dressing::dress(*scene.model, scene.start.positions, body, options);
}

/// Builds the scene, and again with another unit where the garment is scaled.
std::shared_ptr<const scene::Scene> openScaled(const DressArguments& arguments,
                                               const scene::SceneDescription& description) {
  auto scene = arguments.settings.build(description);
  if (arguments.scale == 1.0) {
    return scene;
  }
  SceneArguments scaled = arguments.settings;
  const double unit = arguments.scale * scene->cloths.front().placement.metresPerUnit;
  scaled.settings.push_back("unit=" + settings::formatValue(unit));
  scaled.settings.push_back("up=" + scene->cloths.front().placement.up);
  return scaled.build(description);
}

void writeGarment(scene::Scene scene, const Dressed& result, const DressArguments& arguments) {
  scene.cloths.front().placement.metresPerUnit /= arguments.scale;
  exportFrame(scene, *scene.model, result.positions, arguments.output);
}

/// A scene of the fitted garment, whose unit and axes are known now.
void writeScene(const scene::Scene& scene, const DressArguments& arguments) {
  scene::SceneDescription fitted = scene::openGarmentOnBody(arguments.output, arguments.body);
  fitted.bodies.front().meshes = scene.description.bodies.front().meshes;
  settings::Settings settings = scene.settings;
  const scene::MeshPlacement& placement = scene.cloths.front().placement;
  settings.mesh.unit = scene::wordForUnit(placement.metresPerUnit / arguments.scale);
  settings.mesh.up = placement.up;
  const auto built = scene::buildScene(fitted, settings);
  for (const std::string& note :
       saveScene(*built, scene::unchanged(*built), sceneFile(arguments.sceneOutput), Existing::Refused)) {
    std::cerr << "note: " << note << '\n';
  }
}

void printNotes(const Dressed& result) {
  if (!result.atCentreLines.empty() && result.before.body > 0) {
    std::cerr << "note: where the garment was placed, the centre lines of the body are not inside it: "
              << inWords(result.atCentreLines) << '\n';
  }
}

/// What a garment lacks that is closed where head and arms come out.
std::string adviceOnOpenings(const Dressed& result) {
  return result.openings > 1 ? ""
                             : fmt::format(
                                   "It has {} for neck, arms, waist and legs; is it closed where it should be "
                                   "open? ",
                                   result.openings == 0 ? "no opening" : "only one opening");
}

void requireNewFile(const std::filesystem::path& file) {
  if (!file.empty() && std::filesystem::exists(file)) {
    throw messages::InputError(file.string() + " exists; choose another name");
  }
}

}  // namespace

void DressArguments::addTo(CLI::App& app) {
  constexpr double maxMove = 10.0;  // [m]
  constexpr double fullTurn = 360.0;
  app.add_option("garment", garment, "The garment, a mesh file or a built-in one such as builtin:tshirt.obj")
      ->type_name("GARMENT")
      ->required()
      ->check(notEmpty());
  app.add_option("body", body, "The body, a closed mesh file, or one of mannequin, figure")
      ->type_name("BODY")
      ->required()
      ->check(notEmpty());
  app.add_option("--place", rule,
                 "auto: as in the files if the body is inside the garment there, else by landmarks, else by boxes; "
                 "file; landmarks: neck, sleeves and waist; boxes")
      ->type_name("RULE")
      ->check(CLI::IsMember(rulesByName()));
  app.add_option("--move", move, "Move the garment by this after the placement, x y z [m]")
      ->type_name("X Y Z")
      ->expected(3)
      ->check(numberFrom(-maxMove, maxMove));
  app.add_option("--turn", turn, "Turn the garment about the vertical after the placement [degrees]")
      ->check(numberFrom(-fullTurn, fullTurn));
  app.add_option("--scale", scale, "A factor on all lengths of the garment")->check(numberFrom(0.001, 1000.0));
  app.add_option("--max-seconds", maxSeconds,
                 "Stop after this simulated time with the full body, if intersections are left [s]")
      ->check(numberFrom(0.0, 1000.0));
  app.add_option("--scene", sceneOutput, "Also write a scene file of the fitted garment and the body")
      ->type_name("OUT.toml")
      ->check(notEmpty());
  settings.addSettingsTo(app);
}

void DressArguments::run() const {
  requireNewFile(output);
  requireNewFile(sceneOutput.empty() ? std::filesystem::path() : sceneFile(sceneOutput));
  const auto scene = openScaled(*this, scene::openGarmentOnBody(garment, body));
  const sim::ClothMesh bodyMesh = bodyOf(*scene);
  requireFit(*scene, bodyMesh, *this);
  const Dressed result = dressed(*scene, bodyMesh, *this);
  if (!result.fits) {
    throw messages::InputError(fmt::format(
        "{} does not go on the body: even where the body is a thin line, {}. {}Move it with --move, --turn or --scale.",
        garment, inWords(result.faults), adviceOnOpenings(result)));
  }
  printNotes(result);
  writeGarment(*scene, result, *this);
  if (!sceneOutput.empty()) {
    writeScene(*scene, *this);
  }
  const std::string summary =
      fmt::format("{}: {}; {} intersected there, and {} at the end", output, inWords(result.placement.rule),
                  inWords(result.before), inWords(result.after));
  if (result.after.all() > 0 || !result.faults.empty()) {
    const std::string faults = inWords(result.faults);
    throw messages::InputError(summary + (faults.empty() ? "" : ": " + faults) +
                               ". Try another place with --move, --turn or --scale.");
  }
  std::cout << summary << '\n';
}

}  // namespace drape::app
