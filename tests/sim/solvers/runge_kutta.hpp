#pragma once

#include "sim/model/cloth_model.hpp"

#include <vector>

namespace drape::sim::testing {

/// Accelerations of springs and gravity, written down once more.
inline std::vector<Vec3> accelerations(const ClothModel& model, double stiffness, const std::vector<Vec3>& positions) {
  std::vector<Vec3> result(positions.size(), Vec3(0.0, -9.81, 0.0));
  for (const Spring& spring : model.springs) {
    const auto a = static_cast<std::size_t>(spring.a);
    const auto b = static_cast<std::size_t>(spring.b);
    const Vec3 offset = positions[b] - positions[a];
    const Vec3 pull = stiffness * spring.relativeStiffness * (1.0 - spring.restLength / offset.norm()) * offset;
    result[a] += pull / model.vertexMass[a];
    result[b] -= pull / model.vertexMass[b];
  }
  for (std::size_t v = 0; v < result.size(); ++v) {
    result[v] = model.pinned[v] ? Vec3(Vec3::Zero()) : result[v];
  }
  return result;
}

/// The classical Runge-Kutta method of fourth order, a reference that shares no code with the solvers.
inline std::vector<Vec3> rungeKutta(const ClothModel& model, double stiffness, double seconds, int steps) {
  const double h = seconds / steps;
  std::vector<Vec3> x = model.restPositions;
  std::vector<Vec3> v(x.size(), Vec3::Zero());
  const auto plus = [](std::vector<Vec3> base, double scale, const std::vector<Vec3>& change) {
    for (std::size_t i = 0; i < base.size(); ++i) {
      base[i] += scale * change[i];
    }
    return base;
  };
  for (int step = 0; step < steps; ++step) {
    const auto a1 = accelerations(model, stiffness, x);
    const auto v2 = plus(v, 0.5 * h, a1);
    const auto a2 = accelerations(model, stiffness, plus(x, 0.5 * h, v));
    const auto v3 = plus(v, 0.5 * h, a2);
    const auto a3 = accelerations(model, stiffness, plus(x, 0.5 * h, v2));
    const auto v4 = plus(v, h, a3);
    const auto a4 = accelerations(model, stiffness, plus(x, h, v3));
    for (std::size_t i = 0; i < x.size(); ++i) {
      x[i] += h / 6.0 * (v[i] + 2.0 * v2[i] + 2.0 * v3[i] + v4[i]);
      v[i] += h / 6.0 * (a1[i] + 2.0 * a2[i] + 2.0 * a3[i] + a4[i]);
    }
  }
  return x;
}

}  // namespace drape::sim::testing
