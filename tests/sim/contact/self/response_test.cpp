#include "sim/contact/self/response.hpp"

#include "contact/self/position_lanes.hpp"
#include "sim/motion/momentum.hpp"
#include "test_meshes.hpp"

#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <memory>
#include <set>
#include <vector>

namespace drape::sim::contact {
namespace {

using testing::lanesOf;

constexpr double h = 0.01;

/// Vertices with different masses, unconnected except for the one triangle that a cloth must have.
std::shared_ptr<const ClothModel> loosePoints(std::size_t count, const std::vector<int>& pins = {}) {
  ClothMesh mesh;
  for (std::size_t i = 0; i < count; ++i) {
    mesh.positions.emplace_back(static_cast<double>(i), 0.0, 0.0);
  }
  mesh.triangles = {{0, 1, 2}};
  auto model = std::make_shared<ClothModel>(*buildClothModel(mesh, 1.0, MassLumping::Uniform, pins));
  for (std::size_t i = 0; i < count; ++i) {
    model->vertexMass[i] = 0.1 * static_cast<double>(i + 1);
  }
  return model;
}

/// Points that move freely for a step, x1 = x0 + h v, and then collide.
struct Flight {
  std::shared_ptr<const ClothModel> model;
  std::vector<Vec3> start;
  ClothState state;

  Flight(std::shared_ptr<const ClothModel> cloth, std::vector<Vec3> positions, std::vector<Vec3> velocities)
      : model(std::move(cloth)), start(std::move(positions)) {
    state.velocities = std::move(velocities);
    state.positions = start;
    for (std::size_t i = 0; i < start.size(); ++i) {
      state.positions[i] += h * state.velocities[i];
    }
  }

  int collide(const SelfResponse::Inputs& inputs, const std::vector<VertexPair>& pairs) {
    std::vector<ContactPoint> points;
    std::vector<std::uint64_t> scratch;
    ColouredPairs coloured;
    colourPairs(model->vertexCount(), pairs, scratch, coloured);
    const int count =
        SelfResponse().resolve(*model, inputs, coloured, lanesOf(start), lanesOf(state.positions), state, points);
    EXPECT_EQ(points.size(), static_cast<std::size_t>(count));
    return count;
  }

