#pragma once

#include "sim/solvers/step_parameters.hpp"
#include "test_meshes.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <ostream>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace drape::sim::testing {

using namespace simd;

/// The same mesh with its vertices in a random order.
inline ClothMesh renumbered(const ClothMesh& mesh, unsigned seed) {
  std::vector<int> name(mesh.positions.size());
  std::iota(name.begin(), name.end(), 0);
  std::mt19937 engine(seed);
  for (std::size_t i = name.size(); i > 1; --i) {
    std::swap(name[i - 1], name[engine() % i]);
  }
  ClothMesh other = mesh;
  for (std::size_t i = 0; i < name.size(); ++i) {
    other.positions[name[i]] = mesh.positions[i];
  }
  for (Triangle& triangle : other.triangles) {
    for (int& vertex : triangle) {
      vertex = name[vertex];
    }
  }
  return other;
}

/// A sheet whose quads are cut along one diagonal or the other by chance, so that vertices have 4 to 8 neighbours, and
/// whose vertices are out of line.
inline ClothMesh unevenSheet(int n, unsigned seed) {
  ClothMesh mesh = sheet(n);
  std::mt19937 engine(seed);
  for (std::size_t t = 0; t < mesh.triangles.size(); t += 2) {
    if (engine() % 2 == 0) {
      const auto [v, below, across] = mesh.triangles[t];
      const int right = mesh.triangles[t + 1][2];
      mesh.triangles[t] = {v, below, right};
      mesh.triangles[t + 1] = {below, across, right};
    }
  }
  RandomVectors random(seed);
  for (Vec3& position : mesh.positions) {
    position += random.next(0.2 / (n - 1));
  }
  return mesh;
}

/// Both meshes, beside each other in one.
inline ClothMesh together(ClothMesh mesh, const ClothMesh& other) {
  const int shift = static_cast<int>(mesh.positions.size());
  for (const Vec3& position : other.positions) {
    mesh.positions.emplace_back(position + Vec3(3.0, 0.0, 0.0));
  }
  for (const Triangle& t : other.triangles) {
    mesh.triangles.push_back({t[0] + shift, t[1] + shift, t[2] + shift});
  }
  return mesh;
}

/// A disc of that many triangles around one vertex.
inline ClothMesh fan(int blades) {
  ClothMesh mesh;
  mesh.positions.emplace_back(0.0, 0.0, 0.0);
  for (int i = 0; i < blades; ++i) {
    const double angle = 2.0 * 3.14159265358979 * i / blades;
    mesh.positions.emplace_back(std::cos(angle), 0.0, std::sin(angle));
    mesh.triangles.push_back({0, 1 + (i + 1) % blades, 1 + i});
  }
  return mesh;
}

/// The sheet and a vertex that belongs to no triangle.
inline ClothMesh withLonelyVertex(ClothMesh mesh) {
  mesh.positions.emplace_back(0.5, 1.0, 0.5);
  return mesh;
}

struct NamedMesh {
  std::string name;
  ClothMesh mesh;
};

inline void PrintTo(const NamedMesh& mesh, std::ostream* out) {
  *out << mesh.name;
}

/// Meshes of every kind that a layout for vector instructions has to cope with.
inline std::vector<NamedMesh> everyKindOfMesh() {
  return {{"grid", sheet(17)},
          {"gridAsWideAsASlice", sheet(16)},
          {"uneven", unevenSheet(15, 3)},
          {"renumbered", renumbered(sheet(15), 5)},
          {"unevenAndRenumbered", renumbered(unevenSheet(17, 4), 6)},
          {"severalPieces", renumbered(together(together(sheet(7), fan(9)), unevenSheet(6, 2)), 7)},
          {"vertexWithoutSprings", withLonelyVertex(sheet(5))},
          {"fewerThanASlice", sheet(3)},
          {"oneTriangle", fan(3)},
          {"fanOf40", fan(40)},
          {"fanOf40Renumbered", renumbered(together(fan(40), sheet(9)), 8)}};
}

/// A cloth of 0.1 kg, masses by area, pinned at two vertices.
inline std::shared_ptr<const ClothModel> pinnedCloth(const ClothMesh& mesh) {
  const int count = static_cast<int>(mesh.positions.size());
  return buildClothModel(mesh, 0.1, MassLumping::Area, {0, count / 2});
}

/// A step with all forces except an attachment.
inline StepParameters windyStep() {
  StepParameters parameters;
  parameters.timeStep = 1.0 / 600.0;
  parameters.material.damping = 0.002;
  parameters.air.drag = 0.8;
  parameters.air.lift = 0.5;
  parameters.air.wind = Vec3(1.0, 0.2, -2.0);
  return parameters;
}

}  // namespace drape::sim::testing
