#include "sim/contact/closest_features/nearest_search.hpp"

#include "test_meshes.hpp"

#include <gtest/gtest.h>
#include <algorithm>
#include <utility>
#include <vector>

namespace drape::sim::contact {
namespace {

/// Ground with hills. Many points have several closest triangles, at edges and corners.
MeshShape hills() {
  const ClothMesh sheet = testing::sheet(17);
  MeshShape shape{sheet.positions, sheet.triangles, {}, 1.0, false};
  for (Vec3& position : shape.positions) {
    position.y() = 0.03 * std::round(3.0 * std::sin(20.0 * position.x()) * std::cos(15.0 * position.z()));
  }
  return shape;
}

/// All leaves of a mesh's tree.
struct LeavesOfMesh {
  explicit LeavesOfMesh(const SearchableMesh& mesh) {
    for (std::size_t leaf = 0; leaf < mesh.tree.leafCount(); ++leaf) {
      leaves.push_back(static_cast<int>(leaf));
      boxes.add(mesh.tree.leafBox(leaf));
    }
  }

  std::vector<int> leaves;
  BoxList boxes;
};

void expectSame(const NearestMeshPoint& a, const NearestMeshPoint& b) {
  EXPECT_EQ(a.triangle, b.triangle);
  EXPECT_EQ(a.gap, b.gap);
  EXPECT_EQ(a.weights, b.weights);
  EXPECT_EQ(a.normal, b.normal);
}

TEST(NearestSearch, findsTheSameBitsFromTheCacheAsByANewSearch) {
  const SearchableMesh mesh(hills());
  const MeshInStep inStep{mesh, mesh.shape.positions, mesh.shape.positions, false};
  const LeavesOfMesh all(mesh);
  constexpr double radius = 0.05;  // [m]
  constexpr double within = 0.004;
  NearestSearch search(inStep);
  testing::RandomVectors random(3);
  int remembered = 0;
  for (int i = 0; i < 3000; ++i) {
    Vec3 point = Vec3(0.5, 0.01, 0.5) + random.next(0.3);
    point.y() = 0.02 + 0.1 * point.y();
    if (i % 3 == 0) {
      point = mesh.shape.positions[static_cast<std::size_t>(i) % mesh.shape.positions.size()] + 0.02 * Vec3::UnitY();
    }
    (void)search.among(all.leaves, all.boxes, point, radius, within);
    NearbyTriangles memory;
    search.remember(point, within, 1.0, memory);
    if (memory.validRadius < 0.0) {
      continue;
    }
    ++remembered;
    for (const Vec3& there : {point, Vec3(point + random.next(within / 2.0)), Vec3(point - within * Vec3::UnitX())}) {
      const double moved = (there - point).norm() + 1e-9;
      expectSame(search.amongRemembered(memory, there, radius, moved),
                 search.among(all.leaves, all.boxes, there, radius));
    }
  }
  EXPECT_GT(remembered, 1000);
}

TEST(NearestSearch, findsTheSameBitsInTheWholeMeshAsInItsLeaves) {
  MeshShape shape = hills();
  std::reverse(shape.triangles.begin(),
               shape.triangles.end());  // so that the tree does not start with the first triangles
  const SearchableMesh mesh(std::move(shape));
  const MeshInStep inStep{mesh, mesh.shape.positions, mesh.shape.positions, false};
  const LeavesOfMesh all(mesh);
  NearestSearch search(inStep);
  testing::RandomVectors random(4);
  for (int i = 0; i < 2000; ++i) {
    // Above a corner all of its triangles have the same distance.
    const Vec3 corner = mesh.shape.positions[static_cast<std::size_t>(i) % mesh.shape.positions.size()];
    const Vec3 point = i % 2 == 0 ? Vec3(corner + 0.01 * Vec3::UnitY()) : Vec3(corner + random.next(0.02));
    expectSame(search.anywhere(point, 0.05), search.among(all.leaves, all.boxes, point, 0.05));
  }
}

TEST(NearestSearch, cachesALowerBoundWhereNothingIsNear) {
  const SearchableMesh mesh(hills());
  const MeshInStep inStep{mesh, mesh.shape.positions, mesh.shape.positions, false};
  const LeavesOfMesh all(mesh);
  NearestSearch search(inStep);
  const Vec3 far(0.5, 1.0, 0.5);
  EXPECT_LT(search.among(all.leaves, all.boxes, far, 0.1).triangle, 0);
  NearbyTriangles memory;
  search.remember(far, 0.01, 2.0, memory);
  EXPECT_LT(memory.validRadius, 0.0);
  EXPECT_GT(memory.clearRadius, 0.8);
  EXPECT_LE(memory.clearRadius, NearestSearch(inStep).anywhere(far, 2.0).gap);
  search.remember(far, 0.01, 0.5, memory);  // triangles outside the leaves may be closer
  EXPECT_EQ(memory.clearRadius, 0.5);
}

}  // namespace
}  // namespace drape::sim::contact
