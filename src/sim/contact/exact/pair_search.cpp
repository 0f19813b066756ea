#include "sim/contact/exact/pair_search.hpp"

#include "sim/contact/constraints/collect_in_order.hpp"

#include <algorithm>
#include <cmath>

namespace drape::sim::contact {
namespace {

/// The margin of a vertex's box is this number of its displacements, between the minimum margin and the largest one, so
/// that the list lasts for several steps. Margins are in reaches. If the largest displacement exceeds `fastMove`
/// reaches, the list lasts for one step only, in which the prediction changes by a fraction of the displacement.
constexpr double marginOfMove = 4.0;
constexpr double marginOfFastMove = 0.3;
constexpr double fastMove = 2.0;  // [-]
constexpr double minMargin = 0.1;
constexpr double maxMargin = 1.0;
constexpr double maxMarginOfShortLists = 5.0;  // of lists with fewer pairs than half the number of vertices

/// Lists with more pairs than this number a vertex get a smaller largest margin [-]. On meshes with edges shorter than
/// the reach, neighbours at the borders of patches are near. The number of pairs then grows with the third power of the
/// margin, and visiting all pairs of the list costs more than a search.
constexpr double pairsOfLongLists = 8.0;

/// The minimum margin grows after a list that lasted for fewer updates than the first number, and shrinks after one
/// that lasted for more than the second.
constexpr int fewUpdates = 6;
constexpr int manyUpdates = 24;
constexpr double marginGrowth = 1.5;

/// Bound of the relative rounding error of the listed distances [-].
constexpr double distanceRounding = 1e-6;

}  // namespace

Vec3 meanDisplacement(std::span<const Vec3> from, std::span<const Vec3> to) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t v = 0; v < from.size(); ++v) {
    sum += to[v] - from[v];
  }
  return from.empty() ? sum : Vec3(sum / static_cast<double>(from.size()));
}

void FeatureBounds::spread(const FeatureMesh& mesh) {
  ofEdge.resize(mesh.edges.edges.size());
  std::transform(mesh.edges.edges.begin(), mesh.edges.edges.end(), ofEdge.begin(),
                 [&](const MeshEdge& edge) { return std::max(ofVertex[edge.a], ofVertex[edge.b]); });
  ofTriangle.resize(mesh.triangles.size());
  std::transform(mesh.triangles.begin(), mesh.triangles.end(), ofTriangle.begin(), [&](const Triangle& triangle) {
    return std::max({ofVertex[triangle[0]], ofVertex[triangle[1]], ofVertex[triangle[2]]});
  });
}

FeatureTree& PairSearch::treeOf(const ClothModel& model) {
  return trees_.get(model, [this](const ClothModel& m) {
    // The list and the check belong to another model.
    positions_.clear();
    checked_.clear();
    return featureTreeOf(m);
  });
}

const std::vector<EdgeCrossing>& PairSearch::crossingsAt(const ClothModel& model, std::span<const Vec3> positions) {
  FeatureTree& tree = treeOf(model);
  if (!std::equal(positions.begin(), positions.end(), checked_.begin(), checked_.end())) {
    checked_.assign(positions.begin(), positions.end());
    findCrossings(tree.mesh, tree.tree, tree.boxes, positions, crossings_);
  }
  return crossings_;
}

void PairSearch::update(const Scope& scope, std::span<const Vec3> start, std::span<const Vec3> end, Workers& workers) {
  tree_ = &treeOf(scope.model);
  mesh_ = &tree_->mesh;
  // The list was made for all pairs within `reach_`. Pairs within a smaller distance are all listed while vertices are
  // outside their boxes by at most half the difference.
  const double slack = 0.5 * (reach_ - scope.distance);
  const bool isForOthers = positions_.size() != start.size() || slack < 0.0 || patches_ != scope.patches;
  if (isForOthers || measureMoves(start, end) > slack * (1.0 - distanceRounding)) {
    if (!isForOthers) {
      adaptMargin();
    }
    updates_ = 0;
    reach_ = std::max(scope.reach, scope.distance);
    patches_ = scope.patches;
    search(start, end, workers, scope.threads);
  }
  ++updates_;
}

