#include "settings/surface_fields.hpp"

#include "messages/error.hpp"

#include <fmt/core.h>
#include <algorithm>
#include <array>

namespace drape::settings {

std::span<const SurfaceField> surfaceFields() {
  static constexpr std::array<SurfaceField, 3> fields{{
      {"static_friction", "Static friction", "-", &sim::contact::SurfaceProperties::staticFriction, 0.0, 10.0, 2.0,
       false,
       "Friction coefficient of cloth that rests on the body. It does not slide on slopes up to the angle with this "
       "tangent."},
      {"kinetic_friction", "Kinetic friction", "-", &sim::contact::SurfaceProperties::kineticFriction, 0.0, 10.0, 2.0,
       false, "Friction coefficient of cloth that slides on the body. At most the static friction."},
      {"thickness", "Thickness", "m", &sim::contact::SurfaceProperties::thickness, 1e-4, 1.0, 0.05, true,
       "Distance that the cloth keeps from the body, in addition to half of its own thickness."},
  }};
  return fields;
}

sim::contact::SurfaceProperties withSurfaceValue(sim::contact::SurfaceProperties surface, const SurfaceField& field,
                                                 double value) {
  surface.*field.value = value;
  if (field.value == &sim::contact::SurfaceProperties::staticFriction) {
    surface.kineticFriction = std::min(surface.kineticFriction, value);
  } else if (field.value == &sim::contact::SurfaceProperties::kineticFriction) {
    surface.staticFriction = std::max(surface.staticFriction, value);
  }
  return surface;
}

void requireAllowed(const sim::contact::SurfaceProperties& surface) {
  for (const SurfaceField& field : surfaceFields()) {
    const double value = surface.*field.value;
    if (!(value >= field.min && value <= field.max)) {
      throw messages::UsageError(
          fmt::format("a body's {} must be from {:g} to {:g}, not {:g}", field.key, field.min, field.max, value));
    }
  }
  if (surface.kineticFriction > surface.staticFriction) {
    throw messages::UsageError("a body's kinetic_friction must not be larger than its static_friction");
  }
}

}  // namespace drape::settings
