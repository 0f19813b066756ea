#include "report/number_text.hpp"
#include "report/sections/collision_run.hpp"
#include "report/sections/collision_view.hpp"
#include "report/sections/paper_times.hpp"
#include "report/sections/sections.hpp"
#include "settings/acting_self_collision.hpp"
#include "settings/settings_table.hpp"

#include <string>
#include <variant>
#include <vector>

namespace drape::report::sections {
namespace {

constexpr double microseconds = 1e6;
/// Default interval between two counts of intersecting triangles [steps].
constexpr int usualInterval = 5;

/// A scene and its measurement.
struct ContactScene {
  const char* scene;
  double seconds;                               ///< simulated time
  std::vector<int> resolutions = {};            ///< of its grid; empty: that of the scene
  std::vector<std::string> selfCollision = {};  ///< the values of this setting; empty: that of the scene
  int countEvery = usualInterval;
};

const std::vector<ContactScene>& contactScenes(bool quick) {
  static const std::vector<std::string> each{"off", "hash", "exact"};
  static const std::vector<std::string> both{"hash", "exact"};
  static const std::vector<ContactScene> few{{"fold", 3.0, {17, 33}, each}, {"sphere", 0.6, {17}}};
  static const std::vector<ContactScene> all{{"fold", 3.0, {17, 33, 65}, each},
                                             {"edge_drop", 2.0, {}, each},
                                             {"falling_sheet", 1.5, {}, {}, 10},
                                             {"falling_sheet_in_air", 2.5, {}, {}, 10},
                                             {"sphere", 2.0, {33}},
                                             {"sphere", 1.5, {65}},
                                             {"sphere", 0.8, {129}},
                                             {"turning_sphere", 5.0, {}, both, 10},
                                             {"flag_on_pole", 4.0, {}, {}, 10},
                                             {"tablecloth", 2.0, {}, both},
                                             {"mannequin", 2.0},
                                             {"cape", 6.24, {}, both, 10}};
  return quick ? few : all;
}

/// The kinds of contact of a scene with its settings, without the ground and the stand, which most scenes have.
std::string modeOf(const scene::Scene& scene) {
  std::string self = settings::actingSelfCollision(scene.settings);
  if (!scene.settings.step.contact.bodies || scene.description.bodies.empty()) {
    return self;
  }
  return self == "off" ? "bodies" : "bodies+" + self;
}

ReportRow rowOf(const ContactScene& contactScene, const scene::Scene& scene, const CollisionRun& run) {
  const double thousands = static_cast<double>(scene.model->triangles.size()) / 1000.0;
  const bool grid = std::holds_alternative<scene::GridSource>(scene.description.cloth().source);
  return {{"scene", contactScene.scene},
          {"resolution", grid ? ReportRow(scene.settings.grid.resolution) : ReportRow(nullptr)},
          {"vertices", scene.model->vertexCount()},
          {"triangles", scene.model->triangles.size()},
          {"bodies", scene.bodies->size()},
          {"method", scene.settings.solver.name},
          {"mode", modeOf(scene)},
          {"seconds", contactScene.seconds},
          {"steps", run.steps},
          {"us_per_step", finiteOrNull(microseconds * run.stepSeconds)},
          {"contact_us_per_step", finiteOrNull(microseconds * run.contactSeconds)},
          {"contact_us_p99", finiteOrNull(microseconds * run.longestContact)},
          {"bodies_us_per_step", finiteOrNull(microseconds * run.bodySeconds)},
          {"bodies_us_per_1000_triangles", finiteOrNull(microseconds * run.bodySeconds / thousands)},
          {"self_us_per_step", finiteOrNull(microseconds * run.selfSeconds)},
          {"self_us_p99", finiteOrNull(microseconds * run.longestSelf)},
          {"paper_self_us", finiteOrNull(microseconds * paperSelfCollision(grid ? scene.settings.grid.resolution : 0))},
          {"energy_gained", finiteOrNull(run.energyGained)},
          {"end_speed", finiteOrNull(run.endSpeed)},
          {"contacts_max", run.contacts},
          {"infeasible_max", run.infeasible},
          {"intersecting_pairs_max", run.pairsWithSelf + run.pairsWithBodies},
          {"intersecting_pairs_self_max", run.pairsWithSelf},
          {"intersecting_pairs_bodies_max", run.pairsWithBodies},
          {"intersecting_share", finiteOrNull(run.shareWithSelf)},
          {"finite", run.finite}};
}

ReportRows measure(const ContactScene& contactScene, const std::vector<std::string>& settings,
                   const CellContext& context) {
  scene::SceneDescription description = scene::openScene(contactScene.scene);
  for (const std::string& expression : settings) {
    settings::assignSettingExpression(description.settings, expression);
  }
  const auto scene = scene::buildScene(description, description.settings);
  return {rowOf(contactScene, *scene,
                runCollision(*scene, contactScene.seconds, contactScene.countEvery, context.checkStop))};
}

/// Adds the cells of one scene at one resolution; 0 is that of the scene.
void addCells(const ContactScene& contactScene, int resolution, const ReportOptions& options,
              std::vector<Cell>& cells) {
  std::string key = contactScene.scene;
  std::vector<std::string> settings{"threads=" + std::to_string(options.threads)};
  if (resolution > 0) {
    key += " " + gridText(resolution);
    settings.push_back("grid.resolution=" + std::to_string(resolution));
  }
  const double weight = 1e-3 * (resolution > 0 ? resolution * resolution : 1500) * contactScene.seconds;
  const auto add = [&](const std::string& suffix) {
    cells.push_back({key + suffix, weight, [&contactScene, settings](const CellContext& context) {
                       return measure(contactScene, settings, context);
                     }});
  };
  if (contactScene.selfCollision.empty()) {
    add("");
  }
  for (const std::string& mode : contactScene.selfCollision) {
    settings.push_back("self_collision=" + mode);
    add(" " + mode);
    settings.pop_back();
  }
}

SectionPlan plan(const ReportOptions& options) {
  SectionPlan plan;
  for (const ContactScene& contactScene : contactScenes(options.quick)) {
    if (contactScene.resolutions.empty()) {
      addCells(contactScene, 0, options, plan.cells);
    }
    for (const int resolution : contactScene.resolutions) {
      addCells(contactScene, resolution, options, plan.cells);
    }
  }
  return plan;
}

}  // namespace

Section collision() {
  return {"collision", "Collision", plan, showCollision};
}

}  // namespace drape::report::sections
