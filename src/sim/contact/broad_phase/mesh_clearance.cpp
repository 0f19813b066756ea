#include "sim/contact/broad_phase/mesh_clearance.hpp"

#include "sim/contact/closest_features/mesh_in_step.hpp"
#include "sim/contact/closest_features/nearest_search.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace drape::sim::contact {
namespace {

/// Slacks that are tried first [m]: if no leaf of the mesh is within the slack and the required distance, the cluster
/// has this slack.
constexpr std::array wideSlacks{0.16, 0.04};
constexpr double narrowSlack = 0.01;  // maximum slack of clusters with closer leaves [m]

bool isPinned(const ClothModel& model, int vertex) {
  return model.pinned[vertex];
}

bool isPinned(const ClothModel& model, const Triangle& triangle) {
  return std::all_of(triangle.begin(), triangle.end(), [&](int v) { return isPinned(model, v); });
}

Eigen::AlignedBox3d boxOf(std::span<const int> vertices, std::span<const Vec3> positions) {
  Eigen::AlignedBox3d box;
  for (const int v : vertices) {
    box.extend(vectorAt(positions, v));
  }
  return box;
}

bool hasLeaf(const MeshTree& tree, const Eigen::AlignedBox3d& box) {
  bool any = false;
  tree.forEachLeafIn(box, [&](std::size_t) { any = true; });
  return any;
}

/// Gap between two intervals; negative: they overlap.
double gapBetween(double low, double high, const Extent& other) {
  return std::max(low - other.high, other.low - high);
}

/// Maximum squared displacement of a cluster's vertices from `reference` [m^2].
double squaredMove(std::span<const int> vertices, std::span<const Vec3> positions, const std::vector<Vec3>& reference) {
  double maximum = 0.0;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    maximum = std::max(maximum, (vectorAt(positions, vertices[i]) - reference[i]).squaredNorm());
  }
  return maximum;
}

}  // namespace

/// The slack of a cluster at its start [m]; negative: a triangle of it is already too close. The gap along any
/// direction is a lower bound of the distance of a triangle and a leaf. Two directions are tried besides the axes: the
/// normal of the triangle, and the offset between the middles of both.
double MeshClearance::slackOf(const SearchableMesh& mesh, const ClothMotion& motion, std::size_t cluster,
                              double distance) {
  const Eigen::AlignedBox3d box = boxOf(motion.clusters.vertices(cluster), motion.start);
  for (const double slack : wideSlacks) {
    if (!hasLeaf(mesh.tree, inflated(box, distance + slack))) {
      return slack;
    }
  }
  leaves_.clear();
  mesh.tree.forEachLeafIn(inflated(box, distance + narrowSlack),
                          [&](std::size_t leaf) { leaves_.push_back(static_cast<std::int32_t>(leaf)); });
  double slack = narrowSlack;
  leaf_.resize(1);
  for (const int t : motion.clusters.triangles(cluster)) {
    const Triangle& triangle = motion.model.triangles[t];
    if (isPinned(motion.model, triangle)) {
      continue;
    }
    const Corners corners = cornersOf(motion.start, triangle);
    const Eigen::AlignedBox3d around = boxAround(corners);
    const Vec3 middle = (corners[0] + corners[1] + corners[2]) / 3.0;
    for (const std::int32_t leaf : leaves_) {
      const Eigen::AlignedBox3d& leafBounds = mesh.tree.leafBox(static_cast<std::size_t>(leaf));
      double gap = around.exteriorDistance(leafBounds);
      leaf_[0] = leaf;
      for (const Vec3& direction : {faceNormal(corners), Vec3((middle - leafBounds.center()).normalized())}) {
        if (gap < distance + slack) {
          gap = std::max(gap, gapBetween(lowestAlong(direction, corners), highestAlong(direction, corners),
                                         mesh.extentsAlong(direction, leaf_, false, extents_)));
        }
      }
      slack = std::min(slack, gap - distance);
      if (slack < 0.0) {
        return slack;
      }
    }
  }
  return slack;
}

/// Forgets what is known of another cloth or distance.
void MeshClearance::prepare(const ClothMotion& motion, double distance, std::uint64_t models) {
  if (models != models_ || distance != distance_ || known_.size() != motion.clusters.count()) {
    known_.assign(motion.clusters.count(), {});
    models_ = models;
    distance_ = distance;
  }
}

bool MeshClearance::clusterCouldMeet(const SearchableMesh& mesh, const ClothMotion& motion, std::size_t cluster) {
  const std::span<const int> vertices = motion.clusters.vertices(cluster);
  Known& known = known_[cluster];
  const auto isWithin = [&] {
    const double squared = known.slack * known.slack;
    return known.slack >= 0.0 && squaredMove(vertices, motion.start, known.reference) <= squared &&
           squaredMove(vertices, motion.end, known.reference) <= squared;
  };
  if (isWithin()) {
    return false;
  }
  known.reference.clear();
  for (const int v : vertices) {
    known.reference.push_back(vectorAt(motion.start, v));
  }
  known.slack = slackOf(mesh, motion, cluster, distance_);
  if (isWithin()) {
    return false;
  }
  lastCluster_ = cluster;
  return true;
}

bool MeshClearance::couldMeet(const SearchableMesh& mesh, const ClothMotion& motion, double distance,
                              std::uint64_t models) {
  prepare(motion, distance, models);
  for (std::size_t c = 0; c < known_.size(); ++c) {
    if (clusterCouldMeet(mesh, motion, c)) {
      return true;
    }
  }
  return false;
}

bool MeshClearance::couldMeet(const SearchableMesh& mesh, const ClothMotion& motion, double distance,
                              std::uint64_t models, std::size_t cluster) {
  prepare(motion, distance, models);
  return clusterCouldMeet(mesh, motion, cluster);
}

bool freeClothIsNear(const SearchableMesh& mesh, const ClothMotion& motion, double far, std::size_t cluster) {
  const MeshInStep inStep{mesh, mesh.shape.positions, mesh.shape.positions};
  NearestSearch nearest(inStep);
  const auto isNear = [&](int v) {
    const Vec3& end = vectorAt(motion.end, v);
    const double radius = far + (end - vectorAt(motion.start, v)).norm();
    return !isPinned(motion.model, v) && nearest.anywhere(end, radius).triangle >= 0;
  };
  const std::span<const int> vertices = motion.clusters.vertices(cluster);
  const Eigen::AlignedBox3d box = boxOf(vertices, motion.start).merged(boxOf(vertices, motion.end));
  return hasLeaf(mesh.tree, inflated(box, far)) && std::any_of(vertices.begin(), vertices.end(), isNear);
}

bool anyFreeClothIsNear(const SearchableMesh& mesh, const ClothMotion& motion, double far, std::size_t& nearCluster) {
  for (std::size_t c = 0; c < motion.clusters.count(); ++c) {
    if (freeClothIsNear(mesh, motion, far, c)) {
      nearCluster = c;
      return true;
    }
  }
  return false;
}

}  // namespace drape::sim::contact
