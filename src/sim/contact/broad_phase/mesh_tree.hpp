#pragma once

#include "sim/model/vector.hpp"

#include <span>
#include <vector>

namespace drape::sim::contact {

/// A bounding volume hierarchy of axis-aligned boxes over the triangles of a mesh. Each leaf holds a few neighbouring
/// triangles. Leaves are numbered from 0 in the order of the tree.
class MeshTree {
 public:
  /// Splits at the median along the longest side, so that the same mesh gives the same tree.
  /// @param maxTriangles in a leaf
  MeshTree(std::span<const Vec3> positions, std::span<const Triangle> triangles, std::size_t maxTriangles);

  /// Fits the boxes to the triangles of a deforming mesh, at its positions before and after a step [m].
  void refit(std::span<const Vec3> before, std::span<const Vec3> after, std::span<const Triangle> triangles);

  [[nodiscard]] const Eigen::AlignedBox3d& bounds() const { return nodes_.front().box; }

  [[nodiscard]] std::size_t leafCount() const { return leaves_.size(); }
  [[nodiscard]] const Eigen::AlignedBox3d& leafBox(std::size_t leaf) const { return nodes_[leaves_[leaf]].box; }
  /// The triangles of a leaf.
  [[nodiscard]] std::span<const int> leaf(std::size_t leaf) const {
    const Node& node = nodes_[leaves_[leaf]];
    return {order_.data() + node.begin, node.end - node.begin};
  }

  /// Calls visit(leaf) for every leaf whose box intersects `box`, in ascending order.
  template <typename Visit>
  void forEachLeafIn(const Eigen::AlignedBox3d& box, Visit&& visit) const {
    forEachLeaf([&](const Eigen::AlignedBox3d& node) { return node.intersects(box); }, visit);
  }

  /// Calls visit(other) for a leaf and for every later one whose box intersects its box, in ascending order, except
  /// those in subtrees with isLeftOut(node).
  template <typename IsLeftOut, typename Visit>
  void forEachLeafFrom(std::size_t leaf, const IsLeftOut& isLeftOut, Visit&& visit) const {
    const Eigen::AlignedBox3d& box = leafBox(leaf);
    const auto meets = [&](const Node& node, std::size_t index) {
      return node.endLeaf > leaf && !isLeftOut(index) && node.box.intersects(box);
    };
    forEachLeafOf(meets, visit);
  }

  /// The common value of all leaves in the subtree of each node; -1 if they differ.
  [[nodiscard]] std::vector<int> commonValues(std::span<const int> ofLeaf) const;

  /// Calls visit(leaf) for every leaf whose box is closer to a point than the square root of `squaredRadius` [m^2]. The
  /// calls may lower `squaredRadius`.
  template <typename Visit>
  void forEachLeafWithin(const Vec3& point, const double& squaredRadius, Visit&& visit) const {
    forEachLeaf([&](const Eigen::AlignedBox3d& node) { return squaredDistance(node, point) < squaredRadius; }, visit);
  }

  /// Calls visit(leaf) for every leaf whose box intersects the ray from a point along a unit vector, in ascending
  /// order.
  template <typename Visit>
  void forEachLeafAlong(const Vec3& from, const Vec3& direction, Visit&& visit) const {
    forEachLeaf([&](const Eigen::AlignedBox3d& node) { return meetsRay(node, from, direction); }, visit);
  }

  /// Squared distance of a point and a box, 0 inside [m^2].
  [[nodiscard]] static double squaredDistance(const Eigen::AlignedBox3d& box, const Vec3& point) {
    const Eigen::Array3d outside = (box.min() - point).array().max((point - box.max()).array()).max(0.0);
    return outside.square().sum();
  }

 private:
  struct Node {
    Eigen::AlignedBox3d box;
    std::size_t next = 0;   // node after this subtree; the children follow their parent
    std::size_t begin = 0;  // range of a leaf's triangles in order_
    std::size_t end = 0;
    std::size_t leaf = 0;
    std::size_t endLeaf = 0;  // one past the last leaf of the subtree
  };

  /// Calls visit(leaf) for every leaf whose box and the boxes around it satisfy meets(box), in ascending order.
  template <typename Meets, typename Visit>
  void forEachLeaf(const Meets& meets, Visit& visit) const {
    forEachLeafOf([&](const Node& node, std::size_t) { return meets(node.box); }, visit);
  }

  /// The same with meets(node, index of the node).
  template <typename Meets, typename Visit>
  void forEachLeafOf(const Meets& meets, Visit& visit) const {
    for (std::size_t at = 0; at < nodes_.size();) {
      const Node& node = nodes_[at];
      if (!meets(node, at)) {
        at = node.next;
        continue;
      }
      if (node.end > node.begin) {
        visit(node.leaf);
      }
      ++at;
    }
  }

  [[nodiscard]] static bool meetsRay(const Eigen::AlignedBox3d& box, const Vec3& from, const Vec3& direction);

  void build(std::vector<Vec3>& middles, std::size_t begin, std::size_t end, std::size_t maxTriangles);

  std::vector<Node> nodes_;
  std::vector<std::size_t> leaves_;  // node of each leaf
  std::vector<int> order_;
};

}  // namespace drape::sim::contact
