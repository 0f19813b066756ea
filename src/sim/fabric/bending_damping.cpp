#include "sim/fabric/bending_damping.hpp"

#include "sim/fabric/fabric.hpp"
#include "sim/fabric/rate_limit.hpp"
#include "sim/model/mesh_topology.hpp"

#include <algorithm>
#include <cmath>

namespace drape::sim::fabric {
namespace {

/// Below this radius of curvature [m] d_i is mainly the direction of Delta_i x, above it mainly the normal. The
/// in-plane strain of flat cloth also causes a small Delta_i x, whose direction means nothing.
constexpr double flatRadius = 1.0;

/// `maxRatio` of the RateLimit [-]. Vibration may last longer in small triangles, where it is invisible.
constexpr double dampingRatio = 4.0;

/// The square root of a material's damping time over the longest one of the cloth [-]. Delta contains it, so that Z is
/// proportional to the damping time. 1 if none damps.
double relativeDamping(const TriangleMaterials& materials, const Material& material) {
  const double longest = materials.maxBendDamping();
  return longest > 0.0 ? std::sqrt(material.bendDamping / longest) : 1.0;
}

std::vector<double> weightsOf(const ClothModel& model) {
  const TriangleMaterials& materials = model.fabric->materials;
  std::vector<double> weights(model.springs.size(), 0.0);
  for (std::size_t t = 0; t < model.triangles.size(); ++t) {
    const RestTriangle& rest = model.fabric->shape.triangles[t];
    if (!(rest.area > 0.0)) {
      continue;
    }
    const Material& material = materials[t];
    const double warp = std::sqrt(material.bendWarp);
    const double weft = std::sqrt(material.bendWeft);
    const double scale = relativeDamping(materials, material) * std::min(1.0, qualityOf(rest) / sliverQuality);
    for (std::size_t k = 0; k < 3; ++k) {
      // The gradient of a corner's shape function is its opposite side, turned by a right angle, over twice the area.
      const Vec2& first = rest.sides[(k + 1) % 3];
      const Vec2& second = rest.sides[(k + 2) % 3];
      const double product = warp * first.y() * second.y() + weft * first.x() * second.x();
      const int edge = springBetween(model.springEnds, model.triangles[t][k], model.triangles[t][(k + 1) % 3]);
      weights[edge] -= scale * product / (4.0 * rest.area);
    }
  }
  return weights;
}

/// Vertices of edges that do not have two triangles.
std::vector<bool> boundaryVertices(const ClothModel& model) {
  std::vector<bool> onBoundary(model.restPositions.size(), false);
  const MeshEdges mesh = edgesOf(model.triangles, model.restPositions.size());
  for (std::size_t e = 0; e < mesh.edges.size(); ++e) {
    if (mesh.sides[e].size() != 2) {
      onBoundary[mesh.edges[e].a] = onBoundary[mesh.edges[e].b] = true;
    }
  }
  return onBoundary;
}

/// Bounds of the row sums of |Z|, one a vertex [N/m].
struct RowSums {
  std::vector<double> own;    ///< of the term of the vertex itself
  std::vector<double> total;  ///< of all terms
};

RowSums rowSumsOf(const ClothModel& model, const BendingDamping& damping) {
  const std::size_t count = model.restPositions.size();
  std::vector<double> diagonal(count, 0.0);  // of |Delta|
  for (std::size_t s = 0; s < model.springs.size(); ++s) {
    diagonal[model.springs[s].a] += std::abs(damping.weights[s]);
    diagonal[model.springs[s].b] += std::abs(damping.weights[s]);
  }
  const auto partOf = [&](std::size_t v) { return 2.0 * diagonal[v] * damping.inverseAreas[v]; };
  RowSums sums;
  for (std::size_t v = 0; v < count; ++v) {
    sums.own.push_back(diagonal[v] * partOf(v));
    double total = sums.own.back();
    for (const SpringEnd& end : model.springEnds[v]) {
      total += std::abs(damping.weights[end.spring]) * partOf(static_cast<std::size_t>(end.neighbour));
    }
    sums.total.push_back(total);
  }
  return sums;
}

/// Scales the fastest terms down to the RateLimit of the mesh. Otherwise a few small triangles would determine the
/// number of stages.
void clampTerms(const ClothModel& model, BendingDamping& damping) {
  const RowSums sums = rowSumsOf(model, damping);
  const RateLimit limit(sums.total, model.vertexArea, maxBendingRatio(dampingRatio), model.clothOf);
  for (std::size_t v = 0; v < sums.own.size(); ++v) {
    damping.inverseAreas[v] *= limit.scaleOf(sums.own[v], v);
  }
}

/// By the row sums of M^-1 Z.
double highestRateOf(const ClothModel& model, const BendingDamping& damping) {
  const RowSums sums = rowSumsOf(model, damping);
  double highest = 0.0;
  for (std::size_t v = 0; v < sums.total.size(); ++v) {
    highest = std::max(highest, model.pinned[v] ? 0.0 : sums.total[v] / model.vertexMass[v]);
  }
  return highest;
}

/// The normal of a vertex, times twice the area of its triangles [m^2].
Vec3 areaNormal(const ClothModel& model, std::span<const Vec3> positions, int vertex) {
  Vec3 normal = Vec3::Zero();
  for (const int t : model.vertexTriangles[vertex]) {
    const auto& [a, b, c] = model.triangles[t];
    normal += (positions[b] - positions[a]).cross(positions[c] - positions[a]);
  }
  return normal;
}

}  // namespace

BendingDamping bendingDampingOf(const ClothModel& model) {
  BendingDamping damping;
  damping.weights = weightsOf(model);
  const std::vector<bool> onBoundary = boundaryVertices(model);
  for (std::size_t v = 0; v < onBoundary.size(); ++v) {
    const bool counts = !onBoundary[v] && model.vertexArea[v] > 0.0;
    damping.inverseAreas.push_back(counts ? 1.0 / model.vertexArea[v] : 0.0);
  }
  clampTerms(model, damping);
  damping.highestRate = highestRateOf(model, damping);
  return damping;
}

Vec3 weightedLaplacian(const ClothModel& model, const BendingDamping& damping, std::span<const Vec3> vectors,
                       int vertex) {
  Vec3 sum = Vec3::Zero();
  for (const SpringEnd& end : model.springEnds[vertex]) {
    sum += damping.weights[end.spring] * (vectors[end.neighbour] - vectors[vertex]);
  }
  return sum;
}

Vec3 bendingDirection(const ClothModel& model, const BendingDamping& damping, std::span<const Vec3> positions,
                      int vertex) {
  if (damping.inverseAreas[vertex] == 0.0) {
    return Vec3::Zero();
  }
  Vec3 direction = areaNormal(model, positions, vertex);
  if (!(direction.squaredNorm() > 0.0)) {
    return Vec3::Zero();
  }
  direction.normalize();
  const TriangleMaterials& materials = model.fabric->materials;
  const Material& material = materials[model.vertexTriangles[vertex].front()];
  const double unit = relativeDamping(materials, material) * std::sqrt(std::max(material.bendWarp, material.bendWeft));
  if (!(unit > 0.0)) {
    return direction;
  }
  const Vec3 curvature =
      flatRadius * damping.inverseAreas[vertex] / unit * weightedLaplacian(model, damping, positions, vertex);
  direction += curvature.dot(direction) < 0.0 ? Vec3(-curvature) : curvature;
  return direction.normalized();
}

}  // namespace drape::sim::fabric
