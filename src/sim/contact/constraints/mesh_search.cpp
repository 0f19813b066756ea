#include "sim/contact/constraints/mesh_search.hpp"

#include "sim/contact/closest_features/nearest_search.hpp"
#include "sim/contact/constraints/collect_in_order.hpp"
#include "sim/contact/constraints/sharp_feature_search.hpp"
#include "sim/contact/recovery/overlap.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace drape::sim::contact {
namespace {

// Ratios to the contact offset [-]:
constexpr double listedRatio = 2.0;      // leaves are listed up to this distance from a cluster
constexpr double listMarginRatio = 1.0;  // additional distance in cached lists
constexpr double knownRatio = 0.15;      // distances are reused up to this displacement of a cluster
constexpr double closeRatio = 0.2;       // edges and faces get contacts up to this distance beyond the edge offset
constexpr double fastRatio = 1.5;        // the result of a vertex is cached up to this searched distance
constexpr double rounding = 1e-9;        // [m]
constexpr double infinity = std::numeric_limits<double>::infinity();

/// Distance below which edges and faces get contacts [m].
double closeDistance(const ContactOffsets& offsets) {
  return offsets.edgeOffset + std::max(offsets.listMargin, closeRatio * offsets.contactOffset);
}

/// The results of one part of the clusters.
template <typename More>
struct Part {
  Candidates found;
  std::vector<More> more;
};

/// Calls visit(first cluster, one past the last, part) for parts of the clusters, and returns the parts in order.
template <typename More, typename Visit>
std::vector<Part<More>> inParts(const ClothClusters& clusters, Workers& workers, int threads, std::size_t triangles,
                                Visit&& visit) {
  return collectInOrder<Part<More>>(workers, threads, static_cast<int>(triangles),
                                    [&](int begin, int end, Part<More>& part) {
                                      const auto [first, last] = clusters.clustersWithin(begin, end);
                                      visit(first, last, part);
                                    });
}

}  // namespace

void MeshSearch::begin(const SearchableMesh& mesh, std::uint64_t model) {
  piercings_.clear();
  piercingsKnown_ = false;
  requested_.clear();
  if (mesh_ != &mesh || model_ != model) {
    nearby_.clear();
    near_.clear();
    outwards_.clear();
    searched_.clear();
    features_.clear();
    mesh_ = &mesh;
    model_ = model;
  }
}

void MeshSearch::NearbyLeaves::list(const MeshTree& tree, const Eigen::AlignedBox3d& box) {
  covered = box;
  leaves.clear();
  boxes.clear();
  tree.forEachLeafIn(box, [&](std::size_t leaf) {
    leaves.push_back(static_cast<int>(leaf));
    boxes.add(tree.leafBox(leaf));
  });
}

/// Finds the leaves near a cluster and the closest points of its vertices.
class MeshSearch::ClusterSearch {
 public:
  ClusterSearch(const ConstraintBuilder& builder, const MeshInStep& mesh, const ClothInBody& cloth)
      : builder_(builder),
        mesh_(mesh),
        cloth_(cloth),
        nearest_(mesh),
        radius_(listedRatio * builder.offsets().contactOffset) {}

