#pragma once

#include "sim/model/cloth_model.hpp"

#include <span>
#include <vector>

namespace drape::sim::contact {

/// A partition of the triangles of a cloth into clusters of up to 8 triangles that are close together at rest. The
/// broad phase culls whole clusters.
class ClothClusters {
 public:
  explicit ClothClusters(const ClothModel& model);

  [[nodiscard]] std::size_t count() const { return triangleBegin_.size() - 1; }
  [[nodiscard]] std::span<const int> triangles(std::size_t cluster) const {
    return part(triangles_, triangleBegin_[cluster], triangleBegin_[cluster + 1]);
  }
  /// All vertices of its triangles.
  [[nodiscard]] std::span<const int> vertices(std::size_t cluster) const {
    return part(vertices_, vertexBegin_[cluster], vertexBegin_[cluster + 1]);
  }
  /// The vertices of a cluster that belong to no earlier cluster, so that a loop over all clusters visits each vertex
  /// once.
  [[nodiscard]] std::span<const int> ownVertices(std::size_t cluster) const {
    return part(vertices_, vertexBegin_[cluster], ownEnd_[cluster]);
  }

  /// The range of clusters (first, one past the last) whose first triangle is in begin to end - 1, if triangles are
  /// counted cluster by cluster. It turns a division of a loop over triangles among threads into one over clusters.
  [[nodiscard]] std::pair<std::size_t, std::size_t> clustersWithin(int begin, int end) const;

 private:
  static std::span<const int> part(const std::vector<int>& all, int begin, int end) {
    return {all.data() + begin, static_cast<std::size_t>(end - begin)};
  }

  std::vector<int> triangles_;
  std::vector<int> triangleBegin_{0};
  std::vector<int> vertices_;
  std::vector<int> vertexBegin_{0};
  std::vector<int> ownEnd_;
};

}  // namespace drape::sim::contact
