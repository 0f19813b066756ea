#include "sim/fabric/material.hpp"

#include <algorithm>
#include <cmath>

namespace drape::sim::fabric {

Mat3 stretchMatrix(const Material& material) {
  const double across = material.poisson * std::sqrt(material.stretchWarp * material.stretchWeft);
  Mat3 matrix;
  matrix << material.stretchWarp, across, 0.0,  //
      across, material.stretchWeft, 0.0,        //
      0.0, 0.0, material.shear;
  return matrix;
}

Mat3 bendMatrix(const Material& material) {
  return Vec3(material.bendWarp, material.bendWeft, material.bendBias - 0.25 * (material.bendWarp + material.bendWeft))
      .asDiagonal();
}

bool TriangleMaterials::stiffen() const {
  return std::ranges::any_of(list_, &Material::stiffens);
}

bool TriangleMaterials::damp() const {
  return std::ranges::any_of(list_, &Material::damps);
}

double TriangleMaterials::maxStretchDamping() const {
  return std::ranges::max(list_, {}, &Material::stretchDamping).stretchDamping;
}

double TriangleMaterials::maxBendDamping() const {
  return std::ranges::max(list_, {}, &Material::bendDamping).bendDamping;
}

bool resistBending(const TriangleMaterials& materials) {
  return std::ranges::any_of(materials.list(), [](const Material& material) {
    return material.bendWarp > 0.0 || material.bendWeft > 0.0 || material.bendBias > 0.0;
  });
}

bool isStable(const Material& material) {
  const bool stretches = material.stretchWarp > 0.0 && material.stretchWeft > 0.0 && material.shear > 0.0 &&
                         std::abs(material.poisson) < 1.0;
  const bool stiffens =
      material.stiffeningWarp >= 0.0 && material.stiffeningWeft >= 0.0 && material.stiffeningStrain >= 0.0;
  const bool damps = material.stretchDamping >= 0.0 && material.bendDamping >= 0.0 &&
                     std::isfinite(material.stretchDamping) && std::isfinite(material.bendDamping);
  const bool finite = stretchMatrix(material).allFinite() && bendMatrix(material).allFinite() &&
                      std::isfinite(material.stiffeningWarp) && std::isfinite(material.stiffeningWeft);
  return stretches && stiffens && damps && finite && (bendMatrix(material).diagonal().array() >= 0.0).all();
}

}  // namespace drape::sim::fabric
