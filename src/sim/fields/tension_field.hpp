#pragma once

#include "sim/fabric/material.hpp"
#include "sim/model/vector.hpp"

#include <Eigen/Core>
#include <array>

namespace drape::sim::fields {

/// The compression of a membrane along one direction.
struct Compression {
  Vec2 along = Vec2::UnitX();  ///< unit vector along warp and weft
  /// The present length over the length at which the stress along it would vanish [-]; 1 without compressive stress.
  double ratio = 1.0;
};

/// The compression of a fabric along the two directions of principal stress, the stronger one first.
///
/// A membrane under compressive stress wrinkles until this stress is gone, since it bends more easily than it shortens
/// (tension field, Pipkin 1986, The relaxed energy density for isotropic elastic membranes). So what counts is the
/// stress: a sheet that is stretched along one direction contracts across it without a wrinkle, and yarns turn towards
/// each other without one. Green's strain along a direction n of compressive principal stress s must rise by
/// -s / (n n^T : C : n n^T). This is exact where the directions of stress and strain coincide, as in an isotropic
/// material.
/// @param metric C = F^T F along warp and weft [-]
[[nodiscard]] std::array<Compression, 2> compressionsOf(const Eigen::Matrix2d& metric,
                                                        const fabric::Material& material);

/// A material whose principal stresses are its principal strains [N/m], for cloth whose moduli are not known.
inline constexpr fabric::Material plainMaterial{.stretchWarp = 1.0, .stretchWeft = 1.0, .shear = 0.5, .poisson = 0.0};

/// The compressive strain at which a strip of this fabric buckles in waves of a wavelength [m]: (2 pi / wavelength)^2
/// B / C (Euler), with the stiffness B in bending and C in stretch along the strip [-].
/// @param along unit vector along warp and weft
[[nodiscard]] double bucklingStrain(const fabric::Material& material, const Vec2& along, double wavelength);

}  // namespace drape::sim::fields
