#pragma once

#include "sim/simd/sliced_cloth.hpp"

#include <array>
#include <vector>

namespace drape {

/// Slices that are summed up together: lane by lane within them, then over the blocks in their order. So a sum is the
/// same for any number of threads and any width of registers.
inline constexpr int blockSlices = 16;

/// The backward-Euler system of a cloth laid out for vector instructions, W dv = h f~, and the vectors of conjugate
/// gradients on it. Each spring stands there from both ends, as in the layout: about 500 bytes a vertex in float.
template <typename T>
struct ConjugateGradients {
  explicit ConjugateGradients(const SliceLayout& layout);

  /// In double, over the blocks in their order.
  [[nodiscard]] double curvature() const { return sumOf(curvatures); }   ///< c . A c
  [[nodiscard]] double descent() const { return sumOf(descents); }       ///< r . P^-1 r
  [[nodiscard]] double squaredResidual() const { return sumOf(norms); }  ///< r . r

  std::vector<SpringTerms<T>> terms;                         ///< one a slot
  std::vector<SliceMatrices<T>> preconditioner;              ///< P^-1 [1/kg], one a slice; zero where pinned
  LaneArray<T> diagonal;                                     ///< mass, and h^2 times the stiffness of the hand [kg]
  LaneVectors<T> change;                                     ///< dv [m/s]
  LaneVectors<T> residual;                                   ///< [N s]
  LaneVectors<T> scaled;                                     ///< P^-1 r [m/s]
  LaneVectors<T> direction;                                  ///< c [m/s]
  LaneVectors<T> product;                                    ///< A c [N s]
  std::vector<SliceNumbers<T>> curvatures, descents, norms;  ///< one a block

 private:
  [[nodiscard]] static double sumOf(const std::vector<SliceNumbers<T>>& blocks);
};

/// The parts of a step between which all threads have to meet.
enum class ConjugatePhase {
  Start,     ///< assembles the system; dv = 0, r = h f~, c = P^-1 r
  Multiply,  ///< A c
  Descend,   ///< dv += factor c, r -= factor A c, P^-1 r
  Turn,      ///< c = P^-1 r + factor c
  Advance    ///< v += dv, x += h v
};

/// One phase for the slices of one thread, by the widest vector instructions that the machine has. A share has to begin
/// with a block.
void conjugatePhase(SlicedCloth<float>& cloth, ConjugateGradients<float>& system, const SliceStep<float>& step,
                    const StepShare& share, ConjugatePhase phase, float factor);
void conjugatePhase(SlicedCloth<double>& cloth, ConjugateGradients<double>& system, const SliceStep<double>& step,
                    const StepShare& share, ConjugatePhase phase, double factor);

/// The share of one of `members` threads, in whole blocks.
[[nodiscard]] StepShare blockShareOf(const SliceLayout& layout, int member, int members);

}  // namespace drape
