#include "report/number_text.hpp"
#include "report/sections/cloth_with_reference.hpp"
#include "report/sections/error_check_view.hpp"
#include "report/sections/section_scene.hpp"
#include "report/sections/sections.hpp"
#include "report/sections/time_limit.hpp"
#include "report/sections/work_plan.hpp"
#include "session/simulation.hpp"
#include "sim/measures/measures.hpp"

#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>

namespace drape::report::sections {
namespace {

/// The methods whose errors are checked, with the settings that differ from the default.
struct CheckedMethod {
  const char* solver;
  std::vector<std::string> settings = {};
};

std::vector<CheckedMethod> checkedMethods() {
  return {{"auto", {"precision=float"}}, {"one_iteration"}, {"newton"}};
}

/// The checkpoint at the end of a check.
const int checkedCheckpoint = checkpointsIn(session::AccuracyCheck::window);

/// The result of the check that the viewer makes, and the true error at its end.
struct CheckedRun {
  std::optional<sim::Accuracy> accuracy;
  double error = 0.0;  ///< mean distance from the converged reference [m]
};

CheckedRun checkedRun(const scene::Scene& scene, settings::Settings settings, const Reference& reference,
                      const TimeLimit& limit) {
  settings.measures.errorCheck = true;
  auto checked = std::make_shared<scene::Scene>(scene);
  checked->settings = std::move(settings);
  session::Simulation simulation(checked);
  for (int step = 0; step < stepsToMeasured.front(); ++step) {
    limit.check();
    simulation.step();
  }
  const auto& positions = reference.trajectory.states.at(static_cast<std::size_t>(checkedCheckpoint)).positions;
  return {simulation.accuracy(), sim::meanDistance(simulation.state().positions, positions)};
}

ReportRows measureMethod(ClothWithReference& cloth, const CheckedMethod& method, const CellContext& context) {
  constexpr double maxSeconds = 60.0;
  ReportRow row{
      {"scene", cloth.name()},
      {"resolution", resolutionJson(cloth.resolution())},
      {"material", cloth.material().name},
      {"stiffness", cloth.material().isFabric() ? ReportRow(nullptr) : ReportRow(*cloth.material().stiffness)},
      {"time", session::AccuracyCheck::window},
      {"method", method.solver},
      {"state", "no reference"},
      {"error", nullptr},
      {"checked_error", nullptr},
      {"spread", nullptr},
      {"noise_floor", nullptr},
      {"reference_difference", nullptr}};
  const Reference* reference = cloth.reference(context.checkStop);
  if (reference == nullptr || reference->trajectory.checkpoints() < checkedCheckpoint) {
    return {row};
  }
  row["noise_floor"] = finiteOrNull(cloth.noiseFloor(checkedCheckpoint, context.checkStop));
  row["reference_difference"] = finiteOrNull(reference->differences.at(static_cast<std::size_t>(checkedCheckpoint)));
  std::vector<std::string> assignments{"solver=" + std::string(method.solver)};
  assignments.insert(assignments.end(), method.settings.begin(), method.settings.end());
  try {
    const CheckedRun run = checkedRun(cloth.scene(), changedSettings(cloth.scene(), assignments), *reference,
                                      TimeLimit(context.checkStop, maxSeconds));
    row["error"] = finiteOrNull(run.error);
    row["state"] = run.accuracy ? sim::isErrorKnown(*run.accuracy) ? "known" : "not known" : "no result";
    if (run.accuracy) {
      row["checked_error"] = finiteOrNull(run.accuracy->error);
      row["spread"] = finiteOrNull(run.accuracy->spread);
    }
  } catch (const TooSlow&) {
    row["state"] = "too slow";
  }
  return {row};
}

SectionPlan plan(const ReportOptions& options) {
  SectionPlan plan;
  const std::vector<SetUp> setUps = comparedSetUps(options.scene);
  for (const SetUp& setUp : setUps) {
    for (const ComparedCloth& compared : comparedCloths(setUp, setUp.name == setUps.front().name, options.quick)) {
      const auto cloth =
          std::make_shared<ClothWithReference>(setUp, compared.resolution, compared.material, options.quick);
      const std::string name = setUp.name + " " + sizeText(compared.resolution) + " " + compared.material.title;
      for (const CheckedMethod& method : checkedMethods()) {
        const sim::SolverInfo* solver = sim::findSolver(method.solver);
        if (solver != nullptr && takes(*solver, compared)) {
          plan.cells.push_back({name + ", " + method.solver, 1.0,
                                [=](const CellContext& context) { return measureMethod(*cloth, method, context); }});
        }
      }
    }
  }
  return plan;
}

}  // namespace

Section errorCheck() {
  return {"error_check", "The error that the window shows", plan, showErrorCheck};
}

}  // namespace drape::report::sections
