#include "sim/fabric/pattern.hpp"

#include "fabric_cloths.hpp"
#include "sim/forces/diagnostics.hpp"
#include "sim/forces/forces.hpp"
#include "sim/forces/stability.hpp"
#include "sim/model/sim_error.hpp"
#include "sim/simd/sliced_run.hpp"
#include "sim/stepping/stepper.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

namespace drape::sim::fabric {
namespace {

using namespace testing;

std::shared_ptr<const ClothModel> flatSheet(int n = 9) {
  return buildClothModel(sheet(n), 0.1, MassLumping::Area, {});
}

/// A sheet of 1 m x 1 m whose pattern has the same form in another size.
std::shared_ptr<const ClothModel> resized(double patternSize, const Material& material = woven()) {
  const auto springs = flatSheet();
  return withPatternFabric(*springs, material, twoPieces(*springs, patternSize, 1.0));
}

TEST(Pattern, ofAFlatMeshIsTheSameFabricAsTheMesh) {
  const auto springs = irregularSheet(9);
  ClothMesh level{springs->restPositions, springs->triangles};
  for (Vec3& position : level.positions) {
    position.y() = 0.0;
  }
  const auto flat = buildClothModel(level, 0.1, MassLumping::Area, {0});
  const auto measured = withFabric(*flat, woven(), warpAlong(Vec3::UnitZ(), level.positions, level.triangles));
  const auto cut = withPatternFabric(*flat, woven(), twoPieces(*flat, 1.0, 1.0));
  ASSERT_TRUE(cut->hasPattern);
  for (std::size_t t = 0; t < level.triangles.size(); ++t) {
    const RestTriangle& one = measured->fabric->shape.triangles[t];
    const RestTriangle& other = cut->fabric->shape.triangles[t];
    EXPECT_NEAR(one.area, other.area, 1e-15);
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_NEAR(one.sides[k].norm(), other.sides[k].norm(), 1e-14);
    }
  }
  EXPECT_NEAR(cut->fabric->meshStrain->high, 0.0, 1e-12);
  // Of the second piece only the direction of warp differs.
  const auto whole = [&] {
    std::vector<RestTriangle> pattern = twoPieces(*flat, 1.0, 1.0);
    for (std::size_t t = 0; t < pattern.size(); ++t) {
      pattern[t] = restTrianglesOf(level.positions, level.triangles,
                                   warpAlong(Vec3::UnitZ(), level.positions, level.triangles))[t];
    }
    return withPatternFabric(*flat, woven(), pattern);
  }();
  EXPECT_NEAR(whole->unitFrequency, measured->unitFrequency, 1e-6 * measured->unitFrequency);
  EXPECT_EQ(whole->fabric->slivers, measured->fabric->slivers);
  simd::SlicedRun run;
  CommonParameters parameters;
  parameters.timeStep = 0.3 / measured->unitFrequency;
  parameters.precision = Precision::Double;
  ClothState one = shaken(*measured, 0.002, 5);
  ClothState other = one;
  run.verlet(*measured, parameters, {}, 50, one);
  run.verlet(*whole, parameters, {}, 50, other);
  EXPECT_LT(largestDifference(one, other), 1e-9);
}

TEST(Pattern, setsLengthsAndAreasAndAnotherRestShapeTakesThemBack) {
  const auto springs = flatSheet();
  const auto cut = resized(0.9);
  EXPECT_NEAR(cut->restArea(), 0.81, 1e-12);
  EXPECT_NEAR(cut->springs[0].restLength, 0.9 * springs->springs[0].restLength, 1e-12);
  EXPECT_EQ(cut->totalMass(), springs->totalMass());
  for (const auto& back : {withSprings(*cut), withMeshSizes(*cut), asFabric(*cut, woven())}) {
    EXPECT_FALSE(back->hasPattern);
    EXPECT_EQ(back->vertexArea, springs->vertexArea);
    EXPECT_EQ(back->springs[0].restLength, springs->springs[0].restLength);
  }
  EXPECT_FALSE(asFabric(*cut, woven())->fabric->meshStrain);
  // At the seam a spring has the mean length of both pieces.
  const auto eased = withPatternFabric(*springs, woven(), twoPieces(*springs, 1.0, 1.02));
  double longest = 0.0;
  for (std::size_t s = 0; s < springs->springs.size(); ++s) {
    const Spring& spring = springs->springs[s];
    const bool inSeam = springs->restPositions[spring.a].x() == 0.5 && springs->restPositions[spring.b].x() == 0.5;
    longest = std::max(longest, inSeam ? eased->springs[s].restLength / spring.restLength : 0.0);
  }
  EXPECT_NEAR(longest, 1.01, 1e-12);
}

TEST(Pattern, isMeasuredAgainstTheMesh) {
  EXPECT_NEAR(resized(1.0 / 1.1)->fabric->meshStrain->median, 0.1, 1e-12);
  EXPECT_NEAR(resized(1.25)->fabric->meshStrain->high, 0.2, 1e-12);
  const auto springs = flatSheet();
  const auto model = withPatternFabric(*springs, woven(), twoPieces(*springs, 1.0, 1.0 / 1.3));
  EXPECT_NEAR(model->fabric->meshStrain->high, 0.3, 1e-12);
}

TEST(Pattern, takesATriangleInEitherOrder) {
  const std::array<Vec2, 3> corners{Vec2(0.0, 0.0), Vec2(2.0, 0.0), Vec2(0.5, 1.0)};
  const RestTriangle front = restTriangleOf(corners);
  const RestTriangle back = restTriangleOf({corners[0], corners[2], corners[1]});
  EXPECT_EQ(front.area, 1.0);
  EXPECT_EQ(back.area, 1.0);
  EXPECT_EQ(back.sides[0], Vec2(0.5, -1.0));
  EXPECT_EQ(restTriangleOf({corners[0], corners[1], corners[1]}).area, 0.0);
  EXPECT_EQ(restTriangleOf({corners[0], corners[1], Vec2(std::nan(""), 0.0)}).area, 0.0);
}

TEST(Pattern, refusesAnotherNumberOfTriangles) {
  const auto springs = flatSheet();
  std::vector<RestTriangle> pattern = twoPieces(*springs, 1.0, 1.0);
  pattern.pop_back();
  try {
    static_cast<void>(withPatternFabric(*springs, woven(), pattern));
    FAIL();
  } catch (const ClothModelError& error) {
    EXPECT_EQ(error.fault(), ClothModelError::Fault::PatternCount);
    EXPECT_EQ(error.numbers().count, 128);
  }
}

TEST(Pattern, givesForcesThatAreTheDerivativeOfTheEnergyAcrossAnEasedSeam) {
  const auto springs = flatSheet();
  for (const auto& [name, material] : everyKindOfFabric()) {
    const auto model = withPatternFabric(*springs, material, twoPieces(*springs, 1.02, 1.05));
    const ClothState state = shaken(*model, 0.01, 7);
    constexpr double step = 1e-6;  // [m]
    double largest = 0.0;
    double worst = 0.0;
    for (std::size_t v = 0; v < state.positions.size(); ++v) {
      const Vec3 force = elasticForceOn(*model, state.positions, v);
      for (Eigen::Index i = 0; i < 3; ++i) {
        std::vector<Vec3> moved = state.positions;
        moved[v][i] += step;
        const double after = elasticEnergy(*model, moved);
        moved[v][i] -= 2.0 * step;
        worst = std::max(worst, std::abs(force[i] + (after - elasticEnergy(*model, moved)) / (2.0 * step)));
      }
      largest = std::max(largest, force.norm());
    }
    EXPECT_LT(worst, 1e-6 * largest) << name;
  }
}

TEST(Pattern, bendsAcrossAnEasedSeamWithoutForceOnRigidMotion) {
  const auto springs = flatSheet();
  const auto model = withPatternFabric(*springs, woven(), twoPieces(*springs, 1.0, 1.05));
  const Eigen::VectorXd ones = Eigen::VectorXd::Ones(model->vertexCount());
  EXPECT_LT((model->fabric->bending * ones).cwiseAbs().maxCoeff(), 1e-9 * model->fabric->bending.diagonal().maxCoeff());
  const ClothState state = shaken(*model, 0.01, 7);
  std::vector<Vec3> turned;
  for (const Vec3& position : state.positions) {
    turned.push_back(Eigen::AngleAxisd(1.1, Vec3(1.0, 2.0, -0.5).normalized()) * position + Vec3(0.3, -1.0, 2.0));
  }
  const double energy = elasticEnergy(*model, state.positions);
  EXPECT_NEAR(elasticEnergy(*model, turned), energy, 1e-9 * energy);
}

/// The largest and the smallest length of a spring by its rest length [-].
std::pair<double, double> stretches(const ClothModel& model, const ClothState& state) {
  std::pair<double, double> range(0.0, 1e9);
  for (const Spring& spring : model.springs) {
    const double ratio = (state.positions[spring.b] - state.positions[spring.a]).norm() / spring.restLength;
    range = {std::max(range.first, ratio), std::min(range.second, ratio)};
  }
  return range;
}

TEST(Pattern, isTheSizeToWhichAMeshOfAnotherSizeRelaxes) {
  Material damped = woven();
  damped.stretchDamping = 0.01;
  for (const char* const solver : {"verlet", "auto", "newton"}) {
    for (const double size : {1.0 / 1.1, 1.1}) {
      const auto model = resized(size, damped);
      StepParameters parameters;
      parameters.gravity = 0.0;
      // Damping acts once a step, so it needs steps that are short beside the periods.
      parameters.timeStep = std::min(1e-3, 0.95 * verletStepLimit(*model, parameters));
      ClothState state = stateAtRest(model->restPositions);
      Stepper stepper(solver);
      double largest = 0.0;
      while (state.time < 0.3) {
        static_cast<void>(stepper.step(*model, parameters, {}, state));
        largest = std::max(largest, std::abs(stretches(*model, state).first - 1.0));
      }
      const auto [longest, shortest] = stretches(*model, state);
      EXPECT_LT(longest, 1.005) << solver << size;
      EXPECT_GT(shortest, 0.995) << solver << size;
      EXPECT_LT(largest, 0.25) << solver << size << ": the motion stays bounded";
    }
  }
}

TEST(Pattern, keepsTheStepLimitAnUpperBoundWhereTheMeshIsStretchedOrCompressed) {
  for (const Material& material : {membraneOnly(), woven(), stiffeningFabric()}) {
    const double atRest = resized(1.0, material)->unitFrequency;
    for (const double size : {1.0 / 1.1, 1.1}) {
      // Without damping the motion gathers in some triangles, which are then stretched by more than 10 %.
      for (const auto& [damping, share] : {std::pair(0.0, 0.8), {0.2e-3, 0.95}}) {
        Material damped = material;
        damped.stretchDamping = damping;
        const auto model = resized(size, damped);
        EXPECT_GT(model->unitFrequency, atRest);
        StepParameters parameters;
        parameters.gravity = 0.0;
        parameters.timeStep = share * verletStepLimit(*model, parameters);
        ClothState state = shaken(*model, 1e-4, 3);
        const double start = energyOf(*model, parameters, state).total();
        Stepper stepper("verlet");
        double largest = 0.0;
        for (int i = 0; i < 1000; ++i) {
          static_cast<void>(stepper.step(*model, parameters, {}, state));
          largest = std::max(largest, energyOf(*model, parameters, state).total());
        }
        EXPECT_LT(largest, 1.3 * start) << size << " " << damping;
        EXPECT_TRUE(isFinite(state)) << size << " " << damping;
      }
    }
  }
}

TEST(Pattern, doesNotMakeStretchedTrianglesSlivers) {
  const auto springs = flatSheet();
  const auto model = withPatternFabric(*springs, woven(), twoPieces(*springs, 0.5, 1.0));
  EXPECT_EQ(model->fabric->slivers, 0);
}

TEST(Pattern, isKeptWhenAutoLowersTheStretchStiffness) {
  const auto model = resized(0.9);
  const auto softer = withStretchScales(*model, std::vector{0.25});
  EXPECT_TRUE(softer->hasPattern);
  EXPECT_EQ(softer->fabric->shape.triangles[3].sides, model->fabric->shape.triangles[3].sides);
  EXPECT_NEAR(softer->unitFrequency, 0.5 * model->unitFrequency, 0.1 * model->unitFrequency);
  EXPECT_EQ(softer->springs[5].restLength, model->springs[5].restLength);
}

/// A tube about y, closed by a seam. @return its mesh and its flat pattern, a rectangle of `patternRadius`
std::pair<ClothMesh, std::vector<RestTriangle>> tube(double radius, double patternRadius) {
  constexpr int around = 24;
  constexpr int rows = 9;
  constexpr double cell = 0.03;
  ClothMesh mesh;
  for (int row = 0; row < rows; ++row) {
    for (int k = 0; k < around; ++k) {
      const double angle = 2.0 * std::numbers::pi * k / around;
      mesh.positions.emplace_back(radius * std::sin(angle), cell * row, radius * std::cos(angle));
    }
  }
  std::vector<RestTriangle> pattern;
  const double chord = 2.0 * patternRadius * std::sin(std::numbers::pi / around);
  for (int row = 0; row + 1 < rows; ++row) {
    for (int k = 0; k < around; ++k) {
      const int next = (k + 1) % around;
      const auto corner = [&](int r, int column) { return Vec2(cell * r, -chord * column); };
      mesh.triangles.push_back({row * around + k, row * around + next, (row + 1) * around + next});
      pattern.push_back(restTriangleOf({corner(row, k), corner(row, k + 1), corner(row + 1, k + 1)}));
      mesh.triangles.push_back({row * around + k, (row + 1) * around + next, (row + 1) * around + k});
      pattern.push_back(restTriangleOf({corner(row, k), corner(row + 1, k + 1), corner(row + 1, k)}));
    }
  }
  return {mesh, pattern};
}

TEST(Pattern, sewnToATubeGivesItsRadius) {
  for (const double meshRadius : {0.1, 0.11}) {
    const auto [mesh, pattern] = tube(meshRadius, 0.1);
    Material damped = woven();
    damped.stretchDamping = 0.003;
    const auto model = withPatternFabric(*buildClothModel(mesh, 0.02, MassLumping::Area, {}), damped, pattern);
    EXPECT_NEAR(model->fabric->meshStrain->median, meshRadius / 0.1 - 1.0, 1e-9);
    StepParameters parameters;
    parameters.gravity = 0.0;
    parameters.timeStep = 1.0 / 300.0;
    ClothState state = stateAtRest(model->restPositions);
    Stepper stepper("auto");
    while (state.time < 0.3) {
      static_cast<void>(stepper.step(*model, parameters, {}, state));
    }
    for (const Vec3& position : state.positions) {
      EXPECT_NEAR(std::hypot(position.x(), position.z()), 0.1, 0.001);
    }
  }
}

}  // namespace
}  // namespace drape::sim::fabric
