#pragma once

#include "sim/fabric/fabric.hpp"
#include "test_meshes.hpp"

#include <Eigen/Geometry>

#include <array>
#include <cmath>
#include <memory>
#include <numeric>
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
inline std::shared_ptr<const ClothModel> asFabric(const ClothModel& model, const fabric::Material& material,
                                                  fabric::RestCurvature curvature = fabric::RestCurvature::Flat) {
  const Vec3 warp = Vec3(1.0, 0.3, 0.4).normalized();
  return fabric::withFabric(model, material, fabric::warpAlong(warp, model.restPositions, model.triangles), curvature);
}

/// A sheet of 17 x 17 vertices, 1 m and 0.1 kg, that hangs from its first row.
inline std::shared_ptr<const ClothModel> hangingFromRow(const fabric::Material& material) {
  constexpr int n = 17;
  std::vector<int> pins(n);
  std::iota(pins.begin(), pins.end(), 0);
  return asFabric(*buildClothModel(sheet(n), 0.1, MassLumping::Area, pins), material);
}

struct NamedCloth {
  std::string name;
  std::shared_ptr<const ClothModel> model;
};

/// The cloth with every kind of fabric, and with one whose rest curvature is that of the mesh.
inline std::vector<NamedCloth> withEveryFabric(const ClothModel& model) {
  std::vector<NamedCloth> cloths;
  for (const auto& [name, material] : everyKindOfFabric()) {
    cloths.push_back({name, asFabric(model, material)});
  }
  cloths.push_back({"curved", asFabric(model, woven(), fabric::RestCurvature::Mesh)});
  return cloths;
}

/// A level sheet, rolled onto a cylinder about the z axis. @param flat its positions [m]  @param curvature [1/m]
inline std::vector<Vec3> rolled(const std::vector<Vec3>& flat, double curvature) {
  std::vector<Vec3> positions;
  for (const Vec3& position : flat) {
    const double angle = curvature * position.x();
    positions.emplace_back(std::sin(angle) / curvature, (1.0 - std::cos(angle)) / curvature, position.z());
  }
  return positions;
}

/// The pattern of a level sheet of 1 m x 1 m, cut in two pieces along x = 0.5 m. The second piece is turned in the
/// pattern. @param scale of both pieces [-]  @param ease a factor on the second piece along warp, which makes its side
/// of the seam longer [-]
inline std::vector<fabric::RestTriangle> twoPieces(const ClothModel& model, double scale, double ease) {
  std::vector<fabric::RestTriangle> pattern;
  for (const Triangle& triangle : model.triangles) {
    std::array<Vec2, 3> corners;
    double middle = 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3& position = model.restPositions[triangle[k]];
      corners[k] = scale * Vec2(position.z(), position.x());
      middle += position.x() / 3.0;
    }
    if (middle > 0.5) {
      const Eigen::Rotation2Dd turn(0.4);
      for (Vec2& corner : corners) {
        corner = turn * Vec2(ease * corner.x(), corner.y());
      }
    }
    pattern.push_back(fabric::restTriangleOf(corners));
  }
  return pattern;
}

}  // namespace drape::sim::testing
