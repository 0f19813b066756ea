#include "intersection/box_tree.hpp"

#include <algorithm>
#include <numeric>

namespace drape {
namespace {

constexpr int leafSize = 4;

}  // namespace

BoxTree::BoxTree(std::vector<Box> boxes) : boxes_(std::move(boxes)), order_(boxes_.size()) {
  std::iota(order_.begin(), order_.end(), 0);
  if (!boxes_.empty()) {
    nodes_.reserve(boxes_.size());
    build(0, static_cast<int>(boxes_.size()));
  }
}

int BoxTree::build(int begin, int end) {
  const auto index = nodes_.size();
  Node node{.box = Box(), .begin = begin, .end = end};
  Box centres;
  for (int i = begin; i < end; ++i) {
    const Box& box = boxes_[static_cast<std::size_t>(order_[static_cast<std::size_t>(i)])];
    node.box.extend(box);
    centres.extend(box.center());
  }
  nodes_.push_back(node);
  if (end - begin > leafSize) {
    Eigen::Index axis = 0;
    centres.sizes().maxCoeff(&axis);
    const int middle = begin + (end - begin) / 2;
    std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end, [&](int i, int j) {
      const double a = boxes_[static_cast<std::size_t>(i)].center()[axis];
      const double b = boxes_[static_cast<std::size_t>(j)].center()[axis];
      return a < b || (a == b && i < j);
    });
    const int left = build(begin, middle);
    const int right = build(middle, end);
    nodes_[index].left = left;
    nodes_[index].right = right;
  }
  return static_cast<int>(index);
}

void BoxTree::forEachPair(const std::function<void(int, int)>& visit) const {
  if (!nodes_.empty()) {
    pairsWithin(nodes_.front(), visit);
  }
}

void BoxTree::forEachPair(const BoxTree& other, const std::function<void(int, int)>& visit) const {
  if (!nodes_.empty() && !other.nodes_.empty()) {
    pairsOf(nodes_.front(), other, other.nodes_.front(), visit);
  }
}

void BoxTree::pairsWithin(const Node& node, const std::function<void(int, int)>& visit) const {
  if (!node.leaf()) {
    const Node& left = nodes_[static_cast<std::size_t>(node.left)];
    const Node& right = nodes_[static_cast<std::size_t>(node.right)];
    pairsWithin(left, visit);
    pairsWithin(right, visit);
    pairsOf(left, *this, right, [&](int i, int j) { visit(std::min(i, j), std::max(i, j)); });
    return;
  }
  for (int i = node.begin; i < node.end; ++i) {
    for (int j = i + 1; j < node.end; ++j) {
      const auto [a, b] =
          std::minmax(order_[static_cast<std::size_t>(i)], order_[static_cast<std::size_t>(j)], std::less<>());
      if (boxes_[static_cast<std::size_t>(a)].intersects(boxes_[static_cast<std::size_t>(b)])) {
        visit(a, b);
      }
    }
  }
}

void BoxTree::pairsOf(const Node& a, const BoxTree& other, const Node& b,
                      const std::function<void(int, int)>& visit) const {
  if (!a.box.intersects(b.box)) {
    return;
  }
  if (a.leaf() && b.leaf()) {
    for (int i = a.begin; i < a.end; ++i) {
      const int first = order_[static_cast<std::size_t>(i)];
      for (int j = b.begin; j < b.end; ++j) {
        const int second = other.order_[static_cast<std::size_t>(j)];
        if (boxes_[static_cast<std::size_t>(first)].intersects(other.boxes_[static_cast<std::size_t>(second)])) {
          visit(first, second);
        }
      }
    }
  } else if (b.leaf() || (!a.leaf() && a.end - a.begin >= b.end - b.begin)) {
    pairsOf(nodes_[static_cast<std::size_t>(a.left)], other, b, visit);
    pairsOf(nodes_[static_cast<std::size_t>(a.right)], other, b, visit);
  } else {
    pairsOf(a, other, other.nodes_[static_cast<std::size_t>(b.left)], visit);
    pairsOf(a, other, other.nodes_[static_cast<std::size_t>(b.right)], visit);
  }
}

}  // namespace drape
