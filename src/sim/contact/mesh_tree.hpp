#pragma once

#include "sim/contact/closest_points.hpp"
#include "sim/vector.hpp"

#include <span>
#include <vector>

namespace drape {

/// A tree of boxes over the triangles of a mesh, so that those near a place are found without looking at all.
class MeshTree {
 public:
  /// Splits at the median of the longest side, so that the same mesh gives the same tree.
  MeshTree(std::span<const Vec3> positions, std::span<const Triangle> triangles);

  /// Fits the boxes around the triangles at both positions (of a mesh that moves in itself).
  void refit(std::span<const Vec3> before, std::span<const Vec3> after, std::span<const Triangle> triangles);

  [[nodiscard]] const Eigen::AlignedBox3d& bounds() const { return nodes_.front().box; }

  /// Calls visit(triangle) for every triangle whose box meets `box`, always in the same order.
  template <typename Visit>
  void forEachIn(const Eigen::AlignedBox3d& box, Visit&& visit) const {
    for (std::size_t at = 0; at < nodes_.size();) {
      const Node& node = nodes_[at];
      if (!node.box.intersects(box)) {
        at = node.next;
        continue;
      }
      for (std::size_t i = node.begin; i < node.end; ++i) {
        visit(order_[i]);
      }
      ++at;
    }
  }

 private:
  struct Node {
    Eigen::AlignedBox3d box;
    std::size_t next = 0;   // where to go on when the box is not met; a node's children follow it
    std::size_t begin = 0;  // of a leaf's triangles in order_
    std::size_t end = 0;
  };

  void build(std::vector<Vec3>& middles, std::size_t begin, std::size_t end);

  std::vector<Node> nodes_;
  std::vector<int> order_;
};

}  // namespace drape