/// Adapts the minimum margin to the number of updates for which the last list was valid.
void PairSearch::adaptMargin() {
  const double factor = updates_ < fewUpdates ? marginGrowth : updates_ > manyUpdates ? 1.0 / marginGrowth : 1.0;
  margin_ = std::clamp(factor * margin_, minMargin, largestMargin());
}

/// The largest margin, in reaches. Larger boxes add few pairs to a short list, and many to a long one. A short list
/// tells nothing about margins that are much larger than its own.
double PairSearch::largestMargin() const {
  const auto pairs = static_cast<double>(pairs_.size());
  const auto vertices = static_cast<double>(positions_.size());
  if (2.0 * pairs < vertices) {
    return std::clamp(marginGrowth * meanMargin_, maxMargin, maxMarginOfShortLists);
  }
  const double wanted = pairsOfLongLists * vertices;
  return pairs > wanted ? std::max(minMargin, maxMargin * wanted / pairs) : maxMargin;
}

/// Measures how far the vertices are from the centres of their boxes.
/// @return the maximum distance from the boxes [m]
double PairSearch::measureMoves(std::span<const Vec3> start, std::span<const Vec3> end) {
  const Vec3 before = meanDisplacement(positions_, start);
  shift_ = meanDisplacement(positions_, end);
  moves_.ofVertex.resize(start.size());
  double outside = 0.0;  // squared
  for (std::size_t v = 0; v < start.size(); ++v) {
    const Vec3 first = start[v] - positions_[v] - before;
    const Vec3 last = end[v] - positions_[v] - shift_;
    moves_.ofVertex[v] = std::sqrt(std::max(first.squaredNorm(), last.squaredNorm()));
    const Vec3 excess = first.cwiseAbs().cwiseMax(last.cwiseAbs()) - halfSizes_[v];
    outside = std::max(outside, excess.cwiseMax(0.0).squaredNorm());
  }
  moves_.spread(*mesh_);
  return std::sqrt(outside);
}

/// Places a box with a margin around each vertex's path, relative to the mean displacement of the cloth.
void PairSearch::placeBoxes(std::span<const Vec3> start, std::span<const Vec3> end) {
  const std::size_t count = start.size();
  const Vec3 common = meanDisplacement(start, end);
  positions_.resize(count);
  halfSizes_.resize(count);
  radii_.ofVertex.resize(count);
  double largest = 0.0;
  for (std::size_t v = 0; v < count; ++v) {
    const Vec3 half = 0.5 * (end[v] - start[v] - common);
    positions_[v] = start[v] + half;
    halfSizes_[v] = half.cwiseAbs();
    largest = std::max(largest, 2.0 * half.norm());
  }
  const double limit = largestMargin();
  const double minimum = std::min(margin_, limit);
  const bool isFast = largest > fastMove * reach_;
  double sum = 0.0;
  for (Vec3& size : halfSizes_) {
    const double wanted = std::clamp(2.0 * marginOfMove * size.norm(), minimum * reach_, limit * reach_);
    const double margin = isFast ? std::max(minMargin * reach_, 2.0 * marginOfFastMove * size.norm()) : wanted;
    size.array() += margin;
    sum += margin;
  }
  meanMargin_ = count > 0 ? sum / (static_cast<double>(count) * reach_) : 0.0;
  std::transform(halfSizes_.begin(), halfSizes_.end(), radii_.ofVertex.begin(),
                 [](const Vec3& size) { return size.norm(); });
  radii_.spread(*mesh_);
}

