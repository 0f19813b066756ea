#include "fabrics/presets.hpp"
#include "report/number_text.hpp"
#include "report/sections/pace_view.hpp"
#include "report/sections/sections.hpp"
#include "report/sections/time_limit.hpp"
#include "scene/scene.hpp"
#include "session/simulation.hpp"
#include "settings/settings_table.hpp"
#include "sim/fabric/fabric.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

namespace drape::report::sections {
namespace {

/// A scene in which the presets are compared.
struct PaceScene {
  std::string name;   ///< of the built-in scene
  int resolution;     ///< of a grid; 0: a mesh
  double seconds;     ///< of motion [s]
  std::string title;  ///< for the table
};

std::vector<PaceScene> scenesOf(bool quick) {
  if (quick) {
    return {{"curtain", 17, 0.2, "curtain"}};
  }
  return {{"curtain", 33, 1.0, "curtain"},
          {"curtain", 65, 1.0, "curtain"},
          {"curtain", 91, 0.5, "curtain"},
          {"mannequin", 0, 1.0, "T-shirt on the mannequin"}};
}

std::shared_ptr<const scene::Scene> sceneOf(const PaceScene& pace, std::string_view preset) {
  scene::SceneDescription description = scene::openScene(pace.name);
  std::vector<std::string> settings{"solver=auto",
                                    "material.model=fabric",
                                    "material.preset=" + std::string(preset),
                                    "fabric.own_density=on",
                                    "auto.strain=0.01",
                                    "precision=float",
                                    "threads=1",
                                    "time_step=1/150"};
  if (pace.resolution > 0) {
    settings.push_back("grid.resolution=" + std::to_string(pace.resolution));
  }
  for (const std::string& expression : settings) {
    settings::assignSettingExpression(description.settings, expression);
  }
  return scene::buildScene(description, description.settings);
}

ReportRows measurePace(const PaceScene& pace, std::string_view preset, const std::function<void()>& checkStop) {
  constexpr double maxSeconds = 120.0;
  const auto scene = sceneOf(pace, preset);
  session::Simulation simulation(scene);
  simulation.step();  // sets the solver up
  const TimeLimit limit(checkStop, maxSeconds);
  const double start = simulation.state().time;
  double evaluations = 0.0;
  double stiffness = 1.0;
  int steps = 0;
  bool ended = false;
  try {
    for (; simulation.state().time < pace.seconds; ++steps) {
      limit.check();
      simulation.step();
      if (const auto& choice = simulation.lastStepReport().choice) {
        evaluations += choice->forceEvaluations;
        stiffness = std::min(stiffness, choice->stiffnessScale);
      }
    }
    ended = true;
  } catch (const TooSlow&) {
  }
  const auto strains = sim::fabric::strainsAlongYarns(simulation.model(), simulation.state().positions);
  const double simulated = std::max(simulation.state().time - start, scene->settings.step.timeStep);
  return {{{"scene", pace.title},
           {"resolution", resolutionJson(pace.resolution)},
           {"vertices", simulation.model().vertexCount()},
           {"material", preset},
           {"ms_per_frame", finiteOrNull(1e3 * limit.spent() / simulated * frameSeconds)},
           {"evaluations_per_step", finiteOrNull(evaluations / std::max(1, steps))},
           {"stiffness_lowest", stiffness},
           {"strain_last", finiteOrNull(*std::ranges::max_element(strains))},
           {"ended", ended}}};
}

SectionPlan plan(const ReportOptions& options) {
  SectionPlan plan;
  for (const PaceScene& pace : scenesOf(options.quick)) {
    for (const fabrics::Preset& preset : fabrics::presetTable()) {
      if (options.quick && preset.name != "cotton" && preset.name != "jersey") {
        continue;
      }
      const std::string_view name = preset.name;
      plan.cells.push_back(
          {pace.name + " " + sizeText(pace.resolution) + " " + std::string(name), options.quick ? 0.1 : 8.0,
           [pace, name](const CellContext& context) { return measurePace(pace, name, context.checkStop); }});
    }
  }
  return plan;
}

}  // namespace

Section pace() {
  return {"pace", "Fabrics against the clock", plan, showPace};
}

}  // namespace drape::report::sections
