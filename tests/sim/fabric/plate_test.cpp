// The bending matrix as that of a thin plate with small deflections: one number a vertex instead of three.

#include "sim/fabric/bending.hpp"

#include <gtest/gtest.h>
#include <Eigen/Eigenvalues>
#include <Eigen/SparseCholesky>

#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <string>
#include <vector>

namespace drape::sim::fabric {
namespace {

enum class MeshKind { Grid, Alternating, Irregular };

struct Plate {
  std::vector<Vec3> positions;
  std::vector<Triangle> triangles;
};

/// A square of 1 m x 1 m in the plane of x and y with n x n cells. Irregular: vertices are moved by up to
/// `moved` cells, those on the boundary along it, and diagonals are chosen by chance.
Plate plate(MeshKind kind, int n, unsigned seed, double moved = 0.3) {
  std::mt19937 random(seed);
  const auto chance = [&] { return static_cast<double>(random()) / 4294967296.0; };
  Plate plate;
  for (int j = 0; j <= n; ++j) {
    for (int i = 0; i <= n; ++i) {
      const double dx = kind == MeshKind::Irregular && i > 0 && i < n ? moved * (2.0 * chance() - 1.0) : 0.0;
      const double dy = kind == MeshKind::Irregular && j > 0 && j < n ? moved * (2.0 * chance() - 1.0) : 0.0;
      plate.positions.emplace_back((i + dx) / n, (j + dy) / n, 0.0);
    }
  }
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      const int a = j * (n + 1) + i;
      const int b = a + 1;
      const int c = a + n + 2;
      const int d = a + n + 1;
      const bool rising = kind == MeshKind::Irregular ? chance() < 0.5 : kind == MeshKind::Grid || (i + j) % 2 == 0;
      plate.triangles.push_back(rising ? Triangle{a, b, c} : Triangle{a, b, d});
      plate.triangles.push_back(rising ? Triangle{a, c, d} : Triangle{b, c, d});
    }
  }
  return plate;
}

/// An anisotropic fabric with D = diag(4, 1, 1) N m.
Material anisotropic() {
  Material material;
  material.bendWarp = 4.0;
  material.bendWeft = 1.0;
  material.bendBias = 2.25;
  return material;
}

VertexMatrix matrixOf(const Plate& plate, const Material& material) {
  const MeshEdges edges = edgesOf(plate.triangles, plate.positions.size());
  const auto warp = warpAlong(Vec3::UnitX(), plate.positions, plate.triangles);
  return bendingMatrix(restShapeOf(plate.positions, plate.triangles, edges, warp), material, plate.positions.size());
}

bool isOn(double value) {
  return value < 1e-9 || value > 1.0 - 1e-9;
}

/// The indices of the free vertices; -1 where `held`.
std::vector<int> numbered(const Plate& plate, const std::function<bool(const Vec3&)>& held, int& count) {
  std::vector<int> index;
  count = 0;
  for (const Vec3& position : plate.positions) {
    index.push_back(held(position) ? -1 : count++);
  }
  return index;
}

Eigen::SparseMatrix<double> freePart(const VertexMatrix& matrix, const std::vector<int>& index, int count) {
  std::vector<Eigen::Triplet<double>> entries;
  for (int row = 0; row < matrix.outerSize(); ++row) {
    for (VertexMatrix::InnerIterator entry(matrix, row); entry; ++entry) {
      if (index[row] >= 0 && index[entry.col()] >= 0) {
        entries.emplace_back(index[row], index[entry.col()], entry.value());
      }
    }
  }
  Eigen::SparseMatrix<double> part(count, count);
  part.setFromTriplets(entries.begin(), entries.end());
  return part;
}

/// The energy of a plate whose four corners are moved to w = x y; the rest is free [J].
double energyOfTwist(const Plate& plate, const VertexMatrix& matrix) {
  int count = 0;
  const auto corner = [](const Vec3& at) { return isOn(at.x()) && isOn(at.y()); };
  const std::vector<int> index = numbered(plate, corner, count);
  Eigen::VectorXd deflection(static_cast<Eigen::Index>(index.size()));
  for (std::size_t v = 0; v < index.size(); ++v) {
    deflection[static_cast<Eigen::Index>(v)] = index[v] < 0 ? plate.positions[v].x() * plate.positions[v].y() : 0.0;
  }
  const Eigen::VectorXd force = -(matrix * deflection);
  Eigen::VectorXd freeForce(count);
  for (std::size_t v = 0; v < index.size(); ++v) {
    if (index[v] >= 0) {
      freeForce[index[v]] = force[static_cast<Eigen::Index>(v)];
    }
  }
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(freePart(matrix, index, count));
  const Eigen::VectorXd moved = solver.solve(freeForce);
  for (std::size_t v = 0; v < index.size(); ++v) {
    if (index[v] >= 0) {
      deflection[static_cast<Eigen::Index>(v)] = moved[index[v]];
    }
  }
  return 0.5 * deflection.dot(matrix * deflection);
}

