#include "sim/fabric/membrane.hpp"

#include "fabric_cloths.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace drape::sim::fabric {
namespace {

using namespace testing;

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

TEST(FabricMembrane, onlyTheAxialDerivativeLeavesOutTheTension) {
  const MembraneTriangle membrane = membraneOf(woven());
  const Corners corners = stretched(1.05, 1.03);
  const Mat9 exact = membrane.derivative(corners, ForceDerivative::Exact);
  EXPECT_LT((membrane.derivative(corners, ForceDerivative::TensionOnly) - exact).norm(), 1e-12 * exact.norm());
  EXPECT_GT((membrane.derivative(corners, ForceDerivative::Axial) - exact).norm(), 1e-3 * exact.norm());
}

TEST(FabricMembrane, stabilisedDerivativeOfACompressedTriangleIsTheElasticPart) {
  const MembraneTriangle membrane = membraneOf(woven());
  const Corners corners = stretched(0.95, 0.97);
  const Mat9 elastic = membrane.derivative(corners, ForceDerivative::Axial);
  EXPECT_LT((membrane.derivative(corners, ForceDerivative::Stabilised) - elastic).norm(), 1e-12 * elastic.norm());
  EXPECT_TRUE(membrane.derivative(corners, ForceDerivative::TensionOnly).isZero(0.0));
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

TEST(FabricMembrane, orthotropicStiffnessTurnsWithWarp) {
  const Corners corners = stretched(1.05, 1.0);
  const RestTriangle rest = restTriangle(Vec3::UnitX());
  const double strain = 0.5 * (1.05 * 1.05 - 1.0);
  EXPECT_NEAR(membraneOf(woven(), Vec3::UnitX()).energy(corners), 0.5 * 300.0 * strain * strain * rest.area, 1e-12);
  EXPECT_NEAR(membraneOf(woven(), Vec3::UnitZ()).energy(corners), 0.5 * 500.0 * strain * strain * rest.area, 1e-12);
}

TEST(FabricMembrane, aDegenerateTriangleHasNoEnergyAndNoDerivative) {
  const std::vector<Vec3> line = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  const RestTriangle rest =
      restShapeOf(line, oneTriangle, edgesOf(oneTriangle, 3), warpAlong(Vec3::UnitX(), line, oneTriangle)).triangles[0];
  const MembraneTriangle membrane(rest, woven());
  EXPECT_EQ(membrane.energy(deformed(0.1, 1)), 0.0);
  EXPECT_TRUE(membrane.derivative(deformed(0.1, 1), ForceDerivative::Exact).isZero(0.0));
}

TEST(FabricMembrane, aTriangleThatCollapsedToAPointHasAFiniteEnergyAndFiniteTensions) {
  const MembraneTriangle membrane = membraneOf(woven());
  const Corners point = Corners::Zero();
  EXPECT_GT(membrane.energy(point), 0.0);
  EXPECT_TRUE(std::isfinite(membrane.energy(point)));
  EXPECT_TRUE(membrane.tensions(point).allFinite()) << "the sides have no length, so they do not pull";
}

}  // namespace
}  // namespace drape::sim::fabric
