#include "report/error_sources.hpp"
#include "report/number_text.hpp"
#include "report/sections/cloth_with_reference.hpp"
#include "report/sections/error_sources_view.hpp"
#include "report/sections/section_scene.hpp"
#include "report/sections/sections.hpp"
#include "report/sections/time_limit.hpp"
#include "report/sections/work_plan.hpp"
#include "settings/settings_table.hpp"
#include "sim/measures/measures.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace drape::report::sections {
namespace {

using Positions = std::vector<Vec3>;

/// A rest position as a key: two vertices of nested grids in the same place have the same key.
std::array<long, 3> keyOf(const Vec3& position) {
  constexpr double cellsPerMetre = 1e5;
  return {std::lround(cellsPerMetre * position.x()), std::lround(cellsPerMetre * position.y()),
          std::lround(cellsPerMetre * position.z())};
}

std::map<std::array<long, 3>, std::size_t> placesOf(const sim::ClothModel& model) {
  std::map<std::array<long, 3>, std::size_t> places;
  for (std::size_t v = 0; v < model.restPositions.size(); ++v) {
    places[keyOf(model.restPositions[v])] = v;
  }
  return places;
}

Vec3 mirrored(const Vec3& position) {
  return {-position.x(), position.y(), position.z()};
}

/// The positions of a cloth at the measured times [m], by the solver of the settings.
std::vector<Positions> motionOf(const scene::Scene& scene, const settings::Settings& settings,
                                const std::function<void()>& checkStop) {
  constexpr double maxSeconds = 300.0;
  const TimeLimit limit(checkStop, maxSeconds);
  const Trajectory run = runTrajectory(scene, settings, measuredCheckpoints, limit.watch());
  return positionsAt(measuredTimes, run);
}

/// Mean distance of the vertices of a coarse grid from those of a finer one in the same places [m].
double meshDistance(const scene::Scene& coarse, const Positions& own, const scene::Scene& fine,
                    const Positions& finer) {
  const auto places = placesOf(*fine.model);
  double sum = 0.0;
  for (std::size_t v = 0; v < own.size(); ++v) {
    sum += (own[v] - finer.at(places.at(keyOf(coarse.model->restPositions[v])))).norm();
  }
  return sum / static_cast<double>(own.size());
}

/// The vertex in the mirror image of each vertex, in x; empty if the start is not symmetric.
std::vector<std::size_t> mirrorOf(const scene::Scene& scene) {
  constexpr double rounding = 1e-6;  // [m]
  const auto places = placesOf(*scene.model);
  std::vector<std::size_t> mirror;
  for (std::size_t v = 0; v < scene.model->restPositions.size(); ++v) {
    const auto found = places.find(keyOf(mirrored(scene.model->restPositions[v])));
    const bool symmetric =
        found != places.end() && scene.model->pinned[v] == scene.model->pinned[found->second] &&
        (scene.start.positions[v] - mirrored(scene.start.positions[found->second])).norm() < rounding;
    if (!symmetric) {
      return {};
    }
    mirror.push_back(found->second);
  }
  return scene.settings.step.air.wind.x() == 0.0 ? mirror : std::vector<std::size_t>();
}

/// Mean distance of a motion from its mirror image [m]: that of the same cloth with its diagonals turned. Not a number
/// if the cloth is not symmetric.
double diagonalDistance(const scene::Scene& scene, const Positions& positions) {
  const std::vector<std::size_t> mirror = mirrorOf(scene);
  double sum = mirror.empty() ? std::numeric_limits<double>::quiet_NaN() : 0.0;
  for (std::size_t v = 0; v < mirror.size(); ++v) {
    sum += (positions[v] - mirrored(positions[mirror[v]])).norm();
  }
  return sum / static_cast<double>(positions.size());
}

/// stifferMaterial as "key=value".
std::vector<std::string> stiffer(const settings::Settings& settings) {
  std::vector<std::string> changes;
  for (const scene::OwnSetting& change : stifferMaterial(settings)) {
    changes.push_back(fmt::format("{}={:.9g}", change.info->key, std::get<double>(change.value)));
  }
  return changes;
}

/// A cloth whose sources of error are compared.
struct ComparedErrors {
  ComparedErrors(const SetUp& setUp, const ComparedCloth& compared)
      : name(setUp.name),
        cloth(compared),
        own(buildSetUp(setUp, compared.resolution, settingsOf(compared))),
        finer(buildSetUp(setUp, 2 * compared.resolution - 1, settingsOf(compared))),
        moved(jittered(*own, jitterLength, 1)) {
    std::vector<std::string> changed = settingsOf(compared);
    const std::vector<std::string> changes = stiffer(own->settings);
    changed.insert(changed.end(), changes.begin(), changes.end());
    stiff = buildSetUp(setUp, compared.resolution, changed);
  }

