#include "report/error_sources.hpp"

#include "messages/error.hpp"
#include "settings/settings_table.hpp"
#include "sim/measures/accuracy.hpp"
#include "sim/measures/measures.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <utility>
#include <variant>

namespace drape::report {
namespace {

using Positions = std::vector<Vec3>;
using scene::OwnSetting;
using settings::Settings;

/// The scene with settings that each cloth has for itself. @param changesOf the settings, by those that count for it
template <typename ChangesOf>
std::shared_ptr<const scene::Scene> changedScene(scene::SceneDescription description, const Settings& settings,
                                                 const ChangesOf& changesOf) {
  for (scene::ClothDescription& cloth : description.cloths) {
    const std::vector<OwnSetting> changes = changesOf(scene::settingsOf(cloth.own, settings));
    cloth.own.insert(cloth.own.end(), changes.begin(), changes.end());
  }
  return scene::buildScene(description, settings);
}

/// The positions at the times of a plan [m]; empty after the cloth blew up.
std::vector<Positions> motionOf(const scene::Scene& scene, const Settings& settings, const ErrorSourcesPlan& plan,
                                const PartDone& progress) {
  Watch watch;
  if (progress) {
    watch.progress = [&](std::string_view, std::int64_t done, std::int64_t total) {
      progress(static_cast<double>(done) / static_cast<double>(total));
    };
  }
  const Trajectory run = runTrajectory(scene, settings, checkpointsIn(plan.times.back()), watch);
  return positionsAt(plan.times, run);
}

Settings referenceOf(Settings settings, const ErrorSourcesPlan& plan) {
  constexpr double maxCost = 1e6;  // never reached
  constexpr int refinement = 2;    // so that they are finer than those of `auto` as the method, too
  settings.solver.name = "auto";
  settings.step.threads = plan.threads;
  settings.step.substeps = 1;
  settings.step.automatic.errorTolerance = plan.referenceTolerance;
  settings.step.automatic.costBudget = maxCost;
  settings.step.automatic.refinement = refinement;
  settings.step.automatic.fullLift = true;
  settings.step.automatic.strainLimit = 0.0;
  settings.step.automatic.soften = false;
  return settings;
}

/// The parts of the runs in the whole time, roughly: the finer mesh has four times the vertices and twice the substeps.
constexpr double costOfMethod = 1.0;
constexpr double costOfReference = 4.0;
constexpr double costOfFinerMesh = 8.0 * costOfReference;
constexpr double costOfAll = costOfMethod + 3.0 * costOfReference + costOfFinerMesh;

}  // namespace

std::vector<std::vector<Vec3>> positionsAt(std::span<const double> times, const Trajectory& run) {
  std::vector<Positions> positions;
  for (const double time : times) {
    const auto checkpoint = static_cast<std::size_t>(checkpointsIn(time));
    positions.push_back(checkpoint < run.states.size() ? run.states[checkpoint].positions : Positions());
  }
  return positions;
}

double distanceOf(const Positions& a, const Positions& b) {
  return a.empty() || b.empty() ? std::numeric_limits<double>::infinity() : sim::meanDistance(a, b);
}

std::vector<OwnSetting> stifferMaterial(const Settings& settings) {
  constexpr double factor = 1.1;
  constexpr std::array<std::string_view, 1> springs{"stiffness"};
  constexpr std::array<std::string_view, 8> fabric{
      "fabric.stretch_warp",    "fabric.stretch_weft", "fabric.shear",     "fabric.stiffening_warp",
      "fabric.stiffening_weft", "fabric.bend_warp",    "fabric.bend_weft", "fabric.bend_bias"};
  const auto keys = settings::usesFabric(settings) ? std::span<const std::string_view>(fabric) : springs;
  std::vector<OwnSetting> changes;
  for (const std::string_view key : keys) {
    const settings::SettingInfo& info = settings::requireSetting(key);
    changes.push_back({&info, factor * std::get<double>(settings::settingValue(settings, info))});
  }
  return changes;
}

std::shared_ptr<const scene::Scene> withFinerMesh(const scene::SceneDescription& description,
                                                  const Settings& settings) {
  return changedScene(description, settings, [](const Settings& own) {
    return std::vector<OwnSetting>{{&settings::requireSetting("subdivide"), own.mesh.subdivide + 1}};
  });
}

std::shared_ptr<const scene::Scene> withStifferMaterial(const scene::SceneDescription& description,
                                                        const Settings& settings) {
  return changedScene(description, settings, stifferMaterial);
}

std::shared_ptr<const scene::Scene> withDisplacedStart(const scene::Scene& scene) {
  auto displaced = std::make_shared<scene::Scene>(scene);
  sim::displaceForTest(scene.model->pinned, displaced->start.positions);
  return displaced;
}

double meshDistance(const scene::Scene& coarse, const Positions& own, const scene::Scene& finer,
                    const Positions& fine) {
  if (own.empty() || fine.empty()) {
    return std::numeric_limits<double>::infinity();
  }
  double sum = 0.0;
  for (std::size_t c = 0; c < coarse.cloths.size(); ++c) {
    const scene::ClothPart& cloth = coarse.cloths[c];
    for (int v = 0; v < cloth.vertexCount; ++v) {
      sum += (own[cloth.firstVertex + v] - fine[finer.cloths[c].firstVertex + v]).norm();
    }
  }
  return sum / static_cast<double>(own.size());
}

std::vector<sim::ErrorSources> measureErrorSources(const scene::SceneDescription& description, const Settings& settings,
                                                   const ErrorSourcesPlan& plan, const PartDone& progress) {
  if (!description.seams.empty()) {
    throw messages::InputError("the sources of error cannot be compared for a cloth with seams");
  }
  double done = 0.0;
  const auto run = [&](const scene::Scene& scene, const Settings& used, double cost) {
    PartDone part;
    if (progress) {
      part = [&](double share) { progress((done + share * cost) / costOfAll); };
    }
    auto motion = motionOf(scene, used, plan, part);
    done += cost;
    return motion;
  };
  Settings method = settings;
  method.step.threads = plan.threads;
  const Settings exact = referenceOf(settings, plan);
  const auto own = scene::buildScene(description, settings);
  const auto finer = withFinerMesh(description, settings);
  const auto ofMethod = run(*own, method, costOfMethod);
  const auto reference = run(*own, exact, costOfReference);
  const auto displaced = run(*withDisplacedStart(*own), exact, costOfReference);
  const auto stiff = run(*withStifferMaterial(description, settings), exact, costOfReference);
  const auto fine = run(*finer, exact, costOfFinerMesh);
  std::vector<sim::ErrorSources> sources;
  for (std::size_t k = 0; k < plan.times.size(); ++k) {
    sources.push_back({.time = checkpointsIn(plan.times[k]) * checkpointInterval,
                       .method = distanceOf(ofMethod[k], reference[k]),
                       .mesh = sim::meshErrorFactor * meshDistance(*own, reference[k], *finer, fine[k]),
                       .material = distanceOf(stiff[k], reference[k]),
                       .start = distanceOf(displaced[k], reference[k])});
  }
  return sources;
}

}  // namespace drape::report
