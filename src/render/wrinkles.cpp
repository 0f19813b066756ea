#include "render/wrinkles.hpp"

#include "scene/cloth_material.hpp"
#include "sim/fabric/fabric.hpp"
#include "sim/fields/tension_field.hpp"
#include "sim/model/fingerprint.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace drape::render {
namespace {

/// By how much the random part of a vertex turns its wrinkles, in parts of the trace of their tensor. Where the cloth
/// is compressed equally along all directions, it alone gives the wrinkles a direction, which does not change from
/// frame to frame.
constexpr double scatter = 0.2;

constexpr double smallestBuckling = 1e-4;  // so that the rounding of a fabric that does not bend is not shown [-]

/// The mean length of a cloth's edges at rest [m]; 0 if it has none.
double meanEdge(const sim::ClothModel& model, const scene::ClothPart& part) {
  double sum = 0.0;
  int count = 0;
  for (const sim::Spring& spring : model.springs) {
    if (spring.a >= part.firstVertex && spring.a < part.firstVertex + part.vertexCount) {
      sum += spring.restLength;
      ++count;
    }
  }
  return count > 0 ? sum / count : 0.0;
}

/// A tensor along the cloth without a trace, whose direction is random but the same in every run.
Mat3 scatterAt(std::size_t vertex, const sim::fields::WarpAndWeft& frame) {
  constexpr double steps = 1024.0;
  const auto random = static_cast<double>(sim::mixHash(0, vertex) % 1024);
  const double angle = std::numbers::pi * random / steps;
  const Vec3 along = frame * Vec2(std::cos(angle), std::sin(angle));
  return scatter * (along * along.transpose() - 0.5 * frame * frame.transpose());
}

}  // namespace

double squaredWrinkleSlope(double ratio, double buckling) {
  constexpr double largest =
      1.0;  // sides steeper than 45 degrees would hide each other, which a normal map cannot show
  if (!(ratio < 1.0)) {
    return 0.0;
  }
  const double excess = 1.0 / std::max(ratio, 0.1) - 1.0;
  return std::min(4.0 * excess * excess / (excess + buckling), largest);
}

WrinkleMap::VertexAtRest WrinkleMap::vertexAtRest(std::size_t vertex, double wavelength) const {
  VertexAtRest rest;
  rest.wavelength = wavelength;
  for (const int t : model_->vertexTriangles[vertex]) {
    if (geometry_.rest[t].area > 0.0) {
      rest.frame = frames_[t];
    }
    if (model_->fabric) {
      rest.material = &model_->fabric->materials[static_cast<std::size_t>(t)];
    }
  }
  rest.scatter = scatterAt(vertex, rest.frame);
  return rest;
}

void WrinkleMap::takeModel(const session::Snapshot& snapshot) {
  scene_ = snapshot.scene;
  model_ = snapshot.model;
  geometry_ = sim::fields::fieldGeometryOf(*model_, scene::warpDirections(*model_, scene_->cloths, snapshot.settings));
  frames_ = sim::fields::warpAndWeftOf(*model_, geometry_);
  const std::size_t count = model_->restPositions.size();
  stretches_.resize(count);
  rest_.assign(count, VertexAtRest());
  vertices_.assign(count, Wrinkles());
  for (const scene::ClothPart& part : scene_->cloths) {
    const double wavelength = edgesPerWrinkle * meanEdge(*model_, part);
    if (wavelength > 0.0) {
      for (int v = part.firstVertex; v < part.firstVertex + part.vertexCount; ++v) {
        rest_[v] = vertexAtRest(static_cast<std::size_t>(v), wavelength);
        vertices_[v].place = (model_->restPositions[v] / wavelength).cast<float>();
      }
    }
  }
}

/// The tensor of Wrinkles. @param stretch of stretchTensors
Mat3 WrinkleMap::tensorOf(const VertexAtRest& vertex, const Mat3& stretch) {
  const Eigen::Matrix2d metric =
      Eigen::Matrix2d::Identity() + vertex.frame.transpose() * (stretch - Mat3::Identity()) * vertex.frame;
  const bool isFabric = vertex.material != nullptr;
  const sim::fabric::Material& material = isFabric ? *vertex.material : sim::fields::plainMaterial;
  Mat3 tensor = Mat3::Zero();
  for (const sim::fields::Compression& compression : sim::fields::compressionsOf(metric, material)) {
    if (compression.ratio < 1.0) {
      const double buckling =
          isFabric ? sim::fields::bucklingStrain(material, compression.along, vertex.wavelength) : springBuckling;
      const Vec3 along = vertex.frame * compression.along;
      tensor +=
          squaredWrinkleSlope(compression.ratio, std::max(buckling, smallestBuckling)) * along * along.transpose();
    }
  }
  return tensor + tensor.trace() * vertex.scatter;
}

bool WrinkleMap::update(const session::Snapshot& snapshot) {
  if (!snapshot.settings.view.wrinkles) {
    return false;
  }
  const bool isOther = snapshot.scene != scene_ || snapshot.model != model_;
  if (!isOther && snapshot.version == version_) {
    return false;
  }
  if (isOther) {
    takeModel(snapshot);
  }
  version_ = snapshot.version;
  sim::fields::stretchTensors(*model_, geometry_, frames_, snapshot.positions, stretches_);
  for (std::size_t v = 0; v < vertices_.size(); ++v) {
    const Eigen::Matrix3f tensor = tensorOf(rest_[v], stretches_[v]).cast<float>();
    vertices_[v].diagonal = tensor.diagonal();
    vertices_[v].mixed = {tensor(1, 2), tensor(2, 0), tensor(0, 1)};
  }
  return true;
}

}  // namespace drape::render
