#pragma once

#include "sim/contact/closest_features/hull_gap.hpp"
#include "sim/contact/closest_features/mesh_in_step.hpp"
#include "sim/contact/constraints/constraint_builder.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace drape::sim::contact {

/// Cached result of a search for the features of a mesh near a triangle of the cloth.
struct NearbyFeatures {
  struct Feature {
    int triangle = 0;
    std::uint8_t at = 0;     ///< index of the corner or side
    std::uint8_t sides = 0;  ///< of an edge: bit mask of the sides of the cloth's triangle near it; 0 for a vertex
    float atLeast = 0.0F;    ///< lower bound of its distance to the triangle or these sides in the search [m]
  };

  Corners at;                 ///< corners of the triangle in the search [m]
  double validRadius = -1.0;  ///< maximum displacement of the corners for which it is valid [m]; negative: it is not
  double complete = 0.0;      ///< within the valid radius all features up to this distance are known [m]
  double distance = 0.0;      ///< lower bound of the distance of the triangle at `at` to the mesh [m]
  std::vector<Feature> features;
};

/// Finds contacts of one triangle of the cloth with vertices and sharp edges of a mesh: vertices of the mesh with the
/// face of the triangle, sharp edges of the mesh with its sides. It first searches a plane with a wide gap between the
/// triangle and the leaves of the mesh near it (HullGapSearch). On surfaces that are smooth at the scale of the cloth
/// there is one, and the search ends there. Otherwise it measures the distances of the features in these leaves.
class SharpFeatureSearch {
 public:
  /// @param close distance below which features get contacts [m]  @param near distance up to which to search [m]
  SharpFeatureSearch(const ConstraintBuilder& builder, const MeshInStep& mesh, const ClothInBody& cloth,
                     std::span<const NearestMeshPoint> nearest, double close, double near, Candidates& candidates)
      : builder_(builder),
        mesh_(mesh),
        cloth_(cloth),
        nearest_(nearest),
        close_(close),
        near_(near),
        candidates_(candidates) {}

  /// Adds the contacts of triangle t.
  /// @param leaves leaves of the mesh's tree, including all near the triangle  @param boxes of these leaves
  /// @param maxDisplacement of its corners, plus the list margin [m]
  /// @param outwards direction in which the search starts: that of the widest gap found last, or zero; updated
  /// @param memory of this triangle; it only skips work. Unused on deforming meshes.
  /// @return lower bound of the distance to the mesh at the start of the pass [m]
  double search(int t, const std::vector<int>& leaves, const BoxList& boxes, double maxDisplacement, Vec3& outwards,
                NearbyFeatures& memory);

  /// Lower bound of the distance between the last triangle and the vertices and sharp edges of the mesh [m].
  [[nodiscard]] double featureGap() const { return featureGap_; }

 private:
  bool useMemory(const NearbyFeatures& memory, double wanted, double& distance);
  bool findNearbyLeaves(const std::vector<int>& leaves, const BoxList& boxes, double near);
  [[nodiscard]] Vec3 outwardNormal() const;
  [[nodiscard]] FaceRegion region(double slack) const;
  void computeFaceWeights();
  [[nodiscard]] bool isOverFace(const Vec3& point) const;
  void searchFeatures(const std::vector<int>& leaves, const BoxList& boxes, double slack, NearbyFeatures& memory);
  double addVertexContact(int bodyTriangle, std::size_t corner);
  [[nodiscard]] std::uint8_t sidesNear(int bodyTriangle, std::size_t side, double far) const;
  double addEdgeContact(int bodyTriangle, std::size_t side, std::size_t ownSide);
  void rememberEdge(int bodyTriangle, std::uint8_t side, double far, NearbyFeatures& memory);
  double contact(int bodyTriangle, const Corners& at, const Vec3& weights, const Vec3& bodyWeights, bool counts);

  const ConstraintBuilder& builder_;
  const MeshInStep& mesh_;
  const ClothInBody& cloth_;
  std::span<const NearestMeshPoint> nearest_;
  double close_;
  double near_;
  Candidates& candidates_;

  std::size_t t_ = 0;                                            // the triangle
  double featureGap_ = 0.0;                                      // see featureGap() [m]
  Corners start_;                                                // its corners at the start of the pass [m]
  Vec3 normal_ = Vec3::UnitY();                                  // its unit normal
  std::array<Vec3, 2> faceWeights_{Vec3::Zero(), Vec3::Zero()};  // see FaceRegion::weights
  std::vector<std::int32_t> leaves_;                             // near the triangle
  std::vector<InRegion> found_;                                  // features of these leaves
};

}  // namespace drape::sim::contact
