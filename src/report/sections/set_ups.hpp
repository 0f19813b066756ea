#pragma once

#include "scene/scene.hpp"

#include <memory>
#include <string>
#include <vector>

namespace drape {

/// A cloth under stated conditions, at any resolution: what methods are compared on.
struct SetUp {
  std::string name;                                   ///< as in report.json: "twist"
  std::string help;                                   ///< what it is, for the report
  std::string scene;                                  ///< built-in scene or scene file whose cloth is a grid
  std::vector<std::string> settings = {};             ///< "key=value", in place of the scene's
  std::vector<std::string> corners = {};              ///< held ones, in place of the scene's pins
  std::vector<std::string> edges = {};                ///< likewise
  Vec3 (*place)(const Vec3& rest, double) = nullptr;  ///< where a vertex starts [m]; see buildSetUp
};

/// Builds it with so many vertices along the shorter side and these settings ("key=value") in place of its own. The
/// cloth starts at rest; with `place` every vertex at the place that this gives for its rest position relative to the
/// barycentre of the rest shape [m] and the length of the sheet's longer side [m].
[[nodiscard]] std::shared_ptr<const Scene> buildSetUp(const SetUp& setUp, int resolution,
                                                      const std::vector<std::string>& settings);

/// The scene with its cloth in another state.
[[nodiscard]] std::shared_ptr<const Scene> startedFrom(const Scene& scene, ClothState start);

/// The same, each coordinate of each free vertex moved by up to `most` [m]; another seed moves it otherwise.
[[nodiscard]] std::shared_ptr<const Scene> jittered(const Scene& scene, double most, unsigned seed);

/// What methods are compared on: without a name all of the report's own; else the one of that name, or a scene of that
/// name whose cloth is a grid. Throws InputError for anything else.
[[nodiscard]] std::vector<SetUp> comparedSetUps(const std::string& name);

}  // namespace drape
