#include "fabric_cloths.hpp"
#include "sim/fabric/weld.hpp"
#include "sim/forces/diagnostics.hpp"
#include "sim/motion/momentum.hpp"
#include "sim/solvers/solver.hpp"
#include "sim/stepping/sewn_cloth.hpp"
#include "sim/stepping/stepper.hpp"
#include "test_meshes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace drape::sim {
namespace {

constexpr int side = 7;  // vertices along a side of a piece

/// Two square pieces of 0.4 m that hang side by side, one before the other. The normals of the second one point away
/// from the first.
ClothMesh twoPieces() {
  ClothMesh mesh;
  const ClothMesh piece = testing::sheet(side);
  const int count = static_cast<int>(piece.positions.size());
  for (const double distance : {0.1, -0.1}) {
    for (const Vec3& position : piece.positions) {
      mesh.positions.emplace_back(0.4 * position.x(), -0.4 * position.z(), distance);
    }
    for (const auto& [a, b, c] : piece.triangles) {
      const int first = distance > 0.0 ? 0 : count;
      mesh.triangles.push_back(distance > 0.0 ? Triangle{a, b, c} : Triangle{first + a, first + c, first + b});
    }
  }
  return mesh;
}

/// A seam along the left side of both, and one along the right side.
std::vector<Seam> sideSeams() {
  std::vector<Seam> seams(2);
  for (int row = 0; row < side; ++row) {
    const int left = row * side;
    const int right = left + side - 1;
    seams[0].pairs.push_back({left, left + side * side});
    seams[1].pairs.push_back({right, right + side * side});
  }
  for (Seam& seam : seams) {
    seam.duration = 0.5;
  }
  return seams;
}

std::shared_ptr<const ClothModel> springPieces(const std::vector<int>& pins = {}) {
  return buildClothModel(twoPieces(), 0.06, MassLumping::Area, pins);
}

StepParameters parametersOf(double timeStep) {
  StepParameters parameters;
  parameters.timeStep = timeStep;
  parameters.material.stiffness = 60.0;
  parameters.material.damping = 0.01;
  parameters.iteration.iterations = 20;
  parameters.contact.self = contact::SelfCollision::Off;
  return parameters;
}

/// A cloth that is sewn by a solver.
struct Sewing {
  Sewing(std::string_view solver, std::shared_ptr<const ClothModel> pieces, std::vector<Seam> seams)
      : stepper(solver), state(stateAtRest(pieces->restPositions)) {
    cloth.use(std::move(pieces), std::make_shared<const std::vector<Seam>>(std::move(seams)));
  }

  void take(int steps, const StepParameters& parameters) {
    for (int i = 0; i < steps; ++i) {
      stepper.drawTogether(cloth.openSeams());
      stepper.step(*cloth.model(), cloth.acting(parameters, state.time), {}, state);
      cloth.weld(weldDistanceOf(*cloth.model(), parameters.contact, stepper.info()), state);
    }
  }

