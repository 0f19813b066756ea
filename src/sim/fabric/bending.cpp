#include "sim/fabric/bending.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace drape::sim::fabric {
namespace {

/// The hinges of a triangle's sides; null on the boundary.
using HingesOfTriangle = std::array<const Hinge*, 3>;

std::vector<HingesOfTriangle> hingesOfTriangles(const RestShape& shape) {
  std::vector<HingesOfTriangle> hinges(shape.triangles.size(), HingesOfTriangle{});
  for (const Hinge& hinge : shape.hinges) {
    for (std::size_t s = 0; s < 2; ++s) {
      hinges[hinge.triangles[s]][hinge.sides[s]] = &hinge;
    }
  }
  return hinges;
}

/// The matrix Q of a triangle's energy 1/2 sum_ef Q_ef u_e.u_f [N m].
Mat3 energyOfBendVectors(const RestTriangle& triangle, const Mat3& moments) {
  Mat3 curvatures;  // column e: l_e / (2 A) N(n_e) [1/m]
  for (Eigen::Index k = 0; k < 3; ++k) {
    const Vec2& side = triangle.sides[static_cast<std::size_t>(k)];
    const double length = side.norm();
    const Vec2 normal = Vec2(side.y(), -side.x()) / length;
    curvatures.col(k) = length / (2.0 * triangle.area) *
                        Vec3(normal.x() * normal.x(), normal.y() * normal.y(), 2.0 * normal.x() * normal.y());
  }
  return triangle.area * curvatures.transpose() * moments * curvatures;
}

/// The factor on the bend vector of a hinge. The stiffness that a sliver causes goes up with the inverse of its height
/// to the third power, and the square of the factor compensates that.
double scaleOf(const Hinge& hinge, const RestShape& shape) {
  const double quality =
      std::min(qualityOf(shape.triangles[hinge.triangles[0]]), qualityOf(shape.triangles[hinge.triangles[1]]));
  return std::pow(std::min(1.0, quality / sliverQuality), 1.5);
}

}  // namespace

VertexMatrix bendingMatrix(const RestShape& shape, const Material& material, std::size_t vertexCount) {
  const Mat3 moments = bendMatrix(material);
  const std::vector<HingesOfTriangle> hingesOf = hingesOfTriangles(shape);
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t t = 0; t < shape.triangles.size(); ++t) {
    if (!(shape.triangles[t].area > 0.0)) {
      continue;
    }
    const Mat3 energy = energyOfBendVectors(shape.triangles[t], moments);
    for (Eigen::Index e = 0; e < 3; ++e) {
      for (Eigen::Index f = 0; f < 3; ++f) {
        const Hinge* first = hingesOf[t][static_cast<std::size_t>(e)];
        const Hinge* second = hingesOf[t][static_cast<std::size_t>(f)];
        const double scale =
            first != nullptr && second != nullptr ? scaleOf(*first, shape) * scaleOf(*second, shape) : 0.0;
        for (Eigen::Index i = 0; first != nullptr && second != nullptr && i < 4; ++i) {
          for (Eigen::Index j = 0; j < 4; ++j) {
            entries.emplace_back(first->vertices[static_cast<std::size_t>(i)],
                                 second->vertices[static_cast<std::size_t>(j)],
                                 scale * energy(e, f) * first->weights[i] * second->weights[j]);
          }
        }
      }
    }
  }
  const auto size = static_cast<Eigen::Index>(vertexCount);
  VertexMatrix matrix(size, size);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

}  // namespace drape::sim::fabric
