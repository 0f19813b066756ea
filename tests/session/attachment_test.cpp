#include "scene/scene.hpp"
#include "session/simulation.hpp"
#include "sim/measures/measures.hpp"
#include "test_scene.hpp"

#include <gtest/gtest.h>
#include <algorithm>
#include <string>
#include <vector>

/// Pulls by an attachment at cloths of different strength.
namespace drape::session {
namespace {

struct Pull {
  std::string scene;
  std::vector<std::string> settings;
  double seconds = 0.5;  ///< before the pull
};

void run(Simulation& simulation, double seconds) {
  const double end = simulation.state().time + seconds;
  while (simulation.state().time < end && !simulation.blewUp()) {
    simulation.step();
  }
}

/// The triangle without pins whose centre is lowest.
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

/// The result of a pull of half a second.
struct Pulled {
  double before = 0.0;  ///< the largest stretch before it [-]
  double during = 0.0;  ///< the largest stretch during it [-]
  double left = 0.0;    ///< distance of the attached point from the target at the end [m]
};

/// Attaches to the lowest triangle and pulls it away.
Pulled pulled(const Pull& pull, const Vec3& way) {
  Simulation simulation(testing::builtIn(pull.scene, pull.settings));
  run(simulation, pull.seconds);
  Pulled result;
  result.before = sim::maxStretch(simulation.model(), simulation.state());
  const int triangle = lowestTriangle(simulation);
  const Vec3 target = centreOf(simulation, triangle) + way;
  simulation.apply(AttachCommand{{triangle, Vec3::Constant(1.0 / 3.0), target}});
  for (int i = 0; i < 10; ++i) {
    run(simulation, 0.05);
    result.during = std::max(result.during, sim::maxStretch(simulation.model(), simulation.state()));
  }
  result.left = (centreOf(simulation, triangle) - target).norm();
  return result;
}

TEST(Attachment, doesNotStretchASkirtByMuchMoreThanAFifth) {
  for (const Vec3& way : {Vec3(0.13, 0, 0), Vec3(0, -0.13, 0), Vec3(0, 0, 0.5)}) {
    EXPECT_LT(pulled({"skirt", {}}, way).during, 0.25) << way.transpose();
    EXPECT_LT(pulled({"skirt", {"material.model=springs", "stiffness=1000"}}, way).during, 0.25) << way.transpose();
  }
}

TEST(Attachment, doesNotTearSoftClothAndDoesNotNeedToHoldBackOnStiffCloth) {
  const Pulled soft = pulled({"skirt", {"material.model=springs", "stiffness=10", "density=0.15"}}, Vec3(0, 0, 0.13));
  EXPECT_LT(soft.during, 0.6) << "its own weight stretches it by " << soft.before;
  EXPECT_LT(soft.left, 0.02);
  const Pulled stiff = pulled({"grid", {"grid.resolution=17", "solver=auto", "stiffness=1e4"}}, Vec3(0, 0, 0.5));
  EXPECT_LT(stiff.during, 0.1);
  EXPECT_LT(stiff.left, 0.05);
}

TEST(Attachment, takesLightClothAlongAndMovesHeavyCloth) {
  EXPECT_LT(pulled({"grid", {"grid.resolution=17", "solver=auto", "mass=0.01"}}, Vec3(0, 0, 0.5)).left, 0.02);
  EXPECT_LT(pulled({"curtain", {}}, Vec3(0, 0, 0.5)).left, 0.1);
  // A skirt of 3 kg instead of 0.15 kg: a quarter of its weight moves its hem.
  EXPECT_LT(pulled({"skirt", {"density=3"}}, Vec3(0, 0, 0.13)).left, 0.08);
}

TEST(Attachment, neverPullsHarderThanTheSettingAllows) {
  // The limit of this sheet is higher.
  const Pulled gentle =
      pulled({"grid", {"grid.resolution=17", "solver=auto", "attachment.max_force=0.02"}}, Vec3(0, 0, 0.5));
  EXPECT_GT(gentle.left, 0.2);
}

}  // namespace
}  // namespace drape::session
