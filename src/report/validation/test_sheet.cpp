#include "report/validation/test_sheet.hpp"

#include "sim/fabric/fabric.hpp"

#include <algorithm>
#include <random>

namespace drape::report::validation {
namespace {

constexpr double displacementShare = 0.3;  // of a cell

/// Numbers from -1 to 1, the same with every standard library.
class EvenNumbers {
 public:
  double next() { return 2.0 * static_cast<double>(engine_()) / 4294967295.0 - 1.0; }

 private:
  std::mt19937 engine_{20};  // NOLINT(bugprone-random-generator-seed): the mesh must not change
};

void addPositions(const SheetForm& form, MeshKind kind, EvenNumbers& numbers, TestSheet& sheet) {
  const double dx = form.length / form.along;
  const double dz = form.width / form.across;
  for (int row = 0; row < sheet.rows; ++row) {
    for (int column = 0; column < sheet.columns; ++column) {
      Vec3 position(form.start + column * dx, 0.0, row * dz);
      const bool inside = column >= form.straight && column < form.along && row > 0 && row < form.across;
      if (kind == MeshKind::Irregular && inside) {
        position.x() += displacementShare * dx * numbers.next();
        position.z() += displacementShare * dz * numbers.next();
      }
      sheet.mesh.positions.push_back(position);
    }
  }
}

}  // namespace

std::string_view nameOf(MeshKind kind) {
  switch (kind) {
    case MeshKind::Grid:
      return "grid";
    case MeshKind::Alternating:
      return "alternating";
    case MeshKind::Irregular:
      break;
  }
  return "irregular";
}

std::vector<int> TestSheet::verticesOf(int first, int last) const {
  std::vector<int> vertices;
  for (int row = 0; row < rows; ++row) {
    for (int column = first; column <= last; ++column) {
      vertices.push_back(vertex(column, row));
    }
  }
  return vertices;
}

TestSheet testSheet(const SheetForm& form, MeshKind kind) {
  TestSheet sheet{.mesh = {}, .columns = form.along + 1, .rows = form.across + 1};
  EvenNumbers numbers;
  addPositions(form, kind, numbers, sheet);
  for (int row = 0; row < form.across; ++row) {
    for (int column = 0; column < form.along; ++column) {
      const int a = sheet.vertex(column, row);
      const int b = sheet.vertex(column + 1, row);
      const int c = sheet.vertex(column, row + 1);
      const int d = sheet.vertex(column + 1, row + 1);
      const bool random = kind == MeshKind::Irregular && numbers.next() < 0.0;
      const bool alternate = kind == MeshKind::Alternating && (row + column) % 2 == 1;
      if (random || alternate) {
        sheet.mesh.triangles.push_back({a, c, b});
        sheet.mesh.triangles.push_back({b, c, d});
      } else {
        sheet.mesh.triangles.push_back({a, c, d});
        sheet.mesh.triangles.push_back({a, d, b});
      }
    }
  }
  return sheet;
}

sim::fabric::Material stiffSheet(double bending) {
  sim::fabric::Material material;
  material.stretchWarp = material.stretchWeft = 2000.0;
  material.shear = 1000.0;
  material.bendWarp = material.bendWeft = material.bendBias = bending;
  return material;
}

TestSheet cantilever(double freeLength, const CaseMesh& mesh) {
  const double cell = freeLength / (mesh.resolution - 0.5);
  return testSheet({.start = -0.5 * cell,
                    .length = freeLength + 0.5 * cell,
                    .width = 0.25 * freeLength,
                    .along = mesh.resolution,
                    .across = std::max(2, mesh.resolution / 4),
                    .straight = 2},
                   mesh.kind);
}

std::shared_ptr<const sim::ClothModel> clothOf(const TestSheet& sheet, const sim::fabric::Material& material,
                                               double density, const std::vector<int>& pins, const Vec3& warp) {
  const auto springs =
      sim::buildClothModel(sheet.mesh, density * sim::restAreaOf(sheet.mesh), sim::MassLumping::Area, pins);
  return sim::fabric::withFabric(*springs, material,
                                 sim::fabric::warpAlong(warp, sheet.mesh.positions, sheet.mesh.triangles));
}

}  // namespace drape::report::validation
