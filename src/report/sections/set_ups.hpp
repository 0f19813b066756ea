#pragma once

#include "scene/scene.hpp"

#include <memory>
#include <string>
#include <vector>

namespace drape::report::sections {

/// A cloth of springs for a full report.
struct SpringCloth {
  int resolution = 0;     ///< vertices along the shorter side; 0 for a mesh
  std::string stiffness;  ///< [N/m], as in a setting
};

/// A cloth under defined conditions, at any resolution, for the comparison of methods.
struct SetUp {
  std::string name;                        ///< as in report.json: "twist"
  std::string help;                        ///< description, for the report
  std::string scene;                       ///< built-in scene or scene file
  std::vector<std::string> settings = {};  ///< "key=value", in place of the scene's
  std::vector<std::string> corners = {};   ///< pinned ones, in place of the scene's pins
  std::vector<std::string> edges = {};     ///< pinned ones, likewise
  double top = 0.0;  ///< of a mesh: all vertices within this share of the height from the top are pinned [-]
  std::vector<SpringCloth> cloths = {};  ///< those of a full report; empty: the usual ones (comparedCloths)
  Vec3 (*place)(const Vec3& rest, double) = nullptr;  ///< start position of a vertex [m]; see buildSetUp
};

/// Builds it with this number of vertices along the shorter side (0 for a scene with a mesh, which has its own) and
/// these settings ("key=value") in place of its own. The cloth starts at rest. `place` maps the rest position of a
/// vertex relative to the barycentre [m], and the length of the longer side [m], to its start position.
[[nodiscard]] std::shared_ptr<const scene::Scene> buildSetUp(const SetUp& setUp, int resolution,
                                                             const std::vector<std::string>& settings);

/// The scene with its cloth in another state.
[[nodiscard]] std::shared_ptr<const scene::Scene> startedFrom(const scene::Scene& scene, sim::ClothState start);

/// The same with each coordinate of each free vertex moved by up to `amplitude` [m], depending on the seed.
[[nodiscard]] std::shared_ptr<const scene::Scene> jittered(const scene::Scene& scene, double amplitude, unsigned seed);

/// The set-ups for comparing methods: without a name all set-ups of the report; otherwise the one of that name, or a
/// scene of that name with a grid. Throws InputError for anything else.
[[nodiscard]] std::vector<SetUp> comparedSetUps(const std::string& name);

/// Whether the cloth is a mesh, which has no resolution.
[[nodiscard]] inline bool isMesh(const SetUp& setUp) {
  return setUp.top > 0.0;
}

}  // namespace drape::report::sections
