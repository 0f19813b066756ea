#include "sim/contact/mesh_search.hpp"

#include "sim/contact/nearest_search.hpp"
#include "sim/contact/sharp_search.hpp"

#include <algorithm>
#include <mutex>
#include <utility>

namespace drape {
namespace {

constexpr double listed = 2.0;      // of the distance that is kept: patches that near to a cluster are listed [-]
constexpr double closeShare = 0.2;  // of it: how much nearer than they may edges and faces come in a pass, at most [-]

void listPatches(const MeshTree& tree, const Eigen::AlignedBox3d& box, std::vector<int>& patches) {
  patches.clear();
  tree.forEachLeafIn(box, [&](std::size_t leaf) { patches.push_back(static_cast<int>(leaf)); });
}

NearPoint pointOf(const MeshInStep& mesh, const NearVertex& near) {
  return {near.gap, near.normal, pointAt(mesh.start(near.triangle), near.weights),
          pointAt(mesh.end(near.triangle), near.weights)};
}

/// What a thread found in its part of the clusters.
template <typename More>
struct Part {
  int begin = 0;
  Findings found;
  std::vector<More> more;
};

/// Calls visit(first cluster, last cluster, part) on pieces of the clusters, and collects the parts in their order,
/// whoever was first: the result must not depend on the threads.
template <typename More, typename Visit>
std::vector<Part<More>> inParts(const ClothClusters& clusters, Workers& workers, int threads, std::size_t triangles,
                                Visit&& visit) {
  std::mutex mutex;
  std::vector<Part<More>> parts;
  workers.forRange(threads, static_cast<int>(triangles), [&](int begin, int end) {
    Part<More> part;
    part.begin = begin;
    const auto [first, last] = clusters.clustersWithin(begin, end);
    visit(first, last, part);
    const std::lock_guard lock(mutex);
    parts.push_back(std::move(part));
  });
  std::sort(parts.begin(), parts.end(), [](const auto& x, const auto& y) { return x.begin < y.begin; });
  return parts;
}

}  // namespace

/// What is near a cluster.
class MeshSearch::Near {
 public:
  Near(const BodySide& side, const MeshInStep& mesh, const ClothInBody& cloth)
      : side_(side), mesh_(mesh), cloth_(cloth), nearest_(mesh), radius_(listed * side.reach().keep) {}

  /// Lists the patches within the radius.
  void list(std::span<const int> vertices, std::vector<int>& patches) {
    Eigen::AlignedBox3d box;
    for (const int v : vertices) {
      box.extend(vectorAt(cloth_.base, v));
    }
    listPatches(mesh_.mesh.tree, inflated(box, radius_), patches);
    patchBoxes_.clear();
    triangles_.clear();
    triangleBoxes_.clear();
    for (const int patch : patches) {
      const auto leaf = static_cast<std::size_t>(patch);
      patchBoxes_.add(mesh_.mesh.tree.leafBox(leaf));
      for (const int triangle : mesh_.mesh.tree.leaf(leaf)) {
        triangles_.push_back(triangle);
        triangleBoxes_.add(boxAround(mesh_.base(triangle)));
      }
    }
  }

  /// The mesh's point that is nearest to a vertex, as far as that is about to go.
  NearVertex nearestTo(int vertex) {
    const Vec3& point = vectorAt(cloth_.base, vertex);
    const NearVertex found = nearest_.among(triangles_, triangleBoxes_, point, radius_);
    const double radius = cloth_.room[static_cast<std::size_t>(vertex)] - side_.reach().keep;
    return found.triangle < 0 && radius > radius_ ? nearest_.anywhere(point, radius) : found;
  }

  [[nodiscard]] const BoxList& patchBoxes() const { return patchBoxes_; }

