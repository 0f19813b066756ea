#include "app/headless/run_stats.hpp"

#include "app/choice_json.hpp"
#include "messages/accuracy_text.hpp"
#include "report/number_text.hpp"
#include "report/settings_json.hpp"
#include "scene/cloth_material.hpp"
#include "scene/rest_pattern.hpp"
#include "settings/acting_self_collision.hpp"
#include "settings/settings_table.hpp"
#include "sim/fabric/fabric.hpp"
#include "sim/forces/diagnostics.hpp"
#include "sim/measures/measures.hpp"
#include "sim/solvers/solver.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace drape::app {
namespace {

/// The quantile of sorted values at this share (nearest rank).
double quantile(const std::vector<float>& sorted, double share) {
  if (sorted.empty()) {
    return 0.0;
  }
  const auto rank = static_cast<std::size_t>(std::ceil(share * static_cast<double>(sorted.size())));
  return static_cast<double>(sorted[std::clamp<std::size_t>(rank, 1, sorted.size()) - 1]);
}

/// Median and 99th percentile in microseconds.
nlohmann::ordered_json quantiles(std::vector<float> seconds) {
  constexpr double microseconds = 1e6;
  std::sort(seconds.begin(), seconds.end());
  const double sum = std::accumulate(seconds.begin(), seconds.end(), 0.0);
  const double mean = seconds.empty() ? 0.0 : sum / static_cast<double>(seconds.size());
  return {{"mean", mean * microseconds},
          {"median", quantile(seconds, 0.5) * microseconds},
          {"p99", quantile(seconds, 0.99) * microseconds}};
}

/// The longest stable substep [s], or null when the solver has no such limit on this cloth.
nlohmann::ordered_json stabilityLimit(const sim::ClothModel& model, const settings::Settings& settings) {
  const sim::SolverInfo* solver = sim::findSolver(settings.solver.name);
  if (solver == nullptr || solver->stepLimit == nullptr) {
    return nullptr;
  }
  return report::finiteOrNull(solver->stepLimit(model, settings.step));
}

/// What the fabric's rest shape is, and for a pattern its scale and the strain of the mesh against it.
nlohmann::ordered_json restShapeJson(const session::Simulation& simulation) {
  const sim::ClothModel& model = *simulation.cloth().pieces();
  if (!model.fabric->meshStrain || !settings::restsOnPattern(simulation.settings())) {
    return {{"from", "mesh"}, {"area", model.restArea()}};
  }
  const auto& [median, high] = *model.fabric->meshStrain;
  return {{"from", "uv"},
          {"area", model.restArea()},
          {"uv_scale", scene::patternScale(simulation.scene().cloths.front().uvs, simulation.settings())},
          {"mesh_strain", {{"median", median}, {"p99", high}}}};
}

/// The fabric's name, where its warp comes from, and the number of triangles whose stiffness is clamped. Null for
/// springs.
nlohmann::ordered_json fabricJson(const session::Simulation& simulation) {
  if (!simulation.model().fabric) {
    return nullptr;
  }
  const settings::Settings& settings = simulation.settings();
  return {{"title", scene::fabricsInWords(simulation.scene().cloths, settings).english()},
          {"warp", scene::warpInWords(simulation.scene().cloths, settings).english()},
          {"warp_from", scene::warpsAlongUvs(simulation.scene().cloths.front().uvs, settings) ? "uv" : "vertical"},
          {"rest_shape", restShapeJson(simulation)},
          {"slivers", simulation.model().fabric->slivers}};
}

/// The cloths of the scene: which vertices and triangles are theirs, their mass and, if they are fabrics, its name.
nlohmann::ordered_json clothsJson(const session::Simulation& simulation) {
  const sim::ClothModel& model = *simulation.cloth().pieces();
  nlohmann::ordered_json cloths = nlohmann::ordered_json::array();
  for (const scene::ClothPart& cloth : simulation.scene().cloths) {
    const auto masses = model.vertexMass.begin() + cloth.firstVertex;
    nlohmann::ordered_json json = {{"name", cloth.name},
                                   {"first_vertex", cloth.firstVertex},
                                   {"vertices", cloth.vertexCount},
                                   {"first_triangle", cloth.firstTriangle},
                                   {"triangles", cloth.triangleCount},
                                   {"mass", std::accumulate(masses, masses + cloth.vertexCount, 0.0)}};
    const settings::Settings own = scene::settingsOf(cloth.own, simulation.settings());
    json["fabric"] =
        model.fabric ? nlohmann::ordered_json(settings::fabricTitle(own).english()) : nlohmann::ordered_json();
    cloths.push_back(std::move(json));
  }
  return cloths;
}

/// How a mesh file was read, or null for a grid.
nlohmann::ordered_json readingJson(const std::optional<scene::MeshReading>& reading) {
  if (!reading) {
    return nullptr;
  }
  nlohmann::ordered_json others = nlohmann::ordered_json::array();
  for (const scene::ReadingAlternative& other : reading->alternatives) {
    others.push_back(other.key + "=" + other.value);
  }
  return {{"unit", reading->unit},
          {"metres_per_unit", reading->metresPerUnit},
          {"unit_guessed", scene::isGuess(reading->unitReason)},
          {"up", reading->up},
          {"up_guessed", scene::isGuess(reading->upReason)},
          {"size", reading->size},
          {"alternatives", std::move(others)},
          {"in_words", scene::inWords(*reading).english()}};
}

/// The last check of the error, or null.
nlohmann::ordered_json accuracyJson(const std::optional<sim::Accuracy>& accuracy) {
  if (!accuracy) {
    return nullptr;
  }
  return {{"time", accuracy->time},
          {"seconds", accuracy->seconds},
          {"error", accuracy->error},
          {"spread", accuracy->spread},
          {"error_known", sim::isErrorKnown(*accuracy)},
          {"words", messages::inWords(*accuracy).english()}};
}

}  // namespace

