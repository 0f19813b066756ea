#pragma once

#include "report/trajectory.hpp"
#include "scene/scene.hpp"
#include "sim/measures/error_sources.hpp"

#include <functional>
#include <memory>
#include <span>
#include <vector>

namespace drape::report {

/// The scene at its start, with a mesh of four times the triangles.
[[nodiscard]] std::shared_ptr<const scene::Scene> withFinerMesh(const scene::SceneDescription& description,
                                                                const settings::Settings& settings);

/// The positions of a run at these times, multiples of checkpointInterval [m]; empty after the cloth blew up.
[[nodiscard]] std::vector<std::vector<Vec3>> positionsAt(std::span<const double> times, const Trajectory& run);

/// The mean distance of two sets of positions [m]; infinite if one of them is empty.
[[nodiscard]] double distanceOf(const std::vector<Vec3>& a, const std::vector<Vec3>& b);

/// The settings of a material that is stiffer by a tenth in stretch, shear and bending.
[[nodiscard]] std::vector<scene::OwnSetting> stifferMaterial(const settings::Settings& settings);

/// The scene at its start, with a material that is stiffer by a tenth in stretch, shear and bending.
[[nodiscard]] std::shared_ptr<const scene::Scene> withStifferMaterial(const scene::SceneDescription& description,
                                                                      const settings::Settings& settings);

/// The scene with free vertices displaced at the start (sim::displaceForTest).
[[nodiscard]] std::shared_ptr<const scene::Scene> withDisplacedStart(const scene::Scene& scene);

/// The mean distance of the vertices of a scene from those of withFinerMesh at the same places of the cloth [m].
[[nodiscard]] double meshDistance(const scene::Scene& coarse, const std::vector<Vec3>& own, const scene::Scene& finer,
                                  const std::vector<Vec3>& fine);

/// What to compare.
struct ErrorSourcesPlan {
  std::vector<double> times{0.2, 0.5};  ///< ascending, rounded to multiples of checkpointInterval [s]
  double referenceTolerance = 1e-5;     ///< error tolerance of `auto` in all runs but that of the method [m]
  int threads = 1;
};

/// Called during the runs with the part that is done, from 0 to 1. An exception from it ends them.
using PartDone = std::function<void(double part)>;

/// Compares the sources of error of a cloth from the start of its scene, at the rounded times of the plan. The method
/// is that of the settings. All other runs use `auto` with the full stiffness, the full lift of eq. 20, the tolerance
/// of the plan and twice the substeps that it needs. A distance is infinite where a run blew up. Throws UsageError for
/// a time step that does not divide checkpointInterval, and InputError for a cloth with seams or a mesh that is too
/// large.
[[nodiscard]] std::vector<sim::ErrorSources> measureErrorSources(const scene::SceneDescription& description,
                                                                 const settings::Settings& settings,
                                                                 const ErrorSourcesPlan& plan,
                                                                 const PartDone& progress = {});

}  // namespace drape::report
