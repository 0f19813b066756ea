#pragma once

#include "sim/model/cloth_model.hpp"
#include "sim/model/cloth_state.hpp"
#include "sim/solvers/step_parameters.hpp"

#include <algorithm>
#include <array>
#include <memory>
#include <random>
#include <vector>

namespace drape::sim::testing {

/// A flat n x n sheet of 1 m x 1 m in the xz plane, one diagonal a quad.
inline ClothMesh sheet(int n) {
  ClothMesh mesh;
  for (int row = 0; row < n; ++row) {
    for (int column = 0; column < n; ++column) {
      mesh.positions.emplace_back(static_cast<double>(column) / (n - 1), 0.0, static_cast<double>(row) / (n - 1));
    }
  }
  for (int row = 0; row + 1 < n; ++row) {
    for (int column = 0; column + 1 < n; ++column) {
      const int v = row * n + column;
      mesh.triangles.push_back({v, v + n, v + n + 1});
      mesh.triangles.push_back({v, v + n + 1, v + 1});
    }
  }
  return mesh;
}

/// The sheet as a cloth of 0.1 kg with uniform mass, pinned at the two ends of its first row.
inline std::shared_ptr<const ClothModel> pinnedSheet(int n) {
  return buildClothModel(sheet(n), 0.1, MassLumping::Uniform, {0, n - 1});
}

/// Vectors with components in [-size, size], the same at every run.
class RandomVectors {
 public:
  explicit RandomVectors(unsigned seed) : engine_(seed) {}

  Vec3 next(double size) {
    const auto component = [&] { return size * (2.0 * static_cast<double>(engine_()) / 4294967295.0 - 1.0); };
    const double x = component();
    const double y = component();
    const double z = component();
    return {x, y, z};
  }

 private:
  std::mt19937 engine_;
};

/// The rest shape with random displacements and velocities of up to `size`; pinned vertices at rest.
inline ClothState shaken(const ClothModel& model, double size, unsigned seed) {
  RandomVectors random(seed);
  ClothState state = stateAtRest(model.restPositions);
  for (std::size_t v = 0; v < state.positions.size(); ++v) {
    state.positions[v] += random.next(size);
    state.velocities[v] = model.pinned[v] ? Vec3(Vec3::Zero()) : random.next(10.0 * size);
  }
  return state;
}

inline constexpr std::array allDerivatives{ForceDerivative::Stabilised, ForceDerivative::Exact, ForceDerivative::Scalar,
                                           ForceDerivative::Axial, ForceDerivative::TensionOnly};

/// A sheet with displaced vertices and masses by area, all different.
inline std::shared_ptr<const ClothModel> irregularSheet(int n, std::vector<int> pins = {0}) {
  ClothMesh mesh = sheet(n);
  RandomVectors random(11);
  for (Vec3& position : mesh.positions) {
    position += random.next(0.25 / (n - 1));
  }
  return buildClothModel(mesh, 0.1, MassLumping::Area, pins);
}

/// The largest difference between two states in any component of position [m] or velocity [m/s].
inline double largestDifference(const ClothState& a, const ClothState& b) {
  double largest = 0.0;
  for (std::size_t v = 0; v < a.positions.size(); ++v) {
    largest = std::max(largest, (a.positions[v] - b.positions[v]).cwiseAbs().maxCoeff());
    largest = std::max(largest, (a.velocities[v] - b.velocities[v]).cwiseAbs().maxCoeff());
  }
  return largest;
}

}  // namespace drape::sim::testing
