#include "scene/scene.hpp"
#include "session/simulation.hpp"
#include "settings/settings_table.hpp"
#include "sim/measures.hpp"

#include <gtest/gtest.h>
#include <algorithm>
#include <string>
#include <vector>

/// How hard the hand pulls at cloths that bear more or less.
namespace drape {
namespace {

struct Pull {
  std::string scene;
  std::vector<std::string> settings;
  double seconds = 0.5;  ///< before the pull
};

std::shared_ptr<const Scene> sceneOf(const Pull& pull) {
  const SceneDescription description = openScene(pull.scene);
  Settings settings = description.settings;
  for (const std::string& expression : pull.settings) {
    assignSettingExpression(settings, expression);
  }
  return buildScene(description, settings);
}

void run(Simulation& simulation, double seconds) {
  const double end = simulation.state().time + seconds;
  while (simulation.state().time < end && !simulation.blewUp()) {
    simulation.step();
  }
}

/// The triangle whose centre is lowest, which no pin holds.
int lowestTriangle(const Simulation& simulation) {
  const auto height = [&](const Triangle& triangle) {
    double sum = 0.0;
    for (const int v : triangle) {
      sum += simulation.state().positions[static_cast<std::size_t>(v)].y();
    }
    return sum;
  };
  const auto& triangles = simulation.model().triangles;
  const auto lowest = std::min_element(triangles.begin(), triangles.end(),
                                       [&](const Triangle& a, const Triangle& b) { return height(a) < height(b); });
  return static_cast<int>(lowest - triangles.begin());
}

Vec3 centreOf(const Simulation& simulation, int triangle) {
  Vec3 centre = Vec3::Zero();
  for (const int v : simulation.model().triangles[static_cast<std::size_t>(triangle)]) {
    centre += simulation.state().positions[static_cast<std::size_t>(v)] / 3.0;
  }
  return centre;
}

/// What a pull comes to within half a second.
struct Pulled {
  double before = 0.0;  ///< the largest stretch before it [-]
  double most = 0.0;    ///< the largest stretch during it [-]
  double left = 0.0;    ///< how far the held point is from the target at the end [m]
};

/// Takes the lowest triangle and pulls it away.
Pulled pulled(const Pull& pull, const Vec3& way) {
  Simulation simulation(sceneOf(pull));
  run(simulation, pull.seconds);
  Pulled result;
  result.before = maxStretch(simulation.model(), simulation.state());
  const int triangle = lowestTriangle(simulation);
  const Vec3 target = centreOf(simulation, triangle) + way;
  simulation.apply(AttachCommand{triangle, Vec3::Constant(1.0 / 3.0), target});
  for (int i = 0; i < 10; ++i) {
    run(simulation, 0.05);
    result.most = std::max(result.most, maxStretch(simulation.model(), simulation.state()));
  }
  result.left = (centreOf(simulation, triangle) - target).norm();
  return result;
}

TEST(Attachment, doesNotStretchASkirtByMuchMoreThanAFifth) {
  for (const Vec3& way : {Vec3(0.13, 0, 0), Vec3(0, -0.13, 0), Vec3(0, 0, 0.5)}) {
    EXPECT_LT(pulled({"skirt", {}}, way).most, 0.25) << way.transpose();
    EXPECT_LT(pulled({"skirt", {"stiffness=1000"}}, way).most, 0.25) << way.transpose();
  }
}

TEST(Attachment, doesNotTearSoftClothAndDoesNotNeedToHoldBackOnStiffCloth) {
  const Pulled soft = pulled({"skirt", {"stiffness=10"}}, Vec3(0, 0, 0.13));
  EXPECT_LT(soft.most, 0.6) << "its own weight stretches it by " << soft.before;
  EXPECT_LT(soft.left, 0.02);
  const Pulled stiff = pulled({"grid", {"grid.resolution=17", "solver=auto", "stiffness=1e4"}}, Vec3(0, 0, 0.5));
  EXPECT_LT(stiff.most, 0.1);
  EXPECT_LT(stiff.left, 0.05);
}

TEST(Attachment, takesLightClothAlongAndMovesHeavyCloth) {
  EXPECT_LT(pulled({"grid", {"grid.resolution=17", "solver=auto", "mass=0.01"}}, Vec3(0, 0, 0.5)).left, 0.02);
  EXPECT_LT(pulled({"curtain", {}}, Vec3(0, 0, 0.5)).left, 0.1);
  // A skirt of 3 kg in place of 0.15 kg: a quarter of its weight takes its hem along.
  EXPECT_LT(pulled({"skirt", {"density=3"}}, Vec3(0, 0, 0.13)).left, 0.08);
}

TEST(Attachment, neverPullsHarderThanTheSettingAllows) {
  // The sheet would bear more than this.
  const Pulled gentle = pulled({"grid", {"grid.resolution=17", "solver=auto", "attachment.max_force=0.02"}}, Vec3(0, 0, 0.5));
  EXPECT_GT(gentle.left, 0.2);
}

}  // namespace
}  // namespace drape
