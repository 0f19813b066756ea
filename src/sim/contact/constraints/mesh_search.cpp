#include "sim/contact/constraints/mesh_search.hpp"

#include "sim/contact/constraints/collect_in_order.hpp"
#include "sim/contact/closest_features/nearest_search.hpp"
#include "sim/contact/recovery/overlap.hpp"
#include "sim/contact/constraints/sharp_feature_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace drape {
namespace {

constexpr double listed = 2.0;     // of the distance that is kept: patches that near to a cluster are listed [-]
constexpr double spare = 1.0;      // of it: how much farther away what is listed may be [-]
constexpr double known = 0.15;     // of it: how far a cluster may move before distances are found anew [-]
constexpr double rounding = 1e-9;  // [m]
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double closeShare = 0.2;  // of it: how much nearer than they may edges and faces come in a pass, at most [-]

/// How near edges and faces have to be for touches to be looked for [m].
double closeBy(const ContactReach& reach) {
  return reach.inner + closeShare * reach.keep;
}

/// What a thread found in its part of the clusters.
template <typename More>
struct Part {
  Findings found;
  std::vector<More> more;
};

/// Calls visit(first cluster, last cluster, part) on pieces of the clusters, and collects the parts in their order.
template <typename More, typename Visit>
std::vector<Part<More>> inParts(const ClothClusters& clusters, Workers& workers, int threads, std::size_t triangles,
                                Visit&& visit) {
  return foundInOrder<Part<More>>(workers, threads, static_cast<int>(triangles),
                                  [&](int begin, int end, Part<More>& part) {
                                    const auto [first, last] = clusters.clustersWithin(begin, end);
                                    visit(first, last, part);
                                  });
}

}  // namespace

void MeshSearch::begin(const SearchableMesh& mesh, std::uint64_t model) {
  piercings_.clear();
  piercingsKnown_ = false;
  asked_.clear();
  if (mesh_ != &mesh || model_ != model) {
    nearby_.clear();
    near_.clear();
    outwards_.clear();
    mesh_ = &mesh;
    model_ = model;
  }
}

void MeshSearch::Nearby::list(const MeshTree& tree, const Eigen::AlignedBox3d& box) {
  covered = box;
  patches.clear();
  boxes.clear();
  tree.forEachLeafIn(box, [&](std::size_t leaf) {
    patches.push_back(static_cast<int>(leaf));
    boxes.add(tree.leafBox(leaf));
  });
}

/// Looks at what is near a cluster.
class MeshSearch::Near {
 public:
  Near(const BodySide& side, const MeshInStep& mesh, const ClothInBody& cloth)
      : side_(side), mesh_(mesh), cloth_(cloth), nearest_(mesh), radius_(listed * side.reach().keep) {}

  /// Lists the patches within the radius, when those that are listed may not do any more.
  /// Says how far the cluster has moved since its distances were found, and remembers it when they have to be found
  /// anew.
  void list(std::span<const int> vertices, Nearby& nearby) const {
    Eigen::AlignedBox3d box;
    double squared = nearby.reference.size() == vertices.size() ? 0.0 : infinity;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      const Vec3& base = vectorAt(cloth_.base, vertices[i]);
      box.extend(base);
      if (squared < infinity) {
        squared = std::max(squared, (base - nearby.reference[i]).squaredNorm());
      }
    }
    box = inflated(box, radius_);
    if (mesh_.mesh.movesInItself()) {
      nearby.list(mesh_.mesh.tree, box);
    } else if (!nearby.covered.contains(box)) {
      nearby.list(mesh_.mesh.tree, inflated(box, spare * side_.reach().keep));
    }
    nearby.moved = std::sqrt(squared) + rounding;
    if (mesh_.mesh.movesInItself() || !(nearby.moved <= known * side_.reach().keep)) {
      double moved = nearby.moved;
      if (mesh_.mesh.movesInItself()) {
        moved = infinity;
      }
      for (double& distance : nearby.distances) {
        distance -= moved;
      }
      nearby.moved = 0.0;
      nearby.reference.clear();
      for (const int v : vertices) {
        nearby.reference.push_back(vectorAt(cloth_.base, v));
      }
    }
  }

  /// The mesh's point that is nearest to a vertex, as far as that is about to go.
  NearVertex nearestTo(int vertex, const Nearby& nearby, NearbyTriangles& memory) {
    const Vec3& point = vectorAt(cloth_.base, vertex);
    const double radius = cloth_.room[static_cast<std::size_t>(vertex)] - side_.reach().keep;
    if (mesh_.mesh.movesInItself() || cloth_.overlap != nullptr) {
      NearVertex found = nearest_.among(nearby.patches, nearby.boxes, point, radius_);
      return found.triangle < 0 && radius > radius_ ? nearest_.anywhere(point, radius) : found;
    }
    const double moved = (point - memory.at).norm() + rounding;
    if (memory.clear - moved >= radius) {
      return {};
    }
    if (moved <= memory.serves) {
      return nearest_.amongRemembered(memory, point, radius, moved);
    }
    const double beyond =
        std::min((point - nearby.covered.min()).minCoeff(), (nearby.covered.max() - point).minCoeff());
    const double within = known * side_.reach().keep;
    if (radius + 2.0 * within > beyond) {
      return nearest_.anywhere(point, radius);
    }
    NearVertex found = nearest_.among(nearby.patches, nearby.boxes, point, radius, within);
    nearest_.remember(point, within, beyond, memory);
    return found;
  }

 private:
  const BodySide& side_;
  const MeshInStep& mesh_;
  const ClothInBody& cloth_;
  NearestSearch nearest_;
  double radius_;  // [m]
};

