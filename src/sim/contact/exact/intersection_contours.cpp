#include "sim/contact/exact/intersection_contours.hpp"

#include "sim/contact/closest_features/triangle_geometry.hpp"
#include "sim/model/disjoint_sets.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <optional>
#include <utility>

namespace drape::sim::contact {
namespace {

/// Excess of the crossing field from which a curve cuts a part off [-]; 1 if the part is small and surrounded.
constexpr double minExcess = 0.02;
/// The same, relative to the other curve of its contour [-].
constexpr double ratioOfContour = 0.5;

/// A crossing as an end of a contour's segment between two triangles.
struct SegmentEnd {
  std::uint64_t triangles = 0;  // of the segment, the lower one in the upper half
  int crossing = 0;
};

/// The ends of all segments, those of one segment in succession.
std::vector<SegmentEnd> segmentEndsOf(const FeatureMesh& mesh, std::span<const EdgeCrossing> crossings) {
  std::vector<SegmentEnd> ends;
  for (std::size_t i = 0; i < crossings.size(); ++i) {
    for (const TriangleSide& side : mesh.edges.sides[crossings[i].edge]) {
      const auto [low, high] = std::minmax(side.triangle, crossings[i].triangle);
      ends.push_back(
          {(static_cast<std::uint64_t>(low) << 32U) | static_cast<std::uint32_t>(high), static_cast<int>(i)});
    }
  }
  std::sort(ends.begin(), ends.end(), [](const SegmentEnd& a, const SegmentEnd& b) {
    return std::pair(a.triangles, a.crossing) < std::pair(b.triangles, b.crossing);
  });
  return ends;
}

/// Whether a crossing's edge belongs to the lower triangle of a segment.
bool isOnLowerTriangle(const EdgeCrossing& crossing, std::uint64_t triangles) {
  return static_cast<std::uint64_t>(crossing.triangle) != triangles >> 32U;
}

/// Numbers the sets of items below `count` by their lowest members.
int numberSets(DisjointSets& sets, std::size_t count, std::vector<int>& numberOf) {
  std::vector<int> ofRoot(sets.size(), -1);
  int sum = 0;
  for (std::size_t i = 0; i < count; ++i) {
    int& number = ofRoot[sets.root(static_cast<int>(i))];
    number = number < 0 ? sum++ : number;
    numberOf.push_back(number);
  }
  return sum;
}

/// 1 if the edge passes from its lower vertex to the front of the triangle, else -1.
int signOf(const FeatureMesh& mesh, const EdgeCrossing& crossing, std::span<const Vec3> positions) {
  const auto& [a, b] = mesh.edges.edges[crossing.edge];
  const auto corners = cornersOf(positions, mesh.triangles[crossing.triangle]);
  return faceNormal(corners).dot(positions[b] - positions[a]) > 0.0 ? 1 : -1;
}

/// Where an edge passes through the plane of a triangle.
Vec3 pointOf(const FeatureMesh& mesh, const EdgeCrossing& crossing, std::span<const Vec3> positions) {
  const MeshEdge& edge = mesh.edges.edges[crossing.edge];
  const Corners corners = cornersOf(positions, mesh.triangles[crossing.triangle]);
  const Vec3 normal = faceNormal(corners);
  const double before = normal.dot(positions[edge.a] - corners[0]);
  const double after = normal.dot(positions[edge.b] - corners[0]);
  return positions[edge.a] + before / (before - after) * (positions[edge.b] - positions[edge.a]);
}

/// Calls visit(from, to, vector) for the segments of all contours, which run between two crossings.
template <typename Visit>
void forEachSegment(const FeatureMesh& mesh, std::span<const EdgeCrossing> crossings, std::span<const Vec3> positions,
                    Visit&& visit) {
  const std::vector<SegmentEnd> ends = segmentEndsOf(mesh, crossings);
  for (std::size_t i = 1; i < ends.size(); ++i) {
    if (ends[i].triangles == ends[i - 1].triangles) {
      const int from = ends[i - 1].crossing;
      const int to = ends[i].crossing;
      visit(from, to, pointOf(mesh, crossings[to], positions) - pointOf(mesh, crossings[from], positions));
    }
  }
}

/// The vertex that the triangles of a segment have in common.
std::optional<int> commonVertexOf(const FeatureMesh& mesh, std::uint64_t triangles) {
  const Triangle& lower = mesh.triangles[triangles >> 32U];
  const Triangle& upper = mesh.triangles[triangles & 0xffffffffU];
  const auto common = std::find_if(lower.begin(), lower.end(), [&](int v) { return hasCorner(upper, v); });
  return common != lower.end() ? std::optional(*common) : std::nullopt;
}

}  // namespace

std::vector<IntersectionSegment> segmentsOf(const FeatureMesh& mesh, std::span<const EdgeCrossing> crossings,
                                            std::span<const Vec3> positions) {
  const std::vector<SegmentEnd> ends = segmentEndsOf(mesh, crossings);
  std::vector<IntersectionSegment> segments;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    const Vec3 point = pointOf(mesh, crossings[ends[i].crossing], positions);
    if (i > 0 && ends[i].triangles == ends[i - 1].triangles) {
      segments.back().to = point;
      continue;
    }
    const std::optional<int> common = commonVertexOf(mesh, ends[i].triangles);
    segments.push_back({point, common ? positions[*common] : point});
  }
  return segments;
}

int intersectingPairCount(const FeatureMesh& mesh, std::span<const EdgeCrossing> crossings) {
  const std::vector<SegmentEnd> ends = segmentEndsOf(mesh, crossings);
  int pairs = 0;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    pairs += i == 0 || ends[i].triangles != ends[i - 1].triangles ? 1 : 0;
  }
  return pairs;
}