  /// Lists the leaves within the radius if the cached list does not cover it. Computes how far the cluster has moved
  /// since its distances were computed. If that is too far, reduces the distances by it, and takes the present
  /// positions as the reference.
  void list(std::span<const int> vertices, NearbyLeaves& nearby) const {
    Eigen::AlignedBox3d box;
    double squared = nearby.reference.size() == vertices.size() ? 0.0 : infinity;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      const Vec3& start = vectorAt(cloth_.start, vertices[i]);
      box.extend(start);
      if (squared < infinity) {
        squared = std::max(squared, (start - nearby.reference[i]).squaredNorm());
      }
    }
    box = inflated(box, radius_);
    if (mesh_.mesh.isDeforming()) {
      nearby.list(mesh_.mesh.tree, box);
    } else if (!nearby.covered.contains(box)) {
      nearby.list(mesh_.mesh.tree, inflated(box, listMarginRatio * builder_.offsets().contactOffset));
    }
    nearby.moved = std::sqrt(squared) + rounding;
    if (mesh_.mesh.isDeforming() || !(nearby.moved <= knownRatio * builder_.offsets().contactOffset)) {
      double moved = nearby.moved;
      if (mesh_.mesh.isDeforming()) {
        moved = infinity;
      }
      for (double& distance : nearby.distances) {
        distance -= moved;
      }
      nearby.moved = 0.0;
      nearby.reference.clear();
      for (const int v : vertices) {
        nearby.reference.push_back(vectorAt(cloth_.start, v));
      }
    }
  }

  /// The distance up to which the closest point to a vertex is searched [m]. A point that is farther away cannot become
  /// a contact.
  [[nodiscard]] double radiusOf(int vertex) const {
    const double radius = cloth_.displacementBounds[vertex] - builder_.offsets().contactOffset;
    return isAmongNearbyLeaves() ? std::max(radius, radius_) : radius;
  }

  /// The closest point of the mesh to a vertex, within `radiusOf`.
  NearestMeshPoint nearestTo(int vertex, const NearbyLeaves& nearby, NearbyTriangles& memory) {
    const Vec3& point = vectorAt(cloth_.start, vertex);
    const double radius = radiusOf(vertex);
    if (isAmongNearbyLeaves()) {
      NearestMeshPoint found = nearest_.among(nearby.leaves, nearby.boxes, point, radius_);
      return found.triangle < 0 && radius > radius_ ? nearest_.anywhere(point, radius) : found;
    }
    const double moved = (point - memory.at).norm() + rounding;
    if (memory.clearRadius - moved >= radius) {
      return {};
    }
    if (moved <= memory.validRadius) {
      return nearest_.amongRemembered(memory, point, radius, moved);
    }
    const double beyond =
        std::min((point - nearby.covered.min()).minCoeff(), (nearby.covered.max() - point).minCoeff());
    const double within = knownRatio * builder_.offsets().contactOffset;
    if (radius + 3.0 * within > beyond) {
      return nearest_.anywhere(point, radius);
    }
    if (radius > fastRatio * builder_.offsets().contactOffset) {
      return nearest_.among(nearby.leaves, nearby.boxes, point, radius);  // it moves too fast for a cached result
    }
    // The cached result must also show that a vertex which moves a little has no closest point within its radius.
    const NearestMeshPoint found = nearest_.among(nearby.leaves, nearby.boxes, point, radius + within, within);
    nearest_.remember(point, within, beyond, memory);
    return found.squaredDistance < radius * radius ? found : NearestMeshPoint();
  }

 private:
  /// Whether the nearby leaves are searched first, up to `radius_`, and no result is cached for other positions.
  [[nodiscard]] bool isAmongNearbyLeaves() const { return mesh_.mesh.isDeforming() || cloth_.overlap != nullptr; }

  const ConstraintBuilder& builder_;
  const MeshInStep& mesh_;
  const ClothInBody& cloth_;
  NearestSearch nearest_;
  double radius_;  // [m]
};

/// Whether the last search started from the same positions, so that its results are still valid: the search at the end
/// of a contact substep starts from the same positions as that for its list of substep contacts.
bool MeshSearch::isSearched(const ConstraintBuilder& builder, const MeshInStep& mesh, const ClothInBody& cloth) {
  const bool cached = !(mesh.mesh.isDeforming() && mesh.atEnd) && cloth.overlap == nullptr;
  const double offset = builder.offsets().contactOffset;
  const bool searched = cached && searchedOffset_ == offset && searchedVersion_ == mesh.mesh.version() &&
                        std::equal(searched_.begin(), searched_.end(), cloth.start.begin(), cloth.start.end());
  if (!searched) {
    // Only a list is followed by another search from the same positions.
    const bool isList = cached && builder.offsets().listMargin > 0.0;
    searched_.assign(isList ? cloth.start.begin() : cloth.start.end(), cloth.start.end());
    searchedOffset_ = offset;
    searchedVersion_ = mesh.mesh.version();
  }
  return searched;
}

