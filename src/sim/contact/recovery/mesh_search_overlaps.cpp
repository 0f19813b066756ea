// The part of MeshSearch that handles cloth that is inside a mesh or pierces it.
#include "sim/contact/closest_features/closest_points.hpp"
#include "sim/contact/constraints/mesh_search.hpp"
#include "sim/contact/recovery/overlap.hpp"

#include <algorithm>

namespace drape::sim::contact {

std::vector<bool> MeshSearch::pierces(std::size_t triangles) const {
  std::vector<bool> pierces(triangles, false);
  for (const Piercing& each : piercings_) {
    pierces[each.cloth] = true;
  }
  return pierces;
}

void MeshSearch::markPenetrating(const ClothInBody& cloth) {
  pierces_ = pierces(cloth.triangles.size());
  penetrating_ = pierces_;
  besidePenetrating_.assign(cloth.start.size(), false);
  if (piercings_.empty() && cloth.overlap == nullptr) {
    return;
  }
  for (std::size_t t = 0; t < cloth.triangles.size(); ++t) {
    const Triangle& corners = cloth.triangles[t];
    penetrating_[t] = penetrating_[t] ||
                      (cloth.overlap != nullptr &&
                       std::any_of(corners.begin(), corners.end(), [&](int v) { return cloth.overlap->inside(v); }));
    for (const int v : corners) {
      besidePenetrating_[v] = besidePenetrating_[v] || penetrating_[t];
    }
  }
}

/// Reuses the known piercings of a penetrating triangle, which has no planes. Returns false if they are not known.
bool MeshSearch::keepKnownPiercings(const MeshInStep& mesh, int triangle, PlaneSearch& planes) const {
  if (!piercingsKnown_ || !penetrating_[triangle] || !mesh.mesh.closed) {
    return false;
  }
  for (std::size_t i = firstPiercing_[triangle]; i < piercings_.size() && piercings_[i].cloth == triangle; ++i) {
    planes.addPiercing(piercings_[i]);
  }
  return true;
}

/// Counts overlaps that can be resolved. Pinned vertices, and triangles that pierce the mesh next to them, do not
/// count.
void MeshSearch::countOverlaps(const ClothInBody& cloth, Candidates& candidates) const {
  if (piercings_.empty() && cloth.overlap == nullptr) {
    return;
  }
  const auto movesInside = [&](int v) {
    return cloth.overlap != nullptr && cloth.overlap->inside(v) && cloth.inverseMass[v] > 0.0;
  };
  for (std::size_t t = 0; t < cloth.triangles.size(); ++t) {
    const Triangle& corners = cloth.triangles[t];
    const bool counts =
        std::any_of(corners.begin(), corners.end(), movesInside) ||
        (pierces_[t] && std::all_of(corners.begin(), corners.end(), [&](int v) { return cloth.inverseMass[v] > 0.0; }));
    candidates.overlaps += penetrating_[t] && counts ? 1 : 0;
  }
  for (std::size_t v = 0; v < cloth.start.size() && cloth.overlap != nullptr; ++v) {
    if (movesInside(static_cast<int>(v))) {
      candidates.deepestOverlap = std::max(candidates.deepestOverlap, cloth.overlap->depthOf(static_cast<int>(v)));
    }
  }
}

/// Adds recovery contacts for triangles that pierce the mesh. Vertices inside have their own exits.
void MeshSearch::addRecoveryContacts(const ConstraintBuilder& builder, const MeshInStep& mesh, const ClothInBody& cloth,
                                     Candidates& candidates) const {
  for (std::size_t i = 0; i < piercings_.size();) {
    const std::size_t first = i;
    while (i < piercings_.size() && piercings_[i].cloth == piercings_[first].cloth) {
      ++i;
    }
    if (mesh.mesh.closed) {
      addContactAcrossTriangle(builder, mesh, cloth, first, i, candidates);
    } else {
      for (std::size_t k = first; k < i; ++k) {
        addContactToFront(builder, mesh, cloth, piercings_[k], candidates);
      }
    }
  }
}

/// A triangle whose corners are all outside is pierced by an edge or a tip of the body. It moves along its own normal,
/// to the side that the pierced faces of the body face; to its front if that is undecided.
void MeshSearch::addContactAcrossTriangle(const ConstraintBuilder& builder, const MeshInStep& mesh,
                                          const ClothInBody& cloth, std::size_t first, std::size_t last,
                                          Candidates& candidates) const {
  const int t = piercings_[first].cloth;
  const Triangle& corners = cloth.triangles[t];
  if (cloth.overlap != nullptr &&
      std::any_of(corners.begin(), corners.end(), [&](int v) { return cloth.overlap->inside(v); })) {
    return;
  }
  const Corners start = cornersOf(cloth.start, corners);
  const Vec3 front = faceNormal(start);
  double facing = 0.0;
  for (std::size_t i = first; i < last; ++i) {
    facing += front.dot(faceNormal(mesh.corners(piercings_[i].body)));
  }
  constexpr double undecided = 1e-3;  // threshold of the sum of cosines [-]
  const Vec3 normal = facing < -undecided ? Vec3(-front) : front;
  const Vec3 middle = (start[0] + start[1] + start[2]) / 3.0;
  const Vec3 from = middle + builder.offsets().contactOffset * normal;
  const auto v = static_cast<int>(corners[0]);
  const NearPoint near{-builder.offsets().contactOffset, normal, from, from + bodyDisplacementAt(mesh, v)};
  builder.addContact(cloth, t, Vec3::Constant(1.0 / 3.0), near, builder.offsets().contactOffset, candidates);
}

/// Recovery from an open mesh: a triangle that pierces one of its faces moves to the front of that face.
void MeshSearch::addContactToFront(const ConstraintBuilder& builder, const MeshInStep& mesh, const ClothInBody& cloth,
                                   const Piercing& piercing, Candidates& candidates) const {
  const int t = piercing.cloth;
  const Corners start = cornersOf(cloth.start, cloth.triangles[t]);
  const Corners at = mesh.corners(piercing.body);
  const Vec3 face = faceNormal(mesh.endCorners(piercing.body));
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 weights = nearestOnTriangle(start[k], at);
    const double depth = face.dot(start[k] - at[0]);
    candidates.deepestOverlap =
        std::max(candidates.deepestOverlap, std::min(-depth, (start[k] - pointAt(at, weights)).norm()));
    if (depth < builder.offsets().contactOffset) {
      const NearPoint near{depth, face, pointAt(mesh.startCorners(piercing.body), weights),
                           pointAt(mesh.endCorners(piercing.body), weights)};
      builder.addContact(cloth, t, onCorner(k), near, builder.offsets().contactOffset, candidates);
    }
  }
}

/// Adds planes for vertices at an overlap: those inside must not move deeper, those outside must not move in. Planes
/// that separate whole triangles would keep them where they are.
void MeshSearch::addPlanesAtOverlap(const ConstraintBuilder& builder, const MeshInStep& mesh, const ClothInBody& cloth,
                                    Candidates& candidates) const {
  for (std::size_t v = 0; v < cloth.start.size(); ++v) {
    if (!besidePenetrating_[v]) {
      continue;
    }
    const auto vertex = static_cast<int>(v);
    if (cloth.overlap->inside(vertex)) {
      const NearPoint& exit = cloth.overlap->exitOf(vertex);
      builder.addPlane(vertex, exit.normal, exit.normal.dot(exit.endPoint), exit.gap, candidates);
    } else if (nearest_[v].triangle >= 0) {
      const NearPoint near = pointOf(mesh, nearest_[v]);
      builder.addPlane(vertex, near.normal, near.normal.dot(near.endPoint), near.gap, candidates);
    }
  }
}

}  // namespace drape::sim::contact
