#include "sim/contact/separating_planes/separating_plane_filter.hpp"

#include <gtest/gtest.h>

namespace drape {
namespace {

using Shelter = BarrierFilter::Shelter;

/// One vertex that wants to be at `position`.
int filter(const std::vector<Barrier>& barriers, const Shelter& shelter, double room, Vec3& position) {
  const std::vector<double> inverseMass{1.0};
  const std::vector<double> rooms{room};
  const std::vector<Vec3> targets{shelter.base};
  std::vector<Vec3> positions{position};
  const int squeezed = BarrierFilter().apply(
      barriers, inverseMass, rooms, 1, [&](int, int) { return shelter; }, targets, positions);
  position = positions[0];
  return squeezed;
}

TEST(BarrierFilter, leavesAloneWhatHoldsItsBarriersAndProjectsWhatDoesNot) {
  const std::vector<Barrier> ground{{0, 0, Vec3::UnitY(), 0.0}};
  Vec3 above(0.3, 0.1, 0.0);
  EXPECT_EQ(filter(ground, {Vec3::Zero(), Vec3::Zero()}, 1.0, above), 0);
  EXPECT_EQ(above, Vec3(0.3, 0.1, 0.0));
  Vec3 below(0.3, -0.1, 0.0);
  EXPECT_EQ(filter(ground, {Vec3::Zero(), Vec3::Zero()}, 1.0, below), 0);
  EXPECT_EQ(below, Vec3(0.3, 0.0, 0.0));
}

TEST(BarrierFilter, goesBackNoFartherThanTheSearchedRoomAllows) {
  Vec3 position(0.9, 0.0, 0.0);
  EXPECT_EQ(filter({}, {Vec3::Zero(), Vec3::Zero()}, 0.5, position), 0);
  EXPECT_NEAR(position.x(), 0.5, 1e-12);
}

TEST(BarrierFilter, takesRefugeWhereTheBodyCarriesTheVertex) {
  // The ground rose by 0.2 past the vertex, and a wall at an acute angle keeps projections from an end.
  const Vec3 wall = Vec3(0.02, -1.0, 0.0).normalized();
  const std::vector<Barrier> wedge{{0, 0, Vec3::UnitY(), 0.2}, {0, 0, wall, wall.y() * 0.21}};
  Vec3 position(-5.0, 0.0, 0.0);
  EXPECT_EQ(filter(wedge, {Vec3::Zero(), Vec3(0.0, 0.205, 0.0)}, 10.0, position), 0);
  for (const Barrier& barrier : wedge) {
    EXPECT_GE(barrier.normal.dot(position) - barrier.height, -1e-9);
  }
}

TEST(BarrierFilter, findsAPlaceWhereTheRefugeIsNone) {
  const std::vector<Barrier> corner{{0, 0, Vec3::UnitY(), 0.1}, {0, 0, Vec3(1.0, 0.2, 0.0).normalized(), 0.1}};
  Vec3 position(0.0, -0.3, 0.0);
  EXPECT_EQ(filter(corner, {Vec3::Zero(), Vec3::Zero()}, 0.3, position), 0);
  for (const Barrier& barrier : corner) {
    EXPECT_GE(barrier.normal.dot(position) - barrier.height, -1e-9);
  }
  EXPECT_LE(position.norm(), 0.3 + 1e-9);
}

TEST(BarrierFilter, countsAVertexThatHasNoPlace) {
  const std::vector<Barrier> press{{0, 0, Vec3::UnitY(), 0.1}, {0, 0, -Vec3::UnitY(), 0.1}};
  Vec3 position = Vec3::Zero();
  EXPECT_EQ(filter(press, {Vec3::Zero(), Vec3::Zero()}, 1.0, position), 1);
}

}  // namespace
}  // namespace drape
