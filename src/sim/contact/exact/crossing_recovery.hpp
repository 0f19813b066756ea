#pragma once

#include "sim/contact/exact/intersection_contours.hpp"
#include "sim/model/cloth_model.hpp"
#include "sim/model/cloth_state.hpp"

#include <span>

namespace drape::sim::contact {

/// Cloth that intersects itself at the start of a step.
struct EntangledCloth {
  const ClothModel& model;
  const FeatureMesh& mesh;
  const CrossingField& field;
  std::span<const double> inverseMass;  ///< 0: the vertex does not move [1/kg]
  std::span<const EdgeCrossing> crossings;
  std::span<const Vec3> start;  ///< positions at the start of the step [m]
  double margin = 0.0;          ///< distance behind a triangle at which a crossing is resolved [m]
  double timeStep = 0.0;        ///< [s]
};

/// Moves crossing features apart, at a limited speed, and removes velocities that drive them further into each other.
///
/// 1. Segments between crossings form contours (contoursOf).
/// 2. Each edge moves so that its wrong end passes back through the triangle (wrongEndsOf), and the triangle moves in
///    the opposite direction. If no curve of a contour cuts a part off, they move so that the contour becomes shorter
///    at the fastest rate (shorteningRates).
///
/// Positions change without velocity. Momentum is conserved.
/// @param state positions and velocities at the end of the step, changed
void recoverFromCrossings(const EntangledCloth& cloth, ClothState& state);

}  // namespace drape::sim::contact
