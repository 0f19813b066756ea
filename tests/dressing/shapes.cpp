#include "shapes.hpp"

#include "io/garments/garments.hpp"
#include "sim/contact/bodies/body.hpp"

#include <cmath>
#include <numbers>
#include <utility>

namespace drape::dressing::testing {

const sim::ClothMesh& mannequin() {
  static const sim::ClothMesh mesh = io::weldMesh(io::makeMannequin(), "mannequin", {}).cloth;
  return mesh;
}

const sim::ClothMesh& figure() {
  static const sim::ClothMesh mesh = io::weldMesh(io::makeFigure(), "figure", {}).cloth;
  return mesh;
}

const sim::ClothMesh& tshirt() {
  static const sim::ClothMesh mesh = io::weldMesh(io::makeTshirt(), "T-shirt", {}).cloth;
  return mesh;
}

sim::ClothMesh ellipsoid(const Vec3& half) {
  sim::contact::BodySurface surface = sim::contact::surfaceOf(sim::contact::SphereShape{1.0});
  for (Vec3& position : surface.positions) {
    position = position.cwiseProduct(half);
  }
  return {std::move(surface.positions), std::move(surface.triangles)};
}

sim::ClothMesh tube(double radius, double height) {
  constexpr int around = 32;
  constexpr int rows = 20;
  sim::ClothMesh mesh;
  for (int row = 0; row <= rows; ++row) {
    for (int k = 0; k < around; ++k) {
      const double angle = 2.0 * std::numbers::pi * k / around;
      mesh.positions.emplace_back(radius * std::sin(angle), height * (double(row) / rows - 0.5),
                                  radius * std::cos(angle));
    }
  }
  for (int row = 0; row < rows; ++row) {
    for (int k = 0; k < around; ++k) {
      const int a = row * around + k;
      const int b = row * around + (k + 1) % around;
      mesh.triangles.push_back({a, b, b + around});
      mesh.triangles.push_back({a, b + around, a + around});
    }
  }
  return mesh;
}

std::shared_ptr<const sim::ClothModel> modelOf(const sim::ClothMesh& mesh) {
  constexpr double mass = 0.2;  // [kg]
  return sim::buildClothModel(mesh, mass, sim::MassLumping::Area, {});
}

sim::ClothMesh shifted(sim::ClothMesh mesh, const Vec3& shift) {
  for (Vec3& position : mesh.positions) {
    position += shift;
  }
  return mesh;
}

}  // namespace drape::dressing::testing
