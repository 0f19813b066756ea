#pragma once

#include "sim/model/cloth_model.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace drape::sim {

/// Measures of the difference between a motion of a cloth and a reference. docs/theory/measures.md explains them.

/// Mean distance between two sets of positions of the same size [m], over all vertices, pinned ones included; 0 for
/// empty sets.
[[nodiscard]] double meanDistance(std::span<const Vec3> a, std::span<const Vec3> b);

/// Root of the mean squared distance [m], as above. Never less than the mean distance.
[[nodiscard]] double rmsDistance(std::span<const Vec3> a, std::span<const Vec3> b);

/// Positions at two successive checkpoints. Four views of the same size.
struct CheckpointPair {
  std::span<const Vec3> before;           ///< the method at the earlier checkpoint [m]
  std::span<const Vec3> after;            ///< the method at the later checkpoint [m]
  std::span<const Vec3> referenceBefore;  ///< the reference at the earlier checkpoint [m]
  std::span<const Vec3> referenceAfter;   ///< the reference at the later checkpoint [m]
};

/// A vertex is still if its reference moved less than this fraction of the diagonal between the checkpoints. An error
/// relative to its motion is then meaningless.
inline constexpr double stillShare = 1e-6;

/// The paper's two measures of a motion between two checkpoints. D_i is the displacement of vertex i by the method, R_i
/// by the reference. The means are over the vertices that are neither pinned nor still:
///
///     eps = mean |D_i - R_i|^2 / |R_i|^2                  "relative squared displacement error"
///     S   = mean (D_i . R_i)^2 / (|D_i|^2 |R_i|^2)        "squared cosine"; 0 for a vertex with D_i = 0
///
/// A frozen cloth has eps = 1 and S = 0; the reference itself eps = 0 and S = 1.
struct DisplacementError {
  double eps = 0.0;            ///< [-]; NaN if there is no vertex for the mean
  double squaredCosine = 0.0;  ///< S [-]; NaN if there is no vertex for the mean
  int vertices = 0;            ///< number of vertices in the means
  int stillVertices = 0;       ///< number of free vertices that are still
  double stillMotion = 0.0;    ///< largest displacement of a still vertex by the method [m]
};

/// @param diagonal of the scene [m], see diagonalOf
[[nodiscard]] DisplacementError displacementError(const ClothModel& model, const CheckpointPair& pair, double diagonal);

/// The motion of a method relative to the reference,
///
///     sqrt(sum m_i |D_i|^2) / sqrt(sum m_i |R_i|^2)
///
/// over all vertices and all added pairs of checkpoints. 1: as much motion as the reference, not necessarily in the
/// same direction; 0: frozen; above 1: too much motion.
class MotionKept {
 public:
  void add(const ClothModel& model, const CheckpointPair& pair);

  /// [-]. 1 if neither moves, infinite if only the method moves.
  [[nodiscard]] double value() const;

 private:
  double own_ = 0.0;        // sum m_i |D_i|^2 [kg m^2]
  double reference_ = 0.0;  // sum m_i |R_i|^2 [kg m^2]
};

/// The same for one pair of checkpoints [-].
[[nodiscard]] double motionKept(const ClothModel& model, const CheckpointPair& pair);

}  // namespace drape::sim