void PairSearch::search(std::span<const Vec3> start, std::span<const Vec3> end, Workers& workers, int threads) {
  placeBoxes(start, end);
  measureMoves(start, end);
  fitBoxes();
  tree_->boxes.setPatches(patches_.get());
  for (std::size_t k = 0; k < tree_->boxes.sets(); ++k) {
    patchesOfNodes_[k] = tree_->tree.commonValues(tree_->boxes.patchesOfLeaves(k));
  }
  const auto parts =
      collectInOrder<std::vector<Listed>>(workers, threads, static_cast<int>(tree_->tree.leafCount()),
                                          [&](int begin, int last, std::vector<Listed>& found) {
                                            Candidates candidates;
                                            for (int leaf = begin; leaf < last; ++leaf) {
                                              collectCandidates(static_cast<std::size_t>(leaf), candidates);
                                              listNear(false, candidates.vertices, found);
                                              listNear(true, candidates.edges, found);
                                            }
                                          });
  pairs_.clear();
  for (const std::vector<Listed>& part : parts) {
    pairs_.insert(pairs_.end(), part.begin(), part.end());
  }
}

void PairSearch::fitBoxes() {
  low_.resize(positions_.size());
  high_.resize(positions_.size());
  for (std::size_t v = 0; v < positions_.size(); ++v) {
    const Vec3 size = (halfSizes_[v].array() + 0.5 * reach_).matrix();
    low_[v] = positions_[v] - size;
    high_[v] = positions_[v] + size;
  }
  tree_->tree.refit(low_, high_, mesh_->triangles);
  tree_->boxes.fit(low_, high_);
}

/// Collects the pairs of a leaf's features with those of the same leaf and of later leaves.
void PairSearch::collectCandidates(std::size_t leaf, Candidates& candidates) const {
  for (Batch* batch : {&candidates.vertices, &candidates.edges}) {
    batch->pairs.clear();
    batch->lanes.clear();
  }
  const auto isInOwnPatch = [&](std::size_t node) {
    bool isIn = false;
    for (std::size_t k = 0; k < tree_->boxes.sets(); ++k) {
      const int own = tree_->boxes.patchesOfLeaves(k)[leaf];
      isIn = isIn || (own >= 0 && own == patchesOfNodes_[k][node]);
    }
    return isIn;
  };
  tree_->tree.forEachLeafFrom(leaf, isInOwnPatch, [&](std::size_t other) {
    compareVertices(leaf, other, candidates);
    if (other != leaf) {
      compareVertices(other, leaf, candidates);
    }
    compareEdges(leaf, other, candidates);
  });
}

void PairSearch::compareVertices(std::size_t leaf, std::size_t leafOfTriangles, Candidates& candidates) const {
  findOverlaps(tree_->boxes.vertices(), leaf, tree_->boxes.triangles(), leafOfTriangles, CommonVertices::LeftOut,
               candidates.overlaps);
  for (const auto& [v, t] : candidates.overlaps) {
    const Triangle& triangle = mesh_->triangles[t];
    candidates.vertices.pairs.push_back({v, t, false});
    candidates.vertices.lanes.add({v, triangle[0], triangle[1], triangle[2]});
  }
}

void PairSearch::compareEdges(std::size_t first, std::size_t second, Candidates& candidates) const {
  findOverlaps(tree_->boxes.edges(), first, tree_->boxes.edges(), second, CommonVertices::LeftOut, candidates.overlaps);
  for (const auto& [e, f] : candidates.overlaps) {
    const MeshEdge& one = mesh_->edges.edges[e];
    const MeshEdge& other = mesh_->edges.edges[f];
    candidates.edges.pairs.push_back({e, f, true});
    candidates.edges.lanes.add({one.a, one.b, other.a, other.b});
  }
}

/// Lists the pairs of a batch that can come within reach.
void PairSearch::listNear(bool edges, Batch& batch, std::vector<Listed>& found) const {
  measureDistances(edges, batch.lanes, positions_.data(), batch.distances);
  for (std::size_t i = 0; i < batch.pairs.size(); ++i) {
    const double distance = batch.distances[i];
    if (distance < (reach_ + radii_.ofPair(batch.pairs[i])) * (1.0 + distanceRounding)) {
      found.push_back({batch.pairs[i], static_cast<float>(distance - std::abs(distance) * distanceRounding)});
    }
  }
}

}  // namespace drape::sim::contact
