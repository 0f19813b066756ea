#include "sim/contact/exact/pair_search.hpp"

#include "sim/contact/closest_features/closest_points.hpp"
#include "sim/contact/constraints/collect_in_order.hpp"
#include "sim/contact/exact/entanglement.hpp"

#include <algorithm>
#include <cmath>

namespace drape::sim::contact {
namespace {

constexpr std::size_t trianglesOfLeaf = 8;

/// The radius of a ball is the displacement in the step plus a margin, so that the list lasts for several steps. The
/// margin is this number of displacements, between these numbers of reaches.
constexpr double marginOfMove = 4.0;
constexpr double minBallMargin = 0.1;
constexpr double maxBallMargin = 1.0;

/// Rounding of the listed distances, relative to them [-].
constexpr double distanceRounding = 1e-6;

}  // namespace

Vec3 meanDisplacement(std::span<const Vec3> from, std::span<const Vec3> to) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t v = 0; v < from.size(); ++v) {
    sum += to[v] - from[v];
  }
  return from.empty() ? sum : Vec3(sum / static_cast<double>(from.size()));
}

PairSearch::Tree& PairSearch::treeOf(const ClothModel& model) {
  return trees_.get(model, [this](const ClothModel& m) {
    positions_.clear();  // the list belongs to another model
    return Tree{featureMeshOf(m), MeshTree(m.restPositions, m.triangles, trianglesOfLeaf)};
  });
}

bool PairSearch::findEntangledVertices(const ClothModel& model, std::span<const Vec3> positions,
                                       std::vector<char>& entangled) {
  Tree& tree = treeOf(model);
  return findEntangled(tree.mesh, tree.tree, positions, entangled);
}

void PairSearch::update(const ClothModel& model, double searchDistance, std::span<const Vec3> start,
                        std::span<const Vec3> end, Workers& workers, int threads) {
  tree_ = &treeOf(model);
  mesh_ = &tree_->mesh;
  if (positions_.size() != start.size() || reach_ != searchDistance || !measureMoves(start, end)) {
    reach_ = searchDistance;
    search(start, end, workers, threads);
  }
}

/// Measures how far the vertices leave the centres of their balls.
/// @return whether they stay inside
bool PairSearch::measureMoves(std::span<const Vec3> start, std::span<const Vec3> end) {
  const Vec3 before = meanDisplacement(positions_, start);
  shift_ = meanDisplacement(positions_, end);
  moves_.resize(start.size());
  bool inside = true;
  for (std::size_t v = 0; v < start.size(); ++v) {
    const Vec3 centre = positions_[v] + before;
    moves_[v] = std::sqrt(std::max((start[v] - centre).squaredNorm(), (end[v] - positions_[v] - shift_).squaredNorm()));
    inside = inside && moves_[v] <= radii_[v];
  }
  return inside;
}

void PairSearch::search(std::span<const Vec3> start, std::span<const Vec3> end, Workers& workers, int threads) {
  positions_.assign(start.begin(), start.end());
  radii_.assign(start.size(), 0.0);
  measureMoves(start, end);
  for (std::size_t v = 0; v < start.size(); ++v) {
    radii_[v] = moves_[v] + std::clamp(marginOfMove * moves_[v], minBallMargin * reach_, maxBallMargin * reach_);
  }
  fitBoxes();
  pairs_.clear();
  collectInOrder(workers, threads, static_cast<int>(tree_->tree.leafCount()), pairs_,
                 [&](int leaf, std::vector<Listed>& found) { collectPairs(static_cast<std::size_t>(leaf), found); });
}

