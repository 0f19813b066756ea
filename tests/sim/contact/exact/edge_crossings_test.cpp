#include "sim/contact/exact/edge_crossings.hpp"

#include "contact/exact/crossings_at_rest.hpp"
#include "intersection/intersections.hpp"
#include "test_meshes.hpp"

#include <gtest/gtest.h>
#include <map>

namespace drape::sim::contact {
namespace {

/// A flat sheet in no coordinate plane, each of whose triangles is divided at the middles of its edges. But for
/// rounding, its vertices lie in one plane and its edges on common lines.
ClothMesh dividedSheet(int side) {
  const Eigen::Matrix3d turn(Eigen::AngleAxisd(0.7, Vec3(1.0, 0.4, -0.3).normalized()));
  const ClothMesh coarse = testing::sheet(side);
  ClothMesh mesh;
  for (const Vec3& position : coarse.positions) {
    mesh.positions.emplace_back(turn * position);
  }
  std::map<std::pair<int, int>, int> middles;
  const auto middle = [&](int a, int b) {
    const auto [place, isNew] = middles.try_emplace(std::minmax(a, b), static_cast<int>(mesh.positions.size()));
    if (isNew) {
      mesh.positions.emplace_back(0.5 * (mesh.positions[a] + mesh.positions[b]));
    }
    return place->second;
  };
  for (const auto& [a, b, c] : coarse.triangles) {
    const int ab = middle(a, b);
    const int bc = middle(b, c);
    const int ca = middle(c, a);
    mesh.triangles.insert(mesh.triangles.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
  }
  return mesh;
}

std::vector<EdgeCrossing> crossingsOf(const ClothMesh& cloth) {
  const auto model = buildClothModel(cloth, 1.0, MassLumping::Uniform, {});
  return testing::crossingsAtRest(*model, featureMeshOf(*model));
}

TEST(EdgeCrossings, areNotFoundBetweenThePartsOfDividedTriangles) {
  const ClothMesh mesh = dividedSheet(30);
  ASSERT_TRUE(intersection::intersectingPairs({mesh.positions, mesh.triangles}).empty());
  EXPECT_EQ(crossingsOf(mesh).size(), 0U);
}

TEST(EdgeCrossings, areFoundWhereAVertexIsAMicrometreBehindAnotherTriangle) {
  ClothMesh mesh = testing::sheet(2);
  mesh.positions.insert(mesh.positions.end(), {{0.3, -1e-6, 0.6}, {0.3, 0.5, 0.6}, {0.4, 0.5, 0.7}});
  mesh.triangles.push_back({4, 5, 6});
  EXPECT_EQ(crossingsOf(mesh).size(), 2U);
  mesh.positions[4].y() = 1e-6;
  EXPECT_EQ(crossingsOf(mesh).size(), 0U);
}

}  // namespace
}  // namespace drape::sim::contact
