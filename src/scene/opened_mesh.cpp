#include "scene/opened_mesh.hpp"

namespace drape::scene {

settings::Settings openedMeshSettings() {
  settings::Settings settings;
  settings.material.model = "fabric";
  // As springs:
  settings.material.density = 0.15;          // cotton jersey
  settings.step.material.stiffness = 150.0;  // stretches a T-shirt by about 1 % in most places, and by 5 % at its pins
  // Damping and stiffness of a spring are the fabric's viscosity and elasticity. Both are independent of the size of
  // the triangles.
  settings.step.material.damping = 0.005;
  settings.step.air.drag = 1.0;  // about that of a flat plate perpendicular to the wind
  settings.step.air.lift = 0.4;
  settings.step.contact.self = sim::contact::SelfCollision::Exact;
  return settings;
}

}  // namespace drape::scene