 private:
  const BodySide& side_;
  const MeshInStep& mesh_;
  const ClothInBody& cloth_;
  NearestSearch nearest_;
  double radius_;  // [m]
  BoxList patchBoxes_;
  std::vector<int> triangles_;
  BoxList triangleBoxes_;
};

void MeshSearch::findTouches(const BodySide& side, const MeshInStep& mesh, const ClothInBody& cloth,
                             const ClothClusters& clusters, Workers& workers, int threads, Findings& findings) {
  patches_.resize(clusters.count());
  nearest_.assign(cloth.base.size(), {});
  pierces_.assign(cloth.triangles.size(), false);
  caught_.assign(cloth.base.size(), false);
  for (const Piercing& each : piercings_) {
    pierces_[static_cast<std::size_t>(each.cloth)] = true;
    for (const int v : cloth.triangles[static_cast<std::size_t>(each.cloth)]) {
      caught_[static_cast<std::size_t>(v)] = true;
    }
  }
  planes_.assign(cloth.triangles.size(), {});
  const double near = listed * side.reach().keep;
  const double close = side.reach().inner + closeShare * side.reach().keep;
  const auto parts = inParts<int>(clusters, workers, threads, cloth.triangles.size(),
                                  [&](std::size_t first, std::size_t last, Part<int>& part) {
                                    Near here(side, mesh, cloth);
                                    SharpSearch sharp(side, mesh, cloth, close, near, part.found);
                                    for (std::size_t c = first; c < last; ++c) {
                                      here.list(clusters.vertices(c), patches_[c]);
                                      for (const int v : clusters.ownVertices(c)) {
                                        nearest_[static_cast<std::size_t>(v)] = here.nearestTo(v);
                                      }
                                      for (const int each : clusters.triangles(c)) {
                                        const auto t = static_cast<std::size_t>(each);
                                        if (!patches_[c].empty() && !pierces_[t]) {
                                          planes_[t] = sharp.look(each, patches_[c], here.patchBoxes());
                                        }
                                      }
                                    }
                                  });
  for (const auto& part : parts) {
    findings.append(part.found);
  }
  pushOut(side, mesh, cloth, findings);
  touchVertices(side, mesh, cloth, findings);
}

void MeshSearch::touchVertices(const BodySide& side, const MeshInStep& mesh, const ClothInBody& cloth,
                               Findings& findings) const {
  for (std::size_t t = 0; t < cloth.triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto v = static_cast<std::size_t>(cloth.triangles[t][k]);
      const NearVertex& near = nearest_[v];
      if (!cloth.owned[t].corners[k] || near.triangle < 0) {
        continue;
      }
      // What has pierced the body and is behind it must not be held there.
      if (!caught_[v] || faceNormal(mesh.base(near.triangle)).dot(near.normal) > 0.0) {
        side.addTouch(cloth, t, onCorner(k), pointOf(mesh, near), side.reach().keep, findings);
      }
    }
  }
}

/// What pierces a triangle of the body goes out along its normal, slowly.
void MeshSearch::pushOut(const BodySide& side, const MeshInStep& mesh, const ClothInBody& cloth,
                         Findings& findings) const {
  for (std::size_t i = 0; i < piercings_.size(); ++i) {
    const auto t = static_cast<std::size_t>(piercings_[i].cloth);
    findings.overlaps += i == 0 || piercings_[i - 1].cloth != piercings_[i].cloth ? 1 : 0;
    const Corners base = cornersOf(cloth.base, cloth.triangles[t]);
    const Corners at = mesh.base(piercings_[i].body);
    const Vec3 face = faceNormal(mesh.end(piercings_[i].body));
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 weights = nearestOnTriangle(base[k], at);
      const double depth = face.dot(base[k] - at[0]);
      findings.deepestOverlap =
          std::max(findings.deepestOverlap, std::min(-depth, (base[k] - pointAt(at, weights)).norm()));
      if (depth < side.reach().keep) {
        const NearPoint near{depth, face, pointAt(mesh.start(piercings_[i].body), weights),
                             pointAt(mesh.end(piercings_[i].body), weights)};
        side.addTouch(cloth, t, onCorner(k), near, side.reach().keep, findings);
      }
    }
  }
}

bool MeshSearch::findPlanes(const BodySide& side, const MeshInStep& mesh, const ClothInBody& cloth,
                            const ClothClusters& clusters, Workers& workers, int threads, Findings& findings) {
  const auto parts =
      inParts<Piercing>(clusters, workers, threads, cloth.triangles.size(),
                        [&](std::size_t first, std::size_t last, Part<Piercing>& part) {
                          PlaneSearch planes(side, mesh, cloth, nearest_, part.found);
                          std::vector<int> wider;
                          for (std::size_t c = first; c < last; ++c) {
                            double far = 0.0;
                            Eigen::AlignedBox3d box;
                            for (const int v : clusters.vertices(c)) {
                              far = std::max(far, cloth.room[static_cast<std::size_t>(v)] + side.reach().guard);
                              box.extend(vectorAt(cloth.base, v));
                            }
                            const bool wide = far > listed * side.reach().keep;
                            if (wide) {
                              listPatches(mesh.mesh.tree, inflated(box, far), wider);
                            }
                            const std::vector<int>& patches = wide ? wider : patches_[c];
                            for (const int t : clusters.triangles(c)) {
                              if (!patches.empty()) {
                                planes.look(t, wide ? OwnPlane() : planes_[static_cast<std::size_t>(t)], patches);
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
  const bool news = piercings.size() != piercings_.size();
  piercings_.swap(piercings);
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
