#include "sim/measures/equilibrium.hpp"

#include "fabric_cloths.hpp"
#include "sim/forces/step_inputs.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace drape::sim {
namespace {

using namespace testing;

/// The sheet of the other tests with a fabric, with its first rows pinned.
std::shared_ptr<const ClothModel> clampedSheet(int n, const fabric::Material& material, int pinnedRows) {
  std::vector<int> pins(n * pinnedRows);
  std::iota(pins.begin(), pins.end(), 0);
  return asFabric(*buildClothModel(sheet(n), 0.1, MassLumping::Area, pins), material);
}

/// The norm of the unbalanced forces on free vertices [N].
double unbalanced(const ClothModel& model, const std::vector<Vec3>& loads, const std::vector<Vec3>& positions) {
  double sum = 0.0;
  for (std::size_t v = 0; v < positions.size(); ++v) {
    sum += model.pinned[v] ? 0.0 : (fabric::elasticForceOn(model, positions, v) + loads[v]).squaredNorm();
  }
  return std::sqrt(sum);
}

double potentialOf(const ClothModel& model, const std::vector<Vec3>& loads, const std::vector<Vec3>& positions) {
  double work = 0.0;
  for (std::size_t v = 0; v < positions.size(); ++v) {
    work += loads[v].dot(positions[v]);
  }
  return fabric::elasticEnergy(model, positions) - work;
}

TEST(Equilibrium, forcesBalanceForEveryKindOfFabric) {
  for (const auto& [name, material] : everyKindOfFabric()) {
    const auto model = clampedSheet(7, material, 1);
    const std::vector<Vec3> loads = weightsOf(*model, 9.81);
    const Equilibrium found = equilibriumUnder(*model, loads, shaken(*model, 0.01, 3).positions);
    EXPECT_TRUE(found.converged) << name;
    EXPECT_LT(found.residual, 1e-8) << name;
    EXPECT_GT(found.iterations, 0) << name;
    EXPECT_LT(unbalanced(*model, loads, found.positions), 1e-7) << name;
  }
}

TEST(Equilibrium, isAMinimumOfThePotential) {
  const auto model = clampedSheet(6, woven(), 2);
  const std::vector<Vec3> loads = weightsOf(*model, 9.81);
  const Equilibrium found = equilibriumUnder(*model, loads, model->restPositions);
  ASSERT_TRUE(found.converged);
  EXPECT_TRUE(found.stable);
  EXPECT_TRUE(isStableAt(*model, found.positions));
  const double lowest = potentialOf(*model, loads, found.positions);
  RandomVectors random(3);
  for (int trial = 0; trial < 20; ++trial) {
    std::vector<Vec3> near = found.positions;
    for (std::size_t v = 0; v < near.size(); ++v) {
      const Vec3 change = random.next(1e-3);
      near[v] += model->pinned[v] ? Vec3(Vec3::Zero()) : change;
    }
    EXPECT_GT(potentialOf(*model, loads, near), lowest);
  }
}

TEST(Equilibrium, pinsStayWhereTheStartHasThem) {
  const auto model = clampedSheet(5, woven(), 1);
  std::vector<Vec3> start = model->restPositions;
  for (Vec3& position : start) {
    position += Vec3(0.1, 0.2, 0.3);
  }
  start[0].x() += 0.02;
  const Equilibrium found = equilibriumUnder(*model, weightsOf(*model, 9.81), start);
  EXPECT_TRUE(found.converged);
  for (std::size_t v = 0; v < 5; ++v) {
    EXPECT_EQ(found.positions[v], start[v]);
  }
}

TEST(Equilibrium, isTheStartIfNothingActs) {
  const auto model = clampedSheet(5, woven(), 1);
  const std::vector<Vec3> none(model->restPositions.size(), Vec3::Zero());
  const Equilibrium found = equilibriumUnder(*model, none, model->restPositions);
  EXPECT_TRUE(found.converged);
  EXPECT_LE(found.iterations, 2) << "to remove rounding errors";
  for (std::size_t v = 0; v < found.positions.size(); ++v) {
    EXPECT_LT((found.positions[v] - model->restPositions[v]).norm(), 1e-14);
  }
}

TEST(Equilibrium, isTheStartIfAllVerticesArePinned) {
  const auto model = clampedSheet(4, woven(), 4);
  const Equilibrium found = equilibriumUnder(*model, weightsOf(*model, 9.81), model->restPositions);
  EXPECT_TRUE(found.converged);
  EXPECT_TRUE(found.stable);
  EXPECT_EQ(found.positions, model->restPositions);
  EXPECT_TRUE(isStableAt(*model, model->restPositions));
}

TEST(Equilibrium, reactionsCarryTheWeight) {
  const auto model = clampedSheet(7, woven(), 2);
  const std::vector<Vec3> loads = weightsOf(*model, 9.81);
  const Equilibrium found = equilibriumUnder(*model, loads, model->restPositions);
  Vec3 reaction = Vec3::Zero();
  double weight = 0.0;
  for (std::size_t v = 0; v < loads.size(); ++v) {
    reaction -= model->pinned[v] ? fabric::elasticForceOn(*model, found.positions, v) : Vec3(Vec3::Zero());
    weight -= model->pinned[v] ? 0.0 : loads[v].y();
  }
  EXPECT_LT((reaction - weight * Vec3::UnitY()).norm(), 1e-7 * weight);
}

TEST(Equilibrium, saysSoIfItHasNotConverged) {
  const auto model = clampedSheet(7, woven(), 1);
  const Equilibrium found =
      equilibriumUnder(*model, weightsOf(*model, 9.81), model->restPositions, {.maxIterations = 2});
  EXPECT_FALSE(found.converged);
  EXPECT_GT(found.residual, 1e-9);
  EXPECT_LE(found.iterations, 2);
}

TEST(Equilibrium, doesNotConvergeWithoutAnEquilibrium) {
  const auto model = clampedSheet(7, woven(), 0);
  const Equilibrium found = equilibriumUnder(*model, weightsOf(*model, 9.81), model->restPositions);
  EXPECT_FALSE(found.converged) << "the cloth falls for ever";
  EXPECT_FALSE(found.stable);
  EXPECT_GT(found.residual, 0.1);
}

TEST(Equilibrium, aToleranceOfZeroIsMetUpToRounding) {
  const auto model = clampedSheet(6, woven(), 2);
  const Equilibrium found = equilibriumUnder(*model, weightsOf(*model, 9.81), model->restPositions, {.tolerance = 0.0});
  EXPECT_TRUE(found.converged);
  EXPECT_LT(found.residual, 1e-8);
}

TEST(Equilibrium, stopsOnRequest) {
  const auto model = clampedSheet(5, woven(), 1);
  std::stop_source source;
  source.request_stop();
  EXPECT_THROW(static_cast<void>(
                   equilibriumUnder(*model, weightsOf(*model, 9.81), model->restPositions, {}, source.get_token())),
               StepStopped);
}

TEST(Equilibrium, compressedFlatClothIsUnstable) {
  const auto model = clampedSheet(7, woven(), 1);
  std::vector<Vec3> positions = model->restPositions;
  EXPECT_TRUE(isStableAt(*model, positions));
  for (Vec3& position : positions) {
    position.z() *= 0.9;
  }
  EXPECT_FALSE(isStableAt(*model, positions));
}

TEST(Equilibrium, neutralModesCountAsStable) {
  // Without tension and bending stiffness, the energy of flat cloth does not grow with small motion out of its plane.
  const auto model = clampedSheet(7, membraneOnly(), 1);
  EXPECT_TRUE(isStableAt(*model, model->restPositions));
}

TEST(WeightsOf, pullDownByMassTimesGravity) {
  const auto model = clampedSheet(4, woven(), 1);
  const std::vector<Vec3> weights = weightsOf(*model, 2.0);
  ASSERT_EQ(weights.size(), model->vertexMass.size());
  double sum = 0.0;
  for (const Vec3& weight : weights) {
    EXPECT_EQ(weight.x(), 0.0);
    sum += weight.y();
  }
  EXPECT_NEAR(sum, -0.2, 1e-15);
}

}  // namespace
}  // namespace drape::sim
