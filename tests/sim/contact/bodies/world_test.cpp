#include "sim/contact/bodies/world.hpp"

#include <gtest/gtest.h>
#include <cmath>
#include <map>

namespace drape::sim::contact {
namespace {

std::shared_ptr<const std::vector<Body>> twoBodies() {
  std::vector<Body> bodies(2);
  bodies[0].name = "still";
  bodies[1].name = "moving";
  bodies[1].motion.keyframes = {{0.0, Vec3::Zero(), Vec3::Zero()}, {1.0, Vec3(1, 0, 0), Vec3::Zero()}};
  return std::make_shared<const std::vector<Body>>(std::move(bodies));
}

TEST(BodyWorld, startsEachStepWhereTheLastOneEnded) {
  BodyWorld world(twoBodies(), 0.25);
  ASSERT_EQ(world.steps().size(), 2U);
  EXPECT_EQ(world.steps()[1].start.position, world.steps()[1].end.position);
  const double before = world.steps()[1].end.position.x();
  world.advance(0.25, 0.1);
  EXPECT_EQ(world.steps()[1].start.position.x(), before);
  EXPECT_EQ(world.steps()[1].end.position.x(), poseAt(world.bodies()[1].motion, 0.35).position.x());
  EXPECT_EQ(world.steps()[0].end.position, Vec3(0, 0, 0));
}

TEST(BodyWorld, followsADragAtABoundedSpeedAndForgetsItWithAReset) {
  BodyWorld world(twoBodies(), 0.0);
  world.shiftTowards(0, Vec3(0.0, 0.1, 0.0));
  world.advance(0.0, 0.01);
  EXPECT_NEAR(world.pose(0).position.y(), BodyWorld::maxDragSpeed * 0.01, 1e-15);
  for (int i = 0; i < 5; ++i) {
    world.advance(0.0, 0.01);
  }
  EXPECT_EQ(world.pose(0).position, Vec3(0.0, 0.1, 0.0));
  world.reset(0.0);
  EXPECT_EQ(world.pose(0).position, Vec3(0, 0, 0));
  world.advance(0.0, 0.01);
  EXPECT_EQ(world.pose(0).position, Vec3(0, 0, 0));
}

TEST(BodyWorld, omitsBodiesThatAreOff) {
  BodyWorld world(twoBodies(), 0.0);
  world.switchOn(0, false);
  ASSERT_EQ(world.steps().size(), 1U);
  EXPECT_EQ(world.steps()[0].body->name, "moving");
  world.switchOn(0, true);
  EXPECT_EQ(world.steps().size(), 2U);
}

TEST(BodyWorld, interpolatesAMeshSequenceLinearlyBetweenItsFrames) {
  MeshShape mesh;
  mesh.positions = {Vec3(0, 0, 0)};
  mesh.frames = {{Vec3(0, 0, 0)}, {Vec3(1, 0, 0)}, {Vec3(1, 2, 0)}};
  mesh.frameTime = 0.5;
  std::vector<Vec3> positions;
  meshPositionsAt(mesh, 0.75, positions);
  EXPECT_EQ(positions[0], Vec3(1, 1, 0));
  meshPositionsAt(mesh, 9.0, positions);
  EXPECT_EQ(positions[0], Vec3(1, 2, 0));
  mesh.loop = true;
  meshPositionsAt(mesh, 1.25, positions);
  EXPECT_EQ(positions[0], Vec3(0.5, 1, 0));
  meshPositionsAt(mesh, 1.75, positions);
  EXPECT_EQ(positions[0], Vec3(0.5, 0, 0));
}

TEST(BodyWorld, showsTheFramesBeforeTheLoopOnce) {
  MeshShape mesh;
  mesh.positions = {Vec3(5, 0, 0)};
  mesh.frames = {{Vec3(5, 0, 0)}, {Vec3(0, 0, 0)}, {Vec3(1, 0, 0)}, {Vec3(2, 0, 0)}};
  mesh.frameTime = 1.0;
  mesh.loop = true;
  mesh.loopStart = 1;
  std::vector<Vec3> positions;
  const auto at = [&](double time) {
    meshPositionsAt(mesh, time, positions);
    return positions[0].x();
  };
  EXPECT_EQ(at(-1.0), 5.0);
  EXPECT_EQ(at(0.5), 2.5);
  EXPECT_EQ(at(3.0), 2.0);
  EXPECT_EQ(at(3.5), 1.0);
  EXPECT_EQ(at(4.0), 0.0);
  EXPECT_EQ(at(5.5), 1.5);
  EXPECT_EQ(at(7.0), 0.0);
}

/// Every edge has two faces in opposite directions, and the volume is positive and slightly below the true one.
void expectClosed(const BodySurface& surface, double volume, double tolerance) {
  std::map<std::pair<int, int>, int> edges;
  double six = 0.0;
  for (const Triangle& t : surface.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      ++edges[{t[k], t[(k + 1) % 3]}];
    }
    const auto at = [&](std::size_t k) { return surface.positions[t[k]]; };
    six += at(0).dot(at(1).cross(at(2)));
  }
  for (const auto& [edge, count] : edges) {
    EXPECT_EQ(count, 1);
    EXPECT_EQ(edges.count({edge.second, edge.first}), 1U);
  }
  EXPECT_LE(six / 6.0, volume + 1e-12);
  EXPECT_GT(six / 6.0, volume * (1.0 - tolerance));
}

TEST(BodySurface, ofEachShapeIsClosedFacesOutwardsAndLiesWithinTheTrueOne) {
  expectClosed(surfaceOf(SphereShape{0.5}), 4.0 / 3.0 * M_PI * 0.125, 0.01);
  expectClosed(surfaceOf(CapsuleShape{0.1, 0.5}), M_PI * 0.01 * (1.0 + 4.0 / 3.0 * 0.1), 0.01);
  expectClosed(surfaceOf(BoxShape{Vec3(1, 2, 3)}), 48.0, 1e-9);
  for (const Vec3& position : surfaceOf(CapsuleShape{0.1, 0.5}).positions) {
    const double along = std::clamp(position.y(), -0.5, 0.5);
    EXPECT_LE((position - Vec3(0, along, 0)).norm(), 0.1 + 1e-15);
  }
  const BodySurface plane = surfaceOf(PlaneShape{2.0});
  const Triangle& t = plane.triangles[0];
  const auto at = [&](std::size_t k) { return plane.positions[t[k]]; };
  EXPECT_GT((at(1) - at(0)).cross(at(2) - at(0)).y(), 0.0);
}

}  // namespace
}  // namespace drape::sim::contact
