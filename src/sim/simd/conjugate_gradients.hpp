#pragma once

#include "sim/simd/sliced_cloth.hpp"

#include <array>
#include <vector>

namespace drape::sim::simd {

/// Number of slices in a block of a sum. Sums run lane by lane within a block and then over the blocks in order, so
/// they do not depend on the number of threads or the register width.
inline constexpr int blockSlices = 16;

/// The backward-Euler system W dv = h f~ of a sliced cloth, and the vectors of the conjugate gradient method. Each
/// spring is stored at both ends, as in the layout: about 500 bytes a vertex in float.
template <typename T>
struct ConjugateGradients {
  explicit ConjugateGradients(const SliceLayout& layout);

  /// Sums over the blocks, in double.
  [[nodiscard]] double curvature() const { return sumOf(curvatures); }   ///< c . A c
  [[nodiscard]] double descent() const { return sumOf(descents); }       ///< r . P^-1 r
  [[nodiscard]] double squaredResidual() const { return sumOf(norms); }  ///< r . r

  std::vector<SpringTerms<T>> terms;             ///< one a slot
  std::vector<SliceMatrices<T>> preconditioner;  ///< P^-1 [1/kg], one a slice; zero where pinned
  LaneArray<T> diagonal;                         ///< mass plus h^2 times the stiffness of the attachment [kg]
  LaneVectors<T> change;                         ///< dv [m/s]
  LaneVectors<T> residual;                       ///< [N s]
  LaneVectors<T> scaled;                         ///< P^-1 r [m/s]
  LaneVectors<T> direction;                      ///< c [m/s]
  LaneVectors<T> product;                        ///< A c [N s]
  std::vector<SliceNumbers<T>> curvatures, descents, norms;  ///< one a block

 private:
  [[nodiscard]] static double sumOf(const std::vector<SliceNumbers<T>>& blocks);
};

/// The phases of a step. All threads wait for each other between them.
enum class ConjugatePhase {
  Start,     ///< assembles the system; dv = 0, r = h f~, c = P^-1 r
  Multiply,  ///< A c
  Descend,   ///< dv += factor c, r -= factor A c, P^-1 r
  Turn,      ///< c = P^-1 r + factor c
  Advance    ///< v += dv, x += h v
};

/// One phase for the slices of one thread, with the widest vector instructions of the machine. A share must start at a
/// block boundary.
void conjugatePhase(SlicedCloth<float>& cloth, ConjugateGradients<float>& system, const SliceStep<float>& step,
                    const StepShare& share, ConjugatePhase phase, float factor);
void conjugatePhase(SlicedCloth<double>& cloth, ConjugateGradients<double>& system, const SliceStep<double>& step,
                    const StepShare& share, ConjugatePhase phase, double factor);

/// The share of one of `members` threads, in whole blocks.
[[nodiscard]] StepShare blockShareOf(const SliceLayout& layout, int member, int members);

}  // namespace drape::sim::simd
