#include "sim/fabric/pattern.hpp"

#include "sim/model/quantile.hpp"
#include "sim/model/sim_error.hpp"

#include <Eigen/LU>
#include <Eigen/SVD>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace drape::sim::fabric {
namespace {

using Matrix32 = Eigen::Matrix<double, 3, 2>;

/// Two sides of the pattern's triangle, from its first corner [m].
Eigen::Matrix2d sidesFromFirst(const RestTriangle& rest) {
  Eigen::Matrix2d sides;
  sides << rest.sides[0], -rest.sides[2];
  return sides;
}

/// The derivative of the mesh by the coordinates along warp and weft [-]. Its singular values are the stretches.
Eigen::JacobiSVD<Matrix32> stretchesOf(const RestTriangle& rest, const Corners& mesh) {
  Matrix32 sides;
  sides << mesh.col(1) - mesh.col(0), mesh.col(2) - mesh.col(0);
  return Eigen::JacobiSVD<Matrix32>(sides * sidesFromFirst(rest).inverse(), Eigen::ComputeFullU | Eigen::ComputeFullV);
}

/// The mean length of each spring in its triangles [m].
std::vector<double> lengthsIn(const ClothModel& model, std::span<const RestTriangle> pattern) {
  const MeshEdges edges = edgesOf(model.triangles, model.restPositions.size());
  std::vector<double> lengths;
  for (std::size_t e = 0; e < edges.edges.size(); ++e) {
    double sum = 0.0;
    for (const TriangleSide& side : edges.sides[e]) {
      sum += pattern[side.triangle].sides[side.corner].norm();
    }
    lengths.push_back(sum / static_cast<double>(edges.sides[e].size()));
  }
  return lengths;
}

}  // namespace

std::shared_ptr<const ClothModel> withPattern(const ClothModel& model, std::span<const RestTriangle> pattern) {
  if (pattern.size() != model.triangles.size()) {
    throw ClothModelError(ClothModelError::Fault::PatternCount,
                          {.found = static_cast<std::int64_t>(pattern.size()),
                           .count = static_cast<std::int64_t>(model.triangles.size())});
  }
  std::vector<double> areas(model.restPositions.size(), 0.0);
  for (std::size_t t = 0; t < pattern.size(); ++t) {
    for (const int vertex : model.triangles[t]) {
      areas[vertex] += pattern[t].area / 3.0;
    }
  }
  return withRestSizes(model, lengthsIn(model, pattern), std::move(areas));
}

MeshStrain meshStrain(const ClothModel& model, std::span<const RestTriangle> pattern) {
  std::vector<double> strains;
  for (std::size_t t = 0; t < pattern.size(); ++t) {
    if (pattern[t].area > 0.0) {
      const Vec2 stretches =
          stretchesOf(pattern[t], cornersOf(model.triangles[t], model.restPositions)).singularValues();
      strains.push_back((stretches.array() - 1.0).abs().maxCoeff());
    }
  }
  const double median = quantileExceededBy(strains, 2);
  return {.median = median, .high = quantileExceededBy(strains, 100)};
}

Corners placedInSpace(const RestTriangle& rest, const Corners& mesh, double maxStretch) {
  Corners corners = Corners::Zero();
  if (rest.area > 0.0) {
    const Eigen::JacobiSVD<Matrix32> parts = stretchesOf(rest, mesh);
    const Vec2 stretches = (1.0 + (parts.singularValues().array() - 1.0).abs()).min(maxStretch);
    corners.rightCols<2>() =
        parts.matrixU().leftCols<2>() * stretches.asDiagonal() * parts.matrixV().transpose() * sidesFromFirst(rest);
  }
  return corners;
}

}  // namespace drape::sim::fabric
