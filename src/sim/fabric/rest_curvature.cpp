#include "sim/fabric/rest_curvature.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace drape::sim::fabric {
namespace {

/// A vertex of a hinge, and the order of the others in which the gradient of V is (x_b - x_a) x (x_c - x_a).
struct Corner {
  std::size_t own = 0;
  std::array<std::size_t, 3> others = {};
};
constexpr std::array<Corner, 4> corners = {{{0, {1, 3, 2}}, {1, {0, 2, 3}}, {2, {0, 3, 1}}, {3, {0, 1, 2}}}};

/// A mesh is flat if the sines of its angles are all below this [-].
constexpr double flatSine = 1e-6;

/// A hinge has no stable rest angle beyond 90 degrees, so it takes one with at least this cosine [-].
constexpr double minCosine = 0.1;

Vec3 gradientOf(const Vec3& a, const Vec3& b, const Vec3& c) {
  return (b - a).cross(c - a);
}

Vec3 gradientAt(const Corner& corner, const std::array<int, 4>& vertices, std::span<const Vec3> positions) {
  return gradientOf(positions[vertices[corner.others[0]]], positions[vertices[corner.others[1]]],
                    positions[vertices[corner.others[2]]]);
}

double volumeOf(const std::array<int, 4>& vertices, std::span<const Vec3> positions) {
  const Vec3& x = positions[vertices[0]];
  return (positions[vertices[1]] - x).cross(positions[vertices[2]] - x).dot(positions[vertices[3]] - x);
}

/// The sine of the angle between the triangles of a hinge [-].
double sineOf(const std::array<int, 4>& vertices, std::span<const Vec3> positions) {
  const Vec3 edge = positions[vertices[1]] - positions[vertices[0]];
  const double areas = edge.cross(positions[vertices[2]] - positions[vertices[0]]).norm() *
                       edge.cross(positions[vertices[3]] - positions[vertices[0]]).norm();
  return areas > 0.0 ? volumeOf(vertices, positions) * edge.norm() / areas : 0.0;
}

bool isFlat(const RestShape& shape, std::span<const Vec3> positions) {
  return std::ranges::all_of(
      shape.hinges, [&](const Hinge& hinge) { return std::abs(sineOf(hinge.vertices, positions)) < flatSine; });
}

/// The modulus for which a hinge has no moment about its edge. Moving an opposite corner along the normal of its
/// triangle bends the hinge without stretching it; both corners ask for a modulus, and the mean serves.
/// @param moment of the flat fabric, see hingeMoments
double modulusOf(const Hinge& hinge, const Vec3& moment, std::span<const Vec3> positions) {
  double wanted = 0.0;
  double gained = 0.0;
  for (const auto& [own, other] : {std::pair(corners[2], corners[3]), std::pair(corners[3], corners[2])}) {
    const Vec3 gradient = gradientAt(own, hinge.vertices, positions);
    const Vec3 normal = gradientAt(other, hinge.vertices, positions).normalized();
    const double cosine = std::max(minCosine, gradient.normalized().dot(normal));
    wanted += hinge.weights[static_cast<Eigen::Index>(own.own)] * moment.dot(normal);
    gained += cosine * gradient.norm();
  }
  return gained > 0.0 ? wanted / gained : 0.0;
}

double bendingEnergy(const VertexMatrix& bending, std::span<const Vec3> positions) {
  double energy = 0.0;
  for (int row = 0; row < bending.outerSize(); ++row) {
    for (VertexMatrix::InnerIterator entry(bending, row); entry; ++entry) {
      energy -= 0.25 * entry.value() * (positions[entry.col()] - positions[row]).squaredNorm();
    }
  }
  return energy;
}

RaggedRows<VertexMoment> momentsOfVertices(std::span<const RestMoment> hinges, std::size_t vertexCount) {
  return RaggedRows<VertexMoment>::collect(vertexCount, [&](const auto& take) {
    for (const RestMoment& hinge : hinges) {
      for (const Corner& corner : corners) {
        VertexMoment moment{.modulus = hinge.modulus};
        std::ranges::transform(corner.others, moment.others.begin(),
                               [&](std::size_t other) { return hinge.vertices[other]; });
        take(static_cast<std::size_t>(hinge.vertices[corner.own]), moment);
      }
    }
  });
}

}  // namespace

RestMoments::RestMoments(const RestShape& shape, const TriangleMaterials& materials, std::span<const double> scales,
                         const VertexMatrix& bending, std::span<const Vec3> positions) {
  if (isFlat(shape, positions)) {
    return;
  }
  const std::vector<Vec3> moments = hingeMoments(shape, materials, scales, positions);
  for (std::size_t h = 0; h < shape.hinges.size(); ++h) {
    if (const double modulus = modulusOf(shape.hinges[h], moments[h], positions); modulus != 0.0) {
      hinges_.push_back({shape.hinges[h].vertices, modulus});
    }
  }
  ofVertices_ = momentsOfVertices(hinges_, positions.size());
  restEnergy_ = bendingEnergy(bending, positions) + energy(positions);
}

Vec3 RestMoments::forceOn(std::size_t vertex, std::span<const Vec3> positions) const {
  Vec3 force = Vec3::Zero();
  for (const VertexMoment& moment : ofVertices_[vertex]) {
    force += moment.modulus *
             gradientOf(positions[moment.others[0]], positions[moment.others[1]], positions[moment.others[2]]);
  }
  return force;
}

double RestMoments::energy(std::span<const Vec3> positions) const {
  double energy = -restEnergy_;
  for (const RestMoment& hinge : hinges_) {
    energy -= hinge.modulus * volumeOf(hinge.vertices, positions);
  }
  return energy;
}

std::vector<double> RestMoments::halfRowSums(std::span<const Vec3> positions) const {
  std::vector<double> sums(positions.size(), 0.0);
  for (std::size_t v = 0; v < sums.size(); ++v) {
    for (const VertexMoment& moment : ofVertices_[v]) {
      const auto& [a, b, c] = moment.others;
      const double edges = (positions[b] - positions[a]).norm() + (positions[c] - positions[b]).norm() +
                           (positions[a] - positions[c]).norm();
      sums[v] += 0.5 * std::abs(moment.modulus) * edges;
    }
  }
  return sums;
}

}  // namespace drape::sim::fabric
