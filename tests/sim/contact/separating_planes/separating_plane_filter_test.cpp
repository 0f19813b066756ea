#include "sim/contact/separating_planes/separating_plane_filter.hpp"

#include <gtest/gtest.h>

namespace drape::sim::contact {
namespace {

struct Fallback {
  Vec3 start, carried;
};

/// Applies the filter to one vertex at `position`.
int filter(const std::vector<SeparatingPlane>& planes, const Fallback& fallback, double bound, Vec3& position) {
  const std::vector<double> inverseMass{1.0};
  const std::vector<double> bounds{bound};
  const std::vector<Vec3> predicted{fallback.start};
  std::vector<Vec3> positions{position};
  const int infeasible = SeparatingPlaneFilter().apply(
      planes, inverseMass, bounds, 1,
      {[&](int, int) { return fallback.start; }, [&](int, int) { return fallback.carried; }}, predicted, positions);
  position = positions[0];
  return infeasible;
}

TEST(SeparatingPlaneFilter, projectsOnlyVerticesThatViolateTheirPlanes) {
  const std::vector<SeparatingPlane> ground{{0, 0, Vec3::UnitY(), 0.0}};
  Vec3 above(0.3, 0.1, 0.0);
  EXPECT_EQ(filter(ground, {Vec3::Zero(), Vec3::Zero()}, 1.0, above), 0);
  EXPECT_EQ(above, Vec3(0.3, 0.1, 0.0));
  Vec3 below(0.3, -0.1, 0.0);
  EXPECT_EQ(filter(ground, {Vec3::Zero(), Vec3::Zero()}, 1.0, below), 0);
  EXPECT_EQ(below, Vec3(0.3, 0.0, 0.0));
}

TEST(SeparatingPlaneFilter, enforcesTheDisplacementBound) {
  Vec3 position(0.9, 0.0, 0.0);
  EXPECT_EQ(filter({}, {Vec3::Zero(), Vec3::Zero()}, 0.5, position), 0);
  EXPECT_NEAR(position.x(), 0.5, 1e-12);
}

TEST(SeparatingPlaneFilter, usesTheFallbackPosition) {
  // The ground rose by 0.2 past the vertex, and a wall at an acute angle prevents convergence of the projections.
  const Vec3 wall = Vec3(0.02, -1.0, 0.0).normalized();
  const std::vector<SeparatingPlane> wedge{{0, 0, Vec3::UnitY(), 0.2}, {0, 0, wall, wall.y() * 0.21}};
  Vec3 position(-5.0, 0.0, 0.0);
  EXPECT_EQ(filter(wedge, {Vec3::Zero(), Vec3(0.0, 0.205, 0.0)}, 10.0, position), 0);
  for (const SeparatingPlane& plane : wedge) {
    EXPECT_GE(plane.normal.dot(position) - plane.height, -1e-9);
  }
}

TEST(SeparatingPlaneFilter, findsAFeasiblePositionFromAnInfeasibleFallback) {
  const std::vector<SeparatingPlane> corner{{0, 0, Vec3::UnitY(), 0.1}, {0, 0, Vec3(1.0, 0.2, 0.0).normalized(), 0.1}};
  Vec3 position(0.0, -0.3, 0.0);
  EXPECT_EQ(filter(corner, {Vec3::Zero(), Vec3::Zero()}, 0.3, position), 0);
  for (const SeparatingPlane& plane : corner) {
    EXPECT_GE(plane.normal.dot(position) - plane.height, -1e-9);
  }
  EXPECT_LE(position.norm(), 0.3 + 1e-9);
}

TEST(SeparatingPlaneFilter, countsAnInfeasibleVertex) {
  const std::vector<SeparatingPlane> opposing{{0, 0, Vec3::UnitY(), 0.1}, {0, 0, -Vec3::UnitY(), 0.1}};
  Vec3 position = Vec3::Zero();
  EXPECT_EQ(filter(opposing, {Vec3::Zero(), Vec3::Zero()}, 1.0, position), 1);
}

}  // namespace
}  // namespace drape::sim::contact
