#include "session/stretch_cause.hpp"

#include "scene/unit_guess.hpp"
#include "session/solver_warning.hpp"
#include "settings/settings_table.hpp"
#include "sim/fabric/fabric.hpp"
#include "sim/forces/diagnostics.hpp"
#include "sim/measures/hanging_load.hpp"
#include "text/number_text.hpp"

#include <fmt/core.h>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace drape::session {
namespace {

using text::Sentence;

constexpr double muchByWeight = 0.5;    // strain under the weight alone that explains the rest [-]
constexpr double wantedStrain = 0.1;    // target of the advice [-]
constexpr double heaviestFabric = 2.0;  // leather, carpets [kg/m^2]
constexpr double usualFabric = 0.2;     // [kg/m^2]
constexpr double sliverRatio = 0.02;    // share of the median edge length
constexpr double pinsApart = 1.5;       // ratio of the extents of moved pins that explains the rest [-]
constexpr double calmMotion = 0.1;      // kinetic energy of cloth that is held, relative to the elastic energy [-]

std::string place(const Vec3& point) {
  return fmt::format("({:.3f}, {:.3f}, {:.3f}) m", point.x(), point.y(), point.z());
}

std::vector<std::size_t> overstretched(const sim::ClothModel& model, const sim::ClothState& state) {
  std::vector<std::size_t> springs;
  for (std::size_t i = 0; i < model.springs.size(); ++i) {
    const sim::Spring& spring = model.springs[i];
    const double length = (state.positions[spring.b] - state.positions[spring.a]).norm();
    if (length > (1.0 + implausibleStretch) * spring.restLength) {
      springs.push_back(i);
    }
  }
  return springs;
}

/// Whether all overstretched edges end at pins, as where the user moves pins faster than the cloth follows.
bool onlyPinsStretch(const sim::ClothModel& model, const sim::ClothState& state) {
  const std::vector<std::size_t> springs = overstretched(model, state);
  return !springs.empty() && std::ranges::all_of(springs, [&](std::size_t i) {
    return model.pinned[model.springs[i].a] || model.pinned[model.springs[i].b];
  });
}

/// How much larger the extents of the pins are than at rest [-]; 1 with fewer than two pins.
double pinExtension(const sim::ClothModel& model, const sim::ClothState& state) {
  Eigen::AlignedBox3d now;
  Eigen::AlignedBox3d rest;
  for (std::size_t v = 0; v < state.positions.size(); ++v) {
    if (model.pinned[v]) {
      now.extend(state.positions[v]);
      rest.extend(model.restPositions[v]);
    }
  }
  const bool isExtended = !rest.isEmpty() && rest.diagonal().norm() > 0.0;
  return isExtended ? now.diagonal().norm() / rest.diagonal().norm() : 1.0;
}

/// Whether the cloth hardly moves, so that external forces hold its strain.
bool isCalm(const settings::Settings& settings, const sim::ClothModel& model, const sim::ClothState& state) {
  const sim::Energy energy = sim::energyOf(model, settings.step, state);
  return energy.kinetic < calmMotion * energy.elastic;
}

double medianLength(const sim::ClothModel& model) {
  std::vector<double> lengths;
  lengths.reserve(model.springs.size());
  for (const sim::Spring& spring : model.springs) {
    lengths.push_back(spring.restLength);
  }
  const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
  std::nth_element(lengths.begin(), middle, lengths.end());
  return *middle;
}

/// A diagnosis when all overstretched edges are far shorter than the others.
std::optional<StretchDiagnosis> findSlivers(const scene::Scene& scene, const sim::ClothModel& model,
                                            const sim::ClothState& state) {
  const std::vector<std::size_t> springs = overstretched(model, state);
  const double median = model.springs.empty() ? 0.0 : medianLength(model);
  double shortest = median;
  for (const std::size_t i : springs) {
    shortest = std::min(shortest, model.springs[i].restLength);
    if (model.springs[i].restLength > sliverRatio * median) {
      return std::nullopt;
    }
  }
  if (springs.empty()) {
    return std::nullopt;
  }
  const sim::Spring& first = model.springs[springs.front()];
  const Vec3 at = 0.5 * (model.restPositions[first.a] + model.restPositions[first.b]);
  StretchDiagnosis found{StretchCause::Slivers, {}};
  found.advice.text = Sentence(
      text::plural(
          static_cast<long long>(springs.size()),
          "Slivers: {} edge is overstretched. The shortest is 1/{} of the median length. The first is at {}. "
          "Merge their ends with a larger weld_tolerance, or repair the mesh.",
          "Slivers: {} edges are overstretched. The shortest is 1/{} of the median length. The first is at {}. "
          "Merge their ends with a larger weld_tolerance, or repair the mesh."),
      springs.size(), text::roundedFigure(median / shortest, 1), place(at));
  const Vec3 size(scene.summary.size[0], scene.summary.size[1], scene.summary.size[2]);
  const double tolerance = 2.0 * sliverRatio * median / std::max(size.norm(), 1e-12);
  const auto& field = std::get<settings::NumberField>(settings::requireSetting("weld_tolerance").field);
  if (std::holds_alternative<scene::MeshFileSource>(scene.description.cloth().source) && tolerance <= field.max) {
    found.advice.key = "weld_tolerance";
    found.advice.value = text::roundedFigure(tolerance, 1);
    found.advice.button = Sentence("Merge them");
  }
  return found;
}

/// The stiffness at which the weight stretches the cloth by `wantedStrain` at most [N/m].
double helpfulStiffness(const sim::ClothModel& model, sim::StepParameters parameters) {
  const auto& field = std::get<settings::NumberField>(settings::requireSetting("stiffness").field);
  parameters.material.stiffness = 1.0;
  return std::min(field.max, text::nextRoundNumber(sim::strainByWeight(model, parameters) / wantedStrain));
}

StretchDiagnosis explainByWeight(double strain, const scene::Scene& scene, const settings::Settings& settings,
                                 const sim::ClothModel& model) {
  const double largest = *std::max_element(scene.summary.size.begin(), scene.summary.size.end());
  const double density = model.totalMass() / std::max(model.restArea(), 1e-12);
  const std::string mass = text::roundedFigure(model.totalMass());
  const std::string percent = text::roundedFigure(100.0 * strain);
  const Sentence weight("Its weight of {} kg alone stretches it by {} %", mass, percent);
  const bool file = std::holds_alternative<scene::MeshFileSource>(scene.description.cloth().source);
  if (file && largest > 2.0 * scene::largestGarment && scene.reading) {
    const double inFile = largest / scene.reading->metresPerUnit;
    const std::string unit = scene::guessUnit(inFile).unit;
    return {StretchCause::Unit,
            {Sentence("The cloth is {} m large. {}. The file is probably in {}: read it so.",
                      text::roundedFigure(largest), weight, scene::unitInWords(unit)),
             "unit", unit, Sentence("Read as {}", scene::unitInWords(unit))}};
  }
  if (density > heaviestFabric) {
    const std::string usual = text::roundedFigure(usualFabric);
    return {StretchCause::Heavy,
            {Sentence("Too heavy: the cloth weighs {} kg/m\u00B2. Fabrics weigh 0.05 to 1 kg/m\u00B2. {}. Lower the "
                      "density.",
                      text::roundedFigure(density), weight),
             "density", usual, Sentence("Density {} kg/m\u00B2", usual)}};
  }
  if (model.fabric) {
    return {StretchCause::Soft,
            {Sentence("Too soft: {}. Choose a stiffer fabric, or raise fabric.stretch_warp and fabric.stretch_weft.",
                      weight),
             "",
             "",
             {}}};
  }
  const std::string stiffness = text::roundedFigure(helpfulStiffness(model, settings.step));
  const Sentence soft = settings.step.material.stiffness > 0.0
                            ? Sentence("Its weight of {} kg alone stretches it by {} % at a stiffness of {} N/m", mass,
                                       percent, text::roundedFigure(settings.step.material.stiffness))
                            : Sentence("a stiffness of 0 cannot carry any weight");
  return {StretchCause::Soft,
          {Sentence("Too soft: {}. A stiffness of {} N/m carries it.", soft, stiffness), "stiffness", stiffness,
           Sentence("Stiffness {} N/m", stiffness)}};
}

/// A diagnosis when the rest shape is a pattern that the mesh is far from.
std::optional<StretchDiagnosis> findPattern(const settings::Settings& settings, const sim::ClothModel& model) {
  constexpr double misfit = 0.5;  // 99th percentile of the strain; that of patterns that fit is a few percent [-]
  if (!model.fabric || !model.fabric->meshStrain || !settings::restsOnPattern(settings) ||
      model.fabric->meshStrain->high < misfit) {
    return std::nullopt;
  }
  const auto& [median, high] = *model.fabric->meshStrain;
  return StretchDiagnosis{
      StretchCause::Pattern,
      {Sentence("The pattern does not fit: the mesh is strained against its UVs by {} % (median), {} % (99th "
                "percentile). Correct fabric.uv_scale or the UVs, or take the mesh as rest shape.",
                fmt::format("{:.0f}", 100.0 * median), fmt::format("{:.0f}", 100.0 * high)),
       "fabric.rest_shape", "mesh", Sentence("Use the mesh")}};
}

scene::Advice useAuto() {
  return {{}, "solver", "auto", Sentence("Use auto")};
}

/// A diagnosis when the time step is too long for the solver.
std::optional<StretchDiagnosis> findTimeStep(const settings::Settings& settings, const sim::ClothModel& model) {
  const Sentence warning = solverWarning(settings, model);
  if (settings.solver.name == "auto" || warning.empty()) {
    return std::nullopt;
  }
  StretchDiagnosis found{StretchCause::TimeStep, useAuto()};
  found.advice.text = Sentence("The time step is too long for the solver {}: {}", settings.solver.name, warning);
  return found;
}

StretchDiagnosis explainBySolver(const settings::Settings& settings) {
  const bool chooses = settings.solver.name == "auto";
  StretchDiagnosis found{StretchCause::Solver, chooses ? scene::Advice{} : useAuto()};
  found.advice.text = Sentence(
      chooses ? "Overstretched: edges are longer than three times their rest length. Neither the weight nor the mouse "
                "causes this. The solver {} failed here; use a shorter time step, then reset."
              : "Overstretched: edges are longer than three times their rest length. Neither the weight nor the mouse "
                "causes this. The solver {} failed here; use auto or a shorter time step, then reset.",
      settings.solver.name);
  return found;
}

StretchDiagnosis explainByForces(const sim::ClothModel& model) {
  return {
      StretchCause::External,
      {Sentence(model.fabric
                    ? "Bodies or the weight stretch the cloth: edges are longer than three times their rest length, "
                      "and the cloth hardly moves. Choose a stiffer fabric, or let bodies pull less far."
                    : "Bodies or the weight stretch the cloth: edges are longer than three times their rest length, "
                      "and the cloth hardly moves. Raise the stiffness, or let bodies pull less far."),
       "",
       "",
       {}}};
}

}  // namespace

