// What MeshSearch does about cloth that is inside a mesh or pierces it.
#include "sim/contact/constraints/mesh_search.hpp"
#include "sim/contact/recovery/overlap.hpp"

#include <algorithm>

namespace drape {

std::vector<bool> MeshSearch::pierces(std::size_t triangles) const {
  std::vector<bool> pierces(triangles, false);
  for (const Piercing& each : piercings_) {
    pierces[static_cast<std::size_t>(each.cloth)] = true;
  }
  return pierces;
}

void MeshSearch::markCaught(const ClothInBody& cloth) {
  pierces_ = pierces(cloth.triangles.size());
  caught_ = pierces_;
  beside_.assign(cloth.base.size(), false);
  if (piercings_.empty() && cloth.overlap == nullptr) {
    return;
  }
  for (std::size_t t = 0; t < cloth.triangles.size(); ++t) {
    const Triangle& corners = cloth.triangles[t];
    caught_[t] = caught_[t] || (cloth.overlap != nullptr && std::any_of(corners.begin(), corners.end(), [&](int v) {
                                  return cloth.overlap->inside(v);
                                }));
    for (const int v : corners) {
      beside_[static_cast<std::size_t>(v)] = beside_[static_cast<std::size_t>(v)] || caught_[t];
    }
  }
}

/// Spares a caught triangle another search: it has no planes, and what it pierces at the base is known.
bool MeshSearch::keepPiercings(const MeshInStep& mesh, int triangle, PlaneSearch& planes) const {
  const auto t = static_cast<std::size_t>(triangle);
  if (!piercingsKnown_ || !caught_[t] || !mesh.mesh.closed) {
    return false;
  }
  for (std::size_t i = firstPiercing_[t]; i < piercings_.size() && piercings_[i].cloth == triangle; ++i) {
    planes.keep(piercings_[i]);
  }
  return true;
}

/// Counts what could come out: pins stay where they are, and what hangs on them with them.
void MeshSearch::countOverlaps(const ClothInBody& cloth, Findings& findings) const {
  if (piercings_.empty() && cloth.overlap == nullptr) {
    return;
  }
  const auto movesInside = [&](int v) {
    return cloth.overlap != nullptr && cloth.overlap->inside(v) && cloth.inverseMass[static_cast<std::size_t>(v)] > 0.0;
  };
  for (std::size_t t = 0; t < cloth.triangles.size(); ++t) {
    const Triangle& corners = cloth.triangles[t];
    const bool counts = std::any_of(corners.begin(), corners.end(), movesInside) ||
                        (pierces_[t] && std::all_of(corners.begin(), corners.end(), [&](int v) {
                           return cloth.inverseMass[static_cast<std::size_t>(v)] > 0.0;
                         }));
    findings.overlaps += caught_[t] && counts ? 1 : 0;
  }
  for (std::size_t v = 0; v < cloth.base.size() && cloth.overlap != nullptr; ++v) {
    if (movesInside(static_cast<int>(v))) {
      findings.deepestOverlap = std::max(findings.deepestOverlap, cloth.overlap->depthOf(static_cast<int>(v)));
    }
  }
}

/// Lets what pierces the mesh out, slowly. Vertices that are inside know their own way.
void MeshSearch::pushOff(const BodySide& side, const MeshInStep& mesh, const ClothInBody& cloth,
                         Findings& findings) const {
  for (std::size_t i = 0; i < piercings_.size();) {
    const std::size_t first = i;
    while (i < piercings_.size() && piercings_[i].cloth == piercings_[first].cloth) {
      ++i;
    }
    if (mesh.mesh.closed) {
      pushAcross(side, mesh, cloth, first, i, findings);
    } else {
      for (std::size_t k = first; k < i; ++k) {
        pushToFront(side, mesh, cloth, piercings_[k], findings);
      }
    }
  }
}

/// A triangle whose corners are all outside is pierced by an edge or a tip: it goes across itself to the side where
/// the body faces there, and towards its front where that cannot be told.
void MeshSearch::pushAcross(const BodySide& side, const MeshInStep& mesh, const ClothInBody& cloth, std::size_t first,
                            std::size_t last, Findings& findings) const {
  const auto t = static_cast<std::size_t>(piercings_[first].cloth);
  const Triangle& corners = cloth.triangles[t];
  if (cloth.overlap != nullptr &&
      std::any_of(corners.begin(), corners.end(), [&](int v) { return cloth.overlap->inside(v); })) {
    return;
  }
  const Corners base = cornersOf(cloth.base, corners);
  const Vec3 front = faceNormal(base);
  double facing = 0.0;
  for (std::size_t i = first; i < last; ++i) {
    facing += front.dot(faceNormal(mesh.base(piercings_[i].body)));
  }
  constexpr double undecided = 1e-3;  // [-]
  const Vec3 normal = facing < -undecided ? Vec3(-front) : front;
  const Vec3 middle = (base[0] + base[1] + base[2]) / 3.0;
  const Vec3 from = middle + side.reach().keep * normal;
  const auto v = static_cast<int>(corners[0]);
  const NearPoint near{-side.reach().keep, normal, from, from + moveAt(mesh, v)};
  side.addTouch(cloth, t, Vec3::Constant(1.0 / 3.0), near, side.reach().keep, findings);
}

/// Of a mesh without an inside: what pierces one of its triangles goes out along that one's normal.
void MeshSearch::pushToFront(const BodySide& side, const MeshInStep& mesh, const ClothInBody& cloth,
                             const Piercing& piercing, Findings& findings) const {
  const auto t = static_cast<std::size_t>(piercing.cloth);
  const Corners base = cornersOf(cloth.base, cloth.triangles[t]);
  const Corners at = mesh.base(piercing.body);
  const Vec3 face = faceNormal(mesh.end(piercing.body));
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 weights = nearestOnTriangle(base[k], at);
    const double depth = face.dot(base[k] - at[0]);
    findings.deepestOverlap =
        std::max(findings.deepestOverlap, std::min(-depth, (base[k] - pointAt(at, weights)).norm()));
    if (depth < side.reach().keep) {
      const NearPoint near{depth, face, pointAt(mesh.start(piercing.body), weights),
                           pointAt(mesh.end(piercing.body), weights)};
      side.addTouch(cloth, t, onCorner(k), near, side.reach().keep, findings);
    }
  }
}

/// What is inside may come out and go no deeper; what is outside beside it may not go in. Planes around triangles would
/// hold them where they are.
void MeshSearch::holdCaught(const BodySide& side, const MeshInStep& mesh, const ClothInBody& cloth,
                            Findings& findings) const {
  for (std::size_t v = 0; v < cloth.base.size(); ++v) {
    if (!beside_[v]) {
      continue;
    }
    const auto vertex = static_cast<int>(v);
    if (cloth.overlap->inside(vertex)) {
      const NearPoint& exit = cloth.overlap->exitOf(vertex);
      side.addBarrier(vertex, exit.normal, exit.normal.dot(exit.endPoint), exit.gap, findings);
    } else if (nearest_[v].triangle >= 0) {
      const NearPoint near = pointOf(mesh, nearest_[v]);
      side.addBarrier(vertex, near.normal, near.normal.dot(near.endPoint), near.gap, findings);
    }
  }
}

}  // namespace drape