void MeshSearch::findTouches(const BodySide& side, const MeshInStep& mesh, const ClothInBody& cloth,
                             const ClothClusters& clusters, Workers& workers, int threads, Findings& findings) {
  nearby_.resize(clusters.count());
  nearest_.resize(cloth.base.size());
  near_.resize(cloth.base.size());
  markCaught(cloth);
  workers.forRange(threads, static_cast<int>(cloth.triangles.size()), [&](int begin, int end) {
    Near here(side, mesh, cloth);
    const auto [first, last] = clusters.clustersWithin(begin, end);
    for (std::size_t c = first; c < last; ++c) {
      here.list(clusters.vertices(c), nearby_[c]);
      for (const int v : clusters.ownVertices(c)) {
        const auto at = static_cast<std::size_t>(v);
        nearest_[at] = here.nearestTo(v, nearby_[c], near_[at]);
      }
    }
  });
  countOverlaps(cloth, findings);
  pushOff(side, mesh, cloth, findings);
  touchVertices(side, mesh, cloth, findings);
}

void MeshSearch::findSharpTouches(const BodySide& side, const MeshInStep& mesh, const ClothInBody& cloth,
                                  const ClothClusters& clusters, Workers& workers, int threads, Findings& findings) {
  distances_.resize(cloth.triangles.size());
  outwards_.resize(cloth.triangles.size(), Vec3::Zero());
  const double close = closeBy(side.reach());
  const auto parts = inParts<int>(
      clusters, workers, threads, cloth.triangles.size(), [&](std::size_t first, std::size_t last, Part<int>& part) {
        SharpSearch sharp(side, mesh, cloth, nearest_, close, side.reach().keep, part.found);
        for (std::size_t c = first; c < last; ++c) {
          lookAtTriangles(cloth, clusters.triangles(c), nearby_[c], side.reach(), sharp);
        }
      });
  for (const auto& part : parts) {
    findings.append(part.found);
  }
}

/// Looks for what touches the triangles of a cluster, as far as they are not known to be too far away.
/// Distances that are not known are found.
void MeshSearch::lookAtTriangles(const ClothInBody& cloth, std::span<const int> triangles, Nearby& nearby,
                                 const ContactReach& reach, SharpSearch& sharp) {
  nearby.distances.resize(triangles.size(), -infinity);
  if (nearby.patches.empty()) {
    const double near = listed * reach.keep;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      distances_[static_cast<std::size_t>(triangles[i])] = near;
      nearby.distances[i] = std::max(nearby.distances[i], near - nearby.moved);
    }
    return;
  }
  const auto way = [&](int v) { return (vectorAt(cloth.target, v) - vectorAt(cloth.base, v)).squaredNorm(); };
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const auto t = static_cast<std::size_t>(triangles[i]);
    distances_[t] = nearby.distances[i] - nearby.moved;
    if (distances_[t] >= closeBy(reach) || caught_[t]) {
      continue;
    }
    const Triangle& corners = cloth.triangles[t];
    const double longest = std::sqrt(std::max({way(corners[0]), way(corners[1]), way(corners[2])})) + rounding;
    if (distances_[t] >= reach.inner + longest) {
      continue;  // nothing of it is about to come near enough to touch
    }
    distances_[t] =
        std::max(distances_[t], sharp.look(triangles[i], nearby.patches, nearby.boxes, longest, outwards_[t]));
    nearby.distances[i] = std::max(nearby.distances[i], distances_[t] - nearby.moved);
  }
}

void MeshSearch::touchVertices(const BodySide& side, const MeshInStep& mesh, const ClothInBody& cloth,
                               Findings& findings) const {
  for (std::size_t t = 0; t < cloth.triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto v = static_cast<std::size_t>(cloth.triangles[t][k]);
      const NearVertex& near = nearest_[v];
      if (!cloth.owned[t].corners[k]) {
        continue;
      }
      if (cloth.overlap != nullptr && cloth.overlap->inside(cloth.triangles[t][k])) {
        side.addTouch(cloth, t, onCorner(k), cloth.overlap->exitOf(cloth.triangles[t][k]), side.reach().keep, findings);
        continue;
      }
      if (near.triangle < 0) {
        continue;
      }
      // Of a mesh without an inside, what has pierced it and is behind it must not be held there.
      if (mesh.mesh.closed || !beside_[v] || faceNormal(mesh.base(near.triangle)).dot(near.normal) > 0.0) {
        side.addTouch(cloth, t, onCorner(k), pointOf(mesh, near), side.reach().keep, findings);
      }
    }
  }
}

