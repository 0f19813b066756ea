#include "sim/contact/exact/crossing_recovery.hpp"

#include "contact/contact_scene.hpp"
#include "contact/exact/crossings_at_rest.hpp"
#include "intersection/intersections.hpp"
#include "sim/contact/solve/contact_solver.hpp"
#include "test_meshes.hpp"

#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

namespace drape::sim::contact {
namespace {

/// Two meshes as one, without common vertices.
ClothMesh together(ClothMesh first, const ClothMesh& second) {
  const int offset = static_cast<int>(first.positions.size());
  first.positions.insert(first.positions.end(), second.positions.begin(), second.positions.end());
  for (const Triangle& triangle : second.triangles) {
    first.triangles.push_back({triangle[0] + offset, triangle[1] + offset, triangle[2] + offset});
  }
  return first;
}

/// A horizontal sheet, and one above it with a dent that passes through the first.
ClothMesh sheetsWithDent() {
  ClothMesh flat = testing::sheet(15);
  const Vec3 middle = 0.5 * (flat.positions.front() + flat.positions.back());
  for (Vec3& position : flat.positions) {
    position = Vec3(position.x() - middle.x(), 0.0, position.z() - middle.z());
  }
  ClothMesh dented = flat;
  for (Vec3& position : dented.positions) {
    position = 0.9 * position + Vec3(0.02, 0.0, 0.013);
    position.y() = 0.02 - 0.1 * std::exp(-position.squaredNorm() / 0.04);
  }
  return together(flat, dented);
}

/// A tube around the y axis from height `low` to `high`, moved by `shift` along x [m].
ClothMesh tube(int around, int rows, double radius, double low, double high, double shift) {
  ClothMesh mesh;
  for (int row = 0; row < rows; ++row) {
    for (int i = 0; i < around; ++i) {
      const double angle = 2.0 * std::numbers::pi * (i + 0.3) / around;
      mesh.positions.emplace_back(shift + radius * std::cos(angle), low + (high - low) * row / (rows - 1),
                                  radius * std::sin(angle));
    }
  }
  for (int row = 0; row + 1 < rows; ++row) {
    for (int i = 0; i < around; ++i) {
      const int a = row * around + i;
      const int b = row * around + (i + 1) % around;
      mesh.triangles.push_back({a, b, b + around});
      mesh.triangles.push_back({a, b + around, a + around});
    }
  }
  return mesh;
}

/// One tube inside another, off its axis, so that a strip of the inner one is outside. It extends beyond the other at
/// one end, so that no contour surrounds the strip.
ClothMesh nestedTubes() {
  return together(tube(40, 25, 0.2, 0.0, 0.5, 0.0), tube(36, 23, 0.19, -0.03, 0.46, 0.02));
}

/// The crossings of a cloth at its rest positions.
struct Crossings {
  std::shared_ptr<const ClothModel> model;
  FeatureMesh mesh;
  std::vector<EdgeCrossing> found;

  explicit Crossings(const ClothMesh& cloth)
      : model(buildClothModel(cloth, 1.0, MassLumping::Uniform, {})),
        mesh(featureMeshOf(*model)),
        found(testing::crossingsAtRest(*model, mesh)) {}

