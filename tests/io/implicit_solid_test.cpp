#include "io/garments/implicit_solid.hpp"

#include "sim/model/enclosed_volume.hpp"

#include <gtest/gtest.h>
#include <cmath>
#include <numbers>

namespace drape::io {
namespace {

double volumeOf(const RawMesh& mesh) {
  return sim::enclosedVolume(mesh.positions, mesh.triangles);
}

TEST(ImplicitSolid, distancesToABarAreThoseOfACapsuleWhenItIsRoundAndEven) {
  const TaperedBar bar{{0, 0, 0}, {0, 2, 0}, 0.5, 0.5};
  EXPECT_DOUBLE_EQ(distanceTo(bar, {1.5, 1.0, 0.0}), 1.0);
  EXPECT_DOUBLE_EQ(distanceTo(bar, {0.0, 3.0, 0.0}), 0.5);
  EXPECT_DOUBLE_EQ(distanceTo(bar, {0.0, 1.0, 0.1}), -0.4);
}

TEST(ImplicitSolid, distancesToAnEllipsoidAreZeroOnItAndThoseOfASphereWhenItIsRound) {
  const Ellipsoid ellipsoid{{1, 2, 3}, {0.5, 0.25, 2.0}};
  EXPECT_NEAR(distanceTo(ellipsoid, {1.5, 2.0, 3.0}), 0.0, 1e-15);
  EXPECT_NEAR(distanceTo(ellipsoid, {1.0, 2.0, 1.0}), 0.0, 1e-15);
  EXPECT_LT(distanceTo(ellipsoid, {1.0, 2.0, 3.0}), 0.0);
  EXPECT_NEAR(distanceTo(Ellipsoid{{0, 0, 0}, {2, 2, 2}}, {3.0, 0.0, 4.0}), 3.0, 1e-15);
}

TEST(ImplicitSolid, aFilletOnlyAddsAndOnlyWhereBothAreNear) {
  EXPECT_DOUBLE_EQ(joined(0.1, 0.3, 0.1), 0.1);
  EXPECT_DOUBLE_EQ(joined(0.3, 0.1, 0.1), 0.1);
  EXPECT_DOUBLE_EQ(joined(0.1, 0.1, 0.1), 0.1 - 0.025);
}

TEST(ImplicitSolid, theSurfaceOfABallIsClosedRoundAndEven) {
  const Ellipsoid ball{{0.1, 0.2, -0.1}, {0.5, 0.5, 0.5}};
  const RawMesh mesh = surfaceOf([&](const Vec3& p) { return distanceTo(ball, p); }, {-1, -1, -1}, {1, 1, 1}, 0.08);
  for (const Vec3& position : mesh.positions) {
    EXPECT_NEAR((position - ball.centre).norm(), 0.5, 1e-9);
  }
  EXPECT_NEAR(volumeOf(mesh), 4.0 / 3.0 * std::numbers::pi * 0.125, 0.01);
  const MeshSummary summary = weldMesh(mesh, "ball", {}).summary;
  EXPECT_EQ(summary.components, 1);
  EXPECT_EQ(summary.boundaryLoops, 0);
  EXPECT_EQ(summary.nonManifoldEdges, 0);
  EXPECT_EQ(summary.misorientedEdges, 0);
  EXPECT_EQ(summary.vertices - summary.springs + summary.triangles, 2) << "Euler's formula";
}

}  // namespace
}  // namespace drape::io
