#pragma once

#include "sim/fabric/fabric.hpp"
#include "test_meshes.hpp"

#include <memory>
#include <string>
#include <vector>

namespace drape::sim::testing {

/// A woven fabric with all of its moduli different.
inline fabric::Material woven() {
  fabric::Material material;
  material.stretchWarp = 300.0;
  material.stretchWeft = 500.0;
  material.shear = 40.0;
  material.poisson = 0.2;
  material.bendWarp = 3e-5;
  material.bendWeft = 2e-5;
  material.bendBias = 4e-5;
  return material;
}

/// The same without bending stiffness.
inline fabric::Material membraneOnly() {
  fabric::Material material = woven();
  material.bendWarp = material.bendWeft = material.bendBias = 0.0;
  return material;
}

/// A fabric that stiffens early along warp and weft.
inline fabric::Material stiffeningFabric() {
  fabric::Material material = woven();
  material.stiffeningStrain = 0.002;
  material.stiffeningWarp = 700.0;
  material.stiffeningWeft = 900.0;
  return material;
}

struct NamedMaterial {
  std::string name;
  fabric::Material material;
};

inline std::vector<NamedMaterial> everyKindOfFabric() {
  return {{"membrane", membraneOnly()}, {"bending", woven()}, {"stiffening", stiffeningFabric()}};
}

/// The cloth with a fabric whose warp runs along a direction that no edge has.
inline std::shared_ptr<const ClothModel> asFabric(const ClothModel& model, const fabric::Material& material) {
  const Vec3 warp = Vec3(1.0, 0.3, 0.4).normalized();
  return fabric::withFabric(model, material, fabric::warpAlong(warp, model.restPositions, model.triangles));
}

}  // namespace drape::sim::testing
