#pragma once

#include <Eigen/Geometry>
#include <functional>
#include <vector>

namespace drape {

using Box = Eigen::AlignedBox3d;

/// A bounding volume hierarchy over boxes, for finding overlapping pairs. Boxes are closed and compared without
/// rounding, so touching pairs are found.
class BoxTree {
 public:
  explicit BoxTree(std::vector<Box> boxes);

  /// Calls visit(i, j) once for each pair of boxes i < j that overlap, in an order that depends only on the boxes.
  void forEachPair(const std::function<void(int, int)>& visit) const;

  /// Calls visit(i, j) for each box i of this tree and j of the other that overlap.
  void forEachPair(const BoxTree& other, const std::function<void(int, int)>& visit) const;

 private:
  /// Holds entries begin to end - 1 of order_. Unless it is a leaf, its two children hold half of them each.
  struct Node {
    Box box;
    int begin = 0;
    int end = 0;
    int left = -1;
    int right = -1;
    [[nodiscard]] bool leaf() const { return left < 0; }
  };

  int build(int begin, int end);
  void pairsOf(const Node& a, const BoxTree& other, const Node& b, const std::function<void(int, int)>& visit) const;
  void pairsWithin(const Node& node, const std::function<void(int, int)>& visit) const;

  std::vector<Box> boxes_;
  std::vector<int> order_;
  std::vector<Node> nodes_;
};

}  // namespace drape
