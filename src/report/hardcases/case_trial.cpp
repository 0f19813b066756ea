#include "report/hardcases/case_trial.hpp"

#include "messages/error.hpp"
#include "report/number_text.hpp"
#include "scene/cloth_material.hpp"
#include "scene/grid_mesh.hpp"
#include "scene/mass.hpp"
#include "settings/settings_table.hpp"
#include "sim/model/seconds_since.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace drape::report::hardcases {

std::string CaseFigure::text() const {
  const std::string found =
      std::isfinite(value) ? text::figure(value) + (unit.empty() ? "" : " " + unit) : "not a number";
  return name + " " + found + (std::isinf(limit) ? "" : " (at most " + text::figure(limit) + ")");
}

CaseTrial::CaseTrial(const CaseOptions& options) : options_(options) {
  static_cast<void>(settings({}));  // reports wrong names before the run
}

settings::Settings CaseTrial::settings(const std::vector<std::string>& changes) const {
  settings::Settings settings;
  settings.material.massGivenAs = "mass";
  settings.fabric.ownDensity = false;
  settings.material.lumping = "uniform";
  settings.step.contact.self = sim::contact::SelfCollision::Off;  // the cases of contact choose theirs
  return changed(settings, changes);
}

settings::Settings CaseTrial::changed(settings::Settings settings, const std::vector<std::string>& changes) const {
  settings.solver.name = options_.solver;
  for (const auto* list : {&changes, &options_.settings}) {
    for (const std::string& expression : *list) {
      settings::assignSettingExpression(settings, expression);
    }
  }
  settings::requireConsistent(settings);
  if (sim::findSolver(settings.solver.name) == nullptr) {
    throw messages::UsageError("there is no solver '" + settings.solver.name +
                               "'; 'drape-headless list solvers' lists them");
  }
  return settings;
}

settings::Settings CaseTrial::fabricSettings(const std::string& preset, const std::vector<std::string>& changes) const {
  std::vector<std::string> all{"material.model=fabric", "material.preset=" + preset, "fabric.own_density=on"};
  all.insert(all.end(), changes.begin(), changes.end());
  settings::Settings settings = this->settings(all);
  if (!sim::findSolver(settings.solver.name)->takesFabric) {
    throw CaseRefused();
  }
  return settings;
}

void CaseTrial::expect(const std::string& name, const std::string& unit, double value, double limit) {
  const auto known =
      std::find_if(figures_.begin(), figures_.end(), [&](const CaseFigure& one) { return one.name == name; });
  if (known == figures_.end()) {
    figures_.push_back({name, unit, value, limit});
  } else if (!std::isnan(known->value) && !(value <= known->value)) {
    known->value = value;
  }
}

void CaseTrial::show(const std::string& name, const std::string& unit, double value) {
  expect(name, unit, value, std::numeric_limits<double>::infinity());
}

void CaseTrial::say(const std::string& words) {
  words_ += (words_.empty() ? "" : " ") + words;
}

void CaseTrial::warn(const sim::SolverWarning& warning) {
  if (!warning_ || warning.substeps > warning_->substeps) {
    warning_ = warning;
  }
}

double CaseTrial::seconds() const {
  return sim::secondsSince(begin_);
}

void CaseTrial::tick() const {
  options_.checkStop();
  if (seconds() > options_.maxSeconds) {
    throw CaseTooSlow();
  }
}

CaseCloth sheetCloth(const settings::Settings& settings, int resolution, Pinned pinned, double side, bool upright) {
  const scene::GridLayout layout = scene::layoutOf({resolution, side, side});
  CaseCloth cloth{
      scene::makeGrid(layout, upright ? scene::GridSource::Plane::Vertical : scene::GridSource::Plane::Horizontal)
          .cloth,
      {},
      settings,
      {},
      {},
      {},
      {}};
  if (pinned == Pinned::OneCorner || pinned == Pinned::TwoCorners) {
    cloth.pins.push_back(layout.index(0, 0));
  }
  if (pinned == Pinned::TwoCorners) {
    cloth.pins.push_back(layout.index(0, layout.columns - 1));
  }
  for (int column = 0; pinned == Pinned::TopEdge && column < layout.columns; ++column) {
    cloth.pins.push_back(layout.index(0, column));
  }
  return cloth;
}

std::shared_ptr<const sim::ClothModel> modelOf(const CaseCloth& cloth) {
  auto model = sim::buildClothModel(cloth.mesh, scene::totalMassOf(cloth.settings, sim::restAreaOf(cloth.mesh)),
                                    scene::lumpingOf(cloth.settings), cloth.pins);
  if (!cloth.masses.empty()) {
    model = sim::withVertexMasses(*model, cloth.masses);
  }
  if (!cloth.stiffness.empty()) {
    model = sim::withSpringStiffness(*model, cloth.stiffness);
  }
  return scene::withElasticity(*model, std::array{scene::wholeCloth(*model)}, cloth.settings);
}

int stableSubsteps(const sim::ClothModel& model, const settings::Settings& settings) {
  constexpr double share = 0.5;
  constexpr double finest = 1.0 / 30000.0;  // the paper's step, for a method that is never stable [s]
  const sim::SolverInfo* solver = sim::findSolver(settings.solver.name);
  if (solver == nullptr || solver->stepLimit == nullptr) {
    return settings.step.substeps;
  }
  const double limit = solver->stepLimit(model, settings.step);
  const double longest = limit > 0.0 ? share * limit : finest;
  return std::max(settings.step.substeps, static_cast<int>(std::ceil(settings.step.timeStep / longest)));
}

}  // namespace drape::report::hardcases
