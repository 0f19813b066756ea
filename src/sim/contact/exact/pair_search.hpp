#pragma once

#include "sim/contact/broad_phase/mesh_lanes.hpp"
#include "sim/contact/broad_phase/mesh_tree.hpp"
#include "sim/contact/exact/pair_gap.hpp"
#include "sim/model/model_cache.hpp"
#include "sim/model/workers.hpp"

#include <memory>
#include <span>
#include <vector>

namespace drape::sim::contact {

/// The mean displacement between two sets of positions of the same vertices [m].
[[nodiscard]] Vec3 meanDisplacement(std::span<const Vec3> from, std::span<const Vec3> to);

/// Finds the pairs of features of a cloth that can come near each other in a step.
///
/// A search places a ball around each vertex, with its displacement in the step and a margin as the radius, and lists
/// the pairs whose distance is less than `reach` plus the radii of both features. The list stays valid while all
/// vertices stay in their balls, which move with the mean displacement of the cloth. A pair that is not in a valid list
/// is farther apart than `reach`. So callers that only use pairs within `reach` get the same result with any valid
/// list, and the list need not belong to the state.
class PairSearch {
 public:
  /// A pair of the list.
  struct Listed {
    FeaturePair pair;
    float distance = 0.0F;  ///< at most its distance when it was listed [m]
  };

  /// Makes the list valid for all vertices on the way from `start` to `end` [m].
  /// @param searchDistance the reach: pairs that come closer than this are listed [m]
  void update(const ClothModel& model, double searchDistance, std::span<const Vec3> start, std::span<const Vec3> end,
              Workers& workers, int threads);

  /// Marks the vertices of triangles that intersect others, see findEntangled. @returns whether there are any
  bool findEntangledVertices(const ClothModel& model, std::span<const Vec3> positions, std::vector<char>& entangled);

  [[nodiscard]] const FeatureMesh& mesh() const { return *mesh_; }
  [[nodiscard]] const std::vector<Listed>& pairs() const { return pairs_; }

  /// A lower bound of a pair's distance on the way of the last `update` [m].
  [[nodiscard]] double minDistance(const Listed& listed) const {
    const FeaturePair& pair = listed.pair;
    const auto apart = static_cast<double>(listed.distance);
    return pair.edges ? apart - edgeMove(pair.first) - edgeMove(pair.second)
                      : apart - moves_[pair.first] - triangleMove(pair.second);
  }

 private:
  struct Tree {
    FeatureMesh mesh;
    MeshTree tree;
  };

  bool measureMoves(std::span<const Vec3> start, std::span<const Vec3> end);
  Tree& treeOf(const ClothModel& model);
  void search(std::span<const Vec3> start, std::span<const Vec3> end, Workers& workers, int threads);
  void fitBoxes();
  void collectPairs(std::size_t leaf, std::vector<Listed>& found) const;
  void comparePair(int a, int b, std::vector<Listed>& found) const;
  void compareVertices(int a, int b, std::vector<Listed>& found) const;
  void compareEdges(int a, int b, std::vector<Listed>& found) const;
  [[nodiscard]] double edgeMove(int edge) const {
    const MeshEdge& ends = mesh_->edges.edges[edge];
    return std::max(moves_[ends.a], moves_[ends.b]);
  }
  [[nodiscard]] double triangleMove(int triangle) const {
    const Triangle& corners = mesh_->triangles[triangle];
    return std::max({moves_[corners[0]], moves_[corners[1]], moves_[corners[2]]});
  }

  ModelCache<Tree> trees_;
  Tree* tree_ = nullptr;
  const FeatureMesh* mesh_ = nullptr;
  double reach_ = 0.0;            // [m]
  std::vector<Vec3> positions_;   // at the search [m]
  std::vector<double> radii_;     // of the balls [m]
  Vec3 shift_ = Vec3::Zero();     // mean displacement since the search, at the end of the last update [m]
  std::vector<double> moves_;     // maximum distance from the ball's centre, on the way of the last update [m]
  std::vector<Vec3> low_, high_;  // of each vertex's ball, extended by half the reach [m]
  std::vector<Eigen::AlignedBox3d> boxes_;      // of the triangles
  std::vector<Eigen::AlignedBox3d> edgeBoxes_;  // of the edges
  std::vector<Listed> pairs_;
};

}  // namespace drape::sim::contact
