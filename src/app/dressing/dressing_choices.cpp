#include "app/dressing/dressing_choices.hpp"

#include "messages/error.hpp"
#include "scene/garment_on_body.hpp"
#include "scene/placement.hpp"
#include "settings/settings_table.hpp"

#include <map>
#include <numbers>

namespace drape::app {
namespace {

using dressing::PlacementRule;

const std::map<std::string, PlacementRule>& rulesByName() {
  static const std::map<std::string, PlacementRule> rules{{"auto", PlacementRule::Auto},
                                                          {"file", PlacementRule::File},
                                                          {"landmarks", PlacementRule::Landmarks},
                                                          {"boxes", PlacementRule::Boxes}};
  return rules;
}

/// Checks a value of a setting.
CLI::Validator valueOf(const char* key) {
  return {[key](const std::string& text) -> std::string {
            try {
              settings::Settings settings;
              settings::assignSettingText(settings, settings::requireSetting(key), text);
              return {};
            } catch (const messages::UsageError& error) {
              return error.what();
            }
          },
          ""};
}

}  // namespace

void DressingChoices::addTo(CLI::App& app) {
  constexpr double maxMove = 10.0;  // [m]
  constexpr double fullTurn = 360.0;
  app.add_option("garment", garment, "The garment, a mesh file or a built-in one such as builtin:tshirt.obj")
      ->type_name("GARMENT")
      ->required()
      ->check(notEmpty());
  app.add_option("body", body, "The body, a mesh file, or one of mannequin, figure")
      ->type_name("BODY")
      ->required()
      ->check(notEmpty());
  app.add_option(
         "--clip", clip,
         "A clip in the file of the body moves it afterwards, from the pose of its mesh within 1 s; '': the only one")
      ->type_name("NAME");
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
  app.add_option("--scale", scale, "A factor on all lengths of the garment")
      ->check(numberFrom(scene::minPlacementScale, scene::maxPlacementScale));
  app.add_option("--body-unit", bodyReading.unit,
                 "The unit of the body's file, as the setting unit is that of the garment: auto, m, dm, cm, mm, inch, "
                 "foot, or metres per unit")
      ->type_name("UNIT")
      ->check(valueOf("unit"));
  app.add_option("--body-up", bodyReading.up,
                 "The axis of the body's file that points up, as the setting up is that of the garment: auto, y, z, x, "
                 "-y or -z")
      ->type_name("AXIS")
      ->check(valueOf("up"));
  app.add_option("--max-seconds", maxSeconds,
                 "Stop after this simulated time with the full body, if intersections are left [s]")
      ->check(numberFrom(0.0, 1000.0));
}

scene::SceneDescription DressingChoices::description(const std::string& wear, const settings::OwnFabrics& own) const {
  return scene::openGarmentOnBody(wear, body, own, bodyReading, clip);
}

std::shared_ptr<const scene::Scene> DressingChoices::open(const SceneArguments& arguments,
                                                          const settings::OwnFabrics& own) const {
  const scene::SceneDescription described = description(garment, own);
  auto scene = arguments.build(described);
  if (scale == 1.0) {
    return scene;
  }
  SceneArguments scaled = arguments;
  const double unit = scale * scene->cloths.front().placement.metresPerUnit;
  scaled.settings.push_back("unit=" + settings::formatValue(unit));
  scaled.settings.push_back("up=" + scene->cloths.front().placement.up);
  return scaled.build(described);
}

dressing::DressingOptions DressingChoices::options(const settings::Settings& settings) const {
  dressing::DressingOptions options;
  options.rule = rulesByName().at(rule);
  if (!move.empty()) {
    options.move = Vec3(move[0], move[1], move[2]);
  }
  options.turn = turn * std::numbers::pi / 180.0;
  options.maxSettleTime = maxSeconds;
  options.step = settings.step;
  return options;
}

}  // namespace drape::app