  Stepper stepper;
  SewnCloth cloth;
  ClothState state;
};

class SewingWith : public ::testing::TestWithParam<std::string> {};

std::vector<std::string> everySolver() {
  std::vector<std::string> names;
  for (const SolverInfo& solver : solverTable()) {
    names.emplace_back(solver.name);
  }
  return names;
}

double largestDistance(const Seam& seam, const ClothState& state) {
  double largest = 0.0;
  for (const SeamPair& pair : seam.pairs) {
    largest = std::max(largest, (state.positions[pair.a] - state.positions[pair.b]).norm());
  }
  return largest;
}

/// Enough for the explicit methods.
int substepsOf(const std::string& solver) {
  return solver == "explicit_euler" ? 200 : solver == "verlet" ? 10 : 2;
}

TEST_P(SewingWith, drawsTheSeamsTogetherAndCarriesTheWeightAcrossThem) {
  Sewing sewing(GetParam(), springPieces({0, side - 1}), sideSeams());
  StepParameters parameters = parametersOf(1.0 / 300.0);
  parameters.substeps = substepsOf(GetParam());
  sewing.take(75, parameters);
  EXPECT_NEAR(largestDistance(sideSeams()[0], sewing.state), 0.1, 0.01) << "half of the time";
  EXPECT_EQ(sewing.cloth.openSeams().size(), 2U);
  sewing.take(135, parameters);
  ASSERT_TRUE(isFinite(sewing.state));
  ASSERT_TRUE(sewing.cloth.openSeams().empty());
  sewing.take(150, parameters);
  for (const Seam& seam : sideSeams()) {
    EXPECT_EQ(largestDistance(seam, sewing.state), 0.0);
  }
  EXPECT_LT(maxStretch(*sewing.cloth.model(), sewing.state), 0.5) << "the second piece hangs from the first one";
}

INSTANTIATE_TEST_SUITE_P(Solvers, SewingWith, ::testing::ValuesIn(everySolver()),
                         [](const auto& test) { return test.param; });

/// The pieces with a rotation, and a motion towards +x.
void setInMotion(ClothState& state) {
  for (std::size_t v = 0; v < state.positions.size(); ++v) {
    state.velocities[v] = Vec3(0.3, 0.0, 0.0) + Vec3(0.2, 0.5, 1.0).cross(state.positions[v]);
  }
}

TEST(Seams, keepTheMomentumOfFreePieces) {
  Sewing sewing("auto", springPieces(), sideSeams());
  StepParameters parameters = parametersOf(1.0 / 600.0);
  parameters.material.damping = 0.0;  // which acts against rotation
  parameters.gravity = 0.0;
  parameters.precision = Precision::Double;
  setInMotion(sewing.state);
  const ClothModel& pieces = *sewing.cloth.pieces();
  const Vec3 before = linearMomentum(pieces, sewing.state);
  const Vec3 spinBefore = angularMomentum(pieces, sewing.state, Vec3::Zero());
  sewing.take(250, parameters);
  ASSERT_EQ(sewing.cloth.openSeams().size(), 2U);
  EXPECT_LT(largestDistance(sideSeams()[0], sewing.state), 0.05);
  EXPECT_LT((linearMomentum(pieces, sewing.state) - before).norm(), 1e-9 * before.norm());
  EXPECT_LT((angularMomentum(pieces, sewing.state, Vec3::Zero()) - spinBefore).norm(), 0.001 * spinBefore.norm());
  sewing.take(200, parameters);
  ASSERT_TRUE(sewing.cloth.openSeams().empty());
  const ClothModel& welded = *sewing.cloth.model();
  EXPECT_LT((linearMomentum(welded, sewing.state) - before).norm(), 1e-5 * before.norm());
  EXPECT_LT((angularMomentum(welded, sewing.state, Vec3::Zero()) - spinBefore).norm(), 0.01 * spinBefore.norm());
}

TEST(Seams, moveTheSameWithAnyNumberOfThreads) {
  for (const std::string& solver : {std::string("auto"), std::string("xpbd")}) {
    std::vector<std::uint64_t> hashes;
    for (const int threads : {1, 2, 4}) {
      Sewing sewing(solver, springPieces({0}), sideSeams());
      StepParameters parameters = parametersOf(1.0 / 300.0);
      parameters.contact.self = contact::SelfCollision::Exact;
      parameters.threads = threads;
      sewing.take(200, parameters);
      EXPECT_TRUE(sewing.cloth.openSeams().empty()) << solver;
      hashes.push_back(stateHash(sewing.state));
    }
    EXPECT_EQ(hashes[0], hashes[1]) << solver;
    EXPECT_EQ(hashes[0], hashes[2]) << solver;
  }
}

TEST(Seams, endWithoutIntersectionsWhereTheClothCollidesWithItself) {
  Sewing sewing("auto", springPieces(), sideSeams());
  StepParameters parameters = parametersOf(1.0 / 300.0);
  parameters.gravity = 0.0;
  parameters.contact.self = contact::SelfCollision::Exact;
  sewing.take(250, parameters);
  EXPECT_TRUE(sewing.cloth.openSeams().empty());
  EXPECT_TRUE(sewing.state.hasNoSelfIntersection);
}

TEST(Seams, addNoEnergyToStiffFabricAtLargeSteps) {
  fabric::Material cotton = testing::woven();
  cotton.stretchWarp *= 40.0;
  cotton.stretchWeft *= 40.0;
  cotton.shear *= 40.0;
  const auto springs = springPieces();
  Sewing sewing("auto", testing::asFabric(*springs, cotton), sideSeams());
  const StepParameters parameters = parametersOf(1.0 / 60.0);
  double highest = 0.0;
  for (int i = 0; i < 60; ++i) {
    sewing.take(1, parameters);
    highest = std::max(highest, energyOf(*sewing.cloth.model(), parameters, sewing.state).elastic);
  }
  EXPECT_TRUE(sewing.cloth.openSeams().empty());
  // The pieces of 30 g move by 0.1 m in half a second, which takes a few millijoules.
  EXPECT_LT(highest, 0.5);
}

TEST(Seams, keepClothAwakeUntilTheyAreWelded) {
  // The seam cannot close: both sides hang from pins.
  std::vector<Seam> seam(1);
  seam[0].pairs = {{side * (side - 1), side * (side - 1) + side * side}};
  seam[0].duration = 0.1;
  const std::vector<int> corners{0, side - 1, side * side, side * side + side - 1};
  StepParameters parameters = parametersOf(1.0 / 300.0);
  parameters.material.stiffness = 2000.0;
  parameters.material.damping = 0.5;
  const auto sleeps = [&](const std::vector<Seam>& seams) {
    Sewing sewing("auto", springPieces(corners), seams);
    bool slept = false;
    for (int i = 0; i < 1500 && !slept; ++i) {
      sewing.stepper.drawTogether(sewing.cloth.openSeams());
      const StepReport report = sewing.stepper.step(*sewing.cloth.model(), parameters, {}, sewing.state);
      slept = report.choice && report.choice->sleeping;
    }
    return slept;
  };
  EXPECT_TRUE(sleeps({}));
  seam[0].pairs = {{0, side * side}};  // two pins
  EXPECT_FALSE(sleeps(seam));
}

TEST(Welds, leaveNoTriangleStrained) {
  const auto pieces = testing::asFabric(*springPieces(), testing::woven());
  const std::vector<Seam> seams = sideSeams();
  const auto welded = fabric::withWelds(*pieces, leadersOf(seams, pieces->pinned));
  ASSERT_EQ(welded->triangles.size(), pieces->triangles.size());
  for (std::size_t t = 0; t < pieces->triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_EQ(welded->fabric->shape.triangles[t].sides[k], pieces->fabric->shape.triangles[t].sides[k]);
    }
  }
  EXPECT_NEAR(welded->totalMass(), pieces->totalMass(), 1e-15);
  EXPECT_NEAR(welded->restArea(), pieces->restArea(), 1e-12);
  EXPECT_EQ(welded->springs.size(), pieces->springs.size() - 2 * (side - 1)) << "the seams have one spring an edge";
  // As fast as its pieces: the weld makes nothing stiffer.
  EXPECT_LT(welded->unitFrequency, 1.3 * pieces->unitFrequency);
}

