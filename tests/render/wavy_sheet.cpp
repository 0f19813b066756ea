#include "wavy_sheet.hpp"

#include <cmath>
#include <memory>
#include <numeric>

namespace drape::render {
namespace {

constexpr int side = 25;  // vertices along an edge

std::vector<Triangle> gridTriangles() {
  std::vector<Triangle> triangles;
  for (int row = 0; row + 1 < side; ++row) {
    for (int column = 0; column + 1 < side; ++column) {
      const int a = row * side + column;
      triangles.push_back({a, a + 1, a + side + 1});
      triangles.push_back({a, a + side + 1, a + side});
    }
  }
  return triangles;
}

std::vector<Vec3> gridPositions(double waveHeight) {
  std::vector<Vec3> positions;
  for (int row = 0; row < side; ++row) {
    for (int column = 0; column < side; ++column) {
      const double u = static_cast<double>(column) / (side - 1);
      const double v = static_cast<double>(row) / (side - 1);
      positions.emplace_back(u - 0.5, v + 0.4, waveHeight * std::sin(14.0 * u) * (1.0 - 0.6 * v));
    }
  }
  return positions;
}

}  // namespace

session::Snapshot wavySheet(double waveHeight) {
  auto model = std::make_shared<sim::ClothModel>();
  model->restPositions = gridPositions(0.0);
  model->triangles = gridTriangles();
  model->pinned.assign(model->restPositions.size(), false);
  model->pinned[side * (side - 1)] = true;
  model->pinned[side * side - 1] = true;

  auto scene = std::make_shared<scene::Scene>();
  scene->model = model;
  scene->cloths = {scene::wholeCloth(*model)};
  scene->renderMesh.particle.resize(model->restPositions.size());
  std::iota(scene->renderMesh.particle.begin(), scene->renderMesh.particle.end(), 0);
  for (const Vec3& position : model->restPositions) {
    scene->renderMesh.uvs.emplace_back(position.x() + 0.5, position.y() - 0.4);
  }
  scene->renderMesh.triangles = model->triangles;
  scene->start = {gridPositions(waveHeight), std::vector<Vec3>(model->restPositions.size(), Vec3::Zero()), 0.0};
  scene->camera = cameraInFront().pose();

  session::Snapshot snapshot;
  snapshot.scene = scene;
  snapshot.model = model;
  snapshot.positions = scene->start.positions;
  snapshot.version = 1;
  return snapshot;
}

Camera cameraInFront() {
  scene::CameraPose pose;
  pose.position = {0.35, 1.25, 2.3};
  pose.focalPoint = {0.0, 0.85, 0.0};
  pose.viewAngle = 38.0;
  return Camera(pose);
}

}  // namespace drape::render