void MeshSearch::findVertexContacts(const ConstraintBuilder& builder, const MeshInStep& mesh, const ClothInBody& cloth,
                                    const ClothClusters& clusters, Workers& workers, int threads,
                                    Candidates& candidates) {
  nearby_.resize(clusters.count());
  nearest_.resize(cloth.start.size());
  near_.resize(cloth.start.size());
  searchedRadius_.resize(cloth.start.size());
  distances_.resize(cloth.triangles.size());
  markPenetrating(cloth);
  samePositions_ = isSearched(builder, mesh, cloth);
  workers.forRange(threads, static_cast<int>(cloth.triangles.size()), [&](int begin, int end) {
    ClusterSearch here(builder, mesh, cloth);
    const auto [first, last] = clusters.clustersWithin(begin, end);
    for (std::size_t c = first; c < last; ++c) {
      if (!samePositions_) {
        here.list(clusters.vertices(c), nearby_[c]);
        useKnownDistances(clusters.triangles(c), nearby_[c]);
      }
      for (const int v : clusters.ownVertices(c)) {
        const double radius = here.radiusOf(v);
        const bool known = samePositions_ && (nearest_[v].triangle >= 0 || radius <= searchedRadius_[v]);
        if (!known) {
          nearest_[v] = here.nearestTo(v, nearby_[c], near_[v]);
          searchedRadius_[v] = radius;
        } else if (nearest_[v].triangle >= 0 && !(nearest_[v].squaredDistance < radius * radius)) {
          nearest_[v] = {};
          searchedRadius_[v] = radius;
        }
      }
    }
  });
  countOverlaps(cloth, candidates);
  addRecoveryContacts(builder, mesh, cloth, candidates);
  addVertexContacts(builder, mesh, cloth, candidates);
}

void MeshSearch::findSharpFeatureContacts(const ConstraintBuilder& builder, const MeshInStep& mesh,
                                          const ClothInBody& cloth, const ClothClusters& clusters, Workers& workers,
                                          int threads, Candidates& candidates) {
  featureGaps_.resize(cloth.triangles.size(), -infinity);
  if (!samePositions_ && !searched_.empty()) {
    std::fill(featureGaps_.begin(), featureGaps_.end(), -infinity);
  }
  outwards_.resize(cloth.triangles.size(), Vec3::Zero());
  features_.resize(cloth.triangles.size());
  if (!samePositions_ && mesh.mesh.isDeforming()) {
    for (NearbyFeatures& memory : features_) {
      memory.validRadius = -1.0;
    }
  }
  const double close = closeDistance(builder.offsets());
  const auto parts = inParts<int>(
      clusters, workers, threads, cloth.triangles.size(), [&](std::size_t first, std::size_t last, Part<int>& part) {
        SharpFeatureSearch sharp(builder, mesh, cloth, nearest_, close, builder.offsets().contactOffset, part.found);
        for (std::size_t c = first; c < last; ++c) {
          searchTriangles(mesh, cloth, clusters.triangles(c), nearby_[c], builder.offsets(), sharp);
        }
      });
  for (const auto& part : parts) {
    candidates.append(part.found);
  }
}

/// Sets the distances of a cluster's triangles to the lower bounds that are known for their present positions.
void MeshSearch::useKnownDistances(std::span<const int> triangles, NearbyLeaves& nearby) {
  nearby.distances.resize(triangles.size(), -infinity);
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    distances_[triangles[i]] = nearby.distances[i] - nearby.moved;
  }
}

