#pragma once

#include "fields/colour_map.hpp"
#include "render/camera.hpp"
#include "sim/model/vector.hpp"

#include <optional>
#include <span>

namespace drape::render {

/// The point where a ray hits a cloth.
struct Hit {
  int triangle = 0;
  Vec3 barycentric = Vec3::Zero();  ///< weights of the triangle's corners
  Vec3 point = Vec3::Zero();        ///< [m]
  double distance = 0.0;            ///< along the ray [m]
};

/// The first triangle that the ray hits, from either side.
[[nodiscard]] std::optional<Hit> pick(const Ray& ray, std::span<const Vec3> positions,
                                      std::span<const Triangle> triangles);

/// The colours of the marks of picked vertices, as they appear on the screen.
[[nodiscard]] std::span<const fields::ScreenColour> pickColours();

}  // namespace drape::render
