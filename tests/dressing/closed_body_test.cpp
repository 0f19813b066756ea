#include "dressing/closed_body.hpp"

#include "shapes.hpp"
#include "sim/model/enclosed_volume.hpp"
#include "sim/model/mesh_topology.hpp"

#include <gtest/gtest.h>
#include <algorithm>
#include <utility>

namespace drape::dressing::testing {
namespace {

/// Whether each side of a triangle has a partner in the opposite direction.
bool hasInside(const sim::ClothMesh& mesh) {
  const sim::MeshEdges edges = sim::edgesOf(mesh.triangles, mesh.positions.size());
  for (std::size_t e = 0; e < edges.edges.size(); ++e) {
    const auto sides = edges.sides[e];
    const auto ascending = std::ranges::count_if(sides, [](const auto& side) { return side.ascending; });
    if (2 * ascending != std::ssize(sides)) {
      return false;
    }
  }
  return true;
}

double volumeOf(const sim::ClothMesh& mesh) {
  return sim::enclosedVolume(mesh.positions, mesh.triangles);
}

sim::ClothMesh without(sim::ClothMesh mesh, double above, double below) {
  std::erase_if(mesh.triangles, [&](const Triangle& t) {
    const double y = mesh.positions[t[0]].y();
    return y > above || y < below;
  });
  return mesh;
}

TEST(ClosedBody, LeavesAClosedMeshAsItIs) {
  const ClosedBody closed = closedBody(ellipsoid({0.2, 0.5, 0.2}));
  EXPECT_EQ(closed.holes, 0);
  EXPECT_EQ(closed.addedArea, 0.0);
  EXPECT_EQ(closed.mesh.triangles, ellipsoid({0.2, 0.5, 0.2}).triangles);
}

TEST(ClosedBody, FillsEachHoleWithAFlatCapFromInside) {
  const sim::ClothMesh open = without(ellipsoid({0.2, 0.5, 0.2}), 0.3, -0.3);
  ASSERT_FALSE(hasInside(open));
  const ClosedBody closed = closedBody(open);
  EXPECT_EQ(closed.holes, 2);
  EXPECT_TRUE(hasInside(closed.mesh));
  EXPECT_TRUE(std::equal(open.positions.begin(), open.positions.end(), closed.mesh.positions.begin()));
  const double whole = volumeOf(ellipsoid({0.2, 0.5, 0.2}));
  EXPECT_LT(volumeOf(closed.mesh), whole);
  EXPECT_GT(volumeOf(closed.mesh), 0.7 * whole);
  EXPECT_GT(closed.addedArea, 0.1);
  EXPECT_LT(closed.addedArea, 0.5);
}

TEST(ClosedBody, FillsAHoleOfOneTriangleWithOneTriangle) {
  sim::ClothMesh open = ellipsoid({0.2, 0.5, 0.2});
  open.triangles.erase(open.triangles.begin() + 7);
  const ClosedBody closed = closedBody(open);
  EXPECT_EQ(closed.holes, 1);
  EXPECT_EQ(closed.mesh.positions.size(), open.positions.size());
  EXPECT_EQ(closed.mesh.triangles.size(), open.triangles.size() + 1);
  EXPECT_TRUE(hasInside(closed.mesh));
}

TEST(ClosedBody, ClosesHolesThatMeetAtAVertexAndEdgesOfThreeTriangles) {
  sim::ClothMesh bowTie = ellipsoid({0.2, 0.5, 0.2});
  const int shared = bowTie.triangles[40][0];
  std::vector<std::size_t> around;
  for (std::size_t t = 0; t < bowTie.triangles.size(); ++t) {
    if (std::ranges::count(bowTie.triangles[t], shared) > 0) {
      around.push_back(t);
    }
  }
  ASSERT_GE(around.size(), 4U);
  bowTie.triangles.erase(bowTie.triangles.begin() + static_cast<std::ptrdiff_t>(around.back()));
  bowTie.triangles.erase(bowTie.triangles.begin() + static_cast<std::ptrdiff_t>(around.front()));
  EXPECT_TRUE(hasInside(closedBody(bowTie).mesh));

  sim::ClothMesh fin = ellipsoid({0.2, 0.5, 0.2});
  fin.positions.emplace_back(0.5, 0.0, 0.0);
  fin.triangles.push_back({fin.triangles[0][0], fin.triangles[0][1], static_cast<int>(fin.positions.size()) - 1});
  EXPECT_TRUE(hasInside(closedBody(fin).mesh));
}

}  // namespace
}  // namespace drape::dressing::testing