/// Finds contacts of the edges and faces of a cluster's triangles that could be close enough. Updates their distances.
void MeshSearch::searchTriangles(const MeshInStep& mesh, const ClothInBody& cloth, std::span<const int> triangles,
                                 NearbyLeaves& nearby, const ContactOffsets& offsets, SharpFeatureSearch& sharp) {
  useKnownDistances(triangles, nearby);
  if (nearby.leaves.empty()) {
    const double near = listedRatio * offsets.contactOffset;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      distances_[triangles[i]] = near;
      nearby.distances[i] = std::max(nearby.distances[i], near - nearby.moved);
    }
    return;
  }
  const auto squaredDisplacement = [&](int v) {
    return (vectorAt(cloth.predicted, v) - vectorAt(cloth.start, v)).squaredNorm();
  };
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const int t = triangles[i];
    if (distances_[t] >= closeDistance(offsets) || penetrating_[t]) {
      continue;
    }
    const Triangle& corners = cloth.triangles[t];
    const double longest = std::sqrt(std::max({squaredDisplacement(corners[0]), squaredDisplacement(corners[1]),
                                               squaredDisplacement(corners[2])})) +
                           rounding + offsets.listMargin;
    const double atLeast = samePositions_ ? std::max(distances_[t], featureGaps_[t]) : distances_[t];
    if (!mesh.moves() && atLeast >= offsets.edgeOffset + longest) {
      continue;  // it stays too far away
    }
    distances_[t] =
        std::max(distances_[t], sharp.search(t, nearby.leaves, nearby.boxes, longest, outwards_[t], features_[t]));
    featureGaps_[t] = sharp.featureGap();
    nearby.distances[i] = std::max(nearby.distances[i], distances_[t] - nearby.moved);
  }
}

void MeshSearch::addVertexContacts(const ConstraintBuilder& builder, const MeshInStep& mesh, const ClothInBody& cloth,
                                   Candidates& candidates) const {
  for (std::size_t t = 0; t < cloth.triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const int v = cloth.triangles[t][k];
      const NearestMeshPoint& near = nearest_[v];
      if (!cloth.owned[t].corners[k]) {
        continue;
      }
      if (cloth.overlap != nullptr && cloth.overlap->inside(cloth.triangles[t][k])) {
        builder.addContact(cloth, t, onCorner(k), cloth.overlap->exitOf(cloth.triangles[t][k]),
                           builder.offsets().contactOffset, candidates);
        continue;
      }
      if (near.triangle < 0) {
        continue;
      }
      // A vertex that has passed through an open mesh must not be kept behind it.
      if (mesh.mesh.closed || !besidePenetrating_[v] ||
          faceNormal(mesh.corners(near.triangle)).dot(near.normal) > 0.0) {
        builder.addContact(cloth, t, onCorner(k), pointOf(mesh, near), builder.offsets().contactOffset, candidates);
      }
    }
  }
}

/// The leaves that a cluster could reach within its displacement bounds.
/// @param wider storage, used if the cached list does not cover the bounds
const MeshSearch::NearbyLeaves& MeshSearch::leavesWithinBound(const ConstraintBuilder& builder, const MeshInStep& mesh,
                                                              const ClothInBody& cloth, const ClothClusters& clusters,
                                                              std::size_t cluster, NearbyLeaves& wider) const {
  double far = 0.0;
  Eigen::AlignedBox3d box;
  for (const int v : clusters.vertices(cluster)) {
    far = std::max(far, cloth.displacementBounds[v] + builder.offsets().minimumSeparation);
    box.extend(vectorAt(cloth.start, v));
  }
  if (far > listedRatio * builder.offsets().contactOffset) {
    wider.list(mesh.mesh.tree, inflated(box, far));
    return wider;
  }
  return nearby_[cluster];
}

/// Finds the planes of one triangle. A triangle that penetrates a closed mesh gets none; the search only updates which
/// triangles it pierces.
void MeshSearch::findPlanesOf(int triangle, const MeshInStep& mesh, const NearbyLeaves& nearby, PlaneSearch& planes,
                              Candidates& candidates) const {
  const std::size_t before = candidates.planes.size();
  planes.search(triangle, nearby.leaves, nearby.boxes);
  if (penetrating_[triangle] && mesh.mesh.closed) {
    candidates.planes.resize(before);
  }
}