  static std::vector<std::string> settingsOf(const ComparedCloth& compared) {
    std::vector<std::string> settings = compared.material.settings;
    settings.insert(settings.end(), {"solver=auto", "time_step=1/150", "substeps=1", "threads=1"});
    return settings;
  }

  std::string name;
  ComparedCloth cloth;
  std::shared_ptr<const scene::Scene> own;
  std::shared_ptr<const scene::Scene> finer;
  std::shared_ptr<const scene::Scene> moved;
  std::shared_ptr<const scene::Scene> stiff;
};

ReportRows measureSources(const ComparedErrors& compared, const std::function<void()>& checkStop) {
  const auto with = [&](const scene::Scene& scene, const std::vector<std::string>& changes) {
    return motionOf(scene, changedSettings(scene, changes), checkStop);
  };
  const std::vector<std::string> exact{"auto.tolerance=1e-7", "auto.cost=1e6", "precision=double"};
  const auto reference = with(*compared.own, exact);
  const auto automatic = with(*compared.own, {"precision=float"});
  const auto implicit = with(*compared.own, {"solver=newton"});
  const auto fine = with(*compared.finer, exact);
  const auto moved = with(*compared.moved, exact);
  const auto stiff = with(*compared.stiff, exact);
  ReportRows rows;
  for (std::size_t k = 0; k < measuredTimes.size(); ++k) {
    rows.push_back({{"scene", compared.name},
                    {"resolution", resolutionJson(compared.cloth.resolution)},
                    {"material", compared.cloth.material.name},
                    {"stiffness", compared.cloth.material.isFabric() ? ReportRow(nullptr)
                                                                     : ReportRow(*compared.cloth.material.stiffness)},
                    {"time", measuredTimes.at(k)},
                    {"auto", finiteOrNull(distanceOf(automatic[k], reference[k]))},
                    {"implicit", finiteOrNull(distanceOf(implicit[k], reference[k]))},
                    {"mesh", finiteOrNull(sim::meshErrorFactor *
                                          meshDistance(*compared.own, reference[k], *compared.finer, fine[k]))},
                    {"diagonals", finiteOrNull(diagonalDistance(*compared.own, reference[k]))},
                    {"stiffer", finiteOrNull(distanceOf(stiff[k], reference[k]))},
                    {"jitter", finiteOrNull(distanceOf(moved[k], reference[k]))}});
  }
  return rows;
}

/// The cloths: the sheets that the work-precision section compares, at the two coarser resolutions.
SectionPlan plan(const ReportOptions& options) {
  constexpr int finest = 33;
  SectionPlan plan;
  const std::vector<SetUp> setUps = comparedSetUps(options.scene);
  for (const SetUp& setUp : setUps) {
    for (const ComparedCloth& cloth : comparedCloths(setUp, setUp.name == setUps.front().name, options.quick)) {
      const bool isStiff = cloth.material.stiffness && *cloth.material.stiffness > 1e4;
      if (isMesh(setUp) || cloth.resolution > finest || (options.quick && isStiff)) {
        continue;
      }
      const std::string key = setUp.name + " " + sizeText(cloth.resolution) + " " + cloth.material.title;
      plan.cells.push_back({key, 5.0, [setUp, cloth](const CellContext& context) {
                              try {
                                return measureSources(ComparedErrors(setUp, cloth), context.checkStop);
                              } catch (const TooSlow&) {
                                return ReportRows();
                              }
                            }});
    }
  }
  return plan;
}

}  // namespace

Section errorSources() {
  return {"error_sources", "Where the error comes from", plan, showErrorSources};
}

}  // namespace drape::report::sections
