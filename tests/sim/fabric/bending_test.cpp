#include "sim/fabric/bending.hpp"

#include "fabric_cloths.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>

namespace drape::sim::fabric {
namespace {

using namespace testing;

using Positions = std::vector<Vec3>;

VertexMatrix matrixOf(const ClothMesh& mesh, const Material& material, const Vec3& warp = Vec3::UnitX()) {
  const RestShape shape = restShapeOf(mesh.positions, mesh.triangles, edgesOf(mesh.triangles, mesh.positions.size()),
                                      warpAlong(warp, mesh.positions, mesh.triangles));
  return bendingMatrix(shape, material, mesh.positions.size());
}

double energyOf(const VertexMatrix& matrix, const Positions& positions) {
  double energy = 0.0;
  for (int row = 0; row < matrix.outerSize(); ++row) {
    for (VertexMatrix::InnerIterator entry(matrix, row); entry; ++entry) {
      energy += 0.5 * entry.value() * positions[row].dot(positions[entry.col()]);
    }
  }
  return energy;
}

/// A sheet of 1 m x 1 m with displaced vertices inside its plane.
ClothMesh unevenSheet(int n) {
  ClothMesh mesh = sheet(n);
  RandomVectors random(7);
  for (Vec3& position : mesh.positions) {
    const Vec3 change = random.next(0.25 / (n - 1));
    position += Vec3(change.x(), 0.0, change.z());
  }
  return mesh;
}

TEST(FabricBending, matrixIsSymmetricAndSemidefiniteWithRowsThatSumToZero) {
  const Eigen::MatrixXd matrix = matrixOf(unevenSheet(7), woven()).toDense();
  const double size = matrix.cwiseAbs().maxCoeff();
  EXPECT_LT((matrix - matrix.transpose()).cwiseAbs().maxCoeff(), 1e-12 * size);
  EXPECT_LT(matrix.rowwise().sum().cwiseAbs().maxCoeff(), 1e-10 * size);
  EXPECT_GT(matrix.selfadjointView<Eigen::Lower>().eigenvalues().minCoeff(), -1e-10 * size);
}

TEST(FabricBending, flatClothHasNoForceEvenIfStretched) {
  const ClothMesh mesh = unevenSheet(6);
  const auto model = asFabric(*buildClothModel(mesh, 0.1, MassLumping::Area, {}), woven());
  Mat3 map;
  map << 1.2, 0.0, 0.3, 0.1, 0.0, -0.4, -0.2, 0.0, 0.9;
  Positions positions;
  for (const Vec3& position : mesh.positions) {
    positions.emplace_back(map * position + Vec3(1.0, 2.0, 3.0));
  }
  const VertexMatrix& matrix = model->fabric->bending;
  EXPECT_LT(energyOf(matrix, positions), 1e-13);
  const auto membrane = asFabric(*model, membraneOnly());
  for (std::size_t v = 0; v < positions.size(); ++v) {
    EXPECT_LT((elasticForceOn(*model, positions, v) - elasticForceOn(*membrane, positions, v)).norm(), 1e-11);
  }
}

TEST(FabricBending, errorOfTheCylinderFallsWithTheCells) {
  const Material material = woven();
  double former = 1.0;
  for (const int n : {11, 21, 41}) {
    const ClothMesh mesh = sheet(n);
    const double energy = energyOf(matrixOf(mesh, material), rolled(mesh.positions, 1.0));
    const double error = std::abs(energy / (0.5 * material.bendWarp) - 1.0);
    EXPECT_LT(error, 0.6 * former) << n;
    former = error;
  }
}

TEST(FabricBending, energyOfASaddleIsThatOfTheTwistStiffness) {
  constexpr double twist = 0.05;  // [1/m]; small, so that the membrane's metric is nearly that of the plane
  const Material material = woven();
  const ClothMesh mesh = sheet(61);
  Positions positions = mesh.positions;
  for (Vec3& position : positions) {
    position.y() = twist * position.x() * position.z();
  }
  const double exact = 0.5 * 4.0 * bendMatrix(material)(2, 2) * twist * twist;
  EXPECT_NEAR(energyOf(matrixOf(mesh, material), positions), exact, 0.05 * exact);
}

TEST(FabricBending, isotropicStiffnessDoesNotDependOnTheDirectionOfWarp) {
  Material material;
  material.bendWarp = material.bendWeft = material.bendBias = 3e-5;
  const ClothMesh mesh = unevenSheet(6);
  const Eigen::MatrixXd first = matrixOf(mesh, material).toDense();
  for (double angle = 0.2; angle < 3.0; angle += 0.4) {
    const Eigen::MatrixXd turned = matrixOf(mesh, material, {std::cos(angle), 0.0, std::sin(angle)}).toDense();
    EXPECT_LT((turned - first).norm(), 1e-12 * first.norm()) << angle;
  }
}

TEST(FabricBending, degenerateTrianglesAndSliversGiveFiniteForces) {
  ClothMesh mesh = sheet(3);
  mesh.triangles.push_back({0, 1, 2});  // a line
  mesh.triangles.push_back({4, 4, 5});
  const Eigen::MatrixXd matrix = matrixOf(mesh, woven()).toDense();
  EXPECT_TRUE(matrix.allFinite());
  ClothMesh narrow = sheet(3);
  narrow.positions[4] = {1e-7, 0.0, 0.5};  // next to vertex 3
  const Eigen::MatrixXd clamped = matrixOf(narrow, woven()).toDense();
  EXPECT_TRUE(clamped.allFinite());
  EXPECT_LT(clamped.cwiseAbs().maxCoeff(), 1e3 * matrixOf(sheet(3), woven()).toDense().cwiseAbs().maxCoeff());
}

}  // namespace
}  // namespace drape::sim::fabric
