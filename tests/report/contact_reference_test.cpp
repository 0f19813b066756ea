#include "report/sections/contact_reference.hpp"

#include "report/sections/budget_cloth.hpp"
#include "report/sections/budget_curves.hpp"
#include "small_grid.hpp"

#include <gtest/gtest.h>
#include <algorithm>
#include <memory>
#include <string>

namespace drape::report {
namespace {

constexpr int checkpointsOfRun = 6;
const auto neverStop = [] {};

/// A small sheet that falls onto a ball, which it touches after 0.03 s.
std::shared_ptr<const scene::Scene> sheetOnBall() {
  scene::SceneDescription description = scene::openScene("sphere");
  description.settings.grid.resolution = 9;
  for (const char* setting : {"time_step=1/150", "substeps=1", "precision=double"}) {
    settings::assignSettingExpression(description.settings, setting);
  }
  return scene::buildScene(description, description.settings);
}

TEST(ContactReference, convergesAndTellsHowFarTwoStartsPart) {
  const auto scene = testing::smallGrid({"stiffness=10"});
  const auto known = sections::contactReference(*scene, scene->settings, checkpointsOfRun, 10.0, neverStop);
  ASSERT_EQ(known.reference.trajectory.checkpoints(), checkpointsOfRun);
  EXPECT_LE(known.reference.differences.back(), 1e-5);
  ASSERT_EQ(known.parting.size(), static_cast<std::size_t>(checkpointsOfRun) + 1);
  EXPECT_GT(known.parting.back(), 0.0);
  EXPECT_LT(known.parting.back(), 1e-5);  // the motion is not chaotic
}

TEST(ContactReference, hasTheContactOfTheScene) {
  const auto scene = sheetOnBall();
  auto without = std::make_shared<scene::Scene>(*scene);
  without->settings.step.contact.bodies = false;
  const auto touching = sections::contactReference(*scene, scene->settings, checkpointsOfRun, 0.5, neverStop);
  const auto falling = sections::contactReference(*without, without->settings, checkpointsOfRun, 0.5, neverStop);
  const auto highest = [](const Trajectory& run) {
    const auto& positions = run.states.back().positions;
    return std::max_element(positions.begin(), positions.end(),
                            [](const Vec3& a, const Vec3& b) { return a.y() < b.y(); })
        ->y();
  };
  EXPECT_GT(highest(touching.reference.trajectory), highest(falling.reference.trajectory) + 1e-3);
}

TEST(BudgetCloth, hasTheSameSelfCollisionForAllMethods) {
  const auto ofPaper = testing::smallGrid({"solver=one_iteration", "self_collision=auto"});
  const auto ofAuto = testing::smallGrid({"solver=auto", "self_collision=auto"});
  const auto selfOf = [](const scene::Scene& scene) {
    return sections::withSettledContact(scene, {})->settings.step.contact.self;
  };
  EXPECT_EQ(selfOf(*ofPaper), sim::contact::SelfCollision::Hash);
  EXPECT_EQ(selfOf(*ofAuto), sim::contact::SelfCollision::Exact);
}

TEST(BudgetCurves, haveOnlySolversThatTakeTheMaterial) {
  for (const char* model : {"springs", "fabric"}) {
    const auto scene = testing::smallGrid({std::string("material.model=") + model});
    const auto curves = sections::budgetCurves(*scene);
    EXPECT_GE(curves.size(), 5U);
    for (const sections::MethodCurve& curve : curves) {
      const sim::SolverInfo* solver = sim::findSolver(curve.method);
      ASSERT_NE(solver, nullptr) << curve.method;
      EXPECT_TRUE(solver->takesFabric || scene->model->fabric == nullptr) << curve.label;
      for (const std::string& value : curve.values) {
        EXPECT_NO_THROW((void)testing::with(*scene, {"solver=" + curve.method, curve.varied + "=" + value}));
      }
    }
  }
}

}  // namespace
}  // namespace drape::report