  double distance(std::size_t a, std::size_t b) const { return (state.positions[b] - state.positions[a]).norm(); }
  double kineticEnergy() const {
    double sum = 0.0;
    for (std::size_t i = 0; i < start.size(); ++i) {
      sum += 0.5 * model->vertexMass[i] * state.velocities[i].squaredNorm();
    }
    return sum;
  }
};

constexpr SelfResponse::Inputs smooth = {h, 0.02, {0.0F, 0.0F}};
constexpr SelfResponse::Inputs rough = {h, 0.02, {0.6F, 0.4F}};

TEST(SelfResponse, StopsAPairAtTheThicknessWithoutRebound) {
  Flight flight(loosePoints(3), {Vec3(0, 0, 0), Vec3(0.03, 0, 0), Vec3(9, 9, 9)},
                {Vec3(2, 0, 0), Vec3(-2, 0, 0), Vec3(0, 0, 0)});
  EXPECT_EQ(flight.collide(smooth, {{0, 1}}), 1);
  EXPECT_NEAR(flight.distance(0, 1), 0.02, 1e-8);
  // They reach the thickness at the end of this step; in the next step they no longer approach.
  flight = Flight(flight.model, flight.state.positions, flight.state.velocities);
  flight.collide(smooth, {{0, 1}});
  EXPECT_NEAR((flight.state.velocities[1] - flight.state.velocities[0]).norm(), 0.0, 1e-5);
  EXPECT_NEAR(flight.state.velocities[0].x(), (0.1 * 2.0 - 0.2 * 2.0) / 0.3, 1e-5);
}

TEST(SelfResponse, IgnoresPairsThatSeparateOrPassEachOther) {
  Flight parting(loosePoints(3), {Vec3(0, 0, 0), Vec3(0.015, 0, 0), Vec3(9, 9, 9)},
                 {Vec3(-1, 0, 0), Vec3(1, 0, 0), Vec3(0, 0, 0)});
  EXPECT_EQ(parting.collide(rough, {{0, 1}}), 0);
  Flight beside(loosePoints(3), {Vec3(0, 0, 0), Vec3(0.03, 0.021, 0), Vec3(9, 9, 9)},
                {Vec3(3, 0, 0), Vec3(-3, 0, 0), Vec3(0, 0, 0)});
  const std::vector<Vec3> before = beside.state.velocities;
  beside.collide(smooth, {{0, 1}});
  EXPECT_EQ(beside.distance(0, 1), (Vec3(-0.03, 0.021, 0)).norm());
}

TEST(SelfResponse, KeepsTheThicknessIfOneWouldPassThroughTheOther) {
  Flight flight(loosePoints(3), {Vec3(0, 0, 0), Vec3(0.025, 0.004, 0), Vec3(9, 9, 9)},
                {Vec3(10, 0, 0), Vec3(0, 0, 0), Vec3(0, 0, 0)});
  flight.collide(smooth, {{0, 1}});
  EXPECT_NEAR(flight.distance(0, 1), 0.02, 1e-8);
  EXPECT_GT((flight.state.positions[1] - flight.state.positions[0]).dot(flight.start[1] - flight.start[0]), 0.0);
}

TEST(SelfResponse, ConservesMomentumOfManyPairs) {
  testing::RandomVectors random(3);
  std::vector<Vec3> positions;
  std::vector<Vec3> velocities;
  std::vector<VertexPair> pairs;
  for (int i = 0; i < 30; ++i) {
    positions.push_back(random.next(0.05));
    velocities.push_back(random.next(4.0));
    for (int j = 0; j < i; ++j) {
      if ((positions[j] - positions[i]).norm() > 0.02) {
        pairs.push_back({j, i});
      }
    }
  }
  for (const SelfResponse::Inputs& inputs : {smooth, rough}) {
    Flight flight(loosePoints(30), positions, velocities);
    const Vec3 linear = linearMomentum(*flight.model, flight.state);
    const Vec3 angular = angularMomentum(*flight.model, flight.state, Vec3(1.0, 2.0, 3.0));
    const double energy = flight.kineticEnergy();
    EXPECT_GT(flight.collide(inputs, pairs), 5);
    EXPECT_LT((linearMomentum(*flight.model, flight.state) - linear).norm(), 1e-6);
    EXPECT_LT(flight.kineticEnergy(), energy);
    if (inputs.friction.staticCoefficient == 0.0F) {
      EXPECT_LT((angularMomentum(*flight.model, flight.state, Vec3(1.0, 2.0, 3.0)) - angular).norm(), 1e-6);
    }
  }
}

TEST(SelfResponse, PushesOverlapsApartWithoutVelocity) {
  Flight flight(loosePoints(3), {Vec3(0, 0, 0), Vec3(0.01, 0, 0), Vec3(9, 9, 9)}, std::vector<Vec3>(3, Vec3(0, 0, 0)));
  flight.collide(rough, {{0, 1}});
  EXPECT_NEAR(flight.distance(0, 1), 0.01 + static_cast<double>(SelfResponse::pushOut) * 0.01, 1e-8);
  EXPECT_EQ(flight.kineticEnergy(), 0.0);
  EXPECT_NEAR(0.1 * flight.state.positions[0].x() + 0.2 * flight.state.positions[1].x(), 0.002, 1e-9);
}

TEST(SelfResponse, DoesNotMovePins) {
  Flight flight(loosePoints(3, {0}), {Vec3(0, 0, 0), Vec3(0.03, 0, 0), Vec3(9, 9, 9)},
                {Vec3(0, 0, 0), Vec3(-3, 0.5, 0), Vec3(0, 0, 0)});
  flight.collide(rough, {{0, 1}});
  EXPECT_EQ(flight.state.positions[0], Vec3(0, 0, 0));
  EXPECT_EQ(flight.state.velocities[0], Vec3(0, 0, 0));
  EXPECT_NEAR(flight.distance(0, 1), 0.02, 1e-4);
}

/// The remaining slip of a point that hits a pinned one obliquely.
double slideAfter(double down, double along) {
  Flight flight(loosePoints(3, {0}), {Vec3(0, 0, 0), Vec3(0, 0.02, 0), Vec3(9, 9, 9)},
                {Vec3(0, 0, 0), Vec3(along, -down, 0), Vec3(0, 0, 0)});
  flight.collide(rough, {{0, 1}});
  return flight.state.velocities[1].x();
}

TEST(SelfResponse, SticksWithinTheConeOfStaticFrictionAndSlidesOutside) {
  EXPECT_NEAR(slideAfter(0.1, 0.059), 0.0, 1e-4);
  for (const double down : {0.1, 0.05}) {
    const double slide = slideAfter(down, 0.2);
    // A sliding point moves down around the other one, which reduces the normal impulse.
    const double round = (0.02 - std::sqrt(0.02 * 0.02 - slide * h * slide * h)) / h;
    EXPECT_NEAR(slide, 0.2 - static_cast<double>(rough.friction.kineticCoefficient) * (down - round), 1e-4);
  }
}

TEST(ColouredPairs, ShareNoVertexWithinAColourAndKeepAllPairs) {
  std::vector<VertexPair> pairs;
  for (int a = 0; a < 40; ++a) {
    for (int b = a + 1; b < 40; ++b) {
      if ((a * 7 + b * 3) % 4 != 0) {
        pairs.push_back({a, b});
      }
    }
  }
  for (int b = 41; b < 140; ++b) {
    pairs.push_back({40, b});  // more pairs at one vertex than colours
  }
  std::vector<std::uint64_t> scratch;
  ColouredPairs coloured;
  colourPairs(140, pairs, scratch, coloured);
  ASSERT_EQ(coloured.count(), static_cast<int>(pairs.size()));
  std::vector<VertexPair> all(coloured.pairs.begin(), coloured.pairs.begin() + coloured.count());
  for (std::size_t c = 0; c < coloured.colourCount(); ++c) {
    std::set<int> seen;
    for (const VertexPair& pair : coloured.colour(c)) {
      EXPECT_TRUE(seen.insert(pair.a).second);
      EXPECT_TRUE(seen.insert(pair.b).second);
    }
  }
  std::sort(all.begin(), all.end());
  std::sort(pairs.begin(), pairs.end());
  EXPECT_EQ(all, pairs);
}

TEST(SelfResponse, SeparatesAStack) {
  // Five points in a row are compressed from both ends.
  std::vector<Vec3> positions;
  std::vector<Vec3> velocities;
  std::vector<VertexPair> pairs;
  for (int i = 0; i < 5; ++i) {
    positions.emplace_back(0.02 * i, 0.0, 0.0);
    velocities.emplace_back(i < 2 ? 0.3 : (i > 2 ? -0.3 : 0.0), 0.0, 0.0);
    if (i > 0) {
      pairs.push_back({i - 1, i});
    }
  }
  Flight flight(loosePoints(5), positions, velocities);
  flight.collide(smooth, pairs);
  for (std::size_t i = 1; i < 5; ++i) {
    EXPECT_GT(flight.distance(i - 1, i), 0.02 - 0.02 * 0.02);
  }
}

}  // namespace
}  // namespace drape::sim::contact