/// The stiffness of the plate against slopes along x under a compression of 1 N/m: linear triangles.
VertexMatrix slopeMatrix(const Plate& plate) {
  std::vector<Eigen::Triplet<double>> entries;
  for (const Triangle& triangle : plate.triangles) {
    const std::array sides{Vec3(plate.positions[triangle[2]] - plate.positions[triangle[1]]),
                           Vec3(plate.positions[triangle[0]] - plate.positions[triangle[2]]),
                           Vec3(plate.positions[triangle[1]] - plate.positions[triangle[0]])};
    const double area = 0.5 * sides[0].cross(sides[1]).norm();
    for (std::size_t a = 0; a < 3; ++a) {
      for (std::size_t b = 0; b < 3; ++b) {
        entries.emplace_back(triangle[a], triangle[b], sides[a].y() * sides[b].y() / (4.0 * area));
      }
    }
  }
  const auto size = static_cast<Eigen::Index>(plate.positions.size());
  VertexMatrix matrix(size, size);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

/// The smallest compression along x at which a plate with hinged ends at x = 0 and x = 1 m buckles [N/m].
double bucklingLoad(const Plate& plate, const VertexMatrix& matrix) {
  int count = 0;
  const std::vector<int> index = numbered(
      plate, [](const Vec3& at) { return isOn(at.x()); }, count);
  const Eigen::SparseMatrix<double> bending = freePart(matrix, index, count);
  const Eigen::SparseMatrix<double> slopes = freePart(slopeMatrix(plate), index, count);
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(bending);
  Eigen::VectorXd mode = Eigen::VectorXd::LinSpaced(count, 1.0, 1.1);
  for (int i = 0; i < 200; ++i) {
    mode = solver.solve(slopes * mode).normalized();
  }
  return mode.dot(bending * mode) / mode.dot(slopes * mode);
}

struct NamedKind {
  const char* name;
  MeshKind kind;
};
constexpr std::array everyKind{NamedKind{"grid", MeshKind::Grid}, NamedKind{"alternating", MeshKind::Alternating},
                               NamedKind{"irregular", MeshKind::Irregular}};

TEST(Plate, resistsTwistEquallyOnEveryMesh) {
  const double expected = 0.5 * 4.0 * 1.0;  // 1/2 D_33 (2 w_xy)^2 times the area
  for (const auto& [name, kind] : everyKind) {
    for (const unsigned seed : {1U, 2U, 3U}) {
      const Plate mesh = plate(kind, 20, seed);
      EXPECT_NEAR(energyOfTwist(mesh, matrixOf(mesh, anisotropic())), expected, 0.02 * expected) << name;
    }
  }
}

TEST(Plate, bucklesAtEulersLoadOnEveryMeshAndConverges) {
  const double expected = std::numbers::pi * std::numbers::pi * 4.0;  // pi^2 D_11 / L^2
  for (const auto& [name, kind] : everyKind) {
    for (const unsigned seed : {1U, 2U, 3U}) {
      const auto errorAt = [of = kind, seed, expected](int n) {
        const Plate mesh = plate(of, n, seed);
        return std::abs(bucklingLoad(mesh, matrixOf(mesh, anisotropic())) / expected - 1.0);
      };
      EXPECT_LT(errorAt(10), 0.03) << name;
      EXPECT_LT(errorAt(30), 0.01) << name;
    }
  }
}

/// The patch test: a field of constant curvature needs no forces inside. Where vertices are moved further, some patches
/// are regularised and this holds to about 1e-6.
TEST(Plate, bearsConstantCurvatureWithoutForcesInside) {
  for (const auto& [name, kind] : everyKind) {
    const Plate mesh = plate(kind, 12, 4U, 0.15);
    const VertexMatrix matrix = matrixOf(mesh, anisotropic());
    for (const Vec3& curvature : {Vec3(1.0, 0.0, 0.0), Vec3(0.0, 1.0, 0.0), Vec3(0.0, 0.0, 1.0)}) {
      Eigen::VectorXd field(static_cast<Eigen::Index>(mesh.positions.size()));
      for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        const Vec3& at = mesh.positions[v];
        field[static_cast<Eigen::Index>(v)] =
            0.5 * (curvature[0] * at.x() * at.x() + curvature[1] * at.y() * at.y() + curvature[2] * at.x() * at.y());
      }
      const Eigen::VectorXd force = matrix * field;
      for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        const Vec3& at = mesh.positions[v];
        const bool inside = at.x() > 0.4 && at.x() < 0.6 && at.y() > 0.4 && at.y() < 0.6;
        if (inside) {
          const double size = matrix.coeff(static_cast<int>(v), static_cast<int>(v));
          EXPECT_LT(std::abs(force[static_cast<Eigen::Index>(v)]), 1e-12 * size) << name << v;
        }
      }
    }
  }
}

TEST(Plate, hasNoModesWithoutEnergyButThoseOfAPlane) {
  for (const auto& [name, kind] : everyKind) {
    const Plate mesh = plate(kind, 6, 5U);
    const Eigen::MatrixXd matrix = matrixOf(mesh, anisotropic());
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> modes(matrix, Eigen::EigenvaluesOnly);
    const double largest = modes.eigenvalues().maxCoeff();
    EXPECT_GT(modes.eigenvalues()[0], -1e-12 * largest) << name;
    EXPECT_LT(modes.eigenvalues()[2], 1e-12 * largest) << name;
    EXPECT_GT(modes.eigenvalues()[3], 1e-6 * largest) << name;
  }
}

/// A square whose corners lie on a saddle bends with the least energy if it takes the saddle's shape.
TEST(Plate, hasTheExactEnergyOfASaddleWithTwoTriangles) {
  const Plate square = {{{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {1.0, 1.0, 0.0}, {0.0, 1.0, 0.0}}, {{0, 1, 2}, {0, 2, 3}}};
  const VertexMatrix matrix = matrixOf(square, anisotropic());
  const Eigen::Vector4d saddle(0.0, 0.0, 1.0, 0.0);  // w = x y
  EXPECT_NEAR(0.5 * saddle.dot(matrix * saddle), 0.5 * 4.0 * 1.0, 1e-12);
}

}  // namespace
}  // namespace drape::sim::fabric
