#pragma once

#include "sim/contact/broad_phase/mesh_lanes.hpp"
#include "sim/contact/exact/edge_crossings.hpp"
#include "sim/contact/exact/feature_tree.hpp"
#include "sim/contact/exact/pair_distances.hpp"
#include "sim/contact/exact/pair_gap.hpp"
#include "sim/model/model_cache.hpp"
#include "sim/model/workers.hpp"

#include <array>
#include <memory>
#include <span>
#include <vector>

namespace drape::sim::contact {

/// The mean displacement between two sets of positions of the same vertices [m].
[[nodiscard]] Vec3 meanDisplacement(std::span<const Vec3> from, std::span<const Vec3> to);

/// A bound for each vertex [m], and the largest bound of the vertices of each edge and triangle.
struct FeatureBounds {
  std::vector<double> ofVertex, ofEdge, ofTriangle;

  /// Computes the bounds of edges and triangles from those of vertices.
  void spread(const FeatureMesh& mesh);

  /// The sum of the bounds of both features.
  [[nodiscard]] double ofPair(const FeaturePair& pair) const {
    return pair.edges ? ofEdge[pair.first] + ofEdge[pair.second] : ofVertex[pair.first] + ofTriangle[pair.second];
  }
};

/// The broad phase of exact self-collision: finds the pairs of features of a cloth that can come near each other in a
/// step.
///
/// A search places a box around each vertex's path in the step, with a margin. It lists the pairs that can come closer
/// than `reach` while all vertices are in their boxes, except pairs of one collision-free patch. The list stays valid
/// for the same patches while all vertices stay in their boxes, which move with the mean displacement of the cloth.
/// Pairs of two patches that are not in a valid list stay farther apart than `reach`. So callers that only use pairs
/// within `reach` get the same result with any valid list, and the list need not belong to the state.
class PairSearch {
 public:
  /// A pair of the list.
  struct Listed {
    FeaturePair pair;
    float distance = 0.0F;  ///< at most its distance when it was listed [m]
  };

  /// What to search for.
  struct Scope {
    const ClothModel& model;
    double distance = 0.0;         ///< the list must contain all pairs that come closer than this [m]
    double reach = 0.0;            ///< the same for a new search, at least `distance` [m]
    SharedFeaturePatches patches;  ///< null: pairs of all features are listed
    int threads = 1;
  };

  /// Makes the list valid for the motion of all vertices from `start` to `end` [m].
  void update(const Scope& scope, std::span<const Vec3> start, std::span<const Vec3> end, Workers& workers);

  /// The crossings of the cloth, see findCrossings.
  const std::vector<EdgeCrossing>& crossingsAt(const ClothModel& model, std::span<const Vec3> positions);

  [[nodiscard]] const FeatureMesh& meshOf(const ClothModel& model) { return treeOf(model).mesh; }

  /// The mesh of the last `update`.
  [[nodiscard]] const FeatureMesh& mesh() const { return *mesh_; }
  [[nodiscard]] const std::vector<Listed>& pairs() const { return pairs_; }

  /// A lower bound of a pair's distance in the motion of the last `update` [m].
  [[nodiscard]] double minDistance(const Listed& listed) const {
    return static_cast<double>(listed.distance) - moves_.ofPair(listed.pair);
  }

 private:
  /// Pairs of one kind whose boxes overlap.
  struct Batch {
    std::vector<FeaturePair> pairs;
    PairLanes lanes;
    std::vector<double> distances;
  };

  struct Candidates {
    Batch vertices, edges;
    std::vector<OverlappingBoxes> overlaps;
  };

  void adaptMargin();
  [[nodiscard]] double largestMargin() const;
  double measureMoves(std::span<const Vec3> start, std::span<const Vec3> end);
  FeatureTree& treeOf(const ClothModel& model);
  void search(std::span<const Vec3> start, std::span<const Vec3> end, Workers& workers, int threads);
  void placeBoxes(std::span<const Vec3> start, std::span<const Vec3> end);
  void fitBoxes();
  void collectCandidates(std::size_t leaf, Candidates& candidates) const;
  void compareVertices(std::size_t leaf, std::size_t leafOfTriangles, Candidates& candidates) const;
  void compareEdges(std::size_t first, std::size_t second, Candidates& candidates) const;
  void listNear(bool edges, Batch& batch, std::vector<Listed>& found) const;

  ModelCache<FeatureTree> trees_;
  FeatureTree* tree_ = nullptr;
  const FeatureMesh* mesh_ = nullptr;
  SharedFeaturePatches patches_;
  double reach_ = 0.0;            // [m]
  double margin_ = 0.1;           // minimum margin of the boxes, in reaches
  double meanMargin_ = 0.0;       // of the boxes, in reaches
  int updates_ = 0;               // since the search
  std::vector<Vec3> positions_;   // of the boxes' centres [m]
  std::vector<Vec3> halfSizes_;   // of the boxes [m]
  FeatureBounds radii_;           // half diagonals of the boxes [m]
  Vec3 shift_ = Vec3::Zero();     // mean displacement since the search, at the end of the last update [m]
  FeatureBounds moves_;           // maximum distances from the boxes' centres, in the motion of the last update [m]
  std::vector<Vec3> low_, high_;  // corners of each vertex's box, extended by half the reach [m]
  std::array<std::vector<int>, patchSets> patchesOfNodes_;  // common patches of the subtrees; -1: there is none
  std::vector<Listed> pairs_;
  std::vector<Vec3> checked_;  // positions of the last call of crossingsAt [m]
  std::vector<EdgeCrossing> crossings_;
};

}  // namespace drape::sim::contact
