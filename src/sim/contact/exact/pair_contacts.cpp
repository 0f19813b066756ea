#include "sim/contact/exact/pair_contacts.hpp"

#include "sim/contact/closest_features/triangle_geometry.hpp"
#include "sim/contact/exact/near_pairs.hpp"

#include <algorithm>

namespace drape::sim::contact {
namespace {

/// Layers rest on each other up to this excess over their required distance, in thicknesses.
constexpr double restExcess = 0.001;

/// Features that are close at rest are in contact below this fraction of their distance at rest [-].
constexpr double fractionOfRest = 0.5;

/// The slant of two edges is the sine of the angle between their offset and the normal of an adjacent face. Above
/// `maxSlant` they are no contact. Edges that are too close move apart more slowly above `slowingSlant`, and not at all
/// above `stoppingSlant`, because the motion increases the slant. Otherwise it would end the contact, the edges would
/// fall back, and cloth in a sharp fold would never come to rest.
constexpr double maxSlant = 0.3;
constexpr double slowingSlant = 0.15;
constexpr double stoppingSlant = 0.25;

/// Distances that differ by less than this fraction count as equal [-].
constexpr double sameDistance = 1e-6;

/// The cloth at the start of the step.
struct StartOfStep {
  const ClothModel& model;
  const FeatureMesh& mesh;
  std::span<const Vec3> start;
};

/// Whether the contact of a vertex with triangle `other` replaces that with `triangle`: `other` is closer than
/// `distance`, or as close and has the lower index. A triangle that contains the vertex counts as closer than any
/// other.
bool replaces(const StartOfStep& at, int vertex, int triangle, int other, double distance) {
  if (other == triangle) {
    return false;
  }
  if (hasCorner(at.mesh.triangles[other], vertex)) {
    return true;
  }
  const double its = gapOf(verticesOf(at.mesh, {vertex, other, false}), at.start).distance;
  const double tie = sameDistance * distance;
  return its < distance - tie || (its <= distance + tie && other < triangle);
}

/// Whether the closest point of a triangle to a vertex is also the closest one of the triangles around that point.
bool isNearestAround(const StartOfStep& at, const FeaturePair& pair, const PairGap& gap) {
  const Triangle& corners = at.mesh.triangles[pair.second];
  std::array<bool, 3> touched{};
  for (std::size_t k = 0; k < 3; ++k) {
    touched[k] = -gap.weights[k + 1] > insideMargin;
  }
  const auto closer = [&](int other) { return replaces(at, pair.first, pair.second, other, gap.distance); };
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t next = (k + 1) % 3;
    const std::size_t last = (k + 2) % 3;
    if (touched[k] && !touched[next] && !touched[last]) {
      const std::span<const int> around = at.model.vertexTriangles[corners[k]];
      return std::none_of(around.begin(), around.end(), closer);
    }
    const int edge = at.mesh.edgesOfTriangle[pair.second][k];
    if (touched[k] && touched[next] && !touched[last] && edge >= 0) {
      const std::span<const TriangleSide> sides = at.mesh.edges.sides[edge];
      return std::none_of(sides.begin(), sides.end(), [&](const TriangleSide& side) { return closer(side.triangle); });
    }
  }
  return true;
}

/// The slant of an offset from an edge: the sine of its angle with the normal of an adjacent face, positive towards the
/// face, the maximum of the faces. If it is large, a point of the face is closer than the edge. If it is negative, the
/// offset leads away from all faces.
double slantOf(const StartOfStep& at, int edge, const Vec3& offset) {
  const MeshEdge& ends = at.mesh.edges.edges[edge];
  const Vec3 along = at.start[ends.b] - at.start[ends.a];
  const double squared = along.squaredNorm();
  double slant = -1.0;
  for (const TriangleSide& side : at.mesh.edges.sides[edge]) {
    const Triangle& corners = at.mesh.triangles[side.triangle];
    const Vec3 out = at.start[corners[(side.corner + 2) % 3]] - at.start[ends.a];
    const Vec3 across = squared > 0.0 ? Vec3(out - out.dot(along) / squared * along) : out;
    const double length = across.norm();
    slant = std::max(slant, length > 0.0 ? offset.dot(across) / length : 0.0);
  }
  return slant;
}

/// The larger slant of the offset between two edges.
double slantOf(const StartOfStep& at, const FeaturePair& pair, const PairGap& gap) {
  return std::max(slantOf(at, pair.first, -gap.normal), slantOf(at, pair.second, gap.normal));
}

/// The speed at which the features of a contact that are too close move apart, relative to the full speed [-].
double separationRatio(const StartOfStep& at, const FeaturePair& pair, const PairGap& gap) {
  return pair.edges ? std::clamp((stoppingSlant - slantOf(at, pair, gap)) / (stoppingSlant - slowingSlant), 0.0, 1.0)
                    : 1.0;
}

bool isContact(const StartOfStep& at, const FeaturePair& pair, const PairGap& gap) {
  if (!(gap.distance > 0.0)) {
    return false;
  }
  if (!pair.edges) {
    return isNearestAround(at, pair, gap);
  }
  return isInside(gap.weights[1]) && isInside(-gap.weights[3]) && slantOf(at, pair, gap) <= maxSlant;
}

}  // namespace