  [[nodiscard]] std::vector<int> wrongEnds() const {
    return wrongEndsOf(mesh, found, contoursOf(mesh, found), CrossingField(mesh, model->vertexMass),
                       model->restPositions);
  }
};

TEST(IntersectionContours, areOnePerDentWithACurveOnEachSheet) {
  const Crossings crossings(sheetsWithDent());
  const IntersectionContours contours = contoursOf(crossings.mesh, crossings.found);
  EXPECT_GT(crossings.found.size(), 10U);
  EXPECT_EQ(contours.count, 1);
  EXPECT_EQ(contours.curveCount, 2);
  for (std::size_t i = 0; i < crossings.found.size(); ++i) {
    const bool onFirst = crossings.mesh.edges.edges[crossings.found[i].edge].a < 15 * 15;
    const bool zeroOnFirst = crossings.mesh.edges.edges[crossings.found[0].edge].a < 15 * 15;
    EXPECT_EQ(contours.curveOf[i] == contours.curveOf[0], onFirst == zeroOnFirst);
  }
}

TEST(WrongEnds, areBelowTheSheetThatTheDentPassesThrough) {
  const Crossings crossings(sheetsWithDent());
  const std::vector<int> wrong = crossings.wrongEnds();
  int found = 0;
  for (std::size_t i = 0; i < wrong.size(); ++i) {
    const MeshEdge& edge = crossings.mesh.edges.edges[crossings.found[i].edge];
    if (edge.a >= 15 * 15) {
      const std::vector<Vec3>& positions = crossings.model->restPositions;
      EXPECT_EQ(wrong[i], positions[edge.a].y() < 0.0 ? edge.a : edge.b);
      ++found;
    }
  }
  EXPECT_GT(found, 10);
}

TEST(WrongEnds, areOfTheStripOutsideTheOuterTubeAlthoughNoContourSurroundsIt) {
  const Crossings crossings(nestedTubes());
  const std::vector<int> wrong = crossings.wrongEnds();
  const std::vector<Vec3>& positions = crossings.model->restPositions;
  int found = 0;
  for (std::size_t i = 0; i < wrong.size(); ++i) {
    const MeshEdge& edge = crossings.mesh.edges.edges[crossings.found[i].edge];
    const auto fromAxis = [&](int v) { return std::hypot(positions[v].x(), positions[v].z()); };
    if (edge.a >= 40 * 25 && wrong[i] >= 0) {
      EXPECT_EQ(wrong[i], fromAxis(edge.a) > fromAxis(edge.b) ? edge.a : edge.b);
      ++found;
    }
  }
  EXPECT_GT(found, 20);
}

/// The length of all contours [m], from the exact intersections of triangles with a plane y = 0.
double lengthInPlane(const ClothMesh& dented) {
  double length = 0.0;
  for (const Triangle& triangle : dented.triangles) {
    std::vector<Vec3> points;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3& from = dented.positions[triangle[k]];
      const Vec3& to = dented.positions[triangle[(k + 1) % 3]];
      if (from.y() * to.y() < 0.0) {
        points.push_back(from + from.y() / (from.y() - to.y()) * (to - from));
      }
    }
    length += points.size() == 2 ? (points[1] - points[0]).norm() : 0.0;
  }
  return length;
}

TEST(ShorteningRates, areTheDerivativeOfTheLengthForAMotionOfTheWholeSheet) {
  const ClothMesh cloth = sheetsWithDent();
  const Crossings crossings(cloth);
  const std::vector<Vec3> rates = shorteningRates(crossings.mesh, crossings.found, crossings.model->restPositions);
  double up = 0.0;
  for (std::size_t i = 0; i < rates.size(); ++i) {
    up += crossings.mesh.edges.edges[crossings.found[i].edge].a >= 15 * 15 ? rates[i].y() : -rates[i].y();
  }
  const auto lengthAt = [&](double height) {
    ClothMesh dented;
    dented.positions.assign(cloth.positions.begin() + 15 * 15, cloth.positions.end());
    for (Vec3& position : dented.positions) {
      position.y() += height;
    }
    dented.triangles = testing::sheet(15).triangles;
    return lengthInPlane(dented);
  };
  constexpr double step = 1e-6;  // [m]
  EXPECT_NEAR(up, (lengthAt(-step) - lengthAt(step)) / (2.0 * step), 1e-3 * up);
  EXPECT_GT(up, 1.0);
}

TEST(CrossingRecovery, conservesTheCentreOfMassAndMomentumAtALimitedSpeed) {
  const Crossings crossings(sheetsWithDent());
  const CrossingField field(crossings.mesh, crossings.model->vertexMass);
  const std::vector<double> inverseMass = inverseMassOf(*crossings.model);
  ClothState state = stateAtRest(crossings.model->restPositions);
  for (std::size_t v = 15 * 15; v < state.velocities.size(); ++v) {
    state.velocities[v] = Vec3(0.3, -2.0, 0.1);  // the dent moves further down
  }
  const auto kineticEnergy = [&] {
    double sum = 0.0;
    for (std::size_t v = 0; v < state.velocities.size(); ++v) {
      sum += 0.5 * crossings.model->vertexMass[v] * state.velocities[v].squaredNorm();
    }
    return sum;
  };
  const auto meanOf = [](const std::vector<Vec3>& values) {
    return Vec3(std::accumulate(values.begin(), values.end(), Vec3(Vec3::Zero())) / static_cast<double>(values.size()));
  };
  const Vec3 centre = meanOf(state.positions);
  const Vec3 velocity = meanOf(state.velocities);
  const double energy = kineticEnergy();
  constexpr double timeStep = 1.0 / 1000.0;
  recoverFromCrossings({.model = *crossings.model,
                        .mesh = crossings.mesh,
                        .field = field,
                        .inverseMass = inverseMass,
                        .crossings = crossings.found,
                        .start = crossings.model->restPositions,
                        .margin = 1e-3,
                        .timeStep = timeStep},
                       state);
  double moved = 0.0;
  for (std::size_t v = 0; v < state.positions.size(); ++v) {
    moved = std::max(moved, (state.positions[v] - crossings.model->restPositions[v]).norm());
  }
  EXPECT_GT(moved, 1e-4);
  EXPECT_LE(moved, 2.0 * timeStep * (1.0 + 1e-12));
  EXPECT_LT((meanOf(state.positions) - centre).norm(), 0.05 * moved);  // the speed limit may cut one side only
  EXPECT_LT((meanOf(state.velocities) - velocity).norm(), 1e-12);
  EXPECT_LT(kineticEnergy(), energy);
}

class CrossingRecoveryOf : public ::testing::TestWithParam<std::pair<const char*, ClothMesh (*)()>> {};

TEST_P(CrossingRecoveryOf, leavesNoIntersectionAndAddsLittleEnergy) {
  const auto model = buildClothModel(GetParam().second(), 0.2, MassLumping::Uniform, {});
  for (const char* solver : {"auto", "one_iteration", "xpbd"}) {
    testing::ContactScene scene(model, {}, solver);
    scene.parameters.contact.self = SelfCollision::Exact;
    scene.parameters.gravity = 0.0;
    scene.parameters.material.stiffness = 300.0;
    scene.parameters.material.damping = 0.01;
    scene.parameters.timeStep = 1.0 / 150.0;
    const auto pairs = [&] {
      return intersection::intersectingPairs({scene.state.positions, scene.model().triangles}).size();
    };
    ASSERT_GT(pairs(), 20U);
    scene.run(1.0);
    EXPECT_EQ(pairs(), 0U) << solver;
    double fastest = 0.0;
    for (const Vec3& velocity : scene.state.velocities) {
      fastest = std::max(fastest, velocity.norm());
    }
    EXPECT_LT(fastest, 1.0) << solver;
  }
}

INSTANTIATE_TEST_SUITE_P(Starts, CrossingRecoveryOf,
                         ::testing::Values(std::pair("dent", &sheetsWithDent), std::pair("tubes", &nestedTubes)),
                         [](const auto& start) { return std::string(start.param.first); });

}  // namespace
}  // namespace drape::sim::contact
