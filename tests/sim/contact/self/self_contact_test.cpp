#include "sim/contact/self/self_contact.hpp"

#include "sim/forces/diagnostics.hpp"
#include "sim/motion/momentum.hpp"
#include "sim/stepping/stepper.hpp"
#include "test_meshes.hpp"

#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <memory>
#include <set>
#include <utility>
#include <vector>

namespace drape::sim::contact {
namespace {

using testing::sheet;

/// Two sheets of one cloth, the second above the first.
ClothMesh twoSheets(int n, double gap) {
  ClothMesh mesh = sheet(n);
  const int count = n * n;
  for (int v = 0; v < count; ++v) {
    mesh.positions.emplace_back(mesh.positions[v] + Vec3(0.0, gap, 0.0));
  }
  const std::size_t triangles = mesh.triangles.size();
  for (std::size_t t = 0; t < triangles; ++t) {
    const Triangle below = mesh.triangles[t];
    mesh.triangles.push_back({below[0] + count, below[1] + count, below[2] + count});
  }
  return mesh;
}

std::vector<int> firstVertices(int count) {
  std::vector<int> vertices(count);
  for (int v = 0; v < count; ++v) {
    vertices[v] = v;
  }
  return vertices;
}

StepParameters withSelfCollision() {
  StepParameters parameters;
  parameters.contact.self = SelfCollision::Hash;
  parameters.material.stiffness = 100.0;
  parameters.material.damping = 0.002;
  return parameters;
}

/// A sheet that is pinned along its middle: its halves swing down and collide.
struct Fold {
  std::shared_ptr<const ClothModel> model;
  ClothState state;

  explicit Fold(int n) {
    std::vector<int> pins;
    for (int i = 0; i < n; ++i) {
      pins.push_back(n / 2 * n + i);
    }
    model = buildClothModel(sheet(n), 0.1, MassLumping::Uniform, pins);
    state = stateAtRest(model->restPositions);
  }

