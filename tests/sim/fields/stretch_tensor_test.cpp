#include "sim/fields/stretch_tensor.hpp"
#include "fabric_cloths.hpp"

#include <gtest/gtest.h>
#include <algorithm>

namespace drape::sim::fields {
namespace {

constexpr double tolerance = 1e-9;

/// The tensors of a cloth at these positions. @param warp a direction along the cloth
std::vector<Mat3> tensorsOf(const ClothModel& model, std::span<const Vec3> positions,
                            const Vec3& warp = Vec3::UnitX()) {
  const FieldGeometry geometry = fieldGeometryOf(model, fabric::warpAlong(warp, model.restPositions, model.triangles));
  std::vector<Mat3> tensors(positions.size());
  stretchTensors(model, geometry, warpAndWeftOf(model, geometry), positions, tensors);
  return tensors;
}

/// A tilted sheet of springs, whose normal is not a coordinate axis.
std::shared_ptr<const ClothModel> tiltedSheet() {
  ClothMesh mesh = testing::sheet(9);
  const Eigen::AngleAxisd tilt(0.8, Vec3(3.0, 1.0, -2.0).normalized());
  for (Vec3& position : mesh.positions) {
    position = tilt * position;
  }
  return buildClothModel(mesh, 0.15, MassLumping::Area, {});
}

/// The positions after a stretch by `ratio` along a unit vector, then a rotation.
std::vector<Vec3> stretched(const ClothModel& model, const Vec3& along, double ratio) {
  const Eigen::AngleAxisd turn(1.3, Vec3(1.0, 2.0, 3.0).normalized());
  std::vector<Vec3> positions = model.restPositions;
  for (Vec3& position : positions) {
    position = turn * Vec3(position + (ratio - 1.0) * along.dot(position) * along);
  }
  return positions;
}

void expectEach(const std::vector<Mat3>& tensors, const Mat3& expected) {
  for (const Mat3& tensor : tensors) {
    ASSERT_LT((tensor - expected).norm(), tolerance) << tensor;
  }
}

TEST(StretchTensor, IsTheIdentityAtRest) {
  const auto model = tiltedSheet();
  expectEach(tensorsOf(*model, model->restPositions), Mat3::Identity());
  expectEach(tensorsOf(*model, stretched(*model, Vec3::UnitX(), 1.0)), Mat3::Identity());
}

TEST(StretchTensor, HasTheRatioAlongTheCompressionForEveryDirectionOfWarp) {
  const auto model = tiltedSheet();
  const Vec3 side = (model->restPositions[12] - model->restPositions[0]).normalized();
  const Mat3 expected = Mat3::Identity() + (0.8 * 0.8 - 1.0) * side * side.transpose();
  const std::vector<Vec3> positions = stretched(*model, side, 0.8);
  for (const Vec3& warp : {Vec3(Vec3::UnitX()), Vec3(0.3, 0.2, 0.9)}) {
    expectEach(tensorsOf(*model, positions, warp), expected);
  }
}

TEST(StretchTensor, RefersToThePatternOfAFabric) {
  const auto springs = buildClothModel(testing::sheet(9), 0.15, MassLumping::Area, {});
  // The pattern is larger than the mesh by a factor of 1.25.
  std::vector<fabric::RestTriangle> pattern;
  for (const Triangle& triangle : springs->triangles) {
    std::array<Vec2, 3> corners;
    std::transform(triangle.begin(), triangle.end(), corners.begin(), [&](int v) {
      return Vec2(1.25 * springs->restPositions[v].z(), 1.25 * springs->restPositions[v].x());
    });
    pattern.push_back(fabric::restTriangleOf(corners));
  }
  const auto model = fabric::withPatternFabric(*springs, testing::woven(), pattern);
  Mat3 expected = 0.64 * Mat3::Identity();
  expected(1, 1) = 1.0;
  expectEach(tensorsOf(*model, model->restPositions), expected);
}

TEST(StretchTensor, IsTheIdentityWithoutTriangles) {
  ClothMesh mesh = testing::sheet(2);
  mesh.positions.emplace_back(5.0, 0.0, 0.0);
  const auto model = buildClothModel(mesh, 0.15, MassLumping::Uniform, {});
  EXPECT_EQ(tensorsOf(*model, stretched(*model, Vec3::UnitX(), 0.5)).back(), Mat3(Mat3::Identity()));
}

}  // namespace
}  // namespace drape::sim::fields
