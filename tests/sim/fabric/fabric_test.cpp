#include "sim/fabric/fabric.hpp"

#include "fabric_cloths.hpp"
#include "sim/model/sim_error.hpp"

#include <gtest/gtest.h>
#include <Eigen/Eigenvalues>

#include <cmath>
#include <limits>
#include <numbers>

namespace drape::sim::fabric {
namespace {

using namespace testing;

/// A triangle that no axis is parallel to.
RestTriangle obliqueTriangle() {
  const std::vector<Vec3> positions{{0.0, 0.0, 0.0}, {0.03, 0.0, 0.01}, {0.005, 0.0, 0.04}};
  const std::vector<Triangle> triangles{{0, 1, 2}};
  const MeshEdges edges = edgesOf(triangles, positions.size());
  return restShapeOf(positions, triangles, edges, warpAlong(Vec3(1.0, 0.0, 0.3), positions, triangles)).triangles[0];
}

/// The triangle with its rest sides times a deformation gradient, somewhere in space.
Corners deformed(const RestTriangle& rest, const Eigen::Matrix<double, 3, 2>& gradient) {
  Corners corners;
  corners.col(0) = Vec3(0.2, -0.1, 0.5);
  corners.col(1) = corners.col(0) + gradient * rest.sides[0];
  corners.col(2) = corners.col(1) + gradient * rest.sides[1];
  return corners;
}

/// A deformation gradient with these strains, turned in space.
Eigen::Matrix<double, 3, 2> gradientOf(double warp, double weft, double shear) {
  Eigen::Matrix<double, 3, 2> flat;
  flat << 1.0 + warp, shear, 0.0, 1.0 + weft, 0.0, 0.0;
  return Eigen::AngleAxisd(0.7, Vec3(1.0, 2.0, -0.5).normalized()).toRotationMatrix() * flat;
}

TEST(MembraneTriangle, measuresGreensStrainForAnyRotation) {
  const RestTriangle rest = obliqueTriangle();
  const MembraneTriangle membrane(rest, woven());
  const Eigen::Matrix<double, 3, 2> gradient = gradientOf(0.1, -0.05, 0.2);
  const Eigen::Matrix2d green = 0.5 * (gradient.transpose() * gradient - Eigen::Matrix2d::Identity());
  const Vec3 strain = membrane.strain(membrane.excess(deformed(rest, gradient)));
  EXPECT_TRUE(strain.isApprox(Vec3(green(0, 0), green(1, 1), 2.0 * green(0, 1)), 1e-12));
}

TEST(MembraneTriangle, hasTheEnergyOfItsStrain) {
  const RestTriangle rest = obliqueTriangle();
  const MembraneTriangle membrane(rest, woven());
  const Corners corners = deformed(rest, gradientOf(0.02, 0.01, 0.03));
  const Vec3 strain = membrane.strain(membrane.excess(corners));
  EXPECT_NEAR(membrane.energy(corners), 0.5 * rest.area * strain.dot(stretchMatrix(woven()) * strain), 1e-15);
}

TEST(MembraneTriangle, stiffensBeyondTheStrainOfTheMaterial) {
  const RestTriangle rest = obliqueTriangle();
  Material material = stiffeningFabric();
  material.poisson = 0.0;
  const MembraneTriangle membrane(rest, material);
  const Corners corners = deformed(rest, gradientOf(0.05, 0.0, 0.0));
  const double strain = 0.05 + 0.5 * 0.05 * 0.05;
  const double beyond = strain - material.stiffeningStrain;
  EXPECT_NEAR(membrane.energy(corners),
              0.5 * rest.area * (material.stretchWarp * strain * strain + material.stiffeningWarp * beyond * beyond),
              1e-15);
}

/// The gradient of a triangle's energy by differences [N].
Eigen::Matrix<double, 9, 1> gradientByDifferences(const MembraneTriangle& membrane, const Corners& corners) {
  constexpr double step = 1e-7;
  Eigen::Matrix<double, 9, 1> gradient;
  for (Eigen::Index i = 0; i < 9; ++i) {
    Corners before = corners;
    Corners after = corners;
    before(i % 3, i / 3) -= step;
    after(i % 3, i / 3) += step;
    gradient[i] = (membrane.energy(after) - membrane.energy(before)) / (2.0 * step);
  }
  return gradient;
}

/// The gradient of a triangle's energy by its tensions [N].
Eigen::Matrix<double, 9, 1> gradientByTensions(const MembraneTriangle& membrane, const Corners& corners) {
  const Vec3 tensions = membrane.tensions(corners);
  Eigen::Matrix<double, 9, 1> gradient = Eigen::Matrix<double, 9, 1>::Zero();
  for (Eigen::Index k = 0; k < 3; ++k) {
    const Vec3 pull = tensions[k] * (corners.col((k + 1) % 3) - corners.col(k));
    gradient.segment<3>(3 * k) -= pull;
    gradient.segment<3>(3 * ((k + 1) % 3)) += pull;
  }
  return gradient;
}

TEST(MembraneTriangle, pullsAgainstTheGradientOfItsEnergy) {
  const RestTriangle rest = obliqueTriangle();
  for (const auto& [name, material] : everyKindOfFabric()) {
    const MembraneTriangle membrane(rest, material);
    for (const double strain : {0.05, -0.04}) {
      const Corners corners = deformed(rest, gradientOf(strain, -0.5 * strain, 0.1));
      const auto gradient = gradientByTensions(membrane, corners);
      EXPECT_TRUE(gradient.isApprox(gradientByDifferences(membrane, corners), 1e-6)) << name << strain;
    }
  }
}

TEST(MembraneTriangle, hasTheSecondDerivativeOfItsEnergy) {
  constexpr double step = 1e-7;
  const RestTriangle rest = obliqueTriangle();
  for (const auto& [name, material] : everyKindOfFabric()) {
    const MembraneTriangle membrane(rest, material);
    const Corners corners = deformed(rest, gradientOf(0.05, -0.03, 0.1));
    const Mat9 exact = membrane.derivative(corners, ForceDerivative::Exact);
    for (Eigen::Index i = 0; i < 9; ++i) {
      Corners before = corners;
      Corners after = corners;
      before(i % 3, i / 3) -= step;
      after(i % 3, i / 3) += step;
      const Eigen::Matrix<double, 9, 1> column =
          (gradientByTensions(membrane, after) - gradientByTensions(membrane, before)) / (2.0 * step);
      EXPECT_LT((exact.col(i) - column).norm(), 1e-5 * exact.norm()) << name << i;
    }
  }
}

TEST(MembraneTriangle, hasASemidefiniteDerivativeInAllVariantsButTheExactOne) {
  const RestTriangle rest = obliqueTriangle();
  const MembraneTriangle membrane(rest, woven());
  for (const double strain : {0.1, -0.1}) {
    const Corners corners = deformed(rest, gradientOf(strain, 0.5 * strain, 0.3));
    for (const ForceDerivative variant : allDerivatives) {
      const Mat9 derivative = membrane.derivative(corners, variant);
      EXPECT_LT((derivative - derivative.transpose()).norm(), 1e-12 * (1.0 + derivative.norm()));
      const double smallest = Eigen::SelfAdjointEigenSolver<Mat9>(derivative).eigenvalues().minCoeff();
      const bool mayBeIndefinite = variant == ForceDerivative::Exact && strain < 0.0;
      EXPECT_EQ(smallest < -1e-9 * (1.0 + derivative.norm()), mayBeIndefinite) << strain << static_cast<int>(variant);
    }
  }
}

TEST(MembraneTriangle, isStabilisedExactlyUnderTension) {
  const RestTriangle rest = obliqueTriangle();
  const MembraneTriangle membrane(rest, woven());
  const Corners tense = deformed(rest, gradientOf(0.1, 0.08, 0.02));
  EXPECT_TRUE(membrane.derivative(tense, ForceDerivative::Stabilised)
                  .isApprox(membrane.derivative(tense, ForceDerivative::Exact), 1e-12));
}

TEST(MembraneTriangle, hasNoStiffnessIfItIsDegenerate) {
  const std::vector<Vec3> positions{{0.0, 0.0, 0.0}, {0.1, 0.0, 0.0}, {0.2, 0.0, 0.0}};
  const std::vector<Triangle> triangles{{0, 1, 2}};
  const RestShape shape =
      restShapeOf(positions, triangles, edgesOf(triangles, 3), warpAlong(Vec3::UnitX(), positions, triangles));
  const MembraneTriangle membrane(shape.triangles[0], woven());
  EXPECT_EQ(membrane.tensions(Corners(Corners::Random())), Vec3(Vec3::Zero()));
  EXPECT_TRUE(shape.hinges.empty());
}

/// The forces on all vertices [N].
std::vector<Vec3> forcesOn(const ClothModel& model, const std::vector<Vec3>& positions) {
  std::vector<Vec3> forces;
  for (std::size_t v = 0; v < positions.size(); ++v) {
    forces.push_back(elasticForceOn(model, positions, v));
  }
  return forces;
}

TEST(Fabric, hasForcesThatAreMinusTheGradientOfItsEnergy) {
  constexpr double step = 1e-6;
  for (const auto& [name, material] : everyKindOfFabric()) {
    const auto model = asFabric(*irregularSheet(5), material);
    std::vector<Vec3> positions = shaken(*model, 0.01, 3).positions;
    const std::vector<Vec3> forces = forcesOn(*model, positions);
    double size = 0.0;
    for (const Vec3& force : forces) {
      size = std::max(size, force.norm());
    }
    for (std::size_t v = 0; v < positions.size(); ++v) {
      for (Eigen::Index i = 0; i < 3; ++i) {
        const double at = positions[v][i];
        positions[v][i] = at + step;
        const double after = elasticEnergy(*model, positions);
        positions[v][i] = at - step;
        const double before = elasticEnergy(*model, positions);
        positions[v][i] = at;
        EXPECT_NEAR(forces[v][i], -(after - before) / (2.0 * step), 1e-6 * size) << name;
      }
    }
  }
}

TEST(Fabric, neitherPullsNorTurnsItselfAsAWhole) {
  for (const auto& [name, material] : everyKindOfFabric()) {
    const auto model = asFabric(*irregularSheet(7), material);
    const std::vector<Vec3> positions = shaken(*model, 0.01, 3).positions;
    Vec3 force = Vec3::Zero();
    Vec3 moment = Vec3::Zero();
    double size = 0.0;
    const std::vector<Vec3> forces = forcesOn(*model, positions);
    for (std::size_t v = 0; v < positions.size(); ++v) {
      force += forces[v];
      moment += positions[v].cross(forces[v]);
      size += forces[v].norm();
    }
    EXPECT_LT(force.norm(), 1e-12 * size) << name;
    EXPECT_LT(moment.norm(), 1e-12 * size) << name;
  }
}

TEST(Fabric, hasTheSameEnergyAfterARigidMotion) {
  const Eigen::AngleAxisd turn(1.1, Vec3(0.3, -1.0, 0.7).normalized());
  for (const auto& [name, material] : everyKindOfFabric()) {
    const auto model = asFabric(*irregularSheet(7), material);
    std::vector<Vec3> positions = shaken(*model, 0.01, 3).positions;
    const double before = elasticEnergy(*model, positions);
    for (Vec3& position : positions) {
      position = turn * position + Vec3(3.0, -2.0, 1.0);
    }
    EXPECT_NEAR(elasticEnergy(*model, positions), before, 1e-9 * before) << name;
  }
}

TEST(Fabric, isEquallyStiffInAllDirectionsIfItIsIsotropic) {
  Material material;
  material.stretchWarp = material.stretchWeft = 100.0;
  material.poisson = 0.3;
  material.shear = 0.5 * 100.0 * (1.0 - 0.3);
  material.bendWarp = material.bendWeft = material.bendBias = 1e-3;
  const auto springs = irregularSheet(7);
  const std::vector<Vec3> positions = shaken(*springs, 0.01, 3).positions;
  std::vector<double> energies;
  for (const Vec3& direction : {Vec3(1.0, 0.0, 0.0), Vec3(1.0, 0.0, 1.0), Vec3(0.2, 0.0, -1.0)}) {
    const auto warp = warpAlong(direction, springs->restPositions, springs->triangles);
    energies.push_back(elasticEnergy(*withFabric(*springs, material, warp), positions));
  }
  EXPECT_NEAR(energies[1], energies[0], 1e-12 * energies[0]);
  EXPECT_NEAR(energies[2], energies[0], 1e-12 * energies[0]);
}

/// The sheet of 1 m x 1 m bent to a part of a cylinder about an axis in its plane. @param angle of the axis to z [rad]
std::vector<Vec3> rolledAtAnAngle(const std::vector<Vec3>& flat, double radius, double angle) {
  std::vector<Vec3> positions;
  const Vec3 axis(std::sin(angle), 0.0, std::cos(angle));
  const Vec3 across(std::cos(angle), 0.0, -std::sin(angle));
  for (const Vec3& position : flat) {
    const double s = position.dot(across) / radius;
    positions.push_back(position.dot(axis) * axis + radius * std::sin(s) * across +
                        Vec3(0.0, radius * (1.0 - std::cos(s)), 0.0));
  }
  return positions;
}

/// In the inside of the sheet; hinges at the border have no second triangle.
TEST(Fabric, hasTheBendingEnergyOfACylinder) {
  constexpr int n = 41;
  constexpr double radius = 2.0;
  Material material;
  material.stretchWarp = material.stretchWeft = 1e-9;
  material.shear = 1e-9;
  material.bendWarp = 4e-4;
  material.bendWeft = 1e-4;
  material.bendBias = 2e-4;
  const auto springs = buildClothModel(sheet(n), 0.1, MassLumping::Area, {});
  const auto model =
      withFabric(*springs, material, warpAlong(Vec3::UnitX(), springs->restPositions, springs->triangles));
  const std::vector<std::pair<double, double>> stiffnessAtAngle{{0.0, material.bendWarp},
                                                                {0.5 * std::numbers::pi, material.bendWeft},
                                                                {0.25 * std::numbers::pi, material.bendBias}};
  for (const auto& [angle, stiffness] : stiffnessAtAngle) {
    const double expected = 0.5 * stiffness / (radius * radius);  // for the area of 1 m^2
    const double energy = elasticEnergy(*model, rolledAtAnAngle(springs->restPositions, radius, angle));
    EXPECT_NEAR(energy, expected, 0.06 * expected) << angle;
  }
}

TEST(Fabric, isFlatAtRestWhateverTheShapeOfTheMesh) {
  const auto springs = buildClothModel(sheet(9), 0.1, MassLumping::Area, {});
  ClothMesh curved = sheet(9);
  curved.positions = rolledAtAnAngle(curved.positions, 0.5, 0.0);
  const auto tube = asFabric(*buildClothModel(curved, 0.1, MassLumping::Area, {}), woven());
  const double unrolling = elasticEnergy(*tube, tube->restPositions);
  EXPECT_GT(unrolling, 1e-6);
  const auto flat = asFabric(*springs, woven());
  EXPECT_NEAR(elasticEnergy(*flat, flat->restPositions), 0.0, 1e-9 * unrolling);
}

TEST(Fabric, countsSliversAndKeepsThemFromBeingStiff) {
  ClothMesh mesh = sheet(9);
  const double before = withFabric(*buildClothModel(mesh, 0.1, MassLumping::Uniform, {}), woven(),
                                   warpAlong(Vec3::UnitX(), mesh.positions, mesh.triangles))
                            ->unitFrequency;
  mesh.positions[40].x() += 0.1249;  // almost on its neighbour
  const auto model = withFabric(*buildClothModel(mesh, 0.1, MassLumping::Uniform, {}), woven(),
                                warpAlong(Vec3::UnitX(), mesh.positions, mesh.triangles));
  EXPECT_EQ(model->fabric->slivers, 2);
  EXPECT_LT(model->unitFrequency, 6.0 * before);
}

TEST(Fabric, hasAnotherFingerprintForAnotherModulusOrDirectionOfWarp) {
  const auto springs = pinnedSheet(5);
  const auto fingerprintOf = [&](const Material& material, const Vec3& warp) {
    return withFabric(*springs, material, warpAlong(warp, springs->restPositions, springs->triangles))
        ->fabric->fingerprint;
  };
  const std::uint64_t own = fingerprintOf(woven(), Vec3::UnitX());
  EXPECT_EQ(fingerprintOf(woven(), Vec3::UnitX()), own);
  EXPECT_NE(fingerprintOf(woven(), Vec3::UnitZ()), own);
  for (double Material::*const modulus :
       {&Material::stretchWarp, &Material::stretchWeft, &Material::shear, &Material::poisson,
        &Material::stiffeningStrain, &Material::stiffeningWarp, &Material::stiffeningWeft, &Material::bendWarp,
        &Material::bendWeft, &Material::bendBias}) {
    Material changed = woven();
    changed.*modulus += 1e-6;
    EXPECT_NE(fingerprintOf(changed, Vec3::UnitX()), own);
  }
}

TEST(Fabric, refusesMaterialsThatAreNotStable) {
  const auto springs = irregularSheet(4);
  const auto warp = warpAlong(Vec3::UnitX(), springs->restPositions, springs->triangles);
  const auto faultOf = [&](const Material& material) {
    try {
      static_cast<void>(withFabric(*springs, material, warp));
    } catch (const ClothModelError& error) {
      return error.fault() == ClothModelError::Fault::Material;
    }
    return false;
  };
  EXPECT_FALSE(faultOf(woven()));
  for (double Material::*member : {&Material::stretchWarp, &Material::stretchWeft, &Material::shear,
                                   &Material::stiffeningWarp, &Material::bendWarp, &Material::bendBias}) {
    for (const double value : {-1.0, std::numeric_limits<double>::quiet_NaN()}) {
      Material material = woven();
      material.*member = value;
      EXPECT_TRUE(faultOf(material)) << value;
    }
  }
  Material material = woven();
  material.poisson = 1.0;
  EXPECT_TRUE(faultOf(material));
  EXPECT_THROW(static_cast<void>(withFabric(*springs, woven(), {})), ClothModelError);
}

TEST(Warp, liesInThePlaneOfEachTriangleAndFallsBackToAnAxis) {
  const std::vector<Vec3> positions{{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 0.0, 1.0}, {1.0, 1.0, 0.0}};
  const std::vector<Triangle> triangles{{0, 2, 1}, {0, 1, 3}, {0, 0, 1}};
  const std::vector<Vec3> warp = warpAlong(Vec3::UnitY(), positions, triangles);
  EXPECT_TRUE(warp[0].isApprox(Vec3::UnitX()));
  EXPECT_TRUE(warp[1].isApprox(Vec3::UnitY()));
  EXPECT_TRUE(warp[2].isZero(0.0));
}

/// A vertex that lies almost on the line between two of its neighbours makes flat triangles. Contact pulls it out by a
/// part of an edge, which stretches them a thousand times.
TEST(Fabric, flatTrianglesStaySlowWhileTheyArePulledOut) {
  constexpr int n = 17;
  constexpr double edge = 1.0 / (n - 1);
  ClothMesh mesh = sheet(n);
  const int pulled = (n / 2) * n + n / 2;
  mesh.positions[pulled].z() -= (1.0 - 1e-4) * edge;  // almost onto the row before
  for (const Material& material : {woven(), stiffeningFabric()}) {
    const auto model = asFabric(*buildClothModel(mesh, 0.1, MassLumping::Area, {}), material);
    std::vector<Vec3> positions = mesh.positions;
    positions[pulled].y() += 0.1 * edge;
    const Mat3 stiffness = stiffnessAt(*model, positions, pulled, ForceDerivative::Stabilised);
    const double largest = Eigen::SelfAdjointEigenSolver<Mat3>(stiffness).eigenvalues().maxCoeff();
    double highest = 0.0;  // frequency squared of the cloth at rest [1/s^2]
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
      highest = std::max(highest, 2.0 * model->fabricStiffness[v] / model->vertexMass[v]);
    }
    EXPECT_LT(largest / model->vertexMass[pulled], maxMembraneRatio * highest);
  }
}

}  // namespace
}  // namespace drape::sim::fabric