/// The patches that a cluster could reach with the room that its vertices have.
/// @param wider is used where what is listed is not enough
const MeshSearch::Nearby& MeshSearch::asFarAsRoom(const BodySide& side, const MeshInStep& mesh,
                                                  const ClothInBody& cloth, const ClothClusters& clusters,
                                                  std::size_t cluster, Nearby& wider) const {
  double far = 0.0;
  Eigen::AlignedBox3d box;
  for (const int v : clusters.vertices(cluster)) {
    far = std::max(far, cloth.room[static_cast<std::size_t>(v)] + side.reach().guard);
    box.extend(vectorAt(cloth.base, v));
  }
  if (far > listed * side.reach().keep) {
    wider.list(mesh.mesh.tree, inflated(box, far));
    return wider;
  }
  return nearby_[cluster];
}

/// Of one triangle. What is caught in a closed mesh gets none, and is only looked at for what it pierces.
void MeshSearch::findPlanesOf(int triangle, const MeshInStep& mesh, const Nearby& nearby, PlaneSearch& planes,
                              Findings& findings) const {
  const std::size_t before = findings.barriers.size();
  planes.look(triangle, nearby.patches, nearby.boxes);
  if (caught_[static_cast<std::size_t>(triangle)] && mesh.mesh.closed) {
    findings.barriers.resize(before);
  }
}

bool MeshSearch::findPlanes(const BodySide& side, const MeshInStep& mesh, const ClothInBody& cloth,
                            const ClothClusters& clusters, std::span<const double> ways, Workers& workers, int threads,
                            Findings& findings) {
  spared_.assign(cloth.triangles.size(), 0);
  asked_.resize(cloth.triangles.size(), 0);
  const auto spares = [&](std::size_t t) {
    const auto way = [&](std::size_t k) { return ways[static_cast<std::size_t>(cloth.triangles[t][k])]; };
    const double longest = std::max({way(0), way(1), way(2)});
    return !mesh.moves() && asked_[t] == 0 && distances_[t] > longest + side.reach().guard + rounding;
  };
  const auto parts =
      inParts<Piercing>(clusters, workers, threads, cloth.triangles.size(),
                        [&](std::size_t first, std::size_t last, Part<Piercing>& part) {
                          PlaneSearch planes(side, mesh, cloth, nearest_, part.found);
                          Nearby wider;
                          for (std::size_t c = first; c < last; ++c) {
                            const std::span<const int> triangles = clusters.triangles(c);
                            for (const int t : triangles) {
                              spared_[static_cast<std::size_t>(t)] = spares(static_cast<std::size_t>(t)) ? 1 : 0;
                            }
                            const auto isSpared = [&](int t) { return spared_[static_cast<std::size_t>(t)] != 0; };
                            if (std::all_of(triangles.begin(), triangles.end(), isSpared)) {
                              continue;
                            }
                            const Nearby& nearby = asFarAsRoom(side, mesh, cloth, clusters, c, wider);
                            if (nearby.patches.empty()) {
                              continue;
                            }
                            for (const int t : triangles) {
                              if (!isSpared(t) && !keepPiercings(mesh, t, planes)) {
                                findPlanesOf(t, mesh, nearby, planes, part.found);
                              }
                            }
                          }
                          part.more = planes.piercings();
                        });
  std::vector<Piercing> piercings;
  for (const auto& part : parts) {
    findings.append(part.found);
    piercings.insert(piercings.end(), part.more.begin(), part.more.end());
  }
  if (cloth.overlap != nullptr) {
    holdCaught(side, mesh, cloth, findings);
  }
  const bool news = piercings.size() != piercings_.size();
  piercings_.swap(piercings);
  firstPiercing_.assign(cloth.triangles.size(), piercings_.size());
  for (std::size_t i = piercings_.size(); i-- > 0;) {
    firstPiercing_[static_cast<std::size_t>(piercings_[i].cloth)] = i;
  }
  piercingsKnown_ = true;
  return news;
}

bool MeshSearch::askAround(std::span<const Triangle> triangles, const std::vector<bool>& moved) {
  bool news = false;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const bool touched = std::any_of(triangles[t].begin(), triangles[t].end(),
                                     [&](int v) { return moved[static_cast<std::size_t>(v)]; });
    if (touched && spared_[t] != 0) {
      asked_[t] = 1;
      news = true;
    }
  }
  return news;
}

Vec3 MeshSearch::moveAt(const MeshInStep& mesh, int vertex) const {
  const NearVertex& near = nearest_[static_cast<std::size_t>(vertex)];
  if (near.triangle < 0) {
    return Vec3::Zero();
  }
  const NearPoint point = pointOf(mesh, near);
  return point.endPoint - point.startPoint;
}

}  // namespace drape