TEST(Welds, giveTriangleAndMassToTheLeaders) {
  const auto pieces = springPieces({side * side});
  const auto leaders = leadersOf(sideSeams(), pieces->pinned);
  EXPECT_EQ(leaders[0], side * side) << "the pinned one leads";
  EXPECT_EQ(leaders[side * side + side], side);
  const auto welded = fabric::withWelds(*pieces, leaders);
  EXPECT_TRUE(fabric::isFollower(*welded, 0));
  EXPECT_TRUE(welded->pinned[0]);
  EXPECT_TRUE(welded->pinned[side * side]);
  EXPECT_FALSE(welded->pinned[side]);
  EXPECT_NEAR(welded->vertexMass[side], pieces->vertexMass[side] + pieces->vertexMass[side * side + side], 1e-9);
  EXPECT_EQ(fabric::ownPinsOf(*welded), pieces->pinned);
}

TEST(Welds, keepTheRestLengthsOfSprings) {
  const auto pieces = springPieces();
  const auto welded = fabric::withWelds(*pieces, leadersOf(sideSeams(), pieces->pinned));
  for (const Spring& spring : welded->springs) {
    EXPECT_LT(spring.restLength, 0.4 / (side - 1) * std::sqrt(2.0) + 1e-12);
    EXPECT_GT(spring.restLength, 0.4 / (side - 1) - 1e-12);
  }
}

TEST(SewnCloth, findsItsWeldsInAState) {
  Sewing sewing("auto", springPieces(), sideSeams());
  StepParameters parameters = parametersOf(1.0 / 300.0);
  parameters.gravity = 0.0;
  const ClothState start = sewing.state;
  sewing.take(210, parameters);
  ASSERT_TRUE(sewing.cloth.openSeams().empty());
  SewnCloth other;
  other.use(sewing.cloth.pieces(), std::make_shared<const std::vector<Seam>>(sideSeams()));
  EXPECT_EQ(other.openSeams().size(), 2U);
  other.follow(sewing.state);
  EXPECT_TRUE(other.openSeams().empty());
  EXPECT_EQ(other.model()->triangles, sewing.cloth.model()->triangles);
  other.follow(start);
  EXPECT_EQ(other.openSeams().size(), 2U);
  EXPECT_EQ(other.model(), other.pieces());
}

TEST(SewnCloth, hasNoWeightUntilItIsSewn) {
  Sewing sewing("auto", springPieces(), sideSeams());
  const StepParameters parameters = parametersOf(1.0 / 300.0);
  EXPECT_EQ(sewing.cloth.acting(parameters, 0.6).gravity, 0.0);
  EXPECT_EQ(sewing.cloth.acting(parameters, 1.1).gravity, parameters.gravity) << "twice the duration";
  sewing.take(210, parameters);
  EXPECT_EQ(sewing.cloth.acting(parameters, 0.6).gravity, parameters.gravity);
}

}  // namespace
}  // namespace drape::sim
