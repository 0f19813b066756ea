#pragma once

#include "sim/fields/field_inputs.hpp"

#include <limits>
#include <span>

namespace drape::sim::fields {

/// Where a field is not defined.
inline constexpr double undefinedValue = std::numeric_limits<double>::quiet_NaN();

/// The formulas of the fields. C = F^T F is the mean over the triangles of a vertex, weighted by their area at rest. F
/// is the deformation gradient of a triangle, whose columns are where unit vectors along warp and weft are now.
/// Triangles without an area have no part in it; a vertex without other triangles gets NaN.

/// 100 sqrt(C_11): the present length along warp over that at rest [%].
void stretchAlongWarp(const FieldInputs& inputs, std::span<double> values);
/// 100 sqrt(C_22): the same along weft [%].
void stretchAlongWeft(const FieldInputs& inputs, std::span<double> values);
/// asin(C_12 / sqrt(C_11 C_22)): by how much the angle between warp and weft is below a right angle [degrees].
void shearAngle(const FieldInputs& inputs, std::span<double> values);
/// The largest principal value of Cauchy's stress F S F^T / det F of the membrane, force per present width [N/m]; S is
/// its stress for Green's strain (C - 1) / 2 of a triangle. The mean over the triangles of a vertex as above. Damping
/// is not part of it. Needs a fabric.
void membraneStress(const FieldInputs& inputs, std::span<double> values);
/// The principal curvature that is larger in size [1/m], positive where the front bulges out: 1/r for a cylinder of
/// radius r. The curvature of a triangle follows from the normals at its corners (Rusinkiewicz 2004, Estimating
/// curvatures and their derivatives on triangle meshes), that of a vertex is the mean of its triangles. The normals on
/// the border of a mesh are one-sided, so triangles there do not count, and a vertex on the border gets the mean of its
/// neighbours.
void curvature(const FieldInputs& inputs, std::span<double> values);
/// The signed distance to the nearest body [mm], see BodyGaps.
void bodyGap(const FieldInputs& inputs, std::span<double> values);
/// J_i / (A_i h): the load of contacts on a vertex in the last step (ContactLoads) over its area at rest and
/// the time step [Pa].
void contactPressure(const FieldInputs& inputs, std::span<double> values);
/// The speed [m/s].
void speed(const FieldInputs& inputs, std::span<double> values);
/// The distance from the same vertex of the ghost [mm].
void ghostError(const FieldInputs& inputs, std::span<double> values);

}  // namespace drape::sim::fields
