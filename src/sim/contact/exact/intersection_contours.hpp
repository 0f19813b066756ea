#pragma once

#include "sim/contact/exact/edge_crossings.hpp"
#include "sim/contact/exact/feature_mesh.hpp"
#include "sim/model/vector.hpp"

#include <Eigen/SparseCholesky>
#include <span>
#include <vector>

namespace drape::sim::contact {

/// The line along which two triangles of a cloth intersect [m].
struct IntersectionSegment {
  Vec3 from = Vec3::Zero();
  Vec3 to = Vec3::Zero();
};

/// One segment per intersecting pair of triangles. For two triangles with a common vertex it begins there.
[[nodiscard]] std::vector<IntersectionSegment> segmentsOf(const FeatureMesh& mesh,
                                                          std::span<const EdgeCrossing> crossings,
                                                          std::span<const Vec3> positions);

/// The number of intersecting pairs of triangles.
[[nodiscard]] int intersectingPairCount(const FeatureMesh& mesh, std::span<const EdgeCrossing> crossings);

/// The contours along which a cloth intersects itself. A contour is a chain of segments, each the intersection of two
/// triangles; its points are crossings. It lies on two parts of the cloth, as a curve on each: the crossings of a curve
/// have their edges on the same part.
struct IntersectionContours {
  std::vector<int> contourOf;  ///< of each crossing
  std::vector<int> curveOf;    ///< of each crossing
  int count = 0;               ///< number of contours
  int curveCount = 0;
};

[[nodiscard]] IntersectionContours contoursOf(const FeatureMesh& mesh, std::span<const EdgeCrossing> crossings);

/// A field u on the vertices that increases by 1 along each edge that passes to the front of a triangle, decreases by 1
/// along each edge that passes to its back, and is as smooth as possible otherwise. It minimises the sum of
/// (u_b - u_a - j_ab)^2 over all edges ab, where j_ab is the sum of these jumps along the edge. Its mean over each
/// connected piece, weighted by the masses, is 0. So |u| is largest in the smaller part that a contour cuts off, even
/// if the contour does not surround the part completely.
class CrossingField {
 public:
  CrossingField(const FeatureMesh& mesh, std::span<const double> vertexMass);

  /// The field u, one number per vertex.
  /// @param crossingSigns per crossing: 1 if the edge passes from its lower vertex to the front of the triangle,
  /// else -1
  [[nodiscard]] Eigen::VectorXd solve(const FeatureMesh& mesh, std::span<const EdgeCrossing> crossings,
                                      std::span<const int> crossingSigns) const;

 private:
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors_;
};

/// Finds the end of each crossing edge that must pass back through its triangle: the one in the smaller part
/// (Baraff, Witkin and Kass 2003, Untangling Cloth). All crossings of a curve have it on the same side. Of the two
/// curves of a contour, one may cut nothing off.
/// @return a vertex per crossing; -1 for crossings of curves that cut nothing off
[[nodiscard]] std::vector<int> wrongEndsOf(const FeatureMesh& mesh, std::span<const EdgeCrossing> crossings,
                                           const IntersectionContours& contours, const CrossingField& field,
                                           std::span<const Vec3> positions);

/// How fast the contours become shorter if the edge of a crossing moves relative to its triangle, each by half of the
/// relative motion: the negative gradients of the length [-], one per crossing (Volino and Magnenat-Thalmann 2006,
/// Resolving Surface Collisions through Intersection Contour Minimization). 0 if the edge lies in the triangle's plane.
[[nodiscard]] std::vector<Vec3> shorteningRates(const FeatureMesh& mesh, std::span<const EdgeCrossing> crossings,
                                                std::span<const Vec3> positions);

}  // namespace drape::sim::contact
