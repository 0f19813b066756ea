#include "scene/boundary_loops.hpp"

#include "garment_shapes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

namespace drape::scene {
namespace {

TEST(BoundaryLoops, goAroundASheetAsItsOutline) {
  const ClothPieces found = findPieces(testing::sheet(0, 1, 2.0, 1.0, 9));
  ASSERT_EQ(found.pieces.size(), 1U);
  ASSERT_EQ(found.loops.size(), 1U);
  EXPECT_NEAR(found.pieces[0].area, 2.0, 1e-12);
  EXPECT_EQ(found.pieces[0].eulerNumber, 1);
  EXPECT_NEAR(found.loops[0].length, 6.0, 1e-12);
  EXPECT_NEAR(found.loops[0].area.norm(), 2.0, 1e-12);
  EXPECT_NEAR((found.loops[0].centre - Vec3(1.0, 0.5, 0.0)).norm(), 0.0, 1e-12);
  EXPECT_EQ(found.loops[0].vertices.size(), 32U);
  EXPECT_TRUE(found.isOutline(found.loops[0]));
}

TEST(BoundaryLoops, areTheTwoOpeningsOfATube) {
  const ClothPieces found = findPieces(testing::tube(0.6, 0.3, 0.2, 1.0));
  ASSERT_EQ(found.loops.size(), 2U);
  EXPECT_EQ(found.pieces[0].eulerNumber, 0);
  const double polygon = 18.0 * std::sin(std::numbers::pi / 18.0);  // of 36 corners, in the unit circle
  for (const BoundaryLoop& loop : found.loops) {
    const double radius = loop.centre.y() > 0.3 ? 0.2 : 0.3;
    EXPECT_NEAR(loop.area.norm(), polygon * radius * radius, 1e-9);
    EXPECT_FALSE(found.isOutline(loop));
  }
}

TEST(BoundaryLoops, takeTheOpeningOfASockForAnOpening) {
  const ClothPieces found = findPieces(testing::sock());
  ASSERT_EQ(found.loops.size(), 1U);
  EXPECT_FALSE(found.isOutline(found.loops[0]));
}

TEST(BoundaryLoops, areTheOutlineAndTheHolesOfASheetWithHoles) {
  testing::GarmentSizes vest;
  vest.sleeve = 0.12;
  vest.sleeveAngle = 0.0;
  vest.frontGap = 0.04;
  testing::GarmentSizes cardigan = vest;
  cardigan.sleeve = 0.5;
  for (const sim::ClothMesh& sheet : {testing::shirt(vest), testing::shirt(cardigan), testing::apron()}) {
    const ClothPieces found = findPieces(sheet);
    const auto longest = std::ranges::max_element(found.loops, {}, &BoundaryLoop::length);
    ASSERT_GE(found.loops.size(), 2U);
    for (const BoundaryLoop& loop : found.loops) {
      EXPECT_EQ(found.isOutline(loop), &loop == &*longest);
    }
  }
}

TEST(BoundaryLoops, ofASlantedRingAreOpenings) {
  sim::ClothMesh ring = testing::tube(0.06, 0.3, 0.3, 0.7);
  for (Vec3& position : ring.positions) {
    position = Eigen::AngleAxisd(0.7, Vec3(1.0, 0.5, 1.0).normalized()) * position;
  }
  const ClothPieces found = findPieces(ring);
  ASSERT_EQ(found.loops.size(), 2U);
  EXPECT_FALSE(found.isOutline(found.loops[0]) || found.isOutline(found.loops[1]));
}

TEST(BoundaryLoops, tellWhichPieceTheyBelongTo) {
  sim::ClothMesh mesh = testing::sheet(0, 1, 1.0, 1.0, 3);
  const sim::ClothMesh other = testing::sheet(0, 1, 1.0, 1.0, 2);
  for (const Vec3& position : other.positions) {
    mesh.positions.emplace_back(position + Vec3(5.0, 0.0, 0.0));
  }
  for (const Triangle& triangle : other.triangles) {
    mesh.triangles.push_back({triangle[0] + 9, triangle[1] + 9, triangle[2] + 9});
  }
  const ClothPieces found = findPieces(mesh);
  ASSERT_EQ(found.pieces.size(), 2U);
  ASSERT_EQ(found.loops.size(), 2U);
  EXPECT_EQ(found.loops[0].piece, 0);
  EXPECT_EQ(found.loops[1].piece, 1);
  EXPECT_EQ(found.pieces[1].vertices, (std::vector<int>{9, 10, 11, 12}));
}

TEST(BoundaryLoops, areToldApartWhereTwoOfThemTouch) {
  // Two triangles that share one vertex.
  sim::ClothMesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 1, 0}, {-1, 1, 0}, {1, -1, 0}, {-1, -1, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 4, 3}};
  const ClothPieces found = findPieces(mesh);
  double length = 0.0;
  for (const BoundaryLoop& loop : found.loops) {
    length += loop.length;
  }
  EXPECT_EQ(found.loops.size(), 2U);
  EXPECT_NEAR(length, 4.0 * std::sqrt(2.0) + 4.0, 1e-12);
}

TEST(BoundaryLoops, areNoneOnAClosedSurface) {
  EXPECT_TRUE(findPieces(testing::figure(60.0)).loops.empty());
}

}  // namespace
}  // namespace drape::scene
