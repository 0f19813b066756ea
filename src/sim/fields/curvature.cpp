#include "sim/fields/computations.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace drape::sim::fields {
namespace {

/// The unit normals of the vertices with weights that are exact on a sphere (Max 1999, Weights for computing vertex
/// normals from facet normals). Those by area are less accurate on irregular meshes. Zero without an area.
std::vector<Vec3> normalsOf(const ClothModel& model, std::span<const Vec3> positions) {
  std::vector<Vec3> normals(positions.size(), Vec3::Zero());
  for (const Triangle& corners : model.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 next = positions[corners[(k + 1) % 3]] - positions[corners[k]];
      const Vec3 previous = positions[corners[(k + 2) % 3]] - positions[corners[k]];
      const double squares = next.squaredNorm() * previous.squaredNorm();
      if (squares > 0.0) {
        normals[corners[k]] += next.cross(previous) / squares;
      }
    }
  }
  for (Vec3& normal : normals) {
    normal.normalize();  // leaves zero as it is
  }
  return normals;
}

/// The curvature of a triangle as a symmetric matrix in space, times its area: along the unit vectors t and s of its
/// plane it is t^T K s [m]. Least squares of K e = change of the normal along each of its sides e.
struct TriangleCurvature {
  Mat3 timesArea = Mat3::Zero();
  double area = 0.0;  // [m^2]
};

TriangleCurvature curvatureOf(const Triangle& corners, std::span<const Vec3> positions, std::span<const Vec3> normals) {
  const Vec3 ab = positions[corners[1]] - positions[corners[0]];
  const Vec3 ac = positions[corners[2]] - positions[corners[0]];
  const Vec3 cross = ab.cross(ac);
  const double twiceArea = cross.norm();
  if (!(twiceArea > 1e-12 * (ab.squaredNorm() + ac.squaredNorm()))) {
    return {};
  }
  Eigen::Matrix<double, 3, 2> plane;
  plane.col(0) = ab.normalized();
  plane.col(1) = (cross / twiceArea).cross(plane.col(0));
  Mat3 left = Mat3::Zero();  // of the normal equations for (K_11, K_12, K_22)
  Vec3 right = Vec3::Zero();
  for (std::size_t side = 0; side < 3; ++side) {
    const int from = corners[side];
    const int to = corners[(side + 1) % 3];
    const Eigen::Vector2d e = plane.transpose() * (positions[to] - positions[from]);
    const Eigen::Vector2d change = plane.transpose() * (normals[to] - normals[from]);
    const Vec3 first(e.x(), e.y(), 0.0);
    const Vec3 second(0.0, e.x(), e.y());
    left += first * first.transpose() + second * second.transpose();
    right += change.x() * first + change.y() * second;
  }
  const Vec3 k = left.ldlt().solve(right);
  Eigen::Matrix2d inPlane;
  inPlane << k[0], k[1], k[1], k[2];
  const double area = 0.5 * twiceArea;
  return {area * plane * inPlane * plane.transpose(), area};
}

/// The eigenvalue that is larger in size, of K restricted to the plane across the normal.
double principalCurvature(const Mat3& curvature, const Vec3& normal) {
  const Vec3 first = normal.unitOrthogonal();
  const Vec3 second = normal.cross(first);
  const double a = first.dot(curvature * first);
  const double b = first.dot(curvature * second);
  const double c = second.dot(curvature * second);
  const double mean = 0.5 * (a + c);
  return mean + std::copysign(std::hypot(0.5 * (a - c), b), mean);
}

/// The mean curvature matrix of some triangles of a vertex; NaN if none of them has an area.
template <typename Counts>
double vertexCurvature(const FieldInputs& inputs, std::span<const TriangleCurvature> triangles, std::size_t vertex,
                       const Vec3& normal, const Counts& counts) {
  TriangleCurvature sum;
  for (const int t : inputs.model.vertexTriangles[vertex]) {
    if (counts(inputs.model.triangles[t])) {
      sum.timesArea += triangles[t].timesArea;
      sum.area += triangles[t].area;
    }
  }
  return sum.area > 0.0 && !normal.isZero(0.0) ? principalCurvature(sum.timesArea / sum.area, normal) : undefinedValue;
}

/// The mean over the neighbours that have a value; NaN if none has.
double meanOfNeighbours(const FieldInputs& inputs, std::span<const double> values, std::size_t vertex) {
  double sum = 0.0;
  int count = 0;
  for (const SpringEnd& end : inputs.model.springEnds[vertex]) {
    if (!std::isnan(values[end.neighbour])) {
      sum += values[end.neighbour];
      ++count;
    }
  }
  return count > 0 ? sum / count : undefinedValue;
}

/// Gives vertices without a value the mean of their neighbours, twice: corners of a mesh have neighbours on the border
/// only.
void fillFromNeighbours(const FieldInputs& inputs, std::span<double> values) {
  for (int round = 0; round < 2; ++round) {
    const std::vector<double> known(values.begin(), values.end());
    for (std::size_t v = 0; v < values.size(); ++v) {
      if (std::isnan(known[v])) {
        values[v] = meanOfNeighbours(inputs, known, v);
      }
    }
  }
}

}  // namespace

void curvature(const FieldInputs& inputs, std::span<double> values) {
  const ClothModel& model = inputs.model;
  const std::vector<Vec3> normals = normalsOf(model, inputs.positions);
  std::vector<TriangleCurvature> triangles(model.triangles.size());
  std::transform(model.triangles.begin(), model.triangles.end(), triangles.begin(),
                 [&](const Triangle& corners) { return curvatureOf(corners, inputs.positions, normals); });
  const std::vector<bool>& onBorder = inputs.geometry.onBorder;
  const auto isInner = [&](const Triangle& corners) {
    return std::none_of(corners.begin(), corners.end(), [&](int corner) { return onBorder[corner]; });
  };
  for (std::size_t v = 0; v < values.size(); ++v) {
    values[v] = onBorder[v] ? undefinedValue : vertexCurvature(inputs, triangles, v, normals[v], isInner);
  }
  fillFromNeighbours(inputs, values);
  // A mesh so small that all of its triangles touch the border.
  for (std::size_t v = 0; v < values.size(); ++v) {
    if (std::isnan(values[v])) {
      values[v] = vertexCurvature(inputs, triangles, v, normals[v], [](const Triangle&) { return true; });
    }
  }
}

}  // namespace drape::sim::fields
