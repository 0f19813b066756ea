#include "sim/fabric/fabric.hpp"
#include "sim/fields/computations.hpp"
#include "sim/fields/triangle_means.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace drape::sim::fields {
namespace {

/// Writes valueOf(mean over the triangles of a vertex of ofTriangle(triangle)). @param zero of the quantity
template <typename Quantity, typename OfTriangle, typename ValueOf>
void fromTriangles(const FieldInputs& inputs, std::span<double> values, const Quantity& zero,
                   const OfTriangle& ofTriangle, const ValueOf& valueOf) {
  forTriangleMeans(
      inputs.model, inputs.geometry, zero, ofTriangle,
      [&](std::size_t v, const Quantity& mean) { values[v] = valueOf(mean); },
      [&](std::size_t v) { values[v] = undefinedValue; });
}

template <typename ValueOf>
void fromMetric(const FieldInputs& inputs, std::span<double> values, const ValueOf& valueOf) {
  const auto metric = [&](std::size_t t) -> Vec3 {
    const Eigen::Matrix2d c = metricOf(inputs.geometry.rest[t], inputs.model.triangles[t], inputs.positions);
    return {c(0, 0), c(1, 1), c(0, 1)};
  };
  fromTriangles(inputs, values, Vec3(Vec3::Zero()), metric, valueOf);
}

/// The largest principal value of Cauchy's stress of a triangle, the sum of t_e x_e x_e^T over its sides by its present
/// area, with the tensions t_e of its membrane [N/m]. One of the three principal values is 0: that across its plane.
double principalStress(const fabric::MembraneTriangle& membrane, const fabric::Corners& corners) {
  const double area = 0.5 * (corners.col(1) - corners.col(0)).cross(corners.col(2) - corners.col(0)).norm();
  const Vec3 tensions = membrane.tensions(corners);
  Mat3 sum = Mat3::Zero();
  double squares = 0.0;
  for (Eigen::Index side = 0; side < 3; ++side) {
    const Vec3 along = corners.col((side + 1) % 3) - corners.col(side);
    sum += tensions[side] * along * along.transpose();
    squares += along.squaredNorm();
  }
  if (!(area > 1e-9 * squares)) {
    return 0.0;  // a collapsed triangle has no width on which a force could act
  }
  const double trace = sum.trace();
  return 0.5 * (trace + std::sqrt(std::max(0.0, 2.0 * sum.squaredNorm() - trace * trace))) / area;
}

}  // namespace

void stretchAlongWarp(const FieldInputs& inputs, std::span<double> values) {
  fromMetric(inputs, values, [](const Vec3& metric) { return 100.0 * std::sqrt(metric[0]); });
}

void stretchAlongWeft(const FieldInputs& inputs, std::span<double> values) {
  fromMetric(inputs, values, [](const Vec3& metric) { return 100.0 * std::sqrt(metric[1]); });
}

void shearAngle(const FieldInputs& inputs, std::span<double> values) {
  fromMetric(inputs, values, [](const Vec3& metric) {
    const double lengths = std::sqrt(metric[0] * metric[1]);
    const double sine = lengths > 0.0 ? std::clamp(metric[2] / lengths, -1.0, 1.0) : 0.0;
    return std::asin(sine) * 180.0 / std::numbers::pi;
  });
}

void membraneStress(const FieldInputs& inputs, std::span<double> values) {
  const std::vector<fabric::MembraneTriangle>& membrane = inputs.model.fabric->membrane;
  const auto stressOf = [&](std::size_t t) {
    return principalStress(membrane[t], fabric::cornersOf(inputs.model.triangles[t], inputs.positions));
  };
  fromTriangles(inputs, values, 0.0, stressOf, [](double stress) { return stress; });
}

}  // namespace drape::sim::fields
