#include "sim/adaptive/taut_cloth.hpp"

#include "test_meshes.hpp"

#include <gtest/gtest.h>
#include <Eigen/Geometry>
#include <numbers>

namespace drape::sim::adaptive {
namespace {

constexpr int side = 33;
constexpr int last = side - 1;

std::vector<int> row(int index) {
  std::vector<int> vertices;
  for (int v = 0; v < side; ++v) {
    vertices.push_back(side * index + v);
  }
  return vertices;
}

std::vector<int> bothEdges() {
  std::vector<int> vertices = row(0);
  const std::vector<int> other = row(last);
  vertices.insert(vertices.end(), other.begin(), other.end());
  return vertices;
}

/// A sheet of 1 m x 1 m.
class TautCloth : public ::testing::Test {
 protected:
  /// @param place of a vertex, from its rest position
  template <typename Place>
  bool isHeldTaut(const std::vector<int>& pins, double stiffness, Place&& place) {
    const auto model = buildClothModel(testing::sheet(side), 0.1, MassLumping::Area, pins);
    std::vector<Vec3> positions;
    for (const Vec3& rest : model->restPositions) {
      positions.push_back(place(rest));
    }
    CommonParameters parameters;
    parameters.material.stiffness = stiffness;
    return isTaut(*model, buildCoarseLevels(*model), parameters, positions);
  }

  bool isHeldTaut(const std::vector<int>& pins, double stiffness = 1e5) {
    return isHeldTaut(pins, stiffness, [](const Vec3& rest) { return rest; });
  }
};

TEST_F(TautCloth, isHeldByFourCornersAndByTwoEdges) {
  EXPECT_TRUE(isHeldTaut({0, last, side * last, side * side - 1}));
  EXPECT_TRUE(isHeldTaut(bothEdges()));
}

TEST_F(TautCloth, isNotHeldByFewerPins) {
  EXPECT_FALSE(isHeldTaut({}));
  EXPECT_FALSE(isHeldTaut({0}));
  EXPECT_FALSE(isHeldTaut({0, last}));
  EXPECT_FALSE(isHeldTaut({0, last, side * last}));
  EXPECT_FALSE(isHeldTaut(row(0)));
}

TEST_F(TautCloth, isNotHeldByPinsThatAreTooCloseToEachOther) {
  const auto closer = [](const Vec3& rest) { return Vec3(rest.x(), rest.y(), 0.9 * rest.z()); };
  EXPECT_FALSE(isHeldTaut(bothEdges(), 1e5, closer));
}

/// Such a sheet is at rest, but it can swing.
TEST_F(TautCloth, isNotHeldByOneEdgeWhileItHangsStill) {
  const auto hanging = [](const Vec3& rest) { return Vec3(rest.x(), -rest.z(), 0.0); };
  EXPECT_FALSE(isHeldTaut(row(0), 1e5, hanging));
}

TEST_F(TautCloth, isHeldByTwoEdgesThatTwistIt) {
  const Vec3 centre(0.5, 0.0, 0.5);
  const auto twisted = [&](const Vec3& rest) -> Vec3 {
    const Vec3 offset = rest - centre;
    return centre + Eigen::AngleAxisd(std::numbers::pi / 4.0 * offset.z(), Vec3::UnitZ()) * offset;
  };
  EXPECT_TRUE(isHeldTaut(bothEdges(), 1e5, twisted));
}

TEST_F(TautCloth, isNotHeldIfItIsSoft) {
  EXPECT_FALSE(isHeldTaut({0, last, side * last, side * side - 1}, 10.0));
}

}  // namespace
}  // namespace drape::sim::adaptive