StretchDiagnosis diagnoseStretch(const scene::Scene& scene, const settings::Settings& settings,
                                 const sim::ClothModel& model, const sim::ClothState& state, bool pulled) {
  if (auto pattern = findPattern(settings, model)) {
    return *std::move(pattern);
  }
  if (auto slivers = findSlivers(scene, model, state)) {
    return *std::move(slivers);
  }
  if (const double strain = sim::strainByWeight(model, settings.step); strain > muchByWeight) {
    return explainByWeight(strain, scene, settings, model);
  }
  if (pulled) {
    return {StretchCause::Attachment,
            {Sentence(model.fabric
                          ? "The mouse pulls too hard for this cloth. Release it, lower the mouse force, or choose "
                            "a stiffer fabric."
                          : "The mouse pulls too hard for this cloth. Release it, lower the mouse force, or raise "
                            "the stiffness."),
             "",
             "",
             {}}};
  }
  if (auto timeStep = findTimeStep(settings, model)) {
    return *std::move(timeStep);
  }
  if (onlyPinsStretch(model, state)) {
    return {
        StretchCause::Attachment,
        {Sentence("Pins pull at the cloth: edges there are longer than three times their rest length. It follows in "
                  "a moment; otherwise move the pins less far."),
         "",
         "",
         {}}};
  }
  if (const double ratio = pinExtension(model, state); ratio > pinsApart) {
    return {StretchCause::Attachment,
            {Sentence("Pins stretch the cloth: they are {} times as far apart as at rest. Move them closer together.",
                      text::roundedFigure(ratio)),
             "",
             "",
             {}}};
  }
  if (isCalm(settings, model, state)) {
    return explainByForces(model);
  }
  return explainBySolver(settings);
}

}  // namespace drape::session
