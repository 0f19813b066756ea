#include "report/sections/collision_run.hpp"
#include "settings/settings_table.hpp"

#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace drape::report {
namespace {

constexpr double duration = 0.3;  // [s]
constexpr int countEvery = 6;     // steps between two counts
const auto noInterruption = [] {};

sections::CollisionRun beginningOf(const std::string& name, const std::vector<std::string>& changes) {
  const scene::SceneDescription description = scene::openScene(name);
  settings::Settings settings = description.settings;
  for (const std::string& change : changes) {
    settings::assignSettingExpression(settings, change);
  }
  return sections::runCollision(*scene::buildScene(description, settings), duration, countEvery, noInterruption);
}

void expectNothingInsideBodies(const sections::CollisionRun& run, const std::string& what) {
  EXPECT_TRUE(run.finite) << what;
  EXPECT_EQ(run.pairsWithBodies, 0) << what;
  EXPECT_EQ(run.infeasible, 0) << what;
  EXPECT_EQ(run.overlapping, 0) << what;
}

TEST(BuiltInScenes, letNoTriangleIntoABodyFromTheirBeginning) {
  for (const scene::SceneInfo& info : scene::sceneList()) {
    const sections::CollisionRun run = beginningOf(info.name, {});
    expectNothingInsideBodies(run, info.name);
    if (info.name == "sphere" || info.name == "tablecloth" || info.name == "mannequin") {
      EXPECT_GT(run.contacts, 50) << info.name << " meets its body";
    }
  }
}

// The long form of these two is scripts/check-intersections --winds.
TEST(BuiltInScenes, letNoTriangleIntoABodyInWind) {
  for (const char* name : {"skirt", "flag", "curtain"}) {
    for (const char* wind : {"wind.x=-10", "wind.z=-10"}) {
      const sections::CollisionRun run = beginningOf(name, {"wind.x=0", "wind.z=0", wind});
      expectNothingInsideBodies(run, std::string(name) + ", " + wind);
    }
  }
}

TEST(BuiltInScenes, letNoTriangleIntoABodyWithoutPins) {
  for (const char* name : {"skirt", "flag", "curtain"}) {
    expectNothingInsideBodies(beginningOf(name, {"pins=none"}), name);
  }
}

}  // namespace
}  // namespace drape::report
