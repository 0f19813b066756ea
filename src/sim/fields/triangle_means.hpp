#pragma once

#include "sim/fabric/rest_shape.hpp"
#include "sim/fields/field_geometry.hpp"
#include "sim/model/cloth_model.hpp"

#include <Eigen/LU>
#include <span>
#include <vector>

namespace drape::sim::fields {

/// C = F^T F of a triangle, along warp and weft [-]: the identity at rest. F is its deformation gradient.
/// @param rest must have an area  @param positions of the cloth [m]
[[nodiscard]] inline Eigen::Matrix2d metricOf(const fabric::RestTriangle& rest, const Triangle& corners,
                                              std::span<const Vec3> positions) {
  Eigen::Matrix2d sides;
  sides << rest.sides[0], rest.sides[1];
  Eigen::Matrix<double, 3, 2> now;
  now << positions[corners[1]] - positions[corners[0]], positions[corners[2]] - positions[corners[1]];
  const Eigen::Matrix<double, 3, 2> gradient = now * sides.inverse();
  return gradient.transpose() * gradient;
}

/// Calls write(vertex, mean) for each vertex with the mean over its triangles of ofTriangle(triangle), weighted by
/// their area at rest, and writeNone(vertex) for a vertex without a triangle that has an area.
/// @param zero of the quantity
template <typename Quantity, typename OfTriangle, typename Write, typename WriteNone>
void forTriangleMeans(const ClothModel& model, const FieldGeometry& geometry, const Quantity& zero,
                      const OfTriangle& ofTriangle, const Write& write, const WriteNone& writeNone) {
  const std::vector<fabric::RestTriangle>& rest = geometry.rest;
  std::vector<Quantity> parts(rest.size(), zero);
  for (std::size_t t = 0; t < rest.size(); ++t) {
    if (rest[t].area > 0.0) {
      parts[t] = rest[t].area * ofTriangle(t);
    }
  }
  for (std::size_t v = 0; v < static_cast<std::size_t>(model.vertexCount()); ++v) {
    double area = 0.0;
    Quantity sum = zero;
    for (const int t : model.vertexTriangles[v]) {
      sum += parts[t];
      area += rest[t].area;
    }
    if (area > 0.0) {
      write(v, Quantity(sum / area));
    } else {
      writeNone(v);
    }
  }
}

}  // namespace drape::sim::fields