IntersectionContours contoursOf(const FeatureMesh& mesh, std::span<const EdgeCrossing> crossings) {
  const std::vector<SegmentEnd> ends = segmentEndsOf(mesh, crossings);
  const int count = static_cast<int>(crossings.size());
  DisjointSets contours(crossings.size());
  // Item i is crossing i as one of a curve, item count + i as one of the contour's other curve.
  DisjointSets curves(2 * crossings.size());
  for (std::size_t k = 1; k < ends.size(); ++k) {
    const int i = ends[k - 1].crossing;
    const int j = ends[k].crossing;
    if (ends[k].triangles == ends[k - 1].triangles) {
      const bool same =
          isOnLowerTriangle(crossings[i], ends[k].triangles) == isOnLowerTriangle(crossings[j], ends[k].triangles);
      contours.join(i, j);
      curves.join(i, same ? j : count + j);
      curves.join(count + i, same ? count + j : j);
    }
  }
  IntersectionContours result;
  result.count = numberSets(contours, crossings.size(), result.contourOf);
  result.curveCount = numberSets(curves, crossings.size(), result.curveOf);
  return result;
}

CrossingField::CrossingField(const FeatureMesh& mesh, std::span<const double> vertexMass) {
  constexpr double meanWeight = 1e-6;  // small, so that only the mean depends on it
  const auto count = static_cast<Eigen::Index>(vertexMass.size());
  const double total = std::accumulate(vertexMass.begin(), vertexMass.end(), 0.0);
  std::vector<Eigen::Triplet<double>> entries;
  for (const auto& [a, b] : mesh.edges.edges) {
    entries.insert(entries.end(), {{a, a, 1.0}, {b, b, 1.0}, {a, b, -1.0}, {b, a, -1.0}});
  }
  for (Eigen::Index v = 0; v < count; ++v) {
    const double mass = total > 0.0 ? vertexMass[v] / total * static_cast<double>(count) : 1.0;
    entries.emplace_back(v, v, meanWeight * std::max(mass, meanWeight));
  }
  Eigen::SparseMatrix<double> matrix(count, count);
  matrix.setFromTriplets(entries.begin(), entries.end());
  factors_.compute(matrix);
}

Eigen::VectorXd CrossingField::solve(const FeatureMesh& mesh, std::span<const EdgeCrossing> crossings,
                                     std::span<const int> crossingSigns) const {
  Eigen::VectorXd jumps = Eigen::VectorXd::Zero(factors_.rows());
  for (std::size_t i = 0; i < crossings.size(); ++i) {
    const auto& [a, b] = mesh.edges.edges[crossings[i].edge];
    jumps[a] -= crossingSigns[i];
    jumps[b] += crossingSigns[i];
  }
  return factors_.solve(jumps);
}

std::vector<int> wrongEndsOf(const FeatureMesh& mesh, std::span<const EdgeCrossing> crossings,
                             const IntersectionContours& contours, const CrossingField& field,
                             std::span<const Vec3> positions) {
  std::vector<int> signs;
  for (const EdgeCrossing& crossing : crossings) {
    signs.push_back(signOf(mesh, crossing, positions));
  }
  const Eigen::VectorXd values = field.solve(mesh, crossings, signs);
  // How much farther from the mean the front ends are than the back ends.
  std::vector<double> excess(static_cast<std::size_t>(contours.curveCount), 0.0);
  std::vector<int> counts(excess.size(), 0);
  for (std::size_t i = 0; i < crossings.size(); ++i) {
    const auto& [a, b] = mesh.edges.edges[crossings[i].edge];
    excess[contours.curveOf[i]] += signs[i] * (std::abs(values[b]) - std::abs(values[a]));
    ++counts[contours.curveOf[i]];
  }
  std::vector<double> ofContour(static_cast<std::size_t>(contours.count), minExcess);
  for (std::size_t i = 0; i < crossings.size(); ++i) {
    const int curve = contours.curveOf[i];
    double& largest = ofContour[contours.contourOf[i]];
    largest = std::max(largest, ratioOfContour * std::abs(excess[curve]) / counts[curve]);
  }
  std::vector<int> wrong;
  for (std::size_t i = 0; i < crossings.size(); ++i) {
    const int curve = contours.curveOf[i];
    const auto& [a, b] = mesh.edges.edges[crossings[i].edge];
    const bool cuts = std::abs(excess[curve]) / counts[curve] >= ofContour[contours.contourOf[i]];
    wrong.push_back(!cuts ? -1 : (excess[curve] > 0.0) == (signs[i] > 0) ? b : a);
  }
  return wrong;
}

std::vector<Vec3> shorteningRates(const FeatureMesh& mesh, std::span<const EdgeCrossing> crossings,
                                  std::span<const Vec3> positions) {
  std::vector<Vec3> normals;
  for (const EdgeCrossing& crossing : crossings) {
    normals.push_back(faceNormal(cornersOf(positions, mesh.triangles[crossing.triangle])));
  }
  std::vector<Vec3> rates(crossings.size(), Vec3::Zero());  // at first for motions of the points
  forEachSegment(mesh, crossings, positions, [&](int from, int to, const Vec3& segment) {
    const Vec3 along = segment.normalized();
    rates[from] += along;
    rates[to] -= along;
  });
  for (std::size_t i = 0; i < crossings.size(); ++i) {
    const auto& [a, b] = mesh.edges.edges[crossings[i].edge];
    const Vec3 edge = positions[b] - positions[a];
    const double across = edge.dot(normals[i]);
    rates[i] = across != 0.0 ? Vec3(0.5 * rates[i] - edge.dot(rates[i]) / across * normals[i]) : Vec3(Vec3::Zero());
  }
  return rates;
}

}  // namespace drape::sim::contact
