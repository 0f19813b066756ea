#pragma once

#include "sim/model/cloth_model.hpp"
#include "sim/model/vector.hpp"

#include <memory>
#include <span>

namespace drape::sim::fabric {

/// The same cloth with its stretch moduli and their stiffening multiplied by a factor. Shear, bending and mass are the
/// same. @param model must have a fabric  @param scale above 0 [-]
[[nodiscard]] std::shared_ptr<const ClothModel> withStretchScale(const ClothModel& model, double scale);

/// The strain along warp or weft that one triangle in 100 exceeds (Green's strain) [-]. Compression counts as none.
/// @param model must have a fabric
[[nodiscard]] double stretchAlongYarns(const ClothModel& model, std::span<const Vec3> positions);

}  // namespace drape::sim::fabric
