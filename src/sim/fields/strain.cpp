#include "sim/fabric/fabric.hpp"
#include "sim/fields/computations.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace drape::sim::fields {
namespace {

/// C of a triangle as (C_11, C_22, C_12) [-]. The triangle must have an area at rest.
Vec3 metricOf(const fabric::RestTriangle& rest, const Triangle& corners, std::span<const Vec3> positions) {
  Eigen::Matrix2d sides;
  sides << rest.sides[0], rest.sides[1];
  Eigen::Matrix<double, 3, 2> now;
  now << positions[corners[1]] - positions[corners[0]], positions[corners[2]] - positions[corners[1]];
  const Eigen::Matrix<double, 3, 2> gradient = now * sides.inverse();
  const Eigen::Matrix2d metric = gradient.transpose() * gradient;
  return {metric(0, 0), metric(1, 1), metric(0, 1)};
}

/// Writes valueOf(mean over the triangles of a vertex of ofTriangle(triangle)). @param zero of the quantity
template <typename Quantity, typename OfTriangle, typename ValueOf>
void fromTriangles(const FieldInputs& inputs, std::span<double> values, const Quantity& zero,
                   const OfTriangle& ofTriangle, const ValueOf& valueOf) {
  const std::vector<fabric::RestTriangle>& rest = inputs.geometry.rest;
  std::vector<Quantity> parts(rest.size(), zero);
  for (std::size_t t = 0; t < rest.size(); ++t) {
    if (rest[t].area > 0.0) {
      parts[t] = rest[t].area * ofTriangle(t);
    }
  }
  for (std::size_t v = 0; v < values.size(); ++v) {
    double area = 0.0;
    Quantity sum = zero;
    for (const int t : inputs.model.vertexTriangles[v]) {
      sum += parts[t];
      area += rest[t].area;
    }
    values[v] = area > 0.0 ? valueOf(Quantity(sum / area)) : undefinedValue;
  }
}

template <typename ValueOf>
void fromMetric(const FieldInputs& inputs, std::span<double> values, const ValueOf& valueOf) {
  const auto metric = [&](std::size_t t) {
    return metricOf(inputs.geometry.rest[t], inputs.model.triangles[t], inputs.positions);
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
