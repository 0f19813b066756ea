#include "intersection/intersections.hpp"
#include "session/simulation.hpp"
#include "test_scene.hpp"

#include <gtest/gtest.h>
#include <cmath>

namespace drape::session {
namespace {

/// A sheet whose right half is folded over the left one, with a dent that passes through it.
std::shared_ptr<const scene::Scene> tangledSheet(const std::string& selfCollision) {
  auto scene = std::make_shared<scene::Scene>(
      *testing::smallGrid(21, {"pins=none", "solver=auto", "gravity=0", "self_collision=" + selfCollision}));
  for (Vec3& position : scene->start.positions) {
    const double x = position.x();
    if (x > 0.0) {
      const double dent = 0.08 * std::exp(-(Vec2(x - 0.3, position.z()).squaredNorm()) / 0.02);
      position = Vec3(-x + 0.013, position.y() + 0.03 * std::min(1.0, x / 0.1) - dent, position.z() + 0.017);
    }
  }
  return scene;
}

std::size_t pairsIn(const Simulation& simulation) {
  return intersection::intersectingPairs({simulation.state().positions, simulation.model().triangles}).size();
}

TEST(UntangleCommand, removesAllIntersectionsAndKeepsTheTime) {
  Simulation simulation(tangledSheet("exact"));
  simulation.step();
  const std::size_t before = pairsIn(simulation);
  const double time = simulation.state().time;
  ASSERT_GT(before, 20U);
  EXPECT_GT(simulation.lastStepReport().contact.intersections, 20);
  simulation.apply(UntangleCommand{});
  EXPECT_EQ(pairsIn(simulation), 0U);
  EXPECT_EQ(simulation.message(), "");
  EXPECT_EQ(simulation.state().time, time);
  EXPECT_EQ(simulation.state().velocities[7], Vec3::Zero());
  simulation.step();
  EXPECT_EQ(pairsIn(simulation), 0U);
  EXPECT_EQ(simulation.lastStepReport().contact.intersections, 0);
}

TEST(UntangleCommand, separatesASheetThatIsFoldedFlatOntoItself) {
  auto scene = std::make_shared<scene::Scene>(
      *testing::smallGrid(17, {"pins=none", "solver=auto", "gravity=0", "self_collision=exact"}));
  for (Vec3& position : scene->start.positions) {
    position.x() = std::abs(position.x());
  }
  Simulation simulation(scene);
  ASSERT_GT(pairsIn(simulation), 100U);
  simulation.apply(UntangleCommand{});
  EXPECT_EQ(pairsIn(simulation), 0U);
  EXPECT_EQ(simulation.message(), "");
}

TEST(UntangleCommand, isReplayedWithTheSameBits) {
  Simulation first(tangledSheet("exact"));
  first.step();
  first.apply(UntangleCommand{});
  first.step();
  Simulation second(tangledSheet("exact"));
  second.replay(first.log(), first.stepsTaken());
  EXPECT_EQ(stateHash(second.state()), stateHash(first.state()));
}

TEST(DrawnIntersections, areOnePerPairOfTrianglesWithAnySelfCollision) {
  for (const char* selfCollision : {"off", "hash", "exact"}) {
    Simulation simulation(tangledSheet(selfCollision));
    Snapshot snapshot;
    simulation.capture(snapshot);
    EXPECT_TRUE(snapshot.intersections.empty()) << "not asked for";
    simulation.apply(SetSettingCommand{"view.intersections", true});
    simulation.capture(snapshot);
    EXPECT_EQ(snapshot.intersections.size(), pairsIn(simulation)) << selfCollision;
    for (const sim::contact::IntersectionSegment& segment : snapshot.intersections) {
      EXPECT_LT((segment.to - segment.from).norm(), 0.1);
    }
    simulation.apply(UntangleCommand{});
    simulation.capture(snapshot);
    EXPECT_TRUE(snapshot.intersections.empty()) << selfCollision;
  }
}

}  // namespace
}  // namespace drape::session