void PairSearch::fitBoxes() {
  low_.resize(positions_.size());
  high_.resize(positions_.size());
  for (std::size_t v = 0; v < positions_.size(); ++v) {
    const double by = radii_[v] + 0.5 * reach_;
    low_[v] = (positions_[v].array() - by).matrix();
    high_[v] = (positions_[v].array() + by).matrix();
  }
  tree_->tree.refit(low_, high_, mesh_->triangles);
  boxes_.resize(mesh_->triangles.size());
  for (std::size_t t = 0; t < boxes_.size(); ++t) {
    const auto& [a, b, c] = mesh_->triangles[t];
    boxes_[t] = {low_[a].cwiseMin(low_[b]).cwiseMin(low_[c]), high_[a].cwiseMax(high_[b]).cwiseMax(high_[c])};
  }
  edgeBoxes_.resize(mesh_->edges.edges.size());
  for (std::size_t e = 0; e < edgeBoxes_.size(); ++e) {
    const auto& [a, b] = mesh_->edges.edges[e];
    edgeBoxes_[e] = {low_[a].cwiseMin(low_[b]), high_[a].cwiseMax(high_[b])};
  }
}

/// Lists the pairs of a leaf's triangles with those of the same leaf and of later leaves.
void PairSearch::collectPairs(std::size_t leaf, std::vector<Listed>& found) const {
  const MeshTree& tree = tree_->tree;
  const std::span<const int> own = tree.leaf(leaf);
  tree.forEachLeafIn(tree.leafBox(leaf), [&](std::size_t other) {
    if (other < leaf) {
      return;
    }
    const std::span<const int> others = tree.leaf(other);
    for (std::size_t i = 0; i < own.size(); ++i) {
      const Eigen::AlignedBox3d& box = boxes_[own[i]];
      if (!box.intersects(tree.leafBox(other))) {
        continue;
      }
      for (std::size_t k = other == leaf ? i + 1 : 0; k < others.size(); ++k) {
        if (box.intersects(boxes_[others[k]])) {
          comparePair(own[i], others[k], found);
        }
      }
    }
  });
}

/// Lists the pairs of the features that belong to two triangles.
void PairSearch::comparePair(int a, int b, std::vector<Listed>& found) const {
  compareVertices(a, b, found);
  compareVertices(b, a, found);
  compareEdges(a, b, found);
}

void PairSearch::compareVertices(int a, int b, std::vector<Listed>& found) const {
  const FeatureMesh::Owned& owned = mesh_->owned[a];
  const Triangle& triangle = mesh_->triangles[b];
  const double radius = std::max({radii_[triangle[0]], radii_[triangle[1]], radii_[triangle[2]]});
  for (int i = 0; i < owned.vertexCount; ++i) {
    const int v = owned.vertices[i];
    if (hasCorner(triangle, v) || !Eigen::AlignedBox3d(low_[v], high_[v]).intersects(boxes_[b])) {
      continue;
    }
    const FeaturePair pair{v, b, false};
    const double distance = gapOf(verticesOf(*mesh_, pair), positions_).distance;
    if (distance < (reach_ + radii_[v] + radius) * (1.0 + distanceRounding)) {
      found.push_back({pair, static_cast<float>(distance * (1.0 - distanceRounding))});
    }
  }
}

void PairSearch::compareEdges(int a, int b, std::vector<Listed>& found) const {
  const FeatureMesh::Owned& first = mesh_->owned[a];
  const FeatureMesh::Owned& second = mesh_->owned[b];
  for (int i = 0; i < first.edgeCount; ++i) {
    const MeshEdge& one = mesh_->edges.edges[first.edges[i]];
    const Eigen::AlignedBox3d& box = edgeBoxes_[first.edges[i]];
    if (!box.intersects(boxes_[b])) {
      continue;
    }
    for (int k = 0; k < second.edgeCount; ++k) {
      const MeshEdge& other = mesh_->edges.edges[second.edges[k]];
      if (shareEnd(one, other) || !box.intersects(edgeBoxes_[second.edges[k]])) {
        continue;
      }
      const FeaturePair pair{first.edges[i], second.edges[k], true};
      const double radius = std::max(radii_[one.a], radii_[one.b]) + std::max(radii_[other.a], radii_[other.b]);
      const double distance = gapOf(verticesOf(*mesh_, pair), positions_).distance;
      if (distance < (reach_ + radius) * (1.0 + distanceRounding)) {
        found.push_back({pair, static_cast<float>(distance * (1.0 - distanceRounding))});
      }
    }
  }
}

}  // namespace drape::sim::contact
