#include "sim/fields/stretch_tensor.hpp"

#include "sim/fields/triangle_means.hpp"

namespace drape::sim::fields {
namespace {

/// Makes the columns unit vectors at a right angle; zero where they are parallel.
WarpAndWeft orthonormal(const WarpAndWeft& frame) {
  WarpAndWeft result = WarpAndWeft::Zero();
  const Vec3 warp = frame.col(0).normalized();
  const Vec3 weft = frame.col(1) - warp * warp.dot(frame.col(1));
  const double length = weft.norm();
  if (length > 0.0) {
    result << warp, weft / length;
  }
  return result;
}

}  // namespace

std::vector<WarpAndWeft> warpAndWeftOf(const ClothModel& model, const FieldGeometry& geometry) {
  std::vector<WarpAndWeft> frames(model.triangles.size(), WarpAndWeft::Zero());
  for (std::size_t t = 0; t < frames.size(); ++t) {
    const fabric::RestTriangle& rest = geometry.rest[t];
    if (rest.area <= 0.0) {
      continue;
    }
    const auto& [a, b, c] = model.triangles[t];
    Eigen::Matrix2d sides;
    sides << rest.sides[0], rest.sides[1];
    WarpAndWeft inMesh;
    inMesh << model.restPositions[b] - model.restPositions[a], model.restPositions[c] - model.restPositions[b];
    frames[t] = orthonormal(inMesh * sides.inverse());
  }
  return frames;
}

void stretchTensors(const ClothModel& model, const FieldGeometry& geometry, std::span<const WarpAndWeft> frames,
                    std::span<const Vec3> positions, std::span<Mat3> tensors) {
  const auto ofTriangle = [&](std::size_t t) -> Mat3 {
    const Eigen::Matrix2d metric = metricOf(geometry.rest[t], model.triangles[t], positions);
    return frames[t] * (metric - Eigen::Matrix2d::Identity()) * frames[t].transpose();
  };
  forTriangleMeans(
      model, geometry, Mat3(Mat3::Zero()), ofTriangle,
      [&](std::size_t v, const Mat3& mean) { tensors[v] = Mat3::Identity() + mean; },
      [&](std::size_t v) { tensors[v] = Mat3::Identity(); });
}

}  // namespace drape::sim::fields