  ContactReport run(int steps, const StepParameters& parameters, Stepper& stepper) {
    ContactReport maximum;
    for (int i = 0; i < steps; ++i) {
      const ContactReport report = stepper.step(*model, parameters, {}, state).contact;
      maximum.selfContacts = std::max(maximum.selfContacts, report.selfContacts);
    }
    return maximum;
  }
};

TEST(SelfContact, DoesNotChangeAClothWithoutSelfContact) {
  const auto model = testing::pinnedSheet(9);
  StepParameters parameters = withSelfCollision();
  Stepper with("one_iteration");
  Stepper without("one_iteration");
  ClothState a = testing::shaken(*model, 0.005, 1);
  ClothState b = a;
  for (int i = 0; i < 20; ++i) {
    parameters.contact.self = SelfCollision::Hash;
    EXPECT_EQ(with.step(*model, parameters, {}, a).contact.selfContacts, 0);
    parameters.contact.self = SelfCollision::Off;
    without.step(*model, parameters, {}, b);
    ASSERT_EQ(stateHash(a), stateHash(b));
  }
  EXPECT_NE(a.selfContact, nullptr);
  EXPECT_EQ(b.selfContact, nullptr);
}

/// The result of a collision of two sheets, relative to the initial values.
struct Collision {
  int contacts = 0;
  double linearLost = 0.0;
  double angularLost = 0.0;
  double nearest = 1e9;  // minimum height of one over the other, in thicknesses
  double speedApart = 0.0;
};

Collision collide(double friction, double stiffness) {
  const auto model = buildClothModel(twoSheets(7, 0.3), 0.2, MassLumping::Uniform, {});
  ClothState state = stateAtRest(model->restPositions);
  for (std::size_t v = 0; v < state.velocities.size(); ++v) {
    state.velocities[v] = v < 49 ? Vec3(0.3, 1.0, 0.0) : Vec3(0.0, -2.0, 0.1);
  }
  StepParameters parameters = withSelfCollision();
  parameters.gravity = 0.0;
  parameters.material.stiffness = stiffness;
  parameters.material.damping = 0.0;
  parameters.iteration.tolerance = 1e-12;
  parameters.contact.staticFriction = friction;
  parameters.contact.kineticFriction = friction;
  Stepper stepper("pcg");
  const Vec3 linear = linearMomentum(*model, state);
  const Vec3 angular = angularMomentum(*model, state, Vec3::Zero());
  const double thickness = selfThicknessOf(*model, parameters.contact);
  Collision collision;
  for (int i = 0; i < 25; ++i) {
    collision.contacts += stepper.step(*model, parameters, {}, state).contact.selfContacts;
    for (std::size_t v = 0; v < 49; ++v) {
      collision.nearest =
          std::min(collision.nearest, (state.positions[v + 49].y() - state.positions[v].y()) / thickness);
    }
  }
  collision.linearLost = (linearMomentum(*model, state) - linear).norm() / linear.norm();
  collision.angularLost = (angularMomentum(*model, state, Vec3::Zero()) - angular).norm() / angular.norm();
  collision.speedApart = (state.velocities[24 + 49] - state.velocities[24]).y();
  return collision;
}

TEST(SelfContact, CollidingSheetsConserveLinearMomentum) {
  for (const double friction : {0.0, 0.4}) {
    const Collision collision = collide(friction, 100.0);
    EXPECT_GT(collision.contacts, 50);
    EXPECT_LT(collision.linearLost, 1e-6);
    EXPECT_GT(collision.nearest, 0.5);
    EXPECT_LT(std::abs(collision.speedApart), 0.5);  // of 3 m/s; without rebound they move on together
  }
}

TEST(SelfContact, CollidingSheetsWithoutFrictionConserveAngularMomentum) {
  // Without springs: the step of a rotating spring does not conserve it exactly either.
  const Collision collision = collide(0.0, 0.0);
  EXPECT_GT(collision.contacts, 50);
  EXPECT_LT(collision.angularLost, 1e-6);
}

TEST(SelfContact, ASheetPressedOntoAnotherKeepsTheThickness) {
  const auto model = buildClothModel(twoSheets(7, 0.2), 0.2, MassLumping::Uniform, firstVertices(49));
  StepParameters parameters = withSelfCollision();
  parameters.contact.selfThickness = 0.05;
  ClothState state = stateAtRest(model->restPositions);
  Stepper stepper("one_iteration");
  for (int i = 0; i < 300; ++i) {
    if (i == 150) {
      parameters.gravity = 100.0;  // ten times its weight
    }
    stepper.step(*model, parameters, {}, state);
  }
  for (std::size_t v = 49; v < 98; ++v) {
    EXPECT_NEAR(state.positions[v].y(), 0.05, 0.0005);
    EXPECT_LT(state.velocities[v].norm(), 1e-3);
  }
}

TEST(SelfContact, LayersHaveFriction) {
  const auto model = buildClothModel(twoSheets(7, 0.05), 0.2, MassLumping::Uniform, firstVertices(49));
  const auto slide = [&](double friction) {
    StepParameters parameters = withSelfCollision();
    parameters.contact.selfThickness = 0.05;
    parameters.contact.staticFriction = friction;
    parameters.contact.kineticFriction = friction;
    ClothState state = stateAtRest(model->restPositions);
    for (std::size_t v = 49; v < 98; ++v) {
      state.velocities[v] = Vec3(0.2, 0.0, 0.0);
    }
    Stepper stepper("one_iteration");
    for (int i = 0; i < 15; ++i) {
      stepper.step(*model, parameters, {}, state);
    }
    return state.velocities[24 + 49].x();
  };
  EXPECT_GT(slide(0.0), 0.15);
  EXPECT_LT(slide(0.5), 0.02);
}

TEST(SelfContact, GivesTheSameBitsForAnyNumberOfThreads) {
  std::set<std::uint64_t> hashes;
  for (const int threads : {1, 2, 4}) {
    Fold fold(17);
    StepParameters parameters = withSelfCollision();
    parameters.threads = threads;
    Stepper stepper("one_iteration");
    EXPECT_GT(fold.run(150, parameters, stepper).selfContacts, 20);
    hashes.insert(stateHash(fold.state));
  }
  EXPECT_EQ(hashes.size(), 1u);
}

TEST(SelfContact, ACopyOfAStateGoesOnToTheSameBits) {
  const StepParameters parameters = withSelfCollision();
  Fold fold(17);
  Stepper stepper("one_iteration");
  fold.run(110, parameters, stepper);
  Fold copy = fold;
  fold.run(60, parameters, stepper);
  Stepper another("one_iteration");
  copy.run(60, parameters, another);
  EXPECT_EQ(stateHash(fold.state), stateHash(copy.state));
}

TEST(SelfContact, RarelyMissesAPairOfDifferentPatchesThatIsTooClose) {
  StepParameters parameters = withSelfCollision();
  Fold fold(17);
  Stepper stepper("one_iteration");
  const double thickness = selfThicknessOf(*fold.model, parameters.contact);
  int near = 0;
  int missed = 0;
  for (int i = 0; i < 300; ++i) {
    fold.run(1, parameters, stepper);
    const SelfContactMemory& memory = *fold.state.selfContact;
    std::set<std::pair<int, int>> known;
    for (std::size_t p = 0; p < static_cast<std::size_t>(memory.pairs.count()); ++p) {
      known.insert({memory.pairs.pairs[p].a, memory.pairs.pairs[p].b});
    }
    for (const auto& [a, b] : known) {
      EXPECT_NE(memory.patches.patches->patchOfVertex[a], memory.patches.patches->patchOfVertex[b]);
    }
    const std::vector<Vec3>& x = fold.state.positions;
    for (int a = 0; a < fold.model->vertexCount(); ++a) {
      for (int b = a + 1; b < fold.model->vertexCount(); ++b) {
        const auto i1 = static_cast<std::size_t>(a);
        const auto i2 = static_cast<std::size_t>(b);
        const bool connected = (fold.model->restPositions[i2] - fold.model->restPositions[i1]).norm() < 0.09;
        if (!connected && memory.patches.patches->patchOfVertex[i1] != memory.patches.patches->patchOfVertex[i2] &&
            (x[i2] - x[i1]).norm() < 1.01 * thickness) {
          ++near;
          missed += known.count({a, b}) == 0 ? 1 : 0;
        }
      }
    }
  }
  EXPECT_GT(near, 1000);
  EXPECT_LT(missed, near / 100);
}

TEST(SelfContact, AddsNoEnergyToStiffClothWithAnEnergyConservingSolver) {
  StepParameters parameters = withSelfCollision();
  parameters.timeStep = 1.0 / 150.0;
  parameters.material.stiffness = 1000.0;
  parameters.material.damping = 0.0;
  Fold fold(17);
  Stepper stepper("auto");
  int contacts = 0;
  double maximum = 0.0;  // [J]; initially 0; a fall by its own length releases 1 J
  for (int step = 0; step < 180; ++step) {
    contacts += fold.run(1, parameters, stepper).selfContacts;
    maximum = std::max(maximum, energyOf(*fold.model, parameters, fold.state).total());
  }
  EXPECT_GT(contacts, 100);
  EXPECT_LT(maximum, 0.05);
  EXPECT_GT(stepper.contactSubsteps(), 1);
}

TEST(SelfContact, PairsConnectedAtRestNeverCount) {
  const auto model = buildClothModel(sheet(9), 0.1, MassLumping::Uniform, {});
  StepParameters parameters = withSelfCollision();
  parameters.gravity = 0.0;
  parameters.material.stiffness = 0.0;
  parameters.contact.selfThickness = 0.3;  // 2.4 edges
  // Folded in the middle, so that there are two patches and all vertices are near the fold.
  ClothState state = stateAtRest(model->restPositions);
  for (Vec3& x : state.positions) {
    const double over = std::max(0.0, x.x() - 0.5);
    x = Vec3(std::min(x.x(), 0.5) + over * std::cos(1.9), over * std::sin(1.9), x.z());
  }
  Stepper stepper("one_iteration");
  stepper.step(*model, parameters, {}, state);
  EXPECT_GT(state.selfContact->patches.patches->count(), 1);
  const ColouredPairs& pairs = state.selfContact->pairs;
  EXPECT_GT(pairs.count(), 0);
  for (std::size_t i = 0; i < static_cast<std::size_t>(pairs.count()); ++i) {
    const auto a = static_cast<std::size_t>(pairs.pairs[i].a);
    const auto b = static_cast<std::size_t>(pairs.pairs[i].b);
    EXPECT_GE((model->restPositions[a] - model->restPositions[b]).norm(), 0.3);
  }
}

TEST(SelfContact, IgnoresAStateThatIsNotFinite) {
  const auto model = testing::pinnedSheet(5);
  ClothState state = stateAtRest(model->restPositions);
  const std::vector<Vec3> start = state.positions;
  state.positions[7].x() = std::nan("");
  std::vector<ContactPoint> points;
  EXPECT_EQ(
      SelfContact().resolve(*model, withSelfCollision().contact, withSelfCollision().timeStep, start, state, points),
      0);
}

TEST(SelfThickness, IsThreeQuartersOfTheMeanEdgeUnlessItIsGiven) {
  const auto model = buildClothModel(sheet(3), 0.1, MassLumping::Uniform, {});
  // 12 edges of 1/2 along the sides of the cells and 4 diagonals.
  EXPECT_NEAR(selfThicknessOf(*model, {}), 0.75 * (12 * 0.5 + 4 * std::sqrt(0.5)) / 16, 1e-12);
  ContactParameters given;
  given.selfThickness = 0.123;
  EXPECT_EQ(selfThicknessOf(*model, given), 0.123);
}

}  // namespace
}  // namespace drape::sim::contact