RunStats::RunStats(const std::string& file, std::int64_t steps) {
  if (!file.empty()) {
    file_.emplace(file, "statistics");
  }
  seconds_.reserve(std::min<std::int64_t>(steps, 1 << 20));
}

void RunStats::add(const session::Simulation& simulation) {
  const sim::StepReport& report = simulation.lastStepReport();
  const sim::contact::ContactReport& contact = report.contact;
  seconds_.push_back(static_cast<float>(simulation.lastStepSeconds()));
  bodySeconds_.push_back(static_cast<float>(contact.bodySeconds));
  selfSeconds_.push_back(static_cast<float>(contact.selfSeconds));
  impulseSeconds_.push_back(static_cast<float>(report.substepContactSeconds));
  if (const auto& choice = report.choice) {
    forceEvaluations_.push_back(static_cast<float>(choice->forceEvaluations));
    retriedSteps_ += choice->retries > 0 ? 1 : 0;
    fallbackSteps_ += choice->usedFallback ? 1 : 0;
    largestError_ = std::max(largestError_, choice->error);
  }
  maxOverlaps_ = std::max(maxOverlaps_, contact.overlaps);
  deepestOverlap_ = std::max(deepestOverlap_, contact.deepestOverlap);
  maxInfeasible_ = std::max(maxInfeasible_, contact.infeasible);
  maxCrossings_ = std::max(maxCrossings_, contact.crossings);
  maxIntersections_ = std::max(maxIntersections_, contact.intersections);
}

nlohmann::ordered_json RunStats::contactJson(const session::Simulation& simulation) const {
  const sim::contact::ContactReport& last = simulation.lastStepReport().contact;
  return {{"self_collision", settings::actingSelfCollision(simulation.settings())},
          {"bodies_us", quantiles(bodySeconds_)},
          {"self_us", quantiles(selfSeconds_)},
          {"substeps_us", quantiles(impulseSeconds_)},
          {"body_contacts", last.bodyContacts},
          {"self_contacts", last.selfContacts},
          {"overlaps_max", maxOverlaps_},
          {"overlaps_final", last.overlaps},
          {"deepest_overlap", deepestOverlap_},
          {"infeasible_max", maxInfeasible_},
          {"crossings_max", maxCrossings_},
          {"crossings_final", last.crossings},
          {"intersections_max", maxIntersections_},
          {"intersections_final", last.intersections}};
}

nlohmann::ordered_json RunStats::choiceJson(const session::Simulation& simulation) const {
  const auto& last = simulation.lastStepReport().choice;
  nlohmann::ordered_json json = app::toJson(last, simulation.scene().cloths, simulation.settings());
  if (last) {
    std::vector<float> evaluations = forceEvaluations_;
    std::sort(evaluations.begin(), evaluations.end());
    json["force_evaluations_median"] = quantile(evaluations, 0.5);
    json["force_evaluations_max"] = quantile(evaluations, 1.0);
    json["retried_steps"] = retriedSteps_;
    json["fallback_steps"] = fallbackSteps_;
    json["error_max"] = largestError_;
  }
  return json;
}

nlohmann::ordered_json RunStats::toJson(const session::Simulation& simulation) const {
  const sim::ClothModel& model = simulation.model();
  const sim::Energy energy = sim::energyOf(model, simulation.settings().step, simulation.state());
  nlohmann::ordered_json json;
  json["scene"] = simulation.scene().description.name;
  json["reading"] = readingJson(simulation.scene().reading);
  json["vertices"] = model.vertexCount();
  json["springs"] = model.springs.size();
  json["triangles"] = model.triangles.size();
  json["cloths"] = clothsJson(simulation);
  json["fabric"] = fabricJson(simulation);
  json["pins"] = std::ranges::count(simulation.cloth().pieces()->pinned, true);
  json["mass"] = model.totalMass();
  json["steps"] = simulation.stepIndex();
  json["time"] = simulation.state().time;
  json["step_us"] = quantiles(seconds_);
  json["contact"] = contactJson(simulation);
  json["choice"] = choiceJson(simulation);
  json["accuracy"] = accuracyJson(simulation.accuracy());
  json["energy"] = energy.total();
  json["energy_kinetic"] = energy.kinetic;
  json["energy_elastic"] = energy.elastic;
  json["energy_potential"] = energy.potential;
  json["max_stretch"] = sim::maxStretch(model, simulation.state());
  json["stability_limit"] = stabilityLimit(model, simulation.settings());
  if (const session::Ghost* ghost = simulation.ghost()) {
    json["ghost_distance_mean"] = sim::meanDistance(simulation.state().positions, ghost->state().positions);
  }
  json["finite"] = !simulation.blewUp() && sim::isFinite(simulation.state());
  json["state_hash"] = sim::toHex(sim::stateHash(simulation.state()));
  json["settings"] = report::settingsJson(simulation.settings());
  return json;
}

void RunStats::write(const nlohmann::ordered_json& figures) {
  if (file_) {
    file_->write(figures);
  }
}

}  // namespace drape::app
