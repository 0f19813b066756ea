#include "sim/fields/field_table.hpp"

#include "sim/fields/computations.hpp"

#include <algorithm>
#include <array>

namespace drape::sim::fields {
namespace {

// Each row: name, title, unit, help, need, has a sign, neutral value, minimum extent, function.
constexpr std::array table{
    FieldInfo{"strain_warp", "Stretch along warp", "%",
              "Length along warp over that at rest: 100 % is unstretched. On springs, warp is where that of a fabric "
              "would run.",
              FieldNeed::Positions, false, 100.0, 1.0, stretchAlongWarp},
    FieldInfo{"strain_weft", "Stretch along weft", "%",
              "Length along weft over that at rest: 100 % is unstretched. On springs, weft is where that of a fabric "
              "would run.",
              FieldNeed::Positions, false, 100.0, 1.0, stretchAlongWeft},
    FieldInfo{"strain_shear", "Shear angle", "degrees",
              "By how much the angle between warp and weft is smaller than 90 degrees.", FieldNeed::Positions, true,
              0.0, 1.0, shearAngle},
    FieldInfo{"stress", "Stress", "N/m",
              "Largest principal stress of the fabric's membrane: force per width, positive in tension.",
              FieldNeed::Fabric, false, 0.0, 0.1, membraneStress},
    FieldInfo{"bending", "Curvature", "1/m",
              "The larger one of the two principal curvatures: one over the radius of the bend, positive where the "
              "front bulges out.",
              FieldNeed::Positions, true, 0.0, 1.0, curvature},
    FieldInfo{"body_gap", "Gap to bodies", "mm",
              "Distance from the cloth's middle to the nearest body, the ground included. Negative inside a body.",
              FieldNeed::Body, false, 0.0, 1.0, bodyGap},
    FieldInfo{"contact_pressure", "Contact pressure", "Pa",
              "Normal force per area of contacts in the last step, with bodies and of the cloth with itself.",
              FieldNeed::Contact, false, 0.0, 0.1, contactPressure},
    FieldInfo{"speed", "Speed", "m/s", "Speed of the cloth.", FieldNeed::Velocities, false, 0.0, 0.01, speed},
    FieldInfo{"ghost_error", "Distance of the ghost", "mm",
              "Distance between a vertex and the same vertex of the ghost.", FieldNeed::Ghost, false, 0.0, 0.1,
              ghostError}};

}  // namespace

std::span<const FieldInfo> fieldTable() {
  return table;
}

const FieldInfo* findField(std::string_view name) {
  const auto* found =
      std::find_if(table.begin(), table.end(), [&](const FieldInfo& field) { return field.name == name; });
  return found == table.end() ? nullptr : found;
}

bool canCompute(const FieldInfo& field, const FieldInputs& inputs) {
  switch (field.need) {
    case FieldNeed::Fabric:
      return inputs.model.fabric != nullptr;
    case FieldNeed::Body:
      return inputs.bodies != nullptr;
    case FieldNeed::Contact:
      return !inputs.contactImpulses.empty() && inputs.timeStep > 0.0;
    case FieldNeed::Ghost:
      return !inputs.ghost.empty();
    case FieldNeed::Velocities:
      return !inputs.velocities.empty();
    case FieldNeed::Positions:
      break;
  }
  return true;
}

}  // namespace drape::sim::fields
