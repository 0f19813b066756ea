#include "scene/opened_mesh.hpp"

namespace drape {

Settings openedMeshSettings() {
  Settings settings;
  settings.material.density = 0.15;  // cotton jersey
  settings.step.stiffness = 150.0;   // a T-shirt then stretches by about 1 % in most places, and by 5 % at its pins
  // The damping of a spring is a viscosity of the fabric, as its stiffness is an elasticity: both are the same for any
  // size of the triangles.
  settings.step.damping = 0.005;
  settings.step.drag = 1.0;  // about that of a flat plate across the wind
  settings.step.lift = 0.4;
  settings.step.contact.self = SelfCollision::Hash;
  return settings;
}

}  // namespace drape
