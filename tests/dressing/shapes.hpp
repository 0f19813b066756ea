#pragma once

#include "sim/model/cloth_model.hpp"

#include <memory>

namespace drape::dressing::testing {

/// The mannequin and the T-shirt of the tree, which fits it as it is.
[[nodiscard]] const sim::ClothMesh& mannequin();
[[nodiscard]] const sim::ClothMesh& tshirt();

/// The figure of the tree, a person with legs.
[[nodiscard]] const sim::ClothMesh& figure();

/// An upright ellipsoid around the origin. @param half axes [m]
[[nodiscard]] sim::ClothMesh ellipsoid(const Vec3& half);

/// An upright tube around the y axis, open at both ends [m].
[[nodiscard]] sim::ClothMesh tube(double radius, double height);

/// A cloth without pins.
[[nodiscard]] std::shared_ptr<const sim::ClothModel> modelOf(const sim::ClothMesh& mesh);

[[nodiscard]] sim::ClothMesh shifted(sim::ClothMesh mesh, const Vec3& shift);

}  // namespace drape::dressing::testing
