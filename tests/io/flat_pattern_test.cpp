#include "io/garments/flat_pattern.hpp"

#include "io/garments/delaunay.hpp"
#include "io/topology_counts.hpp"

#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace drape::io {
namespace {

constexpr double edgeLength = 0.05;

double areaOf(const FlatMesh& mesh) {
  double area = 0.0;
  for (const Triangle& triangle : mesh.triangles) {
    const Vec2& a = mesh.points[triangle[0]];
    const Vec2 ab = mesh.points[triangle[1]] - a;
    const Vec2 ac = mesh.points[triangle[2]] - a;
    area += (ab.x() * ac.y() - ab.y() * ac.x()) / 2.0;
  }
  return area;
}

/// The smallest angle of a mesh [degrees].
double smallestAngle(const FlatMesh& mesh) {
  double smallest = 180.0;
  for (const Triangle& t : mesh.triangles) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const Vec2& a = mesh.points[t[corner]];
      const Vec2 ab = (mesh.points[t[(corner + 1) % 3]] - a).normalized();
      const Vec2 ac = (mesh.points[t[(corner + 2) % 3]] - a).normalized();
      smallest = std::min(smallest, std::acos(ab.dot(ac)) * 180.0 / std::numbers::pi);
    }
  }
  return smallest;
}

/// A square of one metre with a half disc cut out of its upper side.
Outline bittenSquare() {
  Outline outline({-0.5, 0.0}, edgeLength);
  outline.lineTo({0.5, 0.0}, true);
  outline.lineTo({0.5, 1.0}, false);
  outline.lineTo({0.2, 1.0}, false);
  outline.curveTo(
      [](double t) { return Vec2(0.2 * std::cos(std::numbers::pi * t), 1.0 - 0.2 * std::sin(std::numbers::pi * t)); },
      false);
  outline.lineTo({-0.5, 1.0}, false);
  outline.lineTo({-0.5, 0.0}, false);
  return outline;
}

TEST(FlatPattern, fillsTheWholeOutlineAndNothingElse) {
  const FlatMesh mesh = meshPattern({bittenSquare().points(), {}}, edgeLength);
  EXPECT_NEAR(areaOf(mesh), 1.0 - 0.02 * std::numbers::pi, 2e-3);
  const TopologyCounts topology = countTopology(mesh.points.size(), mesh.triangles);
  EXPECT_EQ(topology.boundaryLoops, 1);
  EXPECT_EQ(topology.components, 1);
  EXPECT_EQ(topology.misorientedEdges, 0);
}

TEST(FlatPattern, hasNoThinTriangles) {
  EXPECT_GT(smallestAngle(meshPattern({bittenSquare().points(), {}}, edgeLength)), 28.0);
}

TEST(FlatPattern, putsEdgesAlongInnerLines) {
  const std::vector<Vec2> line = sampleCurve([](double t) { return Vec2(-0.5 + t, 0.4); }, edgeLength);
  const FlatMesh mesh = meshPattern({bittenSquare().points(), {line}}, edgeLength);
  for (const Triangle& triangle : mesh.triangles) {
    const auto isAbove = [&](int corner) { return mesh.points[corner].y() > 0.4 + 1e-6; };
    const auto isBelow = [&](int corner) { return mesh.points[corner].y() < 0.4 - 1e-6; };
    const bool crosses = std::any_of(triangle.begin(), triangle.end(), isAbove) &&
                         std::any_of(triangle.begin(), triangle.end(), isBelow);
    EXPECT_FALSE(crosses);
  }
}

TEST(FlatPattern, marksThePointsOnSeams) {
  const Outline outline = bittenSquare();
  const std::vector<Vec2> points = outline.points();
  const std::vector<bool> sewn = outline.sewn();
  ASSERT_EQ(points.size(), sewn.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_EQ(sewn[i], points[i].y() == 0.0) << "point " << i;
  }
}

TEST(Delaunay, leavesNoPointInsideTheCircleOfATriangle) {
  std::vector<Vec2> points;
  for (int i = 0; i < 60; ++i) {
    points.emplace_back(std::fmod(i * 0.618034, 1.0), std::fmod(i * 0.414214, 1.0));
  }
  const std::vector<Triangle> triangles = delaunay(points);
  EXPECT_GT(triangles.size(), 60U);
  for (const Triangle& t : triangles) {
    const Vec2& a = points[t[0]];
    const Vec2 b = points[t[1]] - a;
    const Vec2 c = points[t[2]] - a;
    const double d = 2.0 * (b.x() * c.y() - b.y() * c.x());
    const Vec2 centre(a.x() + (c.y() * b.squaredNorm() - b.y() * c.squaredNorm()) / d,
                      a.y() + (b.x() * c.squaredNorm() - c.x() * b.squaredNorm()) / d);
    for (const Vec2& point : points) {
      EXPECT_GE((point - centre).norm(), (a - centre).norm() - 1e-9);
    }
  }
}

}  // namespace
}  // namespace drape::io
