#include "scene/grid_mesh.hpp"

#include "messages/error.hpp"

#include <gtest/gtest.h>
#include <cmath>

namespace drape::scene {
namespace {

TEST(GridMesh, hasAsManyVerticesAsAskedForOnASquare) {
  const GridLayout layout = layoutOf({17, 1.0, 1.0});
  const io::ImportedMesh mesh = makeGrid(layout, GridSource::Plane::Horizontal);
  EXPECT_EQ(mesh.cloth.positions.size(), 289U);
  EXPECT_EQ(mesh.cloth.triangles.size(), 512U);
  EXPECT_EQ(mesh.summary.springs, 800);
  EXPECT_EQ(mesh.cloth.positions.front(), Vec3(-0.5, 0.0, -0.5));
  EXPECT_EQ(mesh.cloth.positions.back(), Vec3(0.5, 0.0, 0.5));
}

TEST(GridMesh, keepsItsCellsSquareOnARectangle) {
  const GridLayout layout = layoutOf({33, 1.5, 1.0});
  EXPECT_EQ(layout.rows, 33);
  EXPECT_EQ(layout.columns, 49);
}

TEST(GridMesh, refusesMoreVerticesThanAMachineHolds) {
  EXPECT_THROW(static_cast<void>(layoutOf({1025, 100.0, 0.01})), messages::InputError);
  EXPECT_NO_THROW(static_cast<void>(layoutOf({1025, 1.0, 1.0})));
}

TEST(GridMesh, countsTheSpringsThatTheClothHas) {
  for (const settings::Settings::Grid& grid :
       {settings::Settings::Grid{5, 1.0, 2.0}, settings::Settings::Grid{9, 3.0, 1.0}}) {
    const io::ImportedMesh mesh = makeGrid(layoutOf(grid), GridSource::Plane::Vertical);
    const auto model = sim::buildClothModel(mesh.cloth, 1.0, sim::MassLumping::Area, {});
    EXPECT_EQ(static_cast<std::size_t>(mesh.summary.springs), model->springs.size());
    EXPECT_NEAR(model->restArea(), grid.width * grid.height, 1e-12);
  }
}

TEST(GridMesh, looksUpOrToTheFrontWithEveryTriangle) {
  for (const auto plane : {GridSource::Plane::Horizontal, GridSource::Plane::Vertical}) {
    const Vec3 front = plane == GridSource::Plane::Horizontal ? Vec3(Vec3::UnitY()) : Vec3(Vec3::UnitZ());
    const io::ImportedMesh mesh = makeGrid(layoutOf({5, 1.0, 1.0}), plane);
    for (const Triangle& t : mesh.cloth.triangles) {
      const auto& x = mesh.cloth.positions;
      const Vec3 a = x[t[0]];
      const Vec3 normal = (x[t[1]] - a).cross(x[t[2]] - a);
      EXPECT_GT(normal.dot(front), 0.0);
    }
  }
}

TEST(Pleats, pressTheSheetTogetherButKeepItsRowsLengths) {
  const GridLayout layout = layoutOf({97, 2.0, 1.0});
  const io::ImportedMesh mesh = makeGrid(layout, GridSource::Plane::Vertical);
  std::vector<Vec3> positions = mesh.cloth.positions;
  applyPleats({6, 0.6}, layout.width, positions);
  EXPECT_NEAR(positions[layout.columns - 1].x() - positions[0].x(), 1.2, 1e-9);
  double length = 0.0;
  for (int column = 1; column < layout.columns; ++column) {
    const auto i = static_cast<std::size_t>(column);
    length += (positions[i] - positions[i - 1]).norm();
  }
  EXPECT_NEAR(length, 2.0, 0.03) << "chords are a little shorter than the arcs";
}

TEST(GridPins, namesCornersAndEdges) {
  const GridLayout layout = layoutOf({5, 1.0, 1.0});
  PinSelection pins;
  pins.corners = {"top_left", "bottom_right"};
  EXPECT_EQ(gridPins(pins, layout), (std::vector<int>{0, 24}));
  pins.corners.clear();
  pins.edges = {"left"};
  EXPECT_EQ(gridPins(pins, layout), (std::vector<int>{0, 5, 10, 15, 20}));
  pins.edges = {"top"};
  pins.every = 3;
  EXPECT_EQ(gridPins(pins, layout), (std::vector<int>{0, 3, 4})) << "every third, and the last";
}

TEST(GridPins, refusesNamesThatAreNone) {
  const GridLayout layout = layoutOf({5, 1.0, 1.0});
  PinSelection pins;
  pins.edges = {"front"};
  EXPECT_THROW(static_cast<void>(gridPins(pins, layout)), messages::InputError);
  pins.edges.clear();
  pins.corners = {"top"};
  EXPECT_THROW(static_cast<void>(gridPins(pins, layout)), messages::InputError);
}

}  // namespace
}  // namespace drape::scene