bool isEntangled(std::span<const char> entangled, const PairVertices& vertices) {
  const auto any = [&](std::span<const int> part) {
    return std::any_of(part.begin(), part.end(), [&](int v) { return entangled[v] != 0; });
  };
  return !entangled.empty() && any(vertices.first()) && any(vertices.second());
}

double thicknessOfPair(const ClothModel& model, const PairVertices& vertices, double thickness) {
  const std::vector<Vec3>& rest = model.restPositions;
  const auto& [a, b, c, d] = vertices.all;
  if (!model.areInOneCloth(a, vertices.second()[0])) {
    return thickness;
  }
  // A lower bound of the distance at rest decides for most pairs.
  const double sizes = vertices.firstCount == 2 ? (rest[b] - rest[a]).norm() + (rest[d] - rest[c]).norm()
                                                : std::max((rest[c] - rest[b]).norm(), (rest[d] - rest[b]).norm());
  const double between = (rest[vertices.second()[0]] - rest[a]).norm();
  if (fractionOfRest * (between - sizes) >= thickness) {
    return thickness;
  }
  return std::min(thickness, fractionOfRest * gapOf(vertices, rest).distance);
}

void findPairContacts(const ClothModel& model, const PairSearch& search, const PairContactRules& rules,
                      std::span<const Vec3> start, std::span<const Vec3> predicted, Workers& workers, int threads,
                      std::vector<SubstepContact>& found) {
  const StartOfStep at{model, search.mesh(), start};
  const double limit = rules.thickness + rules.margin;
  const auto consider = [&](const FeaturePair& pair, std::vector<SubstepContact>& into) {
    const PairVertices vertices = verticesOf(at.mesh, pair);
    const PairGap gap = gapOf(vertices, start);
    double predictedGap = 0.0;
    for (std::size_t k = 1; k < 4; ++k) {
      predictedGap += gap.weights[k] * gap.normal.dot(predicted[vertices.all[k]] - predicted[vertices.all[0]]);
    }
    if (std::min(predictedGap, gap.distance) >= limit || isEntangled(rules.entangled, vertices) ||
        !isContact(at, pair, gap) || (gap.distance >= limit && !comesWithin(limit, vertices, start, predicted))) {
      return;
    }
    const double thickness = thicknessOfPair(model, vertices, rules.thickness);
    const bool isTooClose = rules.separationStep > 0.0 && gap.distance < thickness;
    const double apart = isTooClose ? separationRatio(at, pair, gap) * rules.separationStep : 0.0;
    const double height = std::min(thickness, gap.distance + apart);
    if (std::min(predictedGap, gap.distance) < height + rules.margin) {
      into.push_back({.vertices = vertices.all,
                      .weights = gap.weights,
                      .normal = gap.normal,
                      .height = height,
                      .restGap = restExcess * rules.thickness,
                      .staticFriction = rules.staticFriction,
                      .kineticFriction = std::min(rules.kineticFriction, rules.staticFriction),
                      .isFeaturePair = true});
    }
  };
  collectFromNearPairs(search, {start, predicted, approachSlack * limit, limit}, workers, threads, found, consider);
}

}  // namespace drape::sim::contact
