#include "scene/shape_pins.hpp"

#include "garment_shapes.hpp"
#include "scene/boundary_loops.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace drape::scene {
namespace {

double heightOf(const sim::ClothMesh& mesh, int vertex) {
  return mesh.positions[vertex].y();
}

double topOf(const sim::ClothMesh& mesh) {
  double top = mesh.positions.front().y();
  for (const Vec3& position : mesh.positions) {
    top = std::max(top, position.y());
  }
  return top;
}

TEST(ShapePins, holdAShirtByTheWholeNeckAndNothingElse) {
  const sim::ClothMesh mesh = testing::shirt({});
  const std::vector<int> pins = pinsByShape(mesh);
  const ClothPieces found = findPieces(mesh);
  const auto neck =
      std::max_element(found.loops.begin(), found.loops.end(),
                       [](const BoundaryLoop& a, const BoundaryLoop& b) { return a.centre.y() < b.centre.y(); });
  std::vector<int> expected = neck->vertices;
  std::sort(expected.begin(), expected.end());
  EXPECT_EQ(pins, expected);
  EXPECT_LT(pins.size(), mesh.positions.size() / 10);
}

TEST(ShapePins, holdLongSleevesThatAreStretchedOutByTheNeck) {
  testing::GarmentSizes sizes;
  sizes.sleeve = 0.55;
  sizes.sleeveAngle = 0.0;
  const sim::ClothMesh mesh = testing::shirt(sizes);
  for (const int pin : pinsByShape(mesh)) {
    EXPECT_LT(std::abs(mesh.positions[pin].x()), 0.2);
  }
}

TEST(ShapePins, holdATankTopWithADeepNeckByTheShoulders) {
  testing::GarmentSizes sizes;
  sizes.sleeve = -0.02;
  sizes.sleeveAngle = 0.0;
  sizes.neck = 0.11;
  sizes.neckDepth = 0.22;
  const sim::ClothMesh mesh = testing::shirt(sizes);
  const std::vector<int> pins = pinsByShape(mesh);
  bool left = false;
  bool right = false;
  ASSERT_FALSE(pins.empty());
  for (const int pin : pins) {
    EXPECT_GT(heightOf(mesh, pin), topOf(mesh) - 0.1);
    left = left || mesh.positions[pin].x() < -0.05;
    right = right || mesh.positions[pin].x() > 0.05;
  }
  EXPECT_TRUE(left && right) << "both shoulders";
}

TEST(ShapePins, holdSkirtsAndTrousersByTheWaist) {
  for (const sim::ClothMesh& mesh : {testing::tube(0.6, 0.3, 0.15, 0.8), testing::trousers(0.75)}) {
    const std::vector<int> pins = pinsByShape(mesh);
    ASSERT_FALSE(pins.empty());
    for (const int pin : pins) {
      EXPECT_GT(heightOf(mesh, pin), topOf(mesh) - 0.05);
    }
  }
}

TEST(ShapePins, holdAFlatSheetByTwoCorners) {
  // Vertices are ordered along the first axis; the last row is the upper one, or the one with the largest z.
  EXPECT_EQ(pinsByShape(testing::sheet(0, 1, 1.0, 2.0, 9)), (std::vector<int>{72, 80})) << "upright";
  EXPECT_EQ(pinsByShape(testing::sheet(2, 1, 3.0, 1.0, 9)), (std::vector<int>{72, 80}))
      << "upright, seen from the side";
  EXPECT_EQ(pinsByShape(testing::sheet(0, 2, 1.0, 1.0, 9)), (std::vector<int>{0, 8})) << "level: at the back";
  EXPECT_EQ(pinsByShape(testing::sheet(0, 2, 0.3, 4.0, 33)), (std::vector<int>{0, 32})) << "level and long";
}

TEST(ShapePins, neverHoldAllOfAClothOrNothing) {
  for (const testing::TestShape& shape : testing::testShapes()) {
    const std::size_t pins = pinsByShape(shape.mesh).size();
    EXPECT_GT(pins, 1U) << shape.name;
    EXPECT_LT(pins, shape.mesh.positions.size() / 4) << shape.name;
  }
}

TEST(ShapePins, holdEachPieceButNotTheSmallOnes) {
  sim::ClothMesh mesh = testing::sheet(0, 1, 1.0, 1.0, 9);
  const auto add = [&](const sim::ClothMesh& more, const Vec3& by) {
    const int first = static_cast<int>(mesh.positions.size());
    for (const Vec3& position : more.positions) {
      mesh.positions.emplace_back(position + by);
    }
    for (const Triangle& t : more.triangles) {
      mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
    }
  };
  add(testing::sheet(0, 1, 1.0, 1.0, 5), Vec3(0.0, 0.0, 0.3));
  add(testing::sheet(0, 1, 0.05, 0.05, 2), Vec3(0.5, 0.5, 0.35));
  EXPECT_EQ(pinsByShape(mesh), (std::vector<int>{72, 80, 81 + 20, 81 + 24}));
}

TEST(ShapePins, holdACapByItsTopAsItsOpeningIsBelow) {
  sim::ClothMesh cap = testing::sock();
  for (Vec3& position : cap.positions) {
    position = Vec3(position.x(), -position.y(), -position.z());
  }
  for (const int pin : pinsByShape(cap)) {
    EXPECT_GT(heightOf(cap, pin), topOf(cap) - 0.03);
  }
}

}  // namespace
}  // namespace drape::scene