bool MeshSearch::findPlanes(const ConstraintBuilder& builder, const MeshInStep& mesh, const ClothInBody& cloth,
                            const ClothClusters& clusters, std::span<const double> displacements, Workers& workers,
                            int threads, Candidates& candidates) {
  skipped_.assign(cloth.triangles.size(), 0);
  requested_.resize(cloth.triangles.size(), 0);
  const auto canSkip = [&](std::size_t t) {
    const auto displacement = [&](std::size_t k) { return displacements[cloth.triangles[t][k]]; };
    const double longest = std::max({displacement(0), displacement(1), displacement(2)});
    return !mesh.moves() && requested_[t] == 0 &&
           distances_[t] > longest + builder.offsets().minimumSeparation + rounding;
  };
  const auto parts = inParts<Piercing>(clusters, workers, threads, cloth.triangles.size(),
                                       [&](std::size_t first, std::size_t last, Part<Piercing>& part) {
                                         PlaneSearch planes(builder, mesh, cloth, nearest_, part.found);
                                         NearbyLeaves wider;
                                         for (std::size_t c = first; c < last; ++c) {
                                           const std::span<const int> triangles = clusters.triangles(c);
                                           for (const int t : triangles) {
                                             skipped_[t] = canSkip(static_cast<std::size_t>(t)) ? 1 : 0;
                                           }
                                           const auto isSkipped = [&](int t) { return skipped_[t] != 0; };
                                           if (std::all_of(triangles.begin(), triangles.end(), isSkipped)) {
                                             continue;
                                           }
                                           const NearbyLeaves& nearby =
                                               leavesWithinBound(builder, mesh, cloth, clusters, c, wider);
                                           if (nearby.leaves.empty()) {
                                             continue;
                                           }
                                           for (const int t : triangles) {
                                             if (!isSkipped(t) && !keepKnownPiercings(mesh, t, planes)) {
                                               findPlanesOf(t, mesh, nearby, planes, part.found);
                                             }
                                           }
                                         }
                                         part.more = planes.piercings();
                                       });
  std::vector<Piercing> piercings;
  for (const auto& part : parts) {
    candidates.append(part.found);
    piercings.insert(piercings.end(), part.more.begin(), part.more.end());
  }
  if (cloth.overlap != nullptr) {
    addPlanesAtOverlap(builder, mesh, cloth, candidates);
  }
  const bool newlyFound = piercings.size() != piercings_.size();
  piercings_.swap(piercings);
  firstPiercing_.assign(cloth.triangles.size(), piercings_.size());
  for (std::size_t i = piercings_.size(); i-- > 0;) {
    firstPiercing_[piercings_[i].cloth] = i;
  }
  piercingsKnown_ = true;
  return newlyFound;
}

bool MeshSearch::requestPlanesAround(std::span<const Triangle> triangles, const std::vector<bool>& moved) {
  bool newlyFound = false;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const bool touched = std::any_of(triangles[t].begin(), triangles[t].end(), [&](int v) { return moved[v]; });
    if (touched && skipped_[t] != 0) {
      requested_[t] = 1;
      newlyFound = true;
    }
  }
  return newlyFound;
}

bool MeshSearch::isBehindFace(const MeshInStep& mesh, int vertex) const {
  const NearestMeshPoint& near = nearest_[vertex];
  return mesh.mesh.closed && near.triangle >= 0 && faceNormal(mesh.corners(near.triangle)).dot(near.normal) < 0.0;
}

Vec3 MeshSearch::bodyDisplacementAt(const MeshInStep& mesh, int vertex) const {
  const NearestMeshPoint& near = nearest_[vertex];
  if (near.triangle < 0) {
    return Vec3::Zero();
  }
  const NearPoint point = pointOf(mesh, near);
  return point.endPoint - point.startPoint;
}

}  // namespace drape::sim::contact
