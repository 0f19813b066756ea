#include "bench/cloths.hpp"

#include "scene/grid_mesh.hpp"
#include "scene/scene.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

namespace drape::bench {
namespace {

constexpr double mass = 0.1;  // [kg]

ModelPtr modelOf(const sim::ClothMesh& mesh, const std::vector<int>& pins) {
  return sim::buildClothModel(mesh, mass, sim::MassLumping::Uniform, pins);
}

/// A random permutation newIndex[v] of the vertices, the same in every run.
std::vector<int> randomNumbering(std::size_t count) {
  std::vector<int> numbers(count);
  std::iota(numbers.begin(), numbers.end(), 0);
  std::mt19937 random(5);
  std::shuffle(numbers.begin(), numbers.end(), random);
  return numbers;
}

sim::ClothMesh renumbered(const sim::ClothMesh& mesh, const std::vector<int>& newIndex) {
  sim::ClothMesh result{std::vector<Vec3>(mesh.positions.size()), mesh.triangles};
  for (std::size_t v = 0; v < newIndex.size(); ++v) {
    result.positions[static_cast<std::size_t>(newIndex[v])] = mesh.positions[v];
  }
  for (Triangle& triangle : result.triangles) {
    for (int& corner : triangle) {
      corner = newIndex[static_cast<std::size_t>(corner)];
    }
  }
  return result;
}

std::vector<int> corners(int n, const std::vector<int>& newIndex) {
  return {newIndex.front(), newIndex[static_cast<std::size_t>(n) - 1]};
}

/// Replaces the two triangles of a quad by those with the other diagonal. The first and third corner of the first
/// triangle are the ends of the diagonal, as in makeGrid.
void turnDiagonal(Triangle& first, Triangle& second) {
  const Triangle a = first;
  const Triangle b = second;
  const auto alone = [](const Triangle& triangle, const Triangle& other) {
    return *std::find_if(triangle.begin(), triangle.end(),
                         [&](int corner) { return std::find(other.begin(), other.end(), corner) == other.end(); });
  };
  const int apexA = alone(a, b);
  const int apexB = alone(b, a);
  // In the order of the triangle, the corners after its apex are the shared edge's ends.
  const auto at = static_cast<std::size_t>(std::find(a.begin(), a.end(), apexA) - a.begin());
  const int left = a[(at + 1) % 3];
  const int right = a[(at + 2) % 3];
  first = {apexA, left, apexB};
  second = {apexA, apexB, right};
}

}  // namespace

sim::ClothMesh gridMesh(int n) {
  return scene::makeGrid({n, n, 1.0, 1.0}, scene::GridSource::Plane::Horizontal).cloth;
}

ModelPtr grid(int n) {
  return modelOf(gridMesh(n), {0, n - 1});
}

ModelPtr shuffledGrid(int n) {
  const sim::ClothMesh mesh = gridMesh(n);
  const std::vector<int> numbering = randomNumbering(mesh.positions.size());
  return modelOf(renumbered(mesh, numbering), corners(n, numbering));
}

sim::ClothMesh irregularMesh(int n) {
  sim::ClothMesh mesh = gridMesh(n);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> shift(-1.0 / 3.0, 1.0 / 3.0);
  for (Vec3& position : mesh.positions) {
    position.x() += shift(random) / (n - 1);
    position.z() += shift(random) / (n - 1);
  }
  for (std::size_t t = 0; t + 1 < mesh.triangles.size(); t += 2) {
    if (shift(random) < 0.0) {
      turnDiagonal(mesh.triangles[t], mesh.triangles[t + 1]);
    }
  }
  return renumbered(mesh, randomNumbering(mesh.positions.size()));
}

ModelPtr irregularSheet(int n) {
  const std::vector<int> numbering = randomNumbering(static_cast<std::size_t>(n) * static_cast<std::size_t>(n));
  return modelOf(irregularMesh(n), corners(n, numbering));
}

ModelPtr tshirt() {
  scene::SceneDescription description;
  description.cloth().source = scene::MeshFileSource{"tshirt.obj", true};
  return scene::buildScene(description, description.settings)->model;
}

sim::ClothState waving(const sim::ClothModel& model) {
  sim::ClothState state = sim::stateAtRest(model.restPositions);
  for (std::size_t v = 0; v < state.positions.size(); ++v) {
    const Vec3 at = model.restPositions[v];
    const Vec3 wave(std::sin(9.0 * at.z()), std::sin(7.0 * at.x() + 5.0 * at.z()), std::cos(8.0 * at.x()));
    state.positions[v] += 0.02 * wave;
    if (!model.pinned[v]) {
      state.velocities[v] = 0.5 * Vec3(wave.y(), wave.z(), wave.x());
    }
  }
  return state;
}

sim::StepParameters stillAir() {
  sim::StepParameters parameters;
  parameters.material.stiffness = 10.0;
  parameters.precision = sim::Precision::Float;
  return parameters;
}

sim::StepParameters fullStep() {
  sim::StepParameters parameters = stillAir();
  parameters.material.damping = 1e-3;
  parameters.air.drag = 1.0;
  parameters.air.lift = 0.5;
  parameters.air.wind = Vec3(1.0, 0.0, 2.0);
  return parameters;
}

}  // namespace drape::bench
