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
/// Each edge moves so that its wrong end passes back through the triangle (wrongEndsOf). Where no end is wrong, it
/// moves so that the contour becomes shorter at the fastest rate (shorteningRates).
void recoverFromCrossings(const EntangledCloth& cloth, ClothState& state);

}  // namespace drape::sim::contact
