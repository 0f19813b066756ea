#pragma once

#include "sim/model/cloth_model.hpp"

#include <span>
#include <stop_token>
#include <vector>

namespace drape::sim {

/// How equilibriumUnder searches.
struct EquilibriumOptions {
  double tolerance = 1e-9;    ///< residual relative to the load (Equilibrium::residual) at which the search ends [-]
  int maxIterations = 1600;   ///< Newton iterations, of all load steps together; cloth that buckles takes many
  double minLoadStep = 1e-3;  ///< smallest increment of the load, as a fraction of the whole [-]
};

/// A state in which the forces on every free vertex balance.
struct Equilibrium {
  std::vector<Vec3> positions;  ///< [m]
  int iterations = 0;           ///< of Newton, with all load steps
  int loadSteps = 1;            ///< increments of the load that were necessary
  double residual = 0.0;        ///< norm of the unbalanced forces over that of all loads or tensions, see below [-]
  bool converged = false;       ///< the residual is below the tolerance, or is rounding only
  bool stable = false;          ///< converged, and no small displacement releases energy, see isStableAt
};

/// Finds the static equilibrium of a cloth with a fabric (ClothModel::fabric) under constant loads. It is a minimum of
/// the potential energy
///
///     Pi(x) = E(x) - sum_i f_i.x_i
///
/// over the free vertices, with E the elastic energy and f the loads. Pinned vertices stay where `start` has them,
/// which may be off their rest positions.
///
/// Newton's method with a line search, in double precision, with a sparse Cholesky factorisation in each iteration. The
/// second derivative is exact; where it is not positive definite, the stabilised one replaces it. If the search does
/// not converge with the whole load, it starts again and applies the load in steps.
///
/// The residual is relative to the norm of the loads on free vertices, or, where it is larger, to that of the forces
/// that act at `start`. As in IncrementalPotential, a residual that rounding does not allow to decrease counts as
/// converged, but not above 1e-5. A cloth that nothing holds has no equilibrium and does not converge.
///
/// A flat sheet without a load across it is in equilibrium, though it may be an unstable one. A start that is slightly
/// out of plane finds the stable one.
///
/// Throws StepStopped after `stop` was requested.
/// @param loads forces on the vertices [N], one a vertex  @param start positions [m], one a vertex
[[nodiscard]] Equilibrium equilibriumUnder(const ClothModel& model, std::span<const Vec3> loads,
                                           std::span<const Vec3> start, const EquilibriumOptions& options = {},
                                           const std::stop_token& stop = {});

/// The weights of the vertices [N], along -y. @param gravity [m/s^2]
[[nodiscard]] std::vector<Vec3> weightsOf(const ClothModel& model, double gravity);

/// Whether no small displacement of the free vertices releases energy: the second derivative of the elastic energy by
/// their positions has no negative eigenvalue. Constant loads do not matter.
///
/// An eigenvalue of zero counts as stable. Such neutral modes are the rigid motions of a cloth that too few pins hold,
/// and motion out of the plane of a flat fabric without tension or bending stiffness. Eigenvalues count as zero if
/// their size is below about 1e-14 of the largest diagonal entry.
[[nodiscard]] bool isStableAt(const ClothModel& model, std::span<const Vec3> positions);

}  // namespace drape::sim
