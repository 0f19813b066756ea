#include "sim/contact/broad_phase/mesh_tree.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

namespace drape::sim::contact {

MeshTree::MeshTree(std::span<const Vec3> positions, std::span<const Triangle> triangles, std::size_t maxTriangles)
    : order_(triangles.size()) {
  std::iota(order_.begin(), order_.end(), 0);
  std::vector<Vec3> middles;
  middles.reserve(triangles.size());
  for (const Triangle& t : triangles) {
    middles.emplace_back((positions[t[0]] + positions[t[1]] + positions[t[2]]) / 3.0);
  }
  build(middles, 0, order_.size(), maxTriangles);
  refit(positions, positions, triangles);
}

void MeshTree::build(std::vector<Vec3>& middles, std::size_t begin, std::size_t end, std::size_t maxTriangles) {
  const std::size_t self = nodes_.size();
  nodes_.emplace_back();
  if (end - begin <= maxTriangles) {
    nodes_[self].begin = begin;
    nodes_[self].end = end;
    nodes_[self].leaf = leaves_.size();
    leaves_.push_back(self);
  } else {
    Eigen::AlignedBox3d box;
    for (std::size_t i = begin; i < end; ++i) {
      box.extend(middles[order_[i]]);
    }
    Eigen::Index axis = 0;
    box.sizes().maxCoeff(&axis);
    const auto first = order_.begin() + static_cast<std::ptrdiff_t>(begin);
    const auto last = order_.begin() + static_cast<std::ptrdiff_t>(end);
    std::sort(first, last, [&](int a, int b) {
      const double x = middles[a][axis];
      const double y = middles[b][axis];
      return x != y ? x < y : a < b;
    });
    const std::size_t middle = begin + (end - begin) / 2;
    build(middles, begin, middle, maxTriangles);
    build(middles, middle, end, maxTriangles);
  }
  nodes_[self].next = nodes_.size();
  nodes_[self].endLeaf = leaves_.size();
}

std::vector<int> MeshTree::commonValues(std::span<const int> ofLeaf) const {
  std::vector<int> values(nodes_.size());
  // Children follow their parents, so in reverse order every child comes before its parent.
  for (std::size_t n = nodes_.size(); n-- > 0;) {
    const Node& node = nodes_[n];
    if (node.end > node.begin) {
      values[n] = ofLeaf[node.leaf];
      continue;
    }
    values[n] = n + 1 < node.next ? values[n + 1] : -1;
    for (std::size_t child = n + 1; child < node.next; child = nodes_[child].next) {
      values[n] = values[child] == values[n] ? values[n] : -1;
    }
  }
  return values;
}

/// Whether a ray intersects a box, which is extended by the rounding error.
bool MeshTree::meetsRay(const Eigen::AlignedBox3d& box, const Vec3& from, const Vec3& direction) {
  constexpr double rounding = 1e-9;  // [m]
  double first = 0.0;
  double last = std::numeric_limits<double>::infinity();
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const double low = box.min()[axis] - rounding - from[axis];
    const double high = box.max()[axis] + rounding - from[axis];
    if (direction[axis] == 0.0) {
      if (low > 0.0 || high < 0.0) {
        return false;
      }
      continue;
    }
    const auto [near, far] = std::minmax({low / direction[axis], high / direction[axis]});
    first = std::max(first, near);
    last = std::min(last, far);
  }
  return first <= last;
}

void MeshTree::refit(std::span<const Vec3> before, std::span<const Vec3> after, std::span<const Triangle> triangles) {
  // Children follow their parents, so in reverse order every child comes before its parent.
  for (std::size_t n = nodes_.size(); n-- > 0;) {
    Node& node = nodes_[n];
    node.box.setEmpty();
    if (node.end > node.begin) {
      for (std::size_t i = node.begin; i < node.end; ++i) {
        for (const int corner : triangles[order_[i]]) {
          node.box.extend(before[corner]);
          node.box.extend(after[corner]);
        }
      }
    } else {
      for (std::size_t child = n + 1; child < node.next; child = nodes_[child].next) {
        node.box.extend(nodes_[child].box);
      }
    }
  }
}

}  // namespace drape::sim::contact
