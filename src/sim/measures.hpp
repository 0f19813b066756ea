#pragma once

#include "sim/cloth_model.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace drape {

/// How one motion of a cloth differs from another, the reference. docs/theory/measures.md tells what each is good for.

/// Mean distance between two sets of positions [m], over all vertices, pinned ones too. Both have the same size; 0 for
/// none.
[[nodiscard]] double meanDistance(std::span<const Vec3> a, std::span<const Vec3> b);

/// Root of the mean squared distance [m], as above. Never less than the mean distance.
[[nodiscard]] double rmsDistance(std::span<const Vec3> a, std::span<const Vec3> b);

/// Diagonal of the bounding box of a cloth's rest shape [m]: what distances are related to.
[[nodiscard]] double diagonalOf(const ClothModel& model);

/// Where the vertices were at two checkpoints, one after the other. Four views of the same size.
struct CheckpointPair {
  std::span<const Vec3> before;           ///< the method at the earlier checkpoint [m]
  std::span<const Vec3> after;            ///< the method at the later checkpoint [m]
  std::span<const Vec3> referenceBefore;  ///< the reference at the earlier checkpoint [m]
  std::span<const Vec3> referenceAfter;   ///< the reference at the later checkpoint [m]
};

/// A vertex whose reference moved less than this share of the diagonal from one checkpoint to the next is still: an
/// error relative to its motion says nothing about it.
inline constexpr double stillShare = 1e-6;

/// The paper's two measures of a motion between two checkpoints. With D_i the displacement of vertex i by the method
/// and R_i by the reference, means over the vertices that are neither pinned nor still:
///
///     eps = mean |D_i - R_i|^2 / |R_i|^2                  "relative squared displacement error"
///     S   = mean (D_i . R_i)^2 / (|D_i|^2 |R_i|^2)        "squared cosine"; 0 for a vertex with D_i = 0
///
/// A frozen cloth has eps = 1 and S = 0; the reference itself eps = 0 and S = 1.
struct DisplacementError {
  double eps = 0.0;            ///< [-]; not a number when no vertex is left to judge
  double squaredCosine = 0.0;  ///< S [-]; not a number when no vertex is left to judge
  int vertices = 0;            ///< that the means are over
  int stillVertices = 0;       ///< free vertices that are left out since their reference hardly moved
  double stillMotion = 0.0;    ///< the largest displacement by the method of one that is left out so [m]
};

/// @param diagonal of the scene [m], see diagonalOf
[[nodiscard]] DisplacementError displacementError(const ClothModel& model, const CheckpointPair& pair, double diagonal);

/// How much of the reference's motion a method keeps,
///
///     sqrt(sum m_i |D_i|^2) / sqrt(sum m_i |R_i|^2)
///
/// over all vertices and all the pairs of checkpoints that were added: 1 moves as much as the reference (not
/// necessarily there), 0 is frozen, more than 1 moves too much.
class MotionKept {
 public:
  void add(const ClothModel& model, const CheckpointPair& pair);

  /// [-]. 1 when neither moves, infinite when only the method does.
  [[nodiscard]] double value() const;

 private:
  double own_ = 0.0;        // sum m_i |D_i|^2 [kg m^2]
  double reference_ = 0.0;  // sum m_i |R_i|^2 [kg m^2]
};

/// The above for one pair of checkpoints [-].
[[nodiscard]] double motionKept(const ClothModel& model, const CheckpointPair& pair);

}  // namespace drape
