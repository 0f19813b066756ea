#include "sim/fabric/rest_shape.hpp"

#include "test_meshes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace drape::sim::fabric {
namespace {

using Positions = std::vector<Vec3>;
using Triangles = std::vector<Triangle>;

constexpr double tight = 1e-14;

RestShape shapeOf(const Positions& positions, const Triangles& triangles, const Vec3& warp) {
  return restShapeOf(positions, triangles, edgesOf(triangles, positions.size()), warpAlong(warp, positions, triangles));
}

/// The bend vector of a hinge.
Vec3 bendVector(const Hinge& hinge, const Positions& positions) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 0; i < 4; ++i) {
    sum += hinge.weights[static_cast<Eigen::Index>(i)] * positions[hinge.vertices[i]];
  }
  return sum;
}

/// Two triangles about the z axis, the second one lifted by an angle [rad].
Positions foldedPair(double angle) {
  return {{0.0, 0.0, -0.2}, {0.0, 0.0, 0.3}, {-0.5, 0.0, 0.1}, {0.4 * std::cos(angle), 0.4 * std::sin(angle), 0.2}};
}
const Triangles pair = {{0, 1, 2}, {1, 0, 3}};

TEST(WarpAlong, isTheDirectionProjectedOntoTheTriangle) {
  const Positions positions = {{0, 0, 0}, {1, 1, 0}, {0, 0, 1}};
  const Vec3 warp = warpAlong({1.0, 0.0, 0.0}, positions, Triangles{{0, 1, 2}})[0];
  EXPECT_LT((warp - Vec3(1.0, 1.0, 0.0).normalized()).norm(), tight);
}

TEST(WarpAlong, doesNotDependOnTheLengthOfTheDirection) {
  const Positions positions = {{0, 0, 0}, {1, 0.3, 0}, {0, 0.2, 1}};
  const Vec3 one = warpAlong({1.0, 2.0, 0.5}, positions, Triangles{{0, 1, 2}})[0];
  const Vec3 other = warpAlong({1e-6, 2e-6, 0.5e-6}, positions, Triangles{{0, 1, 2}})[0];
  EXPECT_LT((one - other).norm(), tight);
  EXPECT_NEAR(one.norm(), 1.0, tight);
}

TEST(WarpAlong, takesTheClosestAxisWhereTheTriangleIsPerpendicular) {
  const Positions inYz = {{0, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const Positions inXz = {{0, 0, 0}, {1, 0, 0}, {0, 0, 1}};
  const Positions inXy = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const Triangles one = {{0, 1, 2}};
  EXPECT_EQ(warpAlong(Vec3::UnitX(), inYz, one)[0], Vec3::UnitY());
  EXPECT_EQ(warpAlong(Vec3::UnitY(), inXz, one)[0], Vec3::UnitX());
  EXPECT_EQ(warpAlong(Vec3::UnitZ(), inXy, one)[0], Vec3::UnitX());
}

TEST(RestShape, hasSidesAlongWarpAndWeft) {
  const Positions positions = {{0, 0, 0}, {0, 0, 2}, {3, 0, 0}};  // its normal is +y
  const RestTriangle triangle = shapeOf(positions, {{0, 1, 2}}, Vec3::UnitX()).triangles[0];
  EXPECT_NEAR(triangle.area, 3.0, tight);
  EXPECT_LT((triangle.sides[0] - Vec2(0.0, -2.0)).norm(), tight);
  EXPECT_LT((triangle.sides[1] - Vec2(3.0, 2.0)).norm(), tight);
  EXPECT_LT((triangle.sides[2] - Vec2(-3.0, 0.0)).norm(), tight);
}

TEST(RestShape, keepsLengthsForEveryDirectionOfWarp) {
  const ClothMesh mesh = testing::sheet(4);
  for (const Vec3& warp : {Vec3(1, 0, 0), Vec3(1, 0, 1), Vec3(0.3, 2.0, -1.0)}) {
    const RestShape shape = shapeOf(mesh.positions, mesh.triangles, warp);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      for (std::size_t k = 0; k < 3; ++k) {
        const Vec3 side = mesh.positions[mesh.triangles[t][(k + 1) % 3]] - mesh.positions[mesh.triangles[t][k]];
        EXPECT_NEAR(shape.triangles[t].sides[k].norm(), side.norm(), tight);
      }
    }
  }
}

TEST(RestShape, hasNoAreaAndNoHingeAtDegenerateTriangles) {
  const Positions positions = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 0, 1}};
  const RestShape shape = shapeOf(positions, {{0, 1, 2}, {1, 0, 3}}, Vec3::UnitX());
  EXPECT_EQ(shape.triangles[0].area, 0.0);
  EXPECT_EQ(qualityOf(shape.triangles[0]), 0.0);
  EXPECT_GT(shape.triangles[1].area, 0.0);
  EXPECT_TRUE(shape.hinges.empty());
}

TEST(RestShape, hasNoHingeOnTheBoundaryOrWhereThreeTrianglesMeet) {
  Positions positions = foldedPair(0.0);
  EXPECT_EQ(shapeOf(positions, pair, Vec3::UnitX()).hinges.size(), 1U);
  positions.emplace_back(0.0, 0.5, 0.0);
  EXPECT_TRUE(shapeOf(positions, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}, Vec3::UnitX()).hinges.empty());
}

TEST(RestShape, hasBendVectorsThatVanishWhereTheHingeIsFlat) {
  const Positions positions = foldedPair(0.0);
  const Hinge hinge = shapeOf(positions, pair, Vec3::UnitX()).hinges[0];
  EXPECT_NEAR(hinge.weights.sum(), 0.0, 1e-12);
  EXPECT_LT(bendVector(hinge, positions).norm(), 1e-12);
  Positions moved;
  for (const Vec3& position : positions) {  // an affine map
    moved.emplace_back(1.0 + 2.0 * position.x(), position.z(), 0.3 * position.x() - position.z());
  }
  EXPECT_LT(bendVector(hinge, moved).norm(), 1e-12);
}

TEST(RestShape, hasBendVectorsOfTwiceTheSineOfHalfTheAngle) {
  const Hinge hinge = shapeOf(foldedPair(0.0), pair, Vec3::UnitX()).hinges[0];
  for (const double angle : {1e-3, 0.5, -0.5, 2.0, std::numbers::pi}) {
    const Vec3 bend = bendVector(hinge, foldedPair(angle));
    EXPECT_NEAR(bend.norm(), 2.0 * std::abs(std::sin(0.5 * angle)), 1e-12) << angle;
    EXPECT_NEAR(bend.z(), 0.0, 1e-12) << "along the edge";
  }
}

TEST(QualityOf, isOneForAnEquilateralTriangleAndFallsWithItsHeight) {
  const double height = 0.5 * std::numbers::sqrt3;
  const auto quality = [](double y) {
    return qualityOf(shapeOf({{0, 0, 0}, {1, 0, 0}, {0.5, y, 0}}, {{0, 1, 2}}, Vec3::UnitX()).triangles[0]);
  };
  EXPECT_NEAR(quality(height), 1.0, tight);
  EXPECT_LT(quality(0.1 * height), 0.2);
  EXPECT_NEAR(quality(0.02 * height) / quality(0.01 * height), 2.0, 1e-3);
}

}  // namespace
}  // namespace drape::sim::fabric
