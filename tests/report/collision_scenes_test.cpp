#include "report/sections/collision_run.hpp"

#include <gtest/gtest.h>
#include <string>

namespace drape {
namespace {

constexpr double duration = 0.3;  // [s]
constexpr int lookEvery = 6;      // steps between two counts
const auto noInterruption = [] {};

CollisionRun beginningOf(const std::string& name) {
  const SceneDescription description = openScene(name);
  const auto scene = buildScene(description, description.settings);
  return runCollision(*scene, duration, lookEvery, noInterruption);
}

TEST(BuiltInScenes, letNoTriangleIntoABodyFromTheirBeginning) {
  for (const SceneInfo& info : sceneList()) {
    const SceneDescription description = openScene(info.name);
    if (description.bodies.empty() && !description.ground) {
      continue;
    }
    const CollisionRun run = beginningOf(info.name);
    EXPECT_TRUE(run.finite) << info.name;
    EXPECT_EQ(run.pairsWithBodies, 0) << info.name;
    EXPECT_EQ(run.squeezed, 0) << info.name;
    EXPECT_EQ(run.overlapping, 0) << info.name << " starts inside a body";
    if (info.name == "sphere" || info.name == "tablecloth" || info.name == "mannequin") {
      EXPECT_GT(run.contacts, 50) << info.name << " meets its body";
    }
  }
}

}  // namespace
}  // namespace drape
