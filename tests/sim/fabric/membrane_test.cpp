#include "sim/fabric/membrane.hpp"

#include "fabric_cloths.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <numbers>

namespace drape::sim::fabric {
namespace {

using namespace testing;
using Vec9 = Eigen::Matrix<double, 9, 1>;

const std::vector<Vec3> restCorners = {{0.0, 0.0, 0.0}, {0.3, 0.0, 0.05}, {0.1, 0.0, 0.25}};
const std::vector<Triangle> oneTriangle = {{0, 1, 2}};

RestTriangle restTriangle(const Vec3& warp) {
  return restShapeOf(restCorners, oneTriangle, edgesOf(oneTriangle, 3), warpAlong(warp, restCorners, oneTriangle))
      .triangles[0];
}

MembraneTriangle membraneOf(const Material& material, const Vec3& warp = {1.0, 0.3, 0.4}) {
  return {restTriangle(warp), material};
}

Corners atRestPosition() {
  return cornersOf(oneTriangle[0], restCorners);
}

/// The triangle, deformed at random by up to `size` [m].
Corners deformed(double size, unsigned seed) {
  RandomVectors random(seed);
  Corners corners = atRestPosition();
  for (Eigen::Index k = 0; k < 3; ++k) {
    corners.col(k) += random.next(size);
  }
  return corners;
}

/// The triangle in its plane, stretched by these factors along x and z.
Corners stretched(double alongX, double alongZ) {
  return Vec3(alongX, 1.0, alongZ).asDiagonal() * atRestPosition();
}

/// The triangle's forces on its corners [N], in order.
Vec9 forcesOf(const MembraneTriangle& membrane, const Corners& corners) {
  const Vec3 tensions = membrane.tensions(corners);
  Corners forces = Corners::Zero();
  for (Eigen::Index k = 0; k < 3; ++k) {
    const Eigen::Index next = (k + 1) % 3;
    const Vec3 pull = tensions[k] * (corners.col(next) - corners.col(k));
    forces.col(k) += pull;
    forces.col(next) -= pull;
  }
  return Eigen::Map<const Vec9>(forces.data());
}

/// The corners with one of the nine coordinates moved.
Corners nudged(Corners corners, Eigen::Index coordinate, double distance) {
  corners.data()[coordinate] += distance;
  return corners;
}

double minEigenvalue(const Mat9& matrix) {
  return matrix.selfadjointView<Eigen::Lower>().eigenvalues().minCoeff();
}

TEST(FabricMembrane, forcesAreMinusTheGradientOfTheEnergy) {
  constexpr double h = 1e-6;  // [m]
  for (const auto& [name, material] : everyKindOfFabric()) {
    const MembraneTriangle membrane = membraneOf(material);
    for (unsigned seed = 0; seed < 5; ++seed) {
      const Corners corners = deformed(0.05, seed);
      const Vec9 forces = forcesOf(membrane, corners);
      for (Eigen::Index i = 0; i < 9; ++i) {
        const double slope =
            (membrane.energy(nudged(corners, i, h)) - membrane.energy(nudged(corners, i, -h))) / (2.0 * h);
        EXPECT_NEAR(-slope, forces[i], 1e-7 * forces.norm()) << name << " coordinate " << i;
      }
    }
  }
}

TEST(FabricMembrane, exactDerivativeIsMinusThatOfTheForces) {
  constexpr double h = 1e-6;  // [m]
  for (const auto& [name, material] : everyKindOfFabric()) {
    const MembraneTriangle membrane = membraneOf(material);
    for (unsigned seed = 0; seed < 5; ++seed) {
      const Corners corners = deformed(0.05, seed);
      const Mat9 derivative = membrane.derivative(corners, ForceDerivative::Exact);
      EXPECT_LT((derivative - derivative.transpose()).norm(), 1e-12 * derivative.norm());
      for (Eigen::Index i = 0; i < 9; ++i) {
        const Vec9 slope =
            (forcesOf(membrane, nudged(corners, i, h)) - forcesOf(membrane, nudged(corners, i, -h))) / (2.0 * h);
        EXPECT_LT((slope + derivative.col(i)).norm(), 1e-6 * derivative.norm()) << name << " coordinate " << i;
      }
    }
  }
}

TEST(FabricMembrane, everyOtherDerivativeIsSemidefinite) {
  for (const ForceDerivative variant : allDerivatives) {
    for (unsigned seed = 0; seed < 20 && variant != ForceDerivative::Exact; ++seed) {
      const Mat9 derivative = membraneOf(woven()).derivative(deformed(0.2, seed), variant);
      EXPECT_GT(minEigenvalue(derivative), -1e-12 * derivative.norm()) << "seed " << seed;
    }
  }
}

TEST(FabricMembrane, exactDerivativeIsIndefiniteUnderCompression) {
  EXPECT_LT(minEigenvalue(membraneOf(woven()).derivative(stretched(0.9, 0.9), ForceDerivative::Exact)), -1.0);
}

TEST(FabricMembrane, stabilisedDerivativeIsExactInTension) {
  const MembraneTriangle membrane = membraneOf(woven());
  const Corners corners = stretched(1.05, 1.03);
  const Mat9 exact = membrane.derivative(corners, ForceDerivative::Exact);
  for (const ForceDerivative variant : {ForceDerivative::Stabilised, ForceDerivative::TensionOnly}) {
    EXPECT_LT((membrane.derivative(corners, variant) - exact).norm(), 1e-12 * exact.norm());
  }
  EXPECT_GT((membrane.derivative(corners, ForceDerivative::Axial) - exact).norm(), 1e-3 * exact.norm());
}

TEST(FabricMembrane, stabilisedDerivativeOfACompressedTriangleIsTheElasticPart) {
  const MembraneTriangle membrane = membraneOf(woven());
  const Corners corners = stretched(0.95, 0.97);
  const Mat9 elastic = membrane.derivative(corners, ForceDerivative::Axial);
  EXPECT_LT((membrane.derivative(corners, ForceDerivative::Stabilised) - elastic).norm(), 1e-12 * elastic.norm());
  EXPECT_TRUE(membrane.derivative(corners, ForceDerivative::TensionOnly).isZero(0.0));
}

TEST(FabricMembrane, rigidMotionGivesNeitherForceNorEnergy) {
  const Mat3 rotation = Eigen::AngleAxisd(1.1, Vec3(1.0, 2.0, -0.5).normalized()).toRotationMatrix();
  const Corners corners = (rotation * atRestPosition()).colwise() + Vec3(3.0, -2.0, 5.0);
  for (const auto& [name, material] : everyKindOfFabric()) {
    const MembraneTriangle membrane = membraneOf(material);
    EXPECT_LT(forcesOf(membrane, corners).norm(), 1e-11) << name;
    EXPECT_LT(membrane.energy(corners), 1e-24) << name;
  }
}

TEST(FabricMembrane, forcesHaveNeitherResultantNorMoment) {
  for (unsigned seed = 0; seed < 10; ++seed) {
    const Corners corners = deformed(0.1, seed);
    const Vec9 forces = forcesOf(membraneOf(stiffeningFabric()), corners);
    Vec3 sum = Vec3::Zero();
    Vec3 moment = Vec3::Zero();
    for (Eigen::Index k = 0; k < 3; ++k) {
      sum += forces.segment<3>(3 * k);
      moment += corners.col(k).cross(Vec3(forces.segment<3>(3 * k)));
    }
    EXPECT_LT(sum.norm(), 1e-13 * forces.norm());
    EXPECT_LT(moment.norm(), 1e-13 * forces.norm());
  }
}

TEST(FabricMembrane, uniformStrainIsReproducedOnEveryMesh) {
  // The patch test: under an affine map no vertex inside the sheet has a force, and the energy is the continuum's.
  Mat3 map;
  map << 1.03, 0.2, 0.01, 0.0, 1.0, 0.3, -0.02, 0.0, 0.98;
  ClothMesh flat = sheet(7);
  RandomVectors random(5);
  for (Vec3& position : flat.positions) {
    const Vec3 change = random.next(0.04);
    position += Vec3(change.x(), 0.0, change.z());
  }
  const auto irregular = fabric::withFabric(*buildClothModel(flat, 0.1, MassLumping::Area, {}), membraneOnly(),
                                            warpAlong(Vec3::UnitX(), flat.positions, flat.triangles));
  std::vector<Vec3> positions;
  for (const Vec3& position : irregular->restPositions) {
    positions.emplace_back(map * position);
  }
  const MeshEdges edges = edgesOf(flat.triangles, flat.positions.size());
  std::vector<bool> onBoundary(positions.size(), false);
  for (const MeshEdge& edge : boundaryEdges(edges)) {
    onBoundary[edge.a] = onBoundary[edge.b] = true;
  }
  int inside = 0;
  for (std::size_t v = 0; v < positions.size(); ++v) {
    if (!onBoundary[v]) {
      EXPECT_LT(elasticForceOn(*irregular, positions, v).norm(), 1e-12);
      ++inside;
    }
  }
  EXPECT_EQ(inside, 25);
  // Warp is x; the weft of triangles that face +y is -z.
  const Vec3 alongX = map.col(0);
  const Vec3 alongZ = -map.col(2);
  const Vec3 strain(0.5 * (alongX.squaredNorm() - 1.0), 0.5 * (alongZ.squaredNorm() - 1.0), alongX.dot(alongZ));
  const double density = 0.5 * strain.dot(stretchMatrix(membraneOnly()) * strain);
  EXPECT_NEAR(elasticEnergy(*irregular, positions), irregular->restArea() * density, 1e-11 * density);
}

TEST(FabricMembrane, isotropicStiffnessDoesNotDependOnTheDirectionOfWarp) {
  Material material;
  material.stretchWarp = material.stretchWeft = 400.0;
  material.poisson = 0.3;
  material.shear = 0.5 * 400.0 * (1.0 - 0.3);
  const Corners corners = deformed(0.05, 3);
  const MembraneTriangle first = membraneOf(material, Vec3::UnitX());
  const Vec9 forces = forcesOf(first, corners);
  for (double angle = 0.1; angle < 3.0; angle += 0.3) {
    const MembraneTriangle turned = membraneOf(material, {std::cos(angle), 0.0, std::sin(angle)});
    EXPECT_NEAR(turned.energy(corners), first.energy(corners), 1e-12 * first.energy(corners));
    EXPECT_LT((forcesOf(turned, corners) - forces).norm(), 1e-12 * forces.norm());
  }
}

TEST(FabricMembrane, orthotropicStiffnessTurnsWithWarp) {
  const Corners corners = stretched(1.05, 1.0);
  const RestTriangle rest = restTriangle(Vec3::UnitX());
  const double strain = 0.5 * (1.05 * 1.05 - 1.0);
  EXPECT_NEAR(membraneOf(woven(), Vec3::UnitX()).energy(corners), 0.5 * 300.0 * strain * strain * rest.area, 1e-12);
  EXPECT_NEAR(membraneOf(woven(), Vec3::UnitZ()).energy(corners), 0.5 * 500.0 * strain * strain * rest.area, 1e-12);
}

TEST(FabricMembrane, stiffensBeyondItsStrain) {
  const Material material = stiffeningFabric();
  const double area = restTriangle(Vec3::UnitX()).area;
  const auto energyAt = [&](double strain) {
    return membraneOf(material, Vec3::UnitX()).energy(stretched(std::sqrt(1.0 + 2.0 * strain), 1.0)) / area;
  };
  const double below = 0.5 * material.stiffeningStrain;
  const double beyond = 0.05;
  const double excess = beyond - material.stiffeningStrain;
  EXPECT_NEAR(energyAt(below), 150.0 * below * below, 1e-12);
  EXPECT_NEAR(energyAt(beyond), 150.0 * beyond * beyond + 350.0 * excess * excess, 1e-12);
}

TEST(FabricMembrane, aDegenerateTriangleHasNoForce) {
  const std::vector<Vec3> line = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  const RestTriangle rest =
      restShapeOf(line, oneTriangle, edgesOf(oneTriangle, 3), warpAlong(Vec3::UnitX(), line, oneTriangle)).triangles[0];
  const MembraneTriangle membrane(rest, woven());
  EXPECT_EQ(membrane.energy(deformed(0.1, 1)), 0.0);
  EXPECT_TRUE(forcesOf(membrane, deformed(0.1, 1)).isZero(0.0));
  EXPECT_TRUE(membrane.derivative(deformed(0.1, 1), ForceDerivative::Exact).isZero(0.0));
}

TEST(FabricMembrane, aTriangleThatCollapsedToAPointHasAFiniteEnergyAndNoForce) {
  const MembraneTriangle membrane = membraneOf(woven());
  const Corners point = Corners::Zero();
  EXPECT_GT(membrane.energy(point), 0.0);
  EXPECT_TRUE(std::isfinite(membrane.energy(point)));
  EXPECT_TRUE(forcesOf(membrane, point).isZero(0.0));
}

}  // namespace
}  // namespace drape::sim::fabric
