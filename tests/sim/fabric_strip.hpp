#pragma once

#include "sim/fabric/fabric.hpp"

#include <array>
#include <memory>
#include <random>
#include <vector>

namespace drape::sim::testing {

/// How the triangles of a strip lie.
enum class StripTriangles {
  Grid,         ///< parallel diagonals
  Alternating,  ///< diagonals of alternating direction
  Irregular     ///< vertices inside are displaced by up to 30 % of a cell, diagonals by chance
};

inline constexpr std::array stripKinds{StripTriangles::Grid, StripTriangles::Alternating, StripTriangles::Irregular};

/// A flat strip in the xz plane that begins at x = start and z = 0.
struct FabricStrip {
  double start = 0.0;    ///< [m]
  double length = 0.2;   ///< along x [m]
  double width = 0.05;   ///< along z [m]
  int along = 20;        ///< cells along x
  int across = 5;        ///< cells along z
  int straight = 1;      ///< this number of columns of vertices at the start is not displaced
  unsigned seed = 1;     ///< of the irregular kind
  ClothMesh mesh = {};   ///< filled by triangulate
  double density = 0.2;  ///< [kg/m^2]

  [[nodiscard]] int vertex(int column, int row) const { return row * (along + 1) + column; }

  /// The vertices of a column.
  [[nodiscard]] std::vector<int> column(int column) const {
    std::vector<int> vertices;
    for (int row = 0; row <= across; ++row) {
      vertices.push_back(vertex(column, row));
    }
    return vertices;
  }

  /// The mean of the positions of a column [m].
  [[nodiscard]] Vec3 meanOf(int column, const std::vector<Vec3>& positions) const {
    Vec3 sum = Vec3::Zero();
    for (int row = 0; row <= across; ++row) {
      sum += positions[vertex(column, row)];
    }
    return sum / (across + 1);
  }

  [[nodiscard]] bool isOnBoundary(int column, int row) const {
    return column == 0 || row == 0 || column == along || row == across;
  }

  void triangulate(StripTriangles kind) {
    std::mt19937 engine(seed);
    const auto random = [&] { return 2.0 * static_cast<double>(engine()) / 4294967295.0 - 1.0; };
    const bool irregular = kind == StripTriangles::Irregular;
    mesh = {};
    for (int row = 0; row <= across; ++row) {
      for (int column = 0; column <= along; ++column) {
        Vec3 cells(column, 0.0, row);
        if (irregular && column >= straight && !isOnBoundary(column, row)) {
          cells.x() += 0.3 * random();
          cells.z() += 0.3 * random();
        }
        mesh.positions.emplace_back(start + cells.x() * length / along, 0.0, cells.z() * width / across);
      }
    }
    for (int row = 0; row < across; ++row) {
      for (int column = 0; column < along; ++column) {
        const bool other = irregular ? random() < 0.0 : kind == StripTriangles::Alternating && (row + column) % 2 == 1;
        addCell(column, row, other);
      }
    }
  }

  /// The strip as a cloth with warp along x.
  [[nodiscard]] std::shared_ptr<const ClothModel> cloth(const fabric::Material& material,
                                                        const std::vector<int>& pins) const {
    const auto springs = buildClothModel(mesh, density * restAreaOf(mesh), MassLumping::Area, pins);
    return fabric::withFabric(*springs, material, fabric::warpAlong(Vec3::UnitX(), mesh.positions, mesh.triangles));
  }

 private:
  void addCell(int column, int row, bool otherDiagonal) {
    const int a = vertex(column, row);
    const int b = vertex(column + 1, row);
    const int c = vertex(column, row + 1);
    const int d = vertex(column + 1, row + 1);
    mesh.triangles.push_back(otherDiagonal ? Triangle{a, c, b} : Triangle{a, c, d});
    mesh.triangles.push_back(otherDiagonal ? Triangle{b, c, d} : Triangle{a, d, b});
  }
};

}  // namespace drape::sim::testing
