#include "scene/up_guess.hpp"

#include "garment_shapes.hpp"
#include "io/garments/garments.hpp"

#include <gtest/gtest.h>

#include <random>

namespace drape::scene {
namespace {

int upOf(const sim::ClothMesh& mesh) {
  return guessUp(mesh, findPieces(mesh)).axis;
}

constexpr int y = 1;
constexpr int z = 2;

/// The mesh rotated by a quarter turn about its up axis, so that it faces the side.
sim::ClothMesh lookingAside(sim::ClothMesh mesh) {
  for (Vec3& position : mesh.positions) {
    position = Vec3(position.z(), position.y(), -position.x());
  }
  return mesh;
}

sim::ClothMesh mirrored(sim::ClothMesh mesh) {
  for (Vec3& position : mesh.positions) {
    position.x() *= -1.0;
  }
  return mesh;
}

/// Every vertex moved by up to this distance [m], the same in every run.
sim::ClothMesh jittered(sim::ClothMesh mesh, double much) {
  std::mt19937 random(7);
  const auto next = [&] { return much * (2.0 * static_cast<double>(random()) / 4294967295.0 - 1.0); };
  for (Vec3& position : mesh.positions) {
    const double dx = next();
    const double dy = next();
    position += Vec3(dx, dy, next());
  }
  return mesh;
}

/// The shapes of the tests and the garments of the program.
std::vector<testing::TestShape> allShapes() {
  std::vector<testing::TestShape> shapes = testing::testShapes();
  struct Own {
    const char* name;
    io::RawMesh (*make)();
  };
  for (const Own& own :
       {Own{"own T-shirt", io::makeTshirt}, Own{"own skirt", io::makeSkirt}, Own{"own poncho", io::makePoncho},
        Own{"own cape", io::makeCape}, Own{"mannequin", io::makeMannequin}, Own{"skater", io::makeSkater}}) {
    shapes.push_back({own.name, io::weldMesh(own.make(), own.name, {}).cloth});
  }
  return shapes;
}

TEST(UpGuess, findsWhatPointsUpOfGarmentsAndBodies) {
  for (const testing::TestShape& shape : allShapes()) {
    EXPECT_EQ(upOf(shape.mesh), y) << shape.name;
    EXPECT_EQ(upOf(testing::withZUp(shape.mesh)), z) << shape.name << ", z up";
  }
}

TEST(UpGuess, doesNotCareForSizeMirroringAndJitter) {
  for (const testing::TestShape& shape : allShapes()) {
    const sim::ClothMesh changed = jittered(mirrored(shape.mesh), 0.004);
    EXPECT_EQ(upOf(testing::scaled(changed, 100.0)), y) << shape.name;
    EXPECT_EQ(upOf(testing::scaled(testing::withZUp(changed), 0.0254)), z) << shape.name << ", z up";
  }
}

TEST(UpGuess, doesNotCareWhereAGarmentLooks) {
  for (const testing::TestShape& shape : testing::testShapes()) {
    EXPECT_EQ(upOf(lookingAside(shape.mesh)), y) << shape.name;
  }
}

TEST(UpGuess, takesYForFlatSheets) {
  EXPECT_EQ(upOf(testing::sheet(0, 1, 1.0, 1.5, 9)), y);
  EXPECT_EQ(upOf(testing::sheet(0, 2, 1.0, 1.5, 9)), y);
  EXPECT_EQ(upOf(testing::sheet(0, 2, 1.5, 1.0, 2)), y);
  EXPECT_EQ(upOf(testing::sheet(1, 2, 0.4, 3.0, 5)), y);
}

TEST(UpGuess, tellsWhatItSaw) {
  const sim::ClothMesh skirt = testing::tube(0.6, 0.3, 0.15, 0.8);
  const UpGuess guess = guessUp(skirt, findPieces(skirt));
  EXPECT_NEAR(guess.evidence.openings[1], 1.0, 1e-9) << "waist and hem face up and down";
  EXPECT_LT(guess.evidence.asymmetry[0], 0.02) << "left and right are alike";
  EXPECT_GT(guess.evidence.asymmetry[1], 0.1) << "the hem is wider than the waist";
  EXPECT_NEAR(guess.evidence.extent[2], 0.8, 1e-9);
  EXPECT_GT(guess.margin, 0.5);
}

}  // namespace
}  // namespace drape::scene
