#pragma once

#include "sim/fields/body_gaps.hpp"
#include "sim/fields/field_geometry.hpp"
#include "sim/model/cloth_model.hpp"

#include <span>

namespace drape::sim::fields {

/// What fields are computed from. Every list has one entry a vertex; an empty one is not known.
struct FieldInputs {
  const ClothModel& model;
  const FieldGeometry& geometry;            ///< of `model`
  std::span<const Vec3> positions;          ///< never empty [m]
  std::span<const Vec3> velocities;         ///< [m/s]
  std::span<const Vec3> ghost;              ///< positions of the ghost [m]
  std::span<const double> contactImpulses;  ///< of the last step, see ContactLoads [N s]
  double timeStep = 0.0;                    ///< of that step [s]
  BodyGaps* bodies = nullptr;               ///< at their present places; null: there are none
};

}  // namespace drape::sim::fields
